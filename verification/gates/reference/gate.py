#!/usr/bin/env python3
"""The reference of the public headers is made without a warning (tools/reference), as ./dev docs does."""
import pathlib
import shutil
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from common import CannotLook, run_gate  # noqa: E402

MAKE = "tools/reference/make.py"


def gate(root, data):
    if not (root / MAKE).is_file() or not shutil.which("doxygen"):
        raise CannotLook(f"{MAKE} and doxygen, expected both")
    with tempfile.TemporaryDirectory(prefix="reference_") as folder:
        done = subprocess.run([sys.executable, root / MAKE, folder], cwd=root, capture_output=True, text=True, check=False)
    said = [line for line in (done.stdout + done.stderr).splitlines() if line.strip()]
    if done.returncode == 0:
        return [], said[-1].replace(folder + "/", "")
    return said, "headers and documents of the reference"


run_gate(gate)
