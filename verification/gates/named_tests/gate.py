#!/usr/bin/env python3
"""Every test that the reference table names exists: `Suite.Name`, the bare names behind "both:", checks of the emulated PC, gates. Each row of
its tables names one, or says `-`."""
import pathlib
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from common import TEST_CASE, CannotLook, files, read, run_gate  # noqa: E402

TABLE = "docs/reference_table.md"
CONFORMANCE = re.compile(r"\bMakeCase\(\s*\"(\w+)\"")
PLACES = ("tests", "verification")
QUOTED = re.compile(r"`([^`]+)`")


def known(root):
    """Names of cases with and without their suite, of checks and of gates, of folders of tests and of test programs."""
    names = set()
    for name in files(root, under=PLACES):
        parts = pathlib.PurePosixPath(name)
        if parts.suffix == ".cpp":
            names |= set(CONFORMANCE.findall(read(root, name)))
            for suite, case in TEST_CASE.findall(read(root, name)):
                names |= {case, f"{suite}.{case}", f"{suite.rstrip('_')}.{case}"}
        names |= {parts.stem, parts.parent.as_posix(), parts.parent.name}
    return names


def gate(root, _data):
    if not (root / TABLE).is_file():
        raise CannotLook(TABLE)
    names = known(root)
    findings, rows, told, head = [], 0, 0, []
    for number, line in enumerate(read(root, TABLE).splitlines(), start=1):
        cells = [cell.strip() for cell in re.split(r"(?<!\\)\|", line)[1:-1]]
        if not cells or cells[0].startswith("---"):
            continue
        if cells[0] in ("Reference", "Option"):
            head = cells
            continue
        if not any(word in ("Test", "Option on") for word in head):
            continue
        rows += 1
        cell = " ".join(cells[2:])
        quoted = [word for word in QUOTED.findall(cell) if word != "./dev vm"]
        told += len(quoted)
        findings += [f"{TABLE}:{number}: there is no test '{word}', expected one of that name" for word in quoted if word not in names]
        folders = re.findall(r"\b(?:tests|canopen|tools)/[\w/]+|\bthe same\b", cell)
        if not quoted and not folders and cell != "-":
            findings.append(f"{TABLE}:{number}: the row names no test, expected one, or -")
    return findings, f"{rows} rows, {told} names of tests"


run_gate(gate)
