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
PROGRAM = "verification/target/coverage/coverage_suite"
ROOMS = ("safety_core", "channel_a", "channel_b")
KINDS = ("functions", "lines", "branches", "mcdc")
# How often these go round follows from addresses and from the size of a pointer: what is reached is compared, not how often.
BY_ADDRESS = "safety_core/selftest/"


def build():
    target_build.build_preset("tms570-coverage", ["coverage_suite"], TARGET)
    target_build.build_preset("coverage", ["coverage_suite"])


def export(program, raw, folder):
    """What llvm-cov tells of each file of the safety rooms, by its place in the tree."""
    merged = raw.with_suffix(".profdata")
    target_build.run("llvm-profdata-19", "merge", "-sparse", raw, "-o", merged)
    sources = [path for room in ROOMS for path in [ROOT / room, *sorted((folder / "include").glob(f"*/{room}")),
                                                   *sorted((folder / "include").glob(f"*/{room}/*"))] if path.is_dir()]
    done = subprocess.run(["llvm-cov-19", "export", str(program), f"-instr-profile={merged}", "-sources", *map(str, sources)],
                          capture_output=True, text=True, check=True)
    files = {}
    for entry in json.loads(done.stdout)["data"][0]["files"]:
        name = pathlib.Path(os.path.realpath(entry["filename"])).relative_to(ROOT).as_posix()
        # One file comes once for each way that leads to it; they tell different instances.
        files.setdefault(name, []).append(entry)
    return files


def told(name, entries):
    """All that is compared: totals, execution counts by place, branches, decisions with their conditions."""
    once = name.startswith(BY_ADDRESS)
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


def differences(ours, theirs):
    return sorted(name for name in ours.keys() | theirs.keys()
                  if name not in ours or name not in theirs or told(name, ours[name]) != told(name, theirs[name]))


def changed(files):
    """The same with one execution count more: a fixture that the comparison has to refuse."""
    copy = json.loads(json.dumps(files))
    entry = next(entries[0] for name, entries in copy.items() if entries[0]["segments"] and not name.startswith(BY_ADDRESS))
    entry["segments"][0][2] += 1
    return copy


def check(report):
    """Runs both and compares; the totals of the target."""
    raw = {"target": TARGET / "target.profraw", "host": TARGET / "host.profraw"}
    for path in raw.values():
        path.unlink(missing_ok=True)
    run = emulator.run_image(TARGET / f"{PROGRAM}.bin", str(raw["target"].relative_to(ROOT)), 300, count_instructions=False, folder=ROOT)
    host = subprocess.run([HOST / PROGRAM], env=dict(os.environ, LLVM_PROFILE_FILE=str(raw["host"])), capture_output=True, text=True,
                          timeout=300, check=False)
    both_ran = run.status == 0 and host.returncode == 0 and run.output == host.stdout and all(path.is_file() for path in raw.values())
    last = (run.output.strip().splitlines() or ["no output"])[-1]
    report.add(both_ran, "instrumented suite on the target and on the host", last if both_ran else f"target {run.status}, host {host.returncode}: {last}",
               "SRS-FW-010")
    if not both_ran:
        return {}
    ours, theirs = export(TARGET / f"{PROGRAM}.elf", raw["target"], TARGET), export(HOST / PROGRAM, raw["host"], HOST)
    found = differences(ours, theirs)
    sums = totals(ours)
    text = ", ".join(f"{kind} {covered} of {count}" for kind, (covered, count) in sums.items())
    report.add(not found and len(ours) >= 30 and sums["mcdc"][1] > 100, "coverage of the target's objects, equal to the host's in every count",
               f"{len(ours)} files, {text}" if not found else f"different: {', '.join(found)}", "SRS-FW-010")
    report.add(len(differences(theirs, changed(theirs))) == 1, "one execution more on the host is refused", "1 file", "SRS-FW-010")
    return {"files": len(ours), **{kind: {"covered": covered, "count": count} for kind, (covered, count) in sums.items()}}
