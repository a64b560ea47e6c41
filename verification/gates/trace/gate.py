#!/usr/bin/env python3
"""Every requirement is shown the way its VERIFICATION says, and nothing names a requirement that does not exist."""
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve()
sys.path.insert(0, str(HERE.parents[1]))
sys.path.insert(0, str(HERE.parents[2] / "trace"))
from common import CannotLook, run_gate  # noqa: E402
from matrix import repository_matrix  # noqa: E402


def gate(root, data):
    matrix = repository_matrix(root, data)
    if matrix.test_count == 0:
        raise CannotLook("no test that names a requirement in tests/*.xml")
    return sorted(set(matrix.problems)), f"{len(matrix.requirements)} requirements, {matrix.test_count} links from tests"


run_gate(gate)
