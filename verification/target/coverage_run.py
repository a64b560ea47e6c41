"""MC/DC, branch and line coverage of the same program on the target's objects and on the host: both must agree."""
import json
import os
import pathlib
import subprocess

import emulator
import target_build

ROOT = pathlib.Path(__file__).resolve().parents[2]
TARGET = ROOT / "build/target-coverage"
HOST = ROOT / "build/coverage"
# Cases and sequences with the bench's devices; where `--tests` asks for them, the tests of core, link and self tests, and
# corrupted storage of the channels.
SUITE = "verification/target/coverage/coverage_suite"
TESTS = "verification/target/gtest/coverage_tests"
SELF_TESTS = "verification/target/gtest/coverage_self_tests"
FLIPS = "verification/target/coverage/coverage_flips"
# How often something is reached follows from addresses and from how storage lies in memory: whether it is reached is compared.
BY_LAYOUT = (SELF_TESTS, FLIPS)
ROOMS = ("safety_core", "channel_a", "channel_b")
# A busy machine emulates slowly.
SECONDS = 1500
KINDS = ("functions", "lines", "branches", "mcdc")
# How often these go round follows from addresses and from the size of a pointer: what is reached is compared, not how often.
BY_ADDRESS = "safety_core/selftest/"


def build(programs):
    names = [pathlib.Path(program).name for program in programs]
    target_build.build_preset("tms570-coverage", names, TARGET)
    target_build.build_preset("coverage", names)


def export(programs, profiles, folder):
    """What llvm-cov tells of each file of the safety rooms, by its place in the tree."""
    merged = profiles[0].with_suffix(".profdata")
    target_build.run("llvm-profdata-19", "merge", "-sparse", *profiles, "-o", merged)
    objects = [str(programs[0])] + [word for program in programs[1:] for word in ("-object", str(program))]
    sources = [path for room in ROOMS for path in [ROOT / room, *sorted((folder / "include").glob(f"*/{room}")),
                                                   *sorted((folder / "include").glob(f"*/{room}/*"))] if path.is_dir()]
    done = subprocess.run(["llvm-cov-19", "export", *objects, f"-instr-profile={merged}", "-sources", *map(str, sources)],
                          capture_output=True, text=True, check=True)
    files = {}
    for entry in json.loads(done.stdout)["data"][0]["files"]:
        name = pathlib.Path(os.path.realpath(entry["filename"])).relative_to(ROOT).as_posix()
        # One file comes once for each way that leads to it; they tell different instances.
        files.setdefault(name, []).append(entry)
    return files


def told(name, entries, reached_only):
    """All that is compared: totals, execution counts by place, branches, decisions with their conditions."""
    once = reached_only or name.startswith(BY_ADDRESS)
    rows = []
    for entry in entries:
        segments = [] if once else entry["segments"]
        branches = [[*part[:4], *(min(count, 1) if once else count for count in part[4:6]), *part[6:]] for part in entry["branches"]]
        rows.append(json.dumps([[entry["summary"][kind] for kind in KINDS], segments, branches, entry["mcdc_records"]]))
    return sorted(rows)


def totals(files):
    sums = {kind: [0, 0] for kind in KINDS}
    for entries in files.values():
        for entry in entries:
            for kind in KINDS:
                sums[kind][0] += entry["summary"][kind]["covered"]
                sums[kind][1] += entry["summary"][kind]["count"]
    return sums


def differences(ours, theirs, reached_only=False, left_out="-"):
    return sorted(name for name in ours.keys() | theirs.keys()
                  if not name.startswith(left_out) and (name not in ours or name not in theirs or told(name, ours[name], reached_only) != told(name, theirs[name], reached_only)))


def unreached(files):
    """Conditions of decisions without an independence pair: the place and which of how many."""
    return [f"{name}:{record[0]}: condition {number + 1} of {len(record[-1])}" for name, entries in sorted(files.items()) for entry in entries
            for record in entry["mcdc_records"] for number, shown in enumerate(record[-1]) if not shown]


def changed(files):
    """The same with one execution count more: a fixture that the comparison has to refuse."""
    copy = json.loads(json.dumps(files))
    entry = next(entries[0] for name, entries in copy.items() if entries[0]["segments"] and not name.startswith(BY_ADDRESS))
    entry["segments"][0][2] += 1
    return copy


def run_both(report, program):
    """Runs one program on both; its two profiles, or None."""
    name = pathlib.Path(program).name
    raw = [TARGET / f"{name}-{side}.profraw" for side in ("target", "host")]
    for path in raw:
        path.unlink(missing_ok=True)
    run = emulator.run_image(TARGET / f"{program}.bin", str(raw[0].relative_to(ROOT)), SECONDS, count_instructions=False, folder=ROOT)
    host = subprocess.run([HOST / program], env=dict(os.environ, LLVM_PROFILE_FILE=str(raw[1])), capture_output=True, text=True,
                          timeout=SECONDS, check=False)
    both_ran = run.status == 0 and host.returncode == 0 and run.output == host.stdout and all(path.is_file() for path in raw)
    last = (run.output.strip().splitlines() or ["no output"])[-1]
    for line in [line for line in (run.output + host.stdout).splitlines() if line.startswith(("failed:", "FAILURE"))][:5]:
        print(f"      {line}")
    report.add(both_ran, f"{name} instrumented, on the target and on the host", last if both_ran else f"target {run.status}, host {host.returncode}: {last}",
               "SRS_FW_010")
    return raw if both_ran else None


def compare(report, programs, profiles, what, reached_only, left_out="-"):
    """Coverage of the programs together, on the target; both must agree, but in files whose name begins with `left_out`."""
    ours = export([TARGET / f"{program}.elf" for program in programs], [pair[0] for pair in profiles], TARGET)
    theirs = export([HOST / program for program in programs], [pair[1] for pair in profiles], HOST)
    found = differences(ours, theirs, reached_only, left_out)
    sums = totals(ours)
    text = ", ".join(f"{kind} {covered} of {count}" for kind, (covered, count) in sums.items())
    report.add(not found and len(ours) >= 30 and sums["mcdc"][1] > 100, f"coverage of the target's objects, {what}",
               f"{len(ours)} files, {text}" if not found else f"different: {', '.join(found)}", "SRS_FW_010")
    return ours, theirs


def check_fixtures(report, ours, theirs):
    """A count, and a condition, that is another on the host."""
    report.add(len(differences(theirs, changed(theirs))) == 1, "one execution more on the host is refused", "1 file", "SRS_FW_010")
    copy = json.loads(json.dumps(ours))
    record = next(record for entries in copy.values() for entry in entries for record in entry["mcdc_records"] if all(record[-1]))
    record[-1][0] = False
    report.add(len(unreached(copy)) == len(unreached(ours)) + 1 and len(differences(ours, copy, True)) == 1,
               "one condition less on the host is refused, and told", "1 condition", "SRS_FW_010")


def check(report, programs):
    """Runs the programs on both and compares; the totals of the target, and each condition that it does not show."""
    profiles = [run_both(report, program) for program in programs]
    if None in profiles:
        return {}
    exact = [number for number, program in enumerate(programs) if program not in BY_LAYOUT]
    # What self tests reach by the way follows from addresses; with their own tests it is compared below.
    ours, theirs = compare(report, [programs[number] for number in exact], [profiles[number] for number in exact], "equal to the host's in every count", False,
                           BY_ADDRESS if len(exact) < len(programs) else "-")
    check_fixtures(report, ours, theirs)
    if len(exact) < len(programs):
        ours, _ = compare(report, programs, profiles, "with self tests and corrupted storage, reaches what it reaches on the host", True)
        left = unreached(ours)
        for line in left:
            print(f"      not shown on the target: {line}")
        report.add(not left, "conditions of decisions that the target does not show", f"{len(left)}", "SRS_FW_010")
    sums = totals(ours)
    return {"files": len(ours), "unreached": unreached(ours), **{kind: {"covered": covered, "count": count} for kind, (covered, count) in sums.items()}}
