#!/usr/bin/env python3
"""Builds each mutant of mutants.json and shows that the tests kill it.

    python3 verification/mutation/run.py --build build/product            all mutants
    python3 verification/mutation/run.py --build build/product --only a_  those whose name begins so
    python3 verification/mutation/run.py --build build/product --self-test

A mutant is one exact replacement of text in a copy of a room. Only the room's changed sources are compiled, by the command
of the build tree (so with the room's own compiler), and linked before the room's library into the programs that judge it:
for the channels the probe (conformance cases, corrupted storage, differential run), for the comparator its tests.
Exit status: 0 every mutant is killed; 1 one survives, no longer fits the source or does not compile; 2 bad input.
"""
import argparse
import concurrent.futures
import json
import pathlib
import shutil
import sys
import tempfile
import time

from build_tree import BadInput, Build, progress, run_program

ROOT = pathlib.Path(__file__).resolve().parents[2]
HERE = "verification/mutation"
FIELDS = ("name", "room", "file", "find", "replace", "count", "meaning")
PROBE = f"{HERE}/counterpoint_mutation_probe"
COMPARATOR_PROBE = f"{HERE}/counterpoint_comparator_probe"
# Program, its arguments, and what it is called in the report.
JUDGES = {
    "channel_a": ((PROBE, (), "cases"), (PROBE, ("differential",), "differential")),
    "channel_b": ((PROBE, (), "cases"), (PROBE, ("differential",), "differential")),
    "safety_core_comparator": ((COMPARATOR_PROBE, ("--gtest_brief=1",), "tests"),),
}
PROCESSOR_LIMIT_S = 60
FEWEST = 7  # Of each room [SRS_CNF_020].


def read_mutants(path):
    try:
        mutants = json.loads(path.read_text(encoding="utf-8"))["mutants"]
    except (OSError, ValueError, KeyError, TypeError) as error:
        raise BadInput(f"{path}: {error}, expected an object with a list 'mutants'") from error
    for number, mutant in enumerate(mutants, start=1):
        for field in FIELDS:
            if field not in mutant:
                raise BadInput(f"{path}: mutant {number} has no '{field}', expected {', '.join(FIELDS)}")
        if mutant["room"] not in JUDGES:
            raise BadInput(f"{path}: mutant {mutant['name']}: room '{mutant['room']}', expected one of {', '.join(JUDGES)}")
    return mutants


def check_enough(mutants):
    for room in JUDGES:
        count = sum(1 for mutant in mutants if mutant["room"] == room)
        if count < FEWEST:
            raise BadInput(f"{room}: {count} mutants, expected at least {FEWEST}")


def mutate(mutant, work):
    """Copies the room and replaces the text. Returns the sources to compile as (original, copy)."""
    original = ROOT / mutant["file"]
    room = original.parent
    copy_of_room = work / room.relative_to(ROOT)
    shutil.copytree(room, copy_of_room)
    changed = work / mutant["file"]
    text = changed.read_text(encoding="utf-8")
    found = text.count(mutant["find"])
    if found != mutant["count"]:
        raise ValueError(f"{mutant['file']}: text occurs {found} times, expected {mutant['count']}")
    changed.write_text(text.replace(mutant["find"], mutant["replace"]), encoding="utf-8")
    if original.suffix == ".cpp":
        return [(original, changed)]
    return [(source, copy_of_room / source.name) for source in sorted(room.glob("*.cpp"))]


def judge(build, mutant):
    """One mutant from copy to verdict."""
    result = {"name": mutant["name"], "room": mutant["room"], "meaning": mutant["meaning"], "killed": False, "by": {}, "error": ""}
    with tempfile.TemporaryDirectory(prefix="mutant-") as folder:
        work = pathlib.Path(folder)
        try:
            sources = mutate(mutant, work)
        except (OSError, ValueError) as error:
            result["error"] = str(error)
            return result
        objects = {}
        for original, copy in sources:
            item, text = build.compile_mutated(original.resolve(), copy, work)
            if item is None:
                result["error"] = "does not compile: " + next((line for line in text.splitlines() if "error" in line), text)
                return result
            objects[original.resolve()] = item
        programs = {}
        for program, arguments, label in JUDGES[mutant["room"]]:
            if program not in programs:
                programs[program], text = build.link_mutated(program, objects, work)
                if programs[program] is None:
                    result["error"] = "does not link: " + text
                    return result
            killed, said = run_program(programs[program], arguments, PROCESSOR_LIMIT_S)
            if killed:
                result["by"][label] = said
        result["killed"] = bool(result["by"])
    return result


def check_unmutated(build):
    """What the real sources do not pass cannot judge a mutant."""
    for room, judges in JUDGES.items():
        for program, arguments, label in judges:
            killed, said = run_program(build.folder / program, arguments, PROCESSOR_LIMIT_S)
            if killed:
                raise BadInput(f"{room}: the sources themselves fail ({label}): {said}")


def run(build, mutants, jobs):
    results = [None] * len(mutants)
    with concurrent.futures.ThreadPoolExecutor(max_workers=jobs) as pool:
        futures = {pool.submit(judge, build, mutant): index for index, mutant in enumerate(mutants)}
        for done, future in enumerate(concurrent.futures.as_completed(futures), start=1):
            results[futures[future]] = future.result()
            progress(done, len(mutants))
    return results


def show(results):
    for result in results:
        if result["error"]:
            print(f"ERROR     {result['name']}: {result['error']}")
        elif result["killed"]:
            by = "; ".join(f"{label}: {said}" for label, said in result["by"].items())
            print(f"killed    {result['name']}  [{by}]")
        else:
            print(f"SURVIVED  {result['name']}: {result['meaning']}")


def self_test(build):
    """The run must fail on a mutant that changes nothing, one that does not fit, one that does not compile, and too few."""
    few = [{"room": room} for room in JUDGES for _ in range(FEWEST)][1:]
    try:
        check_enough(few)
        said = ""
    except BadInput as error:
        said = str(error)
    good = said == "channel_a: 6 mutants, expected at least 7"
    print(f"{'pass' if good else 'FAIL'}  too few mutants: {said or 'taken'}")
    for mutant, expected in zip(read_mutants(ROOT / HERE / "fixture" / "mutants.json"), ("survives", "occurs", "compile")):
        result = judge(build, mutant)
        if expected == "survives":
            held = not result["killed"] and not result["error"]
        else:
            held = expected in result["error"]
        print(f"{'pass' if held else 'FAIL'}  fixture {mutant['name']}: {result['error'] or ('killed' if result['killed'] else 'survived')}")
        good = good and held
    return 0 if good else 1


def main(arguments):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=pathlib.Path, required=True, help="configured build tree, by preference of preset product")
    parser.add_argument("--mutants", type=pathlib.Path, default=ROOT / HERE / "mutants.json")
    parser.add_argument("--only", default="", help="only mutants whose name begins with this")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--json", type=pathlib.Path, help="writes the report to this file")
    parser.add_argument("--self-test", action="store_true", help="shows that the run fails where it must")
    options = parser.parse_args(arguments)
    started = time.monotonic()
    try:
        mutants = [mutant for mutant in read_mutants(options.mutants) if mutant["name"].startswith(options.only)]
        if not mutants:
            raise BadInput(f"{options.mutants}: no mutant begins with '{options.only}'")
        if not options.only and options.mutants == ROOT / HERE / "mutants.json":
            check_enough(mutants)
        build = Build(options.build.resolve(), [PROBE, COMPARATOR_PROBE])
        if options.self_test:
            return self_test(build)
        check_unmutated(build)
        results = run(build, mutants, options.jobs)
    except BadInput as error:
        print(error, file=sys.stderr)
        return 2
    show(results)
    killed = sum(1 for result in results if result["killed"])
    errors = sum(1 for result in results if result["error"])
    passes = killed == len(results)
    print(f"{len(results)} mutants, {killed} killed, {len(results) - killed - errors} survived, {errors} errors, "
          f"{time.monotonic() - started:.0f} s: {'pass' if passes else 'FAIL'}")
    if options.json:
        options.json.write_text(json.dumps({"mutants": results, "pass": passes}, indent=1) + "\n", encoding="utf-8")
    return 0 if passes else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
