#!/usr/bin/env python3
"""Deviations in the code (`// MISRA D-NNN`) and records (MISRA/deviations/D-NNN.md) match both ways, and each record says
what an assessor asks: guideline, where, why, what it risks, what is done instead."""
import pathlib
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from common import CannotLook, cpp_files, files, read, run_gate  # noqa: E402

FOLDERS = ["safety_core", "channel_a", "channel_b", "hal"]
HEADINGS = ["Guideline", "Where", "Reason", "Risk", "Mitigation", "Checks"]
MARKER = re.compile(r"MISRA (D-\w+)")


def categories(root):
    """Guideline -> category, from the plan."""
    plan = root / "MISRA/compliance_plan.md"
    if not plan.exists():
        raise CannotLook("MISRA/compliance_plan.md is not there")
    return dict(re.findall(r"^\| ((?:D )?\d+\.\d+\.\d+) \| (mandatory|required|advisory) \|", plan.read_text(), re.MULTILINE))


def record_findings(root, name, used_in, known):
    text = read(root, name)
    fields = dict(re.findall(r"^- \*\*(\w+)\*\*: *(\S.*)$", text, re.MULTILINE))
    for heading in HEADINGS:
        if heading not in fields:
            yield f"{name}:1: no line '- **{heading}**: ...', expected {', '.join(HEADINGS)}"
    guidelines = re.findall(r"(?:D )?\d+\.\d+\.\d+", fields.get("Guideline", ""))
    for guideline in guidelines:
        if guideline not in known:
            yield f"{name}:1: guideline {guideline} is not in MISRA/compliance_plan.md"
        elif known[guideline] == "mandatory":
            yield f"{name}:1: guideline {guideline} is mandatory, expected no deviation from it"
    if "Guideline" in fields and not guidelines:
        yield f"{name}:1: Guideline '{fields['Guideline']}', expected a number such as 8.2.5"
    places = re.split(r"[,\s]+", fields.get("Where", "").strip())
    for place in sorted(used_in):
        if "Where" in fields and not any(place == listed or place.startswith(listed + "/") for listed in places):
            yield f"{name}:1: the code names this deviation in {place}, expected Where to list it"
    for listed in places:
        if used_in and not any(place == listed or place.startswith(listed + "/") for place in used_in):
            yield f"{name}:1: Where lists {listed}, expected only files and folders whose code names this deviation"


def gate(root, _data):
    findings = []
    used = {}
    for name in cpp_files(root, FOLDERS):
        for number, line in enumerate(read(root, name).splitlines(), start=1):
            for identifier in MARKER.findall(line):
                used.setdefault(identifier, {}).setdefault(name, number)
    records = {pathlib.PurePosixPath(name).stem: name for name in files(root, "D-*.md", under=["MISRA/deviations"])}
    known = categories(root)
    for identifier, places in sorted(used.items()):
        if identifier not in records:
            name, number = next(iter(places.items()))
            findings.append(f"{name}:{number}: deviation {identifier}, expected a record MISRA/deviations/{identifier}.md")
    for identifier, name in sorted(records.items()):
        if identifier not in used:
            findings.append(f"{name}:1: no code names {identifier}, expected the record to be used or removed")
        findings += record_findings(root, name, used.get(identifier, {}), known)
    return findings, f"{len(used)} deviations in the code, {len(records)} records"


run_gate(gate)
