#!/usr/bin/env python3
"""The reference of the public headers is made without a warning (tools/reference), as ./dev docs does; it can be searched, has a page
for each document of docs, and each page tells the version."""
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from common import CannotLook, run_gate  # noqa: E402

MAKE = "tools/reference/make.py"


def findings_of(root, html):
    """What the pages lack."""
    version = re.search(r"project\(Counterpoint VERSION ([0-9.]+)", (root / "CMakeLists.txt").read_text())[1]
    told = f'id="projectnumber">&#160;{version}<'
    findings = [f"{page.name}: no version, expected {version}" for page in sorted(html.glob("*.html")) if told not in page.read_text(errors="replace")]
    for document in sorted((root / "docs").glob("*.md")):
        if not (html / f"docs_{document.stem}_md.html").is_file():
            findings.append(f"docs/{document.name}: no page of the reference, expected one")
    if not (html / "search" / "searchdata.js").is_file():
        findings.append("html/search: no index, expected that the reference can be searched")
    return findings


def gate(root, data):
    if not (root / MAKE).is_file() or not shutil.which("doxygen"):
        raise CannotLook(f"{MAKE} and doxygen, expected both")
    with tempfile.TemporaryDirectory(prefix="reference_") as folder:
        done = subprocess.run([sys.executable, root / MAKE, folder], cwd=root, capture_output=True, text=True, check=False)
        findings = findings_of(root, pathlib.Path(folder) / "html") if done.returncode == 0 else []
    said = [line for line in (done.stdout + done.stderr).splitlines() if line.strip()]
    if done.returncode == 0:
        return findings, said[-1].replace(folder + "/", "")
    return said, "headers and documents of the reference"


run_gate(gate)
