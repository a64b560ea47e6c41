#!/usr/bin/env python3
"""No test of the safety rooms is lost: those of verification/trace/safety_tests.txt ran and show the requirements of their line, and there is no
other one. Each of them is taken out of the reports in turn, which has to be told."""
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve()
sys.path[:0] = [str(HERE.parents[1]), str(HERE.parents[2] / "trace")]
from common import CannotLook, run_gate  # noqa: E402
from safety_tests import LIST, differences, listed, run_tests, untold_removals  # noqa: E402


def gate(root, data):
    found = run_tests(root, data)
    if not found or not (root / LIST).is_file():
        raise CannotLook(f"{LIST} and reports of tests of the safety rooms in tests/*.xml")
    findings = differences(listed(root), found)
    if not findings:
        findings = [f"{LIST}:1: {test} taken out of the reports is not told" for test in untold_removals(listed(root), found)]
    return findings, f"{len(found)} tests, each taken out in turn"


run_gate(gate)
