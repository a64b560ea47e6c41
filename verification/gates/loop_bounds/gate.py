#!/usr/bin/env python3
"""Every loop of core, channels and the contract of a port ends by what its head and body show: a range, a counter that moves to an end which does
not, the bits or slots of a mask that loses one each turn, or halvings."""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from common import cpp_files, read, run_gate  # noqa: E402
from loop_heads import ROOMS, loops_of  # noqa: E402


def gate(root, _data):
    found = [(name, loop) for name in cpp_files(root, ROOMS) for loop in loops_of(read(root, name))]
    findings = [f"{name}:{loop.line}: '{loop.keyword} ({loop.head})' has no bound, expected a range, a counter, bits of a mask or halvings"
                for name, loop in found if not loop.bound]
    return findings, f"{len(found)} loops"


run_gate(gate)
