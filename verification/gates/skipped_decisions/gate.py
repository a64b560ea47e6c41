#!/usr/bin/env python3
"""No decision of the safety rooms that Clang left out of MC/DC.

Clang only warns, without a name that -Werror could catch, and the decision is then missing from every total. Reads
coverage/compile.log, where measure.py compiled every file of the rooms anew.
"""
import os
import pathlib
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from common import SAFETY_ROOMS, CannotLook, cpp_files, run_gate  # noqa: E402

SKIPPED = re.compile(r"^(?P<file>[^:\n]+):(?P<line>\d+):\d+: warning: (?P<text>unsupported MC/DC boolean expression[^\n]*"
                     r"|[^\n]*(?:MC/DC|mcdc)[^\n]*)", re.MULTILINE)


def gate(root, data):
    log = data / "coverage/compile.log"
    if not log.exists():
        raise CannotLook("coverage/compile.log, made by verification/coverage/measure.py")
    text = log.read_text(errors="replace")
    findings = []
    for found in SKIPPED.finditer(text):
        path = pathlib.Path(os.path.realpath(found["file"]))
        name = path.relative_to(root).as_posix() if path.is_relative_to(root) else found["file"]
        findings.append(f"{name}:{found['line']}: {found['text']}, expected a decision that Clang can measure")
    compiled = set(re.findall(r"^COMPILED (\S+)$", text, re.MULTILINE))
    for name in cpp_files(root, SAFETY_ROOMS):
        if name.endswith(".cpp") and name not in compiled:
            findings.append(f"{name}:1: not compiled for coverage, expected it in coverage/compile.log")
    return sorted(set(findings)), f"{len(compiled)} files compiled"


run_gate(gate)
