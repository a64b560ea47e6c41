#!/usr/bin/env python3
"""Injects faults into the code of the target and says what became of each (./dev inject).

The image is a device of two consumers (one with the restart interlock) and a producer, linked from the big-endian objects that
ship: kernel, channels, the gate and the pins of a TMS570. It lives through a script: start, pairs, acknowledge, send and
confirm, GFC, SCT expiry, NMT, reconfiguration, device safe state. Each instruction that a step executes is skipped once, each
decision is inverted once; bits of registers (before the instruction that reads them) and of RAM are drawn. A run ends when
everything that lives is again as without the fault.

Classes: masked; latent (something that lives stays different, nothing is seen outside); benign (seen outside, not dangerous:
an output closed, a pair lost); detected (by the mechanism told, after so many steps of 1 ms); crash that ends safe (exception,
watchdog not answered); silent: wrong data released or sent, output open without leave (restart without acknowledge too), a
frame under a foreign identifier. A silent one needs a reason in reasons.json: {"function", "what", "reason"}, the function as the
table names it. Forged pair, both variables of a pair changed and a foreign acknowledge must be told as silent each time.
"""
import argparse
import collections
import json
import os
import pathlib
import re
import subprocess
import sys
import threading
import time

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
sys.path[:0] = [str(HERE), str(HERE.parent / "target")]
import image_description  # noqa: E402
import target_build  # noqa: E402

IMAGE = ROOT / "build/target/verification/target/injection/injected"
INJECTOR = ROOT / "build/product/verification/injection/counterpoint_injector"
CODE = {"none": 0, "skips": 1, "inversions": 2, "both": 3}
CLASSES = ("masked", "latent", "benign", "detected", "crash, ends safe", "silent")
EXHAUSTIVE = ("skip", "invert")
# Four that must be told; an undisturbed run up to the end, and one step of it behind all faults, which must not be.
CONTROLS = ["silent", "silent", "silent", "silent", "latent", "masked"]
REQUIREMENTS = ("SRS_VER_040", "SRS_VER_041", "SRS_VER_042")


def enumerators(header, name):
    """Value -> name of an enumeration of the contract."""
    text = (ROOT / "safety_core/contract" / header).read_text(encoding="utf-8")
    body = text.split(f"enum class {name} ")[1].split("};")[0]
    return {int(value, 0): word for word, value in re.findall(r"k(\w+) = (\w+?)U", body)}


def mechanism_name(text, faults, causes):
    for word, names in (("device fault ", faults), ("SRDO cause ", causes)):
        if text.startswith(word):
            return word + names.get(int(text[len(word):]), "of no known value")
    return text


class Progress:
    """One line on a terminal, a line each half minute otherwise."""

    def __init__(self):
        self.state, self.begun, self.told, self.lock = {}, time.monotonic(), 0.0, threading.Lock()

    def see(self, shard, done, total):
        with self.lock:
            self.state[shard] = (done, total)
            now = time.monotonic() - self.begun
            if now - self.told < (1 if sys.stdout.isatty() else 30):
                return
            self.told = now
            done, total = (sum(pair[i] for pair in self.state.values()) for i in (0, 1))
            left = now * (total - done) / max(done, 1)
            print(f"{chr(13) if sys.stdout.isatty() else ''}{done} of {total} faults, {done / now:.0f} a second, about {left:.0f} s left ",
                  end="" if sys.stdout.isatty() else "\n", flush=True)


def command_of(arguments, shard):
    parts = [INJECTOR, f"{IMAGE}.bin", f"{IMAGE}.txt", CODE[arguments.code], arguments.registers, arguments.memory, arguments.seed, shard,
             arguments.jobs, arguments.each, arguments.sample]
    return [str(part) for part in parts]


def show(arguments):
    return subprocess.run(command_of(arguments, 0) + arguments.show, check=False).returncode


def run_shard(arguments, shard, progress, lines, failures):
    with subprocess.Popen(command_of(arguments, shard), stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as process:
        def watch():
            for line in process.stderr:
                fields = line.split("\t")
                if fields[0] == "progress":
                    progress.see(shard, int(fields[1]), int(fields[2]))
                else:
                    failures.append(line.strip())
        watcher = threading.Thread(target=watch)
        watcher.start()
        lines.extend(line.rstrip("\n").split("\t") for line in process.stdout)
        watcher.join()
    if process.returncode != 0:
        failures.append(f"shard {shard} ended with exit status {process.returncode}")


def run_shards(arguments):
    progress, lines, failures = Progress(), [], []
    threads = [threading.Thread(target=run_shard, args=(arguments, shard, progress, lines, failures)) for shard in range(arguments.jobs)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    print("\r" if sys.stdout.isatty() else "", end="")
    return lines, failures


def find_reason(survivor, reasons):
    for reason in reasons:
        if reason["function"] == survivor["function"] and reason["what"] == survivor["what"]:
            return reason
    return None


def judge_survivors(survivors, reasons, is_complete):
    """Problems: a survivor without a reason, and (where all code was faulted) a reason that no survivor needs."""
    problems, used = [], []
    for survivor in survivors:
        reason = find_reason(survivor, reasons)
        survivor["reason"] = reason["reason"] if reason else None
        if reason is None:
            problems.append(f"{survivor['function']} ({survivor['line']}): {survivor['what']}, no reason")
        else:
            used.append(reason)
    if is_complete:
        problems += [f"reason for {reason['function']}, {reason['what']}: no survivor" for reason in reasons
                     if reason not in used and not reason.get("drawn")]
    return sorted(set(problems))


def read_survivors(lines):
    elf = f"{IMAGE}.elf"
    rows = [line for line in lines if line[0] == "silent"]
    places = image_description.places(elf, sorted({int(row[4]) for row in rows if row[1] != "memory"}))
    parts = image_description.parts_of_memory(elf)
    grouped = collections.OrderedDict()
    for row in sorted(rows, key=lambda row: (row[1], int(row[4]), int(row[2]))):
        address = int(row[4])
        if row[1] == "memory":
            begin, name = next((begin, name) for begin, end, name in parts if begin <= address < end)
            function, line = name, f"byte {address - begin}"
        else:
            function, line = places[address]
        key = (row[1], function, line, row[7])
        entry = grouped.setdefault(key, {"fault": row[1], "function": function, "line": line, "what": row[7], "count": 0, "scenes": [],
                                         "example": {"step": int(row[2]), "address": f"{address:#x}", "instruction": int(row[5]), "number": int(row[6])}})
        entry["count"] += 1
        if row[3] not in entry["scenes"]:
            entry["scenes"].append(row[3])
    return list(grouped.values())


def read_counts(lines):
    """Fault -> class -> number, and fault -> mechanism -> steps -> number."""
    faults, causes = enumerators("device_fault.hpp", "DeviceFault"), enumerators("srdo.hpp", "SrdoCause")
    classes = collections.defaultdict(collections.Counter)
    mechanisms = collections.defaultdict(lambda: collections.defaultdict(collections.Counter))
    for line in lines:
        if line[0] == "count":
            classes[line[1]][line[2]] += int(line[5])
            if line[2] in ("detected", "crash, ends safe"):
                mechanisms[line[1]][mechanism_name(line[3], faults, causes)][int(line[4])] += int(line[5])
    return classes, mechanisms


def percentile(steps, share):
    left = share * sum(steps.values())
    for step in sorted(steps):
        left -= steps[step]
        if left <= 0:
            return step
    return 0


def write_table(classes, mechanisms, survivors, controls):
    rows = [f"{'fault':10}" + "".join(f"{name:>18}" for name in CLASSES)]
    rows += [f"{kind:10}" + "".join(f"{counts[name]:>18}" for name in CLASSES) for kind, counts in classes.items()]
    rows += ["", "Detected by (steps of 1 ms from the fault: median, 99.9 %, worst)"]
    for kind, found in mechanisms.items():
        for name, steps in sorted(found.items(), key=lambda item: -sum(item[1].values())):
            rows.append(f"  {kind:9} {sum(steps.values()):>8}  {name}: {percentile(steps, 0.5)}, {percentile(steps, 0.999)}, {max(steps)}")
    rows += ["", "Controls: four must be silent, two must not"] + [f"  {name}: {kind}{', ' if what else ''}{what}" for name, kind, what in controls]
    rows += ["", f"Survivors: {sum(row['count'] for row in survivors)} in {len(survivors)} rows"]
    for row in survivors:
        rows.append(f"  {row['fault']:8} {row['count']:>5} x {row['function']} ({row['line']}): {row['what']} [{'; '.join(row['scenes'])}]")
        rows.append(f"           {row['reason'] or 'NO REASON'}")
    return "\n".join(rows) + "\n"


def self_test():
    """What a survivor without a reason and a reason without a survivor come to."""
    def survivor(function):
        return {"function": function, "line": "x.cpp:1", "what": "wrong data released"}
    reason = {"function": "F", "what": "wrong data released", "reason": "closed by the lockstep of the processor"}
    found = [judge_survivors([survivor("F")], [reason], True), judge_survivors([survivor("G")], [reason], False),
             judge_survivors([], [reason], True), judge_survivors([], [reason], False)]
    good = [len(problems) for problems in found] == [0, 1, 1, 0]
    print(f"{'pass' if good else 'FAIL'}  fixture: a survivor without a reason, a reason without a survivor")
    return good


def build():
    print("Building the image (build/target) and the injector (build/product) ...", flush=True)
    target_build.build_preset("tms570", ["injected"], ROOT / "build/target")
    target_build.build_preset("product", ["counterpoint_injector"])


def parse():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--code", choices=CODE, default="both", help="faults of every executed instruction (default: both)")
    parser.add_argument("--code-of", default="", metavar="REGEX", help="only of functions whose mangled names contain this")
    parser.add_argument("--each", type=int, default=0, metavar="N", help="of each instruction at most N executions a step (default: all)")
    parser.add_argument("--sample", type=int, default=0, metavar="N", help="of the faults of the code so many are drawn (default: all)")
    parser.add_argument("--show", nargs=5, metavar=("STEP", "FAULT", "INSTRUCTION", "ADDRESS", "NUMBER"),
                        help="each step of one run, as a survivor's example in injection.json names it")
    parser.add_argument("--registers", type=int, default=5000, metavar="N", help="so many bits of registers (default: 5000)")
    parser.add_argument("--memory", type=int, default=5000, metavar="N", help="so many bits of RAM (default: 5000)")
    parser.add_argument("--all-memory", action="store_true", help="every bit of RAM of core, channels and port, before every step (an hour)")
    parser.add_argument("--memory-of", metavar="PART", help=f"only of this part, NAME or NAME:BEGIN:END in bytes: {', '.join(image_description.MEMORY)}")
    parser.add_argument("--seed", type=int, default=1, help="of what is drawn (default: 1)")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), metavar="N", help="processes (default: one a core)")
    parser.add_argument("--no-build", action="store_true", help="use what was built before")
    arguments = parser.parse_args()
    if min(arguments.each, arguments.sample, arguments.registers, arguments.memory, arguments.seed) < 0 or arguments.each == 1 or arguments.jobs < 1:
        parser.error("numbers are 0 or greater, --jobs at least 1, --each not 1")
    arguments.memory = 0xFFFFFFFF if arguments.all_memory else arguments.memory
    return arguments


def main():
    arguments = parse()
    is_tested = self_test()
    if not arguments.no_build:
        build()
    image_description.describe(f"{IMAGE}.elf", IMAGE.with_suffix(".txt"), arguments.memory_of, arguments.code_of)
    if arguments.show:
        return show(arguments)
    begun = time.monotonic()
    lines, failures = run_shards(arguments)
    seconds = time.monotonic() - begun
    reasons = json.loads((HERE / "reasons.json").read_text(encoding="utf-8"))
    survivors = read_survivors(lines)
    problems = judge_survivors(survivors, reasons, arguments.code == "both" and arguments.each == arguments.sample == 0 and not arguments.code_of)
    classes, mechanisms = read_counts(lines)
    controls = list(dict.fromkeys(tuple(line[1:4]) for line in lines if line[0] == "control"))
    are_told = [kind for _, kind, _ in controls] == CONTROLS
    total = sum(sum(counts.values()) for counts in classes.values())
    table = write_table(classes, mechanisms, survivors, controls)
    passed = {"SRS_VER_040": not failures and total > 0, "SRS_VER_041": is_tested and not problems, "SRS_VER_042": are_told}
    result = {"faults": total, "seconds": round(seconds, 1), "seed": arguments.seed, "classes": classes, "mechanisms": mechanisms,
              "controls": controls, "survivors": survivors, "problems": problems + failures, "requirements": passed}
    folder = ROOT / "build/injection"
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "injection.json").write_text(json.dumps(result, indent=2) + "\n", encoding="utf-8")
    (folder / "injection.txt").write_text(table, encoding="utf-8")
    print(table)
    for problem in problems + failures:
        print(f"problem: {problem}")
    verdict = all(passed[name] for name in REQUIREMENTS)
    print(f"inject: {total} faults in {seconds:.0f} s, {len(problems)} problems; build/injection/injection.json: {'pass' if verdict else 'FAIL'}")
    return 0 if verdict else 1


if __name__ == "__main__":
    try:
        sys.exit(main())
    except (target_build.BadInput, OSError, ValueError, subprocess.SubprocessError) as problem:
        print(f"run.py: {problem}", file=sys.stderr)
        sys.exit(2)
