#!/usr/bin/env python3
"""What the kernel costs, against limits: item | measured | aim | must | verdict.

    bench.py [--limit ID=VALUE ...] [--from FILE]

Builds the product objects (preset `product`) and the target's, counts instructions with callgrind and on the emulated
processor, adds up bytes; no item is a time. Result: build/bench/bench.json.
  --limit ID=VALUE  judge this item by another limit
  --from FILE       judge the measurements of an earlier run again
Each run also judges its measurements by a limit that cannot be kept and fails when that passes.
Exit status: 0 every limit is kept, 1 one is not, 2 it could not be measured.
"""
import argparse
import concurrent.futures
import json
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "verification/target"), str(ROOT / "verification/bench")]
import callgrind_dumps  # noqa: E402
import emulator  # noqa: E402
import firmware_budget  # noqa: E402
import objects  # noqa: E402
import services  # noqa: E402
import target_build  # noqa: E402

RESULTS = ROOT / "build/bench"
SCENARIO = ROOT / "verification/bench/long_run.yaml"
HALF = ROOT / "verification/bench/long_run_half.yaml"
# What the bench does itself, its driver, output and application among it, is not of the product.
IS_BENCH = re.compile("counterpoint::bench::")
TARGET_LINE = re.compile(r"item=(\w+) srdos=(\d+) repetitions=(\d+) instructions=(\d+)")
RAM_LINE = re.compile(r"ram=(\w+) bytes=(\d+)")
# How often Begin and End of the meter are called in one repetition of an item; what they count of themselves is taken off.
BRACKETS = {"nothing": 1, "idle": 1, "pair": 3, "check": 1, "idle_producers": 1, "send": 5}
SELF_TESTS = {"selftest_signature": "signature, 24 words", "selftest_constants": "signature, end of a pass",
              "selftest_ram": "RAM, 4 words", "selftest_lines": "RAM, one address line", "selftest_permits": "permits, one set"}
# Rooms whose bytes are shown but are not those of core and channels.
APART = ("hal/api", "safety_core/selftest", "safety_core/crosslink")
LOAD_CYCLES = 1000
COUNTS = (1, 8, 64)
# Mappings by the suffix of their items: objects of one side x bits.
SHAPES = {"1x8": "_1x8", "1x32": "_1x32", "2x32": "", "4x16": "_4x16", "8x8": "_8x8"}


class BadInput(Exception):
    """It could not be measured; the text says why."""


def run(*command, **options):
    done = subprocess.run([str(part) for part in command], cwd=ROOT, capture_output=True, text=True, check=False, **options)
    if done.returncode != 0:
        tail = "\n".join((done.stdout + done.stderr).splitlines()[-30:])
        raise BadInput(f"{' '.join(map(str, command))}: exit status {done.returncode}\n{tail}")
    return done.stdout


def sums_on_host(program):
    """(item, srdos) -> (repetitions, instructions) of the product's functions, from callgrind's dumps."""
    for old in RESULTS.glob("callgrind.out*"):
        old.unlink()
    run("valgrind", "--tool=callgrind", "--collect-atstart=no", f"--callgrind-out-file={RESULTS}/callgrind.out", program)
    sums = {}
    for path in RESULTS.glob("callgrind.out.*"):
        label, repetitions, costs_by_function = callgrind_dumps.own_costs(path)
        if label:
            sums[label] = (repetitions, sum(cost for name, cost in costs_by_function.items() if not IS_BENCH.match(name)))
    return sums


def sums_on_target(binary):
    """The same from the emulated processor, with bytes of RAM by part and the stack that was used."""
    result = emulator.run_image(binary, seconds=1800)
    if result.status != 0:
        raise BadInput(f"{binary}: exit status {result.status} on the emulator\n{result.output}")
    sums = {(item, int(srdos)): (int(repetitions), int(total))
            for item, srdos, repetitions, total in TARGET_LINE.findall(result.output)}
    ram = {part: int(size) for part, size in RAM_LINE.findall(result.output)}
    stack = re.search(r"stack_used=(\d+)", result.output)
    return sums, ram, int(stack.group(1))


def costs(sums):
    """Instructions by item and number of SRDOs, without those of the meter."""
    if ("nothing", 0) not in sums:
        raise BadInput("no measurement of the meter itself, expected item=nothing")
    repetitions, total = sums[("nothing", 0)]
    bracket = total / repetitions
    once = {}
    for (item, srdos), (repetitions, total) in sums.items():
        kind = re.sub(r"_\dx\d+$", "", item)
        if kind in BRACKETS:
            once[(item, srdos)] = total / repetitions - BRACKETS[kind] * bracket
    result = {"idle": {}, "pair": {}, "send": {}, "check": {}, "idle_cycle": {}}
    for srdos in COUNTS:
        idle, idle_producers = once[("idle", srdos)], once[("idle_producers", srdos)]
        result["idle_cycle"][srdos] = idle
        result["idle"][srdos] = idle / srdos
        # What a pair adds to a cycle that would have come anyway.
        result["pair"][srdos] = once[("pair", srdos)] - idle
        result["send"][srdos] = once[("send", srdos)] - 2 * idle_producers
        result["check"][srdos] = once[("check", srdos)]
    result["shapes"] = {}
    for shape, suffix in SHAPES.items():
        idle, idle_producers = once[("idle" + suffix, 64)], once[("idle_producers" + suffix, 64)]
        result["shapes"][shape] = {"pair": once[("pair" + suffix, 64)] - idle, "send": once[("send" + suffix, 64)] - 2 * idle_producers,
                                   "check": once[("check" + suffix, 64)], "idle": idle / 64}
    result["selftest"] = {}
    for item in SELF_TESTS:
        repetitions, total = sums[(item, 1)]
        result["selftest"][item] = total / repetitions - bracket
    pairs, total = sums[("full_load", 64)]
    result["load"] = total - (2 * pairs + LOAD_CYCLES) * bracket
    return result


def growth(by_item):
    """Greatest ratio of a cost per SRDO to that of the next smaller number of SRDOs."""
    ratios = {}
    for item in ("idle", "pair", "send", "check"):
        row = by_item[item]
        for small, large in zip(COUNTS, COUNTS[1:]):
            ratios[f"{item} {small} to {large}"] = row[large] / row[small]
    return ratios


def instructions_of(name, *command):
    """Instructions that a whole program executes, counted by callgrind: the same on a fast and on a slow machine."""
    out = RESULTS / f"callgrind_whole.{name}"
    done = subprocess.run(["valgrind", "--tool=callgrind", f"--callgrind-out-file={out}", *map(str, command)], cwd=ROOT, capture_output=True, text=True, check=False)
    counted = re.search(r"Collected : (\d+)", done.stderr)
    if done.returncode != 0 or counted is None:
        raise BadInput(f"{' '.join(map(str, command))}: exit status {done.returncode}, expected a count of callgrind\n{done.stderr[-2000:]}")
    return int(counted.group(1))


def instructions_a_simulated_second(tool):
    """Of the simulator: what SCENARIO takes beyond half of it, by the simulated seconds between the two; start-up is in both. [SRS_BEN_008]"""
    text = SCENARIO.read_text(encoding="utf-8")
    seconds = int(re.search(r"^duration: (\d+) s$", text, re.MULTILINE).group(1))
    whole, half = (instructions_of(path.stem, tool, "simulate", path, "--quiet") for path in (SCENARIO, HALF))
    return 2 * (whole - half) / seconds


def instructions_a_monitored_frame(tool):
    """Of the monitor, from recordings of SCENARIO and HALF. [SRS_MON_012]"""
    chain = ROOT / "examples/emergency_stop"
    devices = [word for name in ("sensor", "controller", "actuator") for word in ("--dcf", chain / f"{name}.dcf")]
    frames, costs = [], []
    for scenario in (SCENARIO, HALF):
        recording = RESULTS / f"{scenario.stem}.log"
        run(tool, "simulate", scenario, "--quiet", "--candump", recording)
        frames.append(len(recording.read_text(encoding="utf-8").splitlines()))
        costs.append(instructions_of(f"monitor_{scenario.stem}", tool, "monitor", recording, *devices, "--json"))
    return (costs[0] - costs[1]) / (frames[0] - frames[1])


def instructions_of_demo(tool):
    """Of the demonstration with its page. [SRS_DEMO_004]"""
    return instructions_of("demo", tool, "demo", "--html", RESULTS / "demo.html")


def objects_of_demo(build):
    """How many objects the build of the demonstration compiles from nothing. [SRS_BEN_014]"""
    commands = run("ninja", "-C", build, "-t", "commands", "counterpoint_demo").splitlines()
    return sum(1 for command in commands if " -c " in command)


def measure():
    RESULTS.mkdir(parents=True, exist_ok=True)
    product = ROOT / "build/product"
    target_build.build_preset("product", ["bench", "bench_mix", "counterpoint", *target_build.CERTIFIED_TARGETS])
    target = target_build.build_target(ROOT / "build/target", "-O2",
                                       ["bench_whole", *firmware_budget.TARGETS, *target_build.CERTIFIED_TARGETS])
    small = target_build.build_target(ROOT / "build/target-small", "-Os", [*target_build.CERTIFIED_TARGETS, *services.TARGETS])
    host = costs(sums_on_host(product / "verification/bench/bench"))
    sums, ram, stack = sums_on_target(target / "verification/target/bench/bench.bin")
    on_target = costs(sums)
    small_sizes = objects.sizes(small, "arm-none-eabi-")
    digest, count = objects.digest(product)
    target_digest, target_count = objects.digest(target)
    around = services.measure(product, target, small, RESULTS)
    with concurrent.futures.ThreadPoolExecutor(max_workers=2) as pool:
        tool = product / "tools/counterpoint"
        whole = {"simulation": instructions_a_simulated_second, "monitored": instructions_a_monitored_frame, "demo": instructions_of_demo}
        # The longest first, beside the others.
        waiting = {name: pool.submit(whole[name], tool) for name in ("demo", "simulation", "monitored")}
        whole = {name: each.result() for name, each in waiting.items()}
    ratios = growth(host)
    budget, firmware = firmware_budget.measure(target)
    return {
        "firmware": firmware, "host": host, "target": on_target, "ram": ram, "stack_used_bytes": stack, "small_sizes": small_sizes,
        "services": around,
        "growth": ratios,
        "digest": {"product": digest, "product_objects": count, "target": target_digest, "target_objects": target_count},
        "measured": {
            **{f"{item}_{shape}": row[item] for shape, row in host["shapes"].items() for item in ("pair", "send", "check")},
            "idle": max(row["idle"] for row in host["shapes"].values()),
            "fixed": host["idle_cycle"][1], "fixed_target": on_target["idle_cycle"][1],
            "ram": sum(ram.values()) / 64,
            # Core and both channels; the hardware layer is the device's, and rooms that it may leave out are counted apart.
            "code": sum(row["text"] + row["rodata"] + row["data"] for room, row in small_sizes.items() if room not in APART),
            "selftest": max(host["selftest"].values()), "load": on_target["load"], "services": around["load"],
            **whole, "demo_build": objects_of_demo(product), "linear": max(ratios.values()), **budget,
        },
    }


def judge(measured, limits):
    """Rows of the table; the last column is true where the limit is kept."""
    rows = []
    for item in limits:
        if item["id"] not in measured:
            raise BadInput(f"no measurement of '{item['id']}', expected one for each item of limits.json")
        value = measured[item["id"]]
        kept = value <= item["must"]
        aimed = value <= item["aim"]
        rows.append({**item, "measured": value, "kept": kept, "verdict": "aim" if kept and aimed else "must" if kept else "BROKEN"})
    return rows


def judge_known_gaps(rows, path):
    """Marks broken limits that are recorded with a reason and are no worse than recorded. [SRS_BEN_011]"""
    gaps = {gap["id"]: gap for gap in json.loads(path.read_text(encoding="utf-8"))["gaps"]}
    for row in rows:
        gap = gaps.get(row["requirement"])
        if row["kept"] or gap is None:
            continue
        if not gap.get("reason"):
            raise BadInput(f"{path}: {row['requirement']} has no reason, expected why its limit is not kept")
        bounds = gap.get("no_worse_than")
        if not isinstance(bounds, dict):
            raise BadInput(f"{path}: {row['requirement']} has no no_worse_than, expected for each broken item the value that may not get worse")
        if row["id"] not in bounds:
            continue
        worse = row["measured"] > bounds[row["id"]]
        row["verdict"] = "WORSE" if worse else "KNOWN GAP"
        row["known"] = not worse


def shown(value):
    return f"{value:.2f}" if value < 10 else f"{value:.0f}"


def print_table(rows, result):
    print(f"{'item':52} {'measured':>10} {'aim':>10} {'must':>10}  {'unit':14} verdict")
    for row in rows:
        print(f"{row['text']:52} {shown(row['measured']):>10} {'<=' + shown(row['aim']):>10} {'<=' + shown(row['must']):>10}"
              f"  {row['unit']:14} {row['verdict']}")
    print()
    print(f"{'instructions (host | target)':42} {'1 SRDO':>15} {'8 SRDOs':>15} {'64 SRDOs':>15}")
    names = {"idle_cycle": "idle cycle of n consumers", "idle": "idle cycle, per consumer", "pair": "receive and release one pair",
             "send": "send one pair", "check": "check one signature, both channels"}
    for item, text in names.items():
        cells = [f"{result['host'][item][srdos]:7.0f} |{result['target'][item][srdos]:6.0f}" for srdos in map(str, COUNTS)]
        print(f"{text:42} {cells[0]:>15} {cells[1]:>15} {cells[2]:>15}")
    print(f"\n{'instructions by mapping, 64 SRDOs':42} " + " ".join(f"{shape:>15}" for shape in SHAPES))
    for item, text in (("pair", names["pair"]), ("send", names["send"]), ("check", names["check"]), ("idle", names["idle"])):
        cells = [f"{result['host']['shapes'][shape][item]:7.0f} |{result['target']['shapes'][shape][item]:6.0f}" for shape in SHAPES]
        print(f"{text:42} " + " ".join(f"{cell:>15}" for cell in cells))
    print("self tests in a cycle with (host | target): " + ", ".join(
        f"{text} {result['host']['selftest'][item]:.0f} | {result['target']['selftest'][item]:.0f}" for item, text in SELF_TESTS.items()))
    print()
    print("RAM on the target, 64 SRDOs: " + ", ".join(f"{part} {size} B" for part, size in result["ram"].items()))
    print("-Os, text + rodata: " + ", ".join(f"{room} {row['text'] + row['rodata']} B" for room, row in
                                             result["small_sizes"].items()))
    firmware_budget.show(result["firmware"])
    print()
    services.print_costs(result["services"])
    print(f"objects measured: host {result['digest']['product']}, target {result['digest']['target']}")


def limits_of(arguments):
    limits = json.loads((ROOT / "verification/bench/limits.json").read_text(encoding="utf-8"))["items"]
    for change in arguments.limit:
        name, equals, value = change.partition("=")
        found = [item for item in limits if item["id"] == name]
        if not equals or not found or not re.fullmatch(r"\d+(\.\d+)?", value):
            known = ", ".join(item["id"] for item in limits)
            raise BadInput(f"--limit {change}: expected ID=NUMBER with ID one of {known}")
        found[0]["must"] = float(value)
    return limits


def bites(path):
    """Whether each limit fails when it is one that cannot be kept; the fixture of this gate. [SRS_BEN_010]"""
    limits = json.loads((ROOT / "verification/bench/limits.json").read_text(encoding="utf-8"))["items"]
    for item in limits:
        done = subprocess.run([sys.executable, __file__, "--from", str(path), "--limit", f"{item['id']}=0"],
                              capture_output=True, text=True, check=False)
        if done.returncode != 1 or f"bench.py: limit broken: {item['text']}" not in done.stderr:
            print(f"bench.py: a broken limit of '{item['id']}' was not found", file=sys.stderr)
            return False
    return True


def gaps_bite(path, rows):
    """Whether a recorded gap lets an equal value pass; a worse one, one that is not recorded and one without a reason not. [SRS_BEN_011]"""
    row = rows[0]
    fixture = RESULTS / "fixture_known_gaps.json"
    for factor, reason, status in ((1.0, "fixture", 0), (0.5, "fixture", 1), (None, "fixture", 1), (1.0, "", 2)):
        bounds = {}
        for each in rows:
            if each is not row or factor is not None:
                bounds.setdefault(each["requirement"], {})[each["id"]] = each["measured"] * (factor if each is row else 1.0)
        gaps = [{"id": uid, "reason": reason, "no_worse_than": items} for uid, items in bounds.items()]
        fixture.write_text(json.dumps({"gaps": gaps}), encoding="utf-8")
        done = subprocess.run([sys.executable, __file__, "--from", str(path), "--limit", f"{row['id']}=0", "--known-gaps", str(fixture)],
                              capture_output=True, text=True, check=False)
        if done.returncode != status:
            print(f"bench.py: known gaps: exit status {done.returncode}, expected {status}", file=sys.stderr)
            return False
    return True


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--limit", action="append", default=[], metavar="ID=VALUE")
    parser.add_argument("--known-gaps", type=pathlib.Path, metavar="FILE",
                        help="a broken limit that FILE records, and that is no worse than recorded, does not fail the run")
    parser.add_argument("--from", dest="earlier", type=pathlib.Path)
    arguments = parser.parse_args()
    limits = limits_of(arguments)
    if arguments.earlier:
        result = json.loads(arguments.earlier.read_text(encoding="utf-8"))
    else:
        # Through JSON, so that a later --from sees the same.
        result = json.loads(json.dumps(measure()))
    rows = judge(result["measured"], limits)
    if arguments.known_gaps:
        judge_known_gaps(rows, arguments.known_gaps)
    print_table(rows, result)
    broken = [row for row in rows if not row["kept"]]
    for row in broken:
        print(f"bench.py: limit broken: {row['text']}: {shown(row['measured'])} {row['unit']}, must be "
              f"at most {shown(row['must'])}", file=sys.stderr)
    unknown = [row for row in broken if not row.get("known")]
    if arguments.earlier:
        return 1 if unknown else 0
    path = RESULTS / "bench.json"
    path.write_text(json.dumps({**result, "rows": rows}, indent=2) + "\n", encoding="utf-8")
    bite = bites(path)
    ratchet = gaps_bite(path, rows)
    counted = result["services"]["bites"]
    rooms = firmware_budget.are_rooms_told(result["firmware"]["rooms"])
    result["requirements"] = {row["requirement"]: all(other["kept"] for other in rows if other["requirement"] == row["requirement"])
                              for row in rows} | {
        "SRS_FW_015": rooms, "SRS_BEN_010": bite, "SRS_BEN_011": ratchet, "SRS_BEN_013": counted}
    path.write_text(json.dumps({**result, "rows": rows, "passed": not broken and bite and ratchet and counted and rooms}, indent=2) + "\n",
                    encoding="utf-8")
    print(f"limits that cannot be kept were found broken: {'yes' if bite else 'NO'}")
    print(f"a gap that got worse, that nobody recorded or that has no reason was found: {'yes' if ratchet else 'NO'}")
    print(f"a source file without a service was found: {'yes' if counted else 'NO'}")
    return 0 if not unknown and bite and ratchet and counted and rooms else 1


if __name__ == "__main__":
    try:
        sys.exit(main())
    except (BadInput, firmware_budget.BadInput, objects.BadInput, services.BadInput, target_build.BadInput, OSError) as problem:
        print(f"bench.py: {problem}", file=sys.stderr)
        sys.exit(2)
