#!/usr/bin/env python3
"""The command line, the images and the evidence are of one version: that of the project, at the commit of the evidence, with the objects
that it measured."""
import json
import pathlib
import re
import sys

HERE = pathlib.Path(__file__).resolve()
sys.path[:0] = [str(HERE.parents[1]), str(HERE.parents[3] / "version")]
from common import CannotLook, read, run_gate  # noqa: E402
from digest import told  # noqa: E402


def gate(root, data):
    project = re.search(r"project\(Counterpoint VERSION (\S+)", read(root, "CMakeLists.txt"))
    identity = data / "identity.json"
    if not project or not identity.is_file():
        raise CannotLook("project(Counterpoint VERSION ...) in CMakeLists.txt and identity.json, expected both")
    record = json.loads(identity.read_text())
    versions, commit = record["versions"], record["commit"]

    def expected(name):
        objects = told(record["digest"] if name == "counterpoint" else record["target_digest"])
        return f"counterpoint {project.group(1)} (commit {commit[:12] or 'unknown'}, objects {objects})"

    findings = [f"{name}: '{text}', expected '{expected(name)}'" for name, text in versions.items() if text != expected(name)]
    if "counterpoint" not in versions or len(versions) < 2:
        findings.append(f"{', '.join(versions) or 'nothing'} looked at, expected the command line and an image")
    if not re.search(rf"^## {re.escape(project.group(1))}\b", read(root, "CHANGELOG.md"), re.MULTILINE):
        findings.append(f"CHANGELOG.md:1: no '## {project.group(1)}', expected what the version of the project brought")
    return findings, f"{len(versions)} programs and images, expected '{expected('counterpoint')}' and images of the target's objects"


run_gate(gate)
