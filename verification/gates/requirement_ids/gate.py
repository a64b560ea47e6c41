#!/usr/bin/env python3
"""Requirement files are valid StrictDoc, and the committed C++ header of identifiers is the one they generate."""
import json
import pathlib
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from common import CannotLook, run_gate  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parents[3]
GENERATOR = ROOT / "verification/trace/generate_ids.py"
STRICTDOC = pathlib.Path(sys.executable).parent / "strictdoc"
if not STRICTDOC.exists():
    STRICTDOC = ROOT / ".venv/bin/strictdoc"


def strictdoc_uids(root, findings):
    """The identifiers as StrictDoc itself reads them."""
    if not STRICTDOC.exists():
        raise CannotLook("StrictDoc is not installed, expected it in .venv (./dev verify makes it)")
    with tempfile.TemporaryDirectory() as out:
        done = subprocess.run([STRICTDOC, "export", root / "docs/requirements", "--formats=json", "--output-dir", out],
                              capture_output=True, text=True, cwd=out, check=False)
        exported = pathlib.Path(out) / "json/index.json"
        if done.returncode != 0 or not exported.exists():
            text = [line.replace(str(root) + "/", "") for line in (done.stdout + done.stderr).splitlines()]
            findings += ["docs/requirements: StrictDoc refuses: " + line for line in text if line.strip()][-5:]
            return None
        nodes, uids = json.loads(exported.read_text())["DOCUMENTS"], set()
    while nodes:
        node = nodes.pop()
        nodes += node.get("NODES", [])
        if node.get("_NODE_TYPE") == "REQUIREMENT":
            uids.add(node["UID"])
    return uids


def gate(root, _data):
    findings = []
    done = subprocess.run([sys.executable, GENERATOR, "--check", "--root", root], capture_output=True, text=True, check=False)
    findings += [line for line in (done.stdout + done.stderr).splitlines() if not line.startswith(("---", "+++", "@@"))]
    listed = subprocess.run([sys.executable, GENERATOR, "--list", "--root", root], capture_output=True, text=True, check=False)
    ours = set(listed.stdout.split())
    theirs = strictdoc_uids(root, findings)
    if theirs is not None:
        findings += [f"docs/requirements: {uid} is read by StrictDoc and not by generate_ids.py" for uid in sorted(theirs - ours)]
        findings += [f"docs/requirements: {uid} is read by generate_ids.py and not by StrictDoc" for uid in sorted(ours - theirs)]
    return findings, f"{len(ours)} requirements"


run_gate(gate)
