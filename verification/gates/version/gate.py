#!/usr/bin/env python3
"""The command line, the images and the evidence are of one version: that of the project, at the commit of the evidence."""
import json
import pathlib
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from common import CannotLook, read, run_gate  # noqa: E402


def gate(root, data):
    project = re.search(r"project\(Counterpoint VERSION (\S+)", read(root, "CMakeLists.txt"))
    identity = data / "identity.json"
    if not project or not identity.is_file():
        raise CannotLook("project(Counterpoint VERSION ...) in CMakeLists.txt and identity.json, expected both")
    record = json.loads(identity.read_text())
    versions, commit = record["versions"], record["commit"]
    expected = f"counterpoint {project.group(1)} (commit {commit[:12] or 'unknown'})"
    findings = [f"{name}: '{text}', expected '{expected}'" for name, text in versions.items() if text != expected]
    if "counterpoint" not in versions or len(versions) < 2:
        findings.append(f"{', '.join(versions) or 'nothing'} looked at, expected the command line and an image")
    if not re.search(rf"^## {re.escape(project.group(1))}\b", read(root, "CHANGELOG.md"), re.MULTILINE):
        findings.append(f"CHANGELOG.md:1: no '## {project.group(1)}', expected what the version of the project brought")
    return findings, f"{len(versions)} programs and images, expected '{expected}'"


run_gate(gate)
