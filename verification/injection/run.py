#!/usr/bin/env python3
"""Injects faults into the code of the target and says what became of each (./dev inject).

The image is a device of two consumers (one with the restart interlock) and a producer, linked from the big-endian objects that
ship: kernel, channels, the gate and the pins of a TMS570. It lives through a script of scenes; each shows without a fault what
it is called, or nothing is run. Each instruction that a step executes is skipped once, each decision is inverted once. Drawn by
the seed: bits of registers (before the instruction that reads them), of instructions (at one execution), of the code and of RAM
from a step on (of RAM until it is written), and bits of RAM that are stuck. A run ends when everything that lives is as without
the fault, or as behind another fault whose end is known; a fault that stays is met where the device reads it.

Classes: masked; latent (something that lives stays different, nothing is seen outside); benign (seen outside, not dangerous: an
output closed); detected (by the mechanism told, after so many steps of 1 ms); crash that ends safe (exception, watchdog not
answered); lost frame (as if the bus had lost one, or its receiver refuses it); pair check only (normal and inverse object do not
fit, and the application alone sees it); silent: wrong data released or sent, output open without leave, restart without
acknowledge, NMT command missed, a frame under a foreign identifier. A silent one needs a reason in reasons.json: {"function",
"what", "mechanism", "reason"}, the function as the table names it (or {"fault", "mechanism", "reason"} for all of a kind that
lasts), the mechanism an assumption or a row of the hardware's table in the safety manual. Each of these kinds is planted, and has to be told as what it is. All rows: build/injection/injection.csv.gz.
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
import results  # noqa: E402
import target_build  # noqa: E402

IMAGE = ROOT / "build/target/verification/target/injection/injected"
INJECTOR = ROOT / "build/product/verification/injection/counterpoint_injector"
FOLDER = ROOT / "build/injection"
CODE = {"none": 0, "skips": 1, "inversions": 2, "both": 3}
DRAWN = ("registers", "opcodes", "flash", "memory", "stuck")
# What the script has to hold: names of its scenes.
SCENES = {"start", "pair", "acknowledge", "send", "confirm", "GFC", "GFC sent", "SCT expiry", "SRVT expiry", "NMT leave", "reconfiguration",
          "diagnosis", "level 2"}
REQUIREMENTS = tuple(f"SRS_VER_{number:03}" for number in (40, 41, 42, 70, 71, 72, 73, 74, 210, 211, 347))
# So many faults a second of processor time.
LEAST_RATE = 300


def enumerators(header, name):
    """Value -> name of an enumeration of the contract."""
    text = (ROOT / "safety_core/contract" / header).read_text(encoding="utf-8")
    body = text.split(f"enum class {name} ")[1].split("};")[0]
    return {int(value, 0): word for word, value in re.findall(r"k(\w+)\s*=\s*(\w+?)U", body)}


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
    numbers = {"code": CODE[arguments.code], "seed": arguments.seed, "shard": shard, "shards": arguments.jobs, "first": arguments.steps[0], "last": arguments.steps[1], "each": arguments.each,
               "sample": arguments.sample, **{name: getattr(arguments, name) for name in DRAWN}}
    return [str(INJECTOR), f"{IMAGE}.bin", f"{IMAGE}.txt"] + [f"{name}={number}" for name, number in numbers.items()]


def show(arguments):
    words = (f"{name}={value}" for name, value in zip(("step", "fault", "instruction", "address", "number"), arguments.show))
    return subprocess.run(command_of(arguments, 0) + list(words), check=False).returncode


def run_shard(arguments, shard, progress, path, failures):
    with open(path, "w", encoding="utf-8") as output, \
            subprocess.Popen(command_of(arguments, shard), stdout=output, stderr=subprocess.PIPE, text=True) as process:
        for line in process.stderr:
            fields = line.split("\t")
            if fields[0] == "progress":
                progress.see(shard, int(fields[1]), int(fields[2]))
            else:
                failures.append(line.strip())
    if process.returncode != 0:
        failures.append(f"shard {shard} ended with exit status {process.returncode}")


def run_shards(arguments):
    """The output of each shard, as a file, and what failed."""
    progress, failures = Progress(), []
    paths = [FOLDER / f"shard_{shard}.txt" for shard in range(arguments.jobs)]
    threads = [threading.Thread(target=run_shard, args=(arguments, shard, progress, path, failures)) for shard, path in enumerate(paths)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    print("\r" if sys.stdout.isatty() else "", end="")
    return paths, failures


def lines_of(paths, kind):
    for path in paths:
        with open(path, encoding="utf-8") as text:
            yield from (line.rstrip("\n").split("\t")[1:] for line in text if line.startswith(kind + "\t"))


def mechanisms_of_manual():
    """Assumption -> its title, and fault of the hardware -> what finds it, of the hardware's section of the safety manual."""
    text = (ROOT / "docs/safety_manual.md").read_text(encoding="utf-8")
    faults = text.split("| fault of the hardware | found by | reaction |")[1].split("\n\n")[0]
    rows = re.findall(r"^\| ([^|-]+) \| ([^|]+) \| [^|]+ \|$", faults, re.MULTILINE)
    return dict(re.findall(r"^\| (AU-\d+) \| \*\*(.*?)\.\*\*", text, re.MULTILINE)) | dict(rows)


def find_reason(survivor, reasons):
    """One of its function and what, or else one of all faults of its kind."""
    def fits(reason):
        return all(reason.get(name, survivor[name]) == survivor[name] for name in ("fault", "function", "what"))
    return next(filter(fits, sorted(reasons, key=lambda reason: "function" not in reason)), None)


def judge_survivors(survivors, reasons, manual, is_complete):
    """Problems: a survivor without a reason or whose mechanism the manual does not name, and (where all code was faulted) a reason that no
    survivor needs."""
    problems, used = [], []
    for survivor in survivors:
        reason = find_reason(survivor, reasons)
        survivor["reason"] = reason["reason"] if reason else None
        survivor["mechanism"] = reason.get("mechanism") if reason else None
        if reason is None:
            problems.append(f"{survivor['function']} ({survivor['line']}): {survivor['what']}, no reason")
            continue
        used.append(reason)
        if survivor["mechanism"] not in manual:
            problems.append(f"{survivor['function']}: the safety manual has no mechanism {survivor['mechanism']}")
    if is_complete:
        problems += [f"reason for {reason.get('function')}, {reason.get('what')}: no survivor" for reason in reasons
                     if reason not in used and not reason.get("drawn")]
    return sorted(set(problems))


def summarise(paths):
    elf = f"{IMAGE}.elf"
    executed = {int(address): int(count) for address, count in lines_of(paths[:1], "executed")}
    places = results.Places(image_description.places(elf, sorted(executed)), image_description.parts_of_memory(elf))
    faults, causes = enumerators("device_fault.hpp", "DeviceFault"), enumerators("srdo.hpp", "SrdoCause")
    summary = results.summarise(paths, places, lambda text: mechanism_name(text, faults, causes), FOLDER / "injection.csv.gz")
    return summary, image_description.functions_not_called(IMAGE.with_suffix(".txt"), elf, executed)


def write_table(record):
    names = results.CLASSES
    rows = [f"{'fault':10}{'injected':>10}{'effective':>10}" + "".join(f"{name:>17}" for name in names) + f"{'at most':>10}"]
    rows += [f"{row['fault']:10}{row['injected']:>10}{row['effective']:>10}" + "".join(f"{row[name]:>17}" for name in names)
             + f"{100 * row['bound']:>9.3g}%" for row in record["table"]]
    rows += ["at most: share of silent ones among the effective, 99 %, one-sided; of what is drawn alone (skips and inversions are all)",
             "", "Detected by (steps of 1 ms from the fault: median, 99.9 %, worst)"]
    rows += [f"  {row['fault']:9}{row['count']:>8}  {row['mechanism']}: {row['median']}, {row['most']}, {row['worst']}" for row in record["times"]]
    rows += ["", "Controls"] + [f"  {name}: {kind}{', ' if what else ''}{what}: {told}" for name, kind, what, told in record["controls"]]
    rows += ["", f"Never called by the script: {len(record['not_called'])} of {record['functions']} functions"]
    rows += ["", f"Survivors: {sum(row['count'] for row in record['survivors'])} in {len(record['survivors'])} rows, "
                 f"{record['behind_ideal_gate']} of them behind an ideal gate"]
    for row in record["survivors"]:
        rows.append(f"  {row['fault']:8} {row['count']:>5} x {row['function']} ({row['line']}): {row['what']} [{'; '.join(row['scenes'])}]")
        rows.append(f"           {row['mechanism']}: {row['reason']}" if row["reason"] else "           NO REASON")
    return "\n".join(rows) + "\n"


def self_test():
    """What a survivor without a reason or mechanism and a reason without a survivor come to; bounds of known numbers."""
    def survivor(function):
        return {"fault": "skip", "function": function, "line": "x.cpp:1", "what": "wrong data released"}
    reason = {"function": "F", "what": "wrong data released", "mechanism": "AU-20", "reason": "closed by the lockstep of the processor"}
    manual = {"AU-20": "Lockstep"}
    found = [judge_survivors([survivor("F")], [reason], manual, True), judge_survivors([survivor("G")], [reason], manual, False),
             judge_survivors([], [reason], manual, True), judge_survivors([], [reason], manual, False), judge_survivors([survivor("F")], [reason], {}, True)]
    bounds = [results.bound(0, 299, 0.95), results.bound(0, 4603, 0.99), results.bound(1, 100, 0.95), results.bound(0, 0)]
    good = [len(problems) for problems in found] == [0, 1, 1, 0, 1] and [round(value, 5) for value in bounds] == [0.00997, 0.001, 0.04656, 1.0]
    paces = [is_fast_enough(*each) for each in ((300, 1), (299, 1))]
    good = good and paces == [True, False]
    print(f"{'pass' if good else 'FAIL'}  fixture: a survivor without a reason, one without a mechanism, a reason without a survivor; four bounds; two paces")
    return good


def is_fast_enough(faults, processor_seconds):
    """Of one core; a fifth of what a slow machine does, so that no verdict depends on the machine. [SRS_VER_073]"""
    return faults >= LEAST_RATE * processor_seconds


def tells_a_mistake():
    """Whether it is told when what is known of a fault is not what a run anew comes to. [SRS_VER_347]"""
    told = subprocess.run([str(INJECTOR), f"{IMAGE}.bin", f"{IMAGE}.txt", "code=1", "sample=1", "shards=1", "mistaken=1"], capture_output=True, text=True, check=False)
    good = "run anew\t1 differ\t\tNOT TOLD" in told.stdout
    print(f"{'pass' if good else 'FAIL'}  fixture: a verdict that a run anew does not come to")
    return good


def refuses_misnamed():
    """Whether nothing is run when a step does not show what its scene is called."""
    told = subprocess.run([str(INJECTOR), f"{IMAGE}.bin", f"{IMAGE}.txt", "misnamed=5"], capture_output=True, text=True, check=False)
    good = told.returncode == 2 and "step 5 does not show" in told.stderr and told.stdout == ""
    print(f"{'pass' if good else 'FAIL'}  fixture: a step that does not show what its scene is called")
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
    parser.add_argument("--sample", type=int, default=0, metavar="N", help="of the skips and inversions so many are drawn (default: all)")
    parser.add_argument("--steps", type=int, nargs=2, default=(0, 0xFFFFFFFF), metavar=("FIRST", "LAST"), help="only faults that come in these cycles")
    parser.add_argument("--show", nargs=5, metavar=("STEP", "FAULT", "INSTRUCTION", "ADDRESS", "NUMBER"),
                        help="each step of one run, as a survivor's example in injection.json names it")
    for name, what in (("registers", "bits of registers"), ("opcodes", "bits of instructions, at one execution"),
                       ("flash", "bits of the code, from a step on"), ("memory", "bits of RAM"), ("stuck", "stuck bits of RAM")):
        parser.add_argument(f"--{name}", type=int, default=5000, metavar="N", help=f"so many {what} (default: 5000)")
    parser.add_argument("--all-memory", action="store_true", help="every bit of RAM of core, channels and port, before every step")
    parser.add_argument("--memory-of", metavar="PART", help=f"only of this part, NAME or NAME:BEGIN:END in bytes: {', '.join(image_description.MEMORY)}")
    parser.add_argument("--seed", type=int, default=1, help="of what is drawn (default: 1)")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), metavar="N", help="processes (default: one a core)")
    parser.add_argument("--no-build", action="store_true", help="use what was built before")
    arguments = parser.parse_args()
    numbers = [arguments.each, arguments.sample, arguments.seed, *(getattr(arguments, name) for name in DRAWN)]
    if min(numbers) < 0 or arguments.each == 1 or arguments.jobs < 1:
        parser.error("numbers are 0 or greater, --jobs at least 1, --each not 1")
    arguments.memory = 0xFFFFFFFF if arguments.all_memory else arguments.memory
    return arguments


def judge(arguments, paths, failures, is_tested, is_refused, is_mistake_told):
    """The record of injection.json."""
    summary, (not_called, functions) = summarise(paths)
    is_complete = arguments.code == "both" and arguments.each == arguments.sample == 0 and not arguments.code_of and arguments.steps == (0, 0xFFFFFFFF)
    reasons = json.loads((HERE / "reasons.json").read_text(encoding="utf-8"))
    survivors = list(summary.survivors.values())
    problems = judge_survivors(survivors, reasons, mechanisms_of_manual(), is_complete)
    controls = list(dict.fromkeys(tuple(line) for line in lines_of(paths, "control")))
    ends = list(lines_of(paths, "end"))
    total = sum(int(end[0]) for end in ends)
    processor = sum(float(end[2]) for end in ends)
    rate = round(total / processor) if processor else 0
    is_quick = is_fast_enough(total, processor)
    is_run = not failures and total > 0 and total == sum(sum(counts.values()) for counts in summary.classes.values())
    are_told = bool(controls) and all(control[3] == "told" for control in controls)
    never_run = image_description.functions_not_called(IMAGE.with_suffix(".txt"), f"{IMAGE}.elf", {})[0]
    scenes = list(dict.fromkeys(line[1] for line in lines_of(paths[:1], "golden")))
    passed = {"SRS_VER_040": is_run, "SRS_VER_041": is_run and is_tested and not problems, "SRS_VER_042": are_told,
              "SRS_VER_070": is_run and all(summary.classes[name[:-1] if name in ("registers", "opcodes") else name] for name in DRAWN
                                            if getattr(arguments, name)),
              "SRS_VER_071": is_run and SCENES <= set(scenes), "SRS_VER_072": is_run and not problems and not any(count for fault, count in summary.unsheltered.items() if fault not in results.LASTING), "SRS_VER_073": is_run and is_tested and is_quick,
              "SRS_VER_074": is_run and is_tested, "SRS_VER_210": is_refused, "SRS_VER_347": is_run and are_told and is_mistake_told,
              "SRS_VER_211": is_run and len(not_called) < functions and set(not_called) < set(never_run)}
    options = {"code": arguments.code, "each": arguments.each, "sample": arguments.sample, **{name: getattr(arguments, name) for name in DRAWN}}
    return {"faults": total, "processor_seconds": round(processor, 1), "faults_a_processor_second": rate, "seed": arguments.seed, "options": options,
            "scenes": scenes, "steps": sum(1 for _ in lines_of(paths[:1], "golden")),
            "table": summary.table(), "times": summary.times(), "silent": summary.silent_kinds, "controls": controls, "survivors": survivors,
            "behind_ideal_gate": sum(summary.unsheltered.values()), "not_called": not_called, "functions": functions, "problems": problems + failures,
            "mechanisms": mechanisms_of_manual(), "requirements": passed}


def main():
    arguments = parse()
    is_tested = self_test()
    if not arguments.no_build:
        build()
    image_description.describe(f"{IMAGE}.elf", IMAGE.with_suffix(".txt"), arguments.memory_of, arguments.code_of)
    is_refused = refuses_misnamed()
    is_mistake_told = tells_a_mistake()
    if arguments.show:
        return show(arguments)
    FOLDER.mkdir(parents=True, exist_ok=True)
    begun = time.monotonic()
    paths, failures = run_shards(arguments)
    seconds = time.monotonic() - begun
    record = judge(arguments, paths, failures, is_tested, is_refused, is_mistake_told)
    table = write_table(record)
    (FOLDER / "injection.json").write_text(json.dumps(record, indent=2) + "\n", encoding="utf-8")
    (FOLDER / "injection.txt").write_text(table, encoding="utf-8")
    for path in paths:
        path.unlink()
    print(table)
    for problem in record["problems"]:
        print(f"problem: {problem}")
    verdict = all(record["requirements"][name] for name in REQUIREMENTS)
    print(f"inject: {record['faults']} faults in {seconds:.0f} s, {record['faults_a_processor_second']} a second of one core, "
          f"{len(record['problems'])} problems; build/injection/injection.json: {'pass' if verdict else 'FAIL'}")
    return 0 if verdict else 1


if __name__ == "__main__":
    try:
        sys.exit(main())
    except (target_build.BadInput, OSError, ValueError, subprocess.SubprocessError) as problem:
        print(f"run.py: {problem}", file=sys.stderr)
        sys.exit(2)
