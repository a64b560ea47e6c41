#!/usr/bin/env python3
"""Functions, lines, branches and MC/DC of the safety rooms at 100 %, and no source file without data. Beyond them each place that is not covered has a record.

Reads coverage/export.json (llvm-cov export), made by verification/coverage/measure.py from tests that name a requirement.
MC/DC is gated together with branches and functions: a decision of one condition is no MC/DC decision, and a function that
never ran has none.
Of hal, canopen and runtime, a place (a function, a condition, a region) that is not covered needs a record with its reason in
verification/coverage/gaps.json; a record whose place is covered or gone is refused as well. Rooms that are not yet there are
listed in that file with the number of their open places, which may not grow.
"""
import json
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "coverage"))
from common import SAFETY_ROOMS, CannotLook, cpp_files, functions, read, run_gate  # noqa: E402
from uncovered import name_below  # noqa: E402
from records import Coverage  # noqa: E402

METRICS = ("functions", "lines", "branches", "mcdc")


def uncovered_lines(segments):
    """First lines of regions that never ran."""
    return sorted({line for line, _, count, has_count, is_entry, *_ in segments if has_count and is_entry and count == 0})


def details(entry):
    """Where the gaps of one file are, one text each."""
    for line in uncovered_lines(entry["segments"])[:20]:
        yield line, "never ran"
    for record in entry.get("branches", []):
        line, column, _, _, true_count, false_count = record[:6]
        if true_count == 0 or false_count == 0:
            yield line, f"column {column}: never {'true' if true_count == 0 else 'false'}"
    for record in entry.get("mcdc_records", []):
        missing = [str(index + 1) for index, shown in enumerate(record[-1]) if not shown]
        if missing:
            yield record[0], f"MC/DC: no independence pair for condition {', '.join(missing)} of {len(record[-1])}"


def gate(root, data):
    export = data / "coverage/export.json"
    if not export.exists():
        raise CannotLook("coverage/export.json, made by verification/coverage/measure.py")
    measured = json.loads(export.read_text())
    findings, seen = [], {}
    for entry in measured["data"][0]["files"]:
        name = name_below(root, entry["filename"])
        if name is None or not any(name.startswith(room + "/") for room in SAFETY_ROOMS):
            continue
        seen[name] = entry
        summary = entry["summary"]
        gaps = [f"{metric} {summary[metric]['covered']} of {summary[metric]['count']}" for metric in METRICS
                if summary[metric]["covered"] != summary[metric]["count"]]
        if gaps:
            findings.append(f"{name}:1: {', '.join(gaps)}, expected all")
            findings += [f"{name}:{line}: {text}" for line, text in details(entry)]
    for name in cpp_files(root, SAFETY_ROOMS):
        if name not in seen and functions(read(root, name)):
            findings.append(f"{name}:1: the file defines functions and has no coverage data, expected it in a measured program")
    totals = {metric: sum(entry["summary"][metric]["count"] for entry in seen.values()) for metric in METRICS}
    for metric in METRICS:
        if totals[metric] == 0:
            findings.append(f"coverage/export.json:1: no {metric} at all in the safety rooms, expected some")
    counts = ", ".join(f"{totals[metric]} {metric}" for metric in METRICS)
    further = Coverage(root, measured)
    findings += further.findings
    gated = sum(room.is_gated for room in further.rooms.values())
    open_places = sum(len(room.open) for room in further.rooms.values() if not room.is_gated)
    return findings, (f"{len(seen)} files: {counts}; beyond the safety rooms {gated} of {len(further.rooms)} rooms gated, "
                      f"{len(further.records)} records of gaps, {open_places} open places elsewhere")


run_gate(gate)
