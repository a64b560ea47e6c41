#!/usr/bin/env python3
"""The list of the tests of the safety rooms, so that none is lost without a line of it being taken out.

    python3 verification/trace/safety_tests.py --write           writes verification/trace/safety_tests.txt from the last ./dev verify
    python3 verification/trace/safety_tests.py --try-removals    takes each test out of the reports, one at a time, and shows that this is told

A line is a test and the requirements that it shows: `FILE SUITE.TEST: ID ID ...`. A conformance case is a line for each channel.
Exit status: 0 written, or each removal is told; 1 one is not told; 2 there are no reports.
"""
import argparse
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve()
sys.path.insert(0, str(HERE.parents[1] / "gates"))
from common import CannotLook  # noqa: E402

ROOT = HERE.parents[2]
DATA = ROOT / "build/evidence/data"
LIST = "verification/trace/safety_tests.txt"
# Tests of what both channels and the core are, by hand or by a table of cases.
FOLDERS = ("tests/safety_core/", "tests/channel_a/", "tests/channel_b/", "verification/conformance/", "verification/differential/", "verification/two_cpu/")


def run_tests(root, data):
    """Test -> requirements that it names, of all that ran in the safety rooms."""
    from matrix import gtest_evidence
    found = {}
    for evidence in gtest_evidence(root, data):
        if evidence.path.startswith(FOLDERS):
            found.setdefault(f"{evidence.path} {evidence.name.split(': ', 1)[1]}", set()).add(evidence.uid)
    return found


def listed(root):
    """Test -> (line, requirements) of the list."""
    result = {}
    for number, line in enumerate((root / LIST).read_text(encoding="utf-8").splitlines(), start=1):
        test, _, uids = line.rpartition(": ")
        if test in result:
            raise CannotLook(f"{LIST}:{number}: {test} stands there twice")
        result[test] = (number, set(uids.split()))
    return result


def differences(wanted, found):
    """What the reports lack of the list, and the list of the reports."""
    problems = []
    for test, (number, uids) in wanted.items():
        place = f"{LIST}:{number}: {test}"
        if test not in found:
            problems.append(f"{place}: did not run, expected that it is there; if it is no longer wanted, its line is taken out")
        else:
            problems += [f"{place}: no longer names {uid}" for uid in sorted(uids - found[test])]
            problems += [f"{place}: names {uid}, too, expected it in the line" for uid in sorted(found[test] - uids)]
    problems += [f"{LIST}:1: {test} is not listed; verification/trace/safety_tests.py --write" for test in sorted(set(found) - set(wanted))]
    return problems


def untold_removals(wanted, found):
    """Tests that could be taken out of the reports without a word."""
    return [test for test in found if not differences(wanted, {name: uids for name, uids in found.items() if name != test})]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    chosen = parser.add_mutually_exclusive_group(required=True)
    chosen.add_argument("--write", action="store_true")
    chosen.add_argument("--try-removals", action="store_true")
    parser.add_argument("--data", type=pathlib.Path, default=DATA)
    arguments = parser.parse_args()
    found = run_tests(ROOT, arguments.data)
    if not found:
        print(f"{arguments.data}: no report of a test of the safety rooms, expected after ./dev verify", file=sys.stderr)
        return 2
    if arguments.write:
        lines = [f"{test}: {' '.join(sorted(uids))}\n" for test, uids in sorted(found.items())]
        (ROOT / LIST).write_text("".join(lines), encoding="utf-8")
        print(f"{LIST}: {len(lines)} tests")
        return 0
    untold = untold_removals(listed(ROOT), found)
    for test in untold:
        print(f"{test}: taken out, and nothing is told")
    print(f"{len(found)} tests taken out, one at a time: {len(found) - len(untold)} told")
    return 1 if untold else 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except CannotLook as problem:
        print(problem, file=sys.stderr)
        sys.exit(2)
