#!/usr/bin/env python3
"""No path of the machine that a file was written on: home directories, roots of working trees."""
import pathlib
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from common import CannotLook, files, run_gate  # noqa: E402

# A path from the root of a file system: not the tail of a longer one (build/work/x) and no address (https://a/home/x).
MACHINE = re.compile(r"(?<![\w.}):/-])/(?:home/\w|Users/\w|root/|work/|workspace/|mnt/\w)|[A-Z]:\\Users\\")


def gate(root, _data):
    findings = []
    names = [name for name in files(root) if name != "verification/gates/machine_paths/gate.py"]
    if not names:
        raise CannotLook(f"no file in {root.name}")
    count = 0
    for name in names:
        content = (root / name).read_bytes()
        if b"\0" in content[:8000]:
            continue
        count += 1
        for number, line in enumerate(content.decode("utf-8", "replace").splitlines(), start=1):
            found = MACHINE.search(line)
            if found:
                findings.append(f"{name}:{number}: '{line[found.start():found.start() + 30].split()[0]}', expected a path "
                                "from the root of the tree")
    return findings, f"{count} text files"


run_gate(gate)
