#!/usr/bin/env python3
"""Every GoogleTest case names a requirement, ran and passed: coverage figures come from requirements alone."""
import pathlib
import re
import sys
import xml.etree.ElementTree as ElementTree

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from common import CannotLook, files, read, run_gate  # noqa: E402


def gate(root, data):
    xml_files = sorted(data.glob("tests/*.xml")) + sorted(data.glob("coverage/tests/*.xml"))
    if not xml_files:
        raise CannotLook("tests/*.xml and coverage/tests/*.xml, GoogleTest's reports")
    headers = files(root, "*.hpp", under=["verification/trace/ids"])
    known = {uid for name in headers for uid in re.findall(r'\{"(SRS_[A-Z0-9_]+)"\}', read(root, name))}
    findings, count = [], 0
    for path in xml_files:
        for case in ElementTree.parse(path).iter("testcase"):
            name = f"{case.get('classname')}.{case.get('name')}"
            where = f"{path.parent.parent.name}/{path.parent.name}/{path.name}:{case.get('line', '?')}: {name}"
            named = [item.get("value") for item in case.iter("property") if item.get("name", "").startswith("requirement-")]
            count += 1
            if case.get("status") == "notrun":
                findings.append(f"{where}: disabled, expected every test to run")
            elif case.find("skipped") is not None:
                findings.append(f"{where}: skipped, expected every test to run")
            elif case.find("failure") is not None:
                findings.append(f"{where}: failed")
            elif not named:
                findings.append(f"{where}: names no requirement, expected Verifies(req::...)")
            findings += [f"{where}: names {uid}, which is no requirement" for uid in named if uid not in known]
    if count == 0:
        raise CannotLook("GoogleTest's reports hold no test")
    return findings, f"{count} runs of tests in {len(xml_files)} reports"


run_gate(gate)
