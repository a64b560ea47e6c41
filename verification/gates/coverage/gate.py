#!/usr/bin/env python3
"""Functions, lines, branches and MC/DC of the safety rooms at 100 %, and no source file without data.

Reads coverage/export.json (llvm-cov export), made by verification/coverage/measure.py from tests that name a requirement.
MC/DC is gated together with branches and functions: a decision of one condition is no MC/DC decision, and a function that
never ran has none.
"""
import json
import os
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from common import SAFETY_ROOMS, CannotLook, cpp_files, functions, read, run_gate  # noqa: E402

METRICS = ("functions", "lines", "branches", "mcdc")


def name_below(root, filename):
    """The file's path below the root, whatever link it was compiled through; None outside."""
    path = pathlib.Path(os.path.realpath(filename))
    return path.relative_to(root).as_posix() if path.is_relative_to(root) else None


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
    findings, seen = [], {}
    for entry in json.loads(export.read_text())["data"][0]["files"]:
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
    return findings, f"{len(seen)} files: {counts}"


run_gate(gate)
