#!/usr/bin/env python3
"""No finding of cppcheck in the certified part, unless the line or the one before names a deviation whose record lists it."""
import pathlib
import re
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from common import cpp_files, read, run_gate  # noqa: E402

FOLDERS = ["safety_core", "channel_a", "channel_b", "hal/api", "hal/absent", "hal/tms570", "hal/zynqmp"]
MARKER = re.compile(r"MISRA (D-\d{3})")
# Not faults: headers of the compiler, advice on style. unreadVariable takes a write through an overloaded operator[] for a
# write to a local; clang-analyzer-deadcode looks for the same and sees through it. AssignmentAddressToInteger takes the
# operator of `T{a} & T{b}` for an address; a real one does not compile.
LEFT_OUT = ["missingInclude", "missingIncludeSystem", "unmatchedSuppression", "unusedStructMember", "useStlAlgorithm",
            "functionStatic", "functionConst", "unreadVariable", "AssignmentAddressToInteger"]


def gate(root, _data):
    names = cpp_files(root, FOLDERS)
    command = ["cppcheck", "--enable=warning,style,performance,portability", "--inconclusive", "--std=c++17", "--language=c++",
               "--quiet", "-I.", "-j2", "--template={file}:{line}: {severity}: {message} [{id}]",
               "--template-location=", *[f"--suppress={name}" for name in LEFT_OUT], *names]
    done = subprocess.run(command, cwd=root, capture_output=True, text=True, check=False)
    findings = set()
    for line in done.stderr.splitlines():
        found = re.match(r"(?P<file>[^:]+):(?P<line>\d+): (?P<text>.*) \[(?P<id>\w+)\]$", line)
        if not found:
            continue
        lines = read(root, found["file"]).splitlines() if (root / found["file"]).is_file() else []
        records = [root / "MISRA/deviations" / f"{identifier}.md" for text in lines[max(0, int(found["line"]) - 2):int(found["line"]) + 1]
                   for identifier in MARKER.findall(text)]
        if not any(record.exists() and f"`{found['id']}`" in record.read_text() for record in records):
            findings.add(line)
    if done.returncode != 0 and not findings:
        findings.add(f"cppcheck: exit status {done.returncode}: {(done.stderr + done.stdout).strip()[-200:]}")
    return sorted(findings), f"{len(names)} files"


run_gate(gate)
