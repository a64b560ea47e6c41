#!/usr/bin/env python3
"""The compile command of a room finds the headers it may see and not those of the other rooms.

Takes the command of one file of each room from DATA/compile_commands.json and compiles a file of one include with it.
"""
import json
import pathlib
import shlex
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from common import CannotLook, run_gate  # noqa: E402

# Room, a folder that its files must not see, a folder that they do see.
RULES = [
    ("channel_a", "channel_b", "safety_core/contract"),
    ("channel_a", "safety_core/kernel", "safety_core/contract"),
    ("channel_b", "channel_a", "safety_core/contract"),
    ("channel_b", "safety_core/comparator", "safety_core/contract"),
    ("safety_core/comparator", "channel_a", "safety_core/contract"),
    ("safety_core/kernel", "channel_a", "hal/api"),
    ("safety_core/kernel", "channel_b", "safety_core/comparator"),
    ("safety_core/kernel", "simulator/world", "safety_core/contract"),
    ("hal/api", "safety_core/kernel", "safety_core/contract"),
]


def compiles(command, directory, header):
    """Whether a file that includes nothing but this header compiles with the options of the command."""
    with tempfile.TemporaryDirectory(prefix="include_") as folder:
        source = pathlib.Path(folder) / "probe.cpp"
        source.write_text(f'#include "{header}"\n')
        words = shlex.split(command)
        compiler, options = words[0], [word for word in words[1:] if word.startswith(("-I", "-isystem", "-std", "-f"))]
        options += [words[index + 1] for index, word in enumerate(words[:-1]) if word in ("-I", "-isystem")]
        done = subprocess.run([compiler, *options, "-fsyntax-only", source], cwd=directory, capture_output=True, text=True, check=False)
        return done.returncode == 0, done.stderr


def gate(root, data):
    database = data / "compile_commands.json"
    if not database.exists():
        raise CannotLook("compile_commands.json of the product build")
    commands = json.loads(database.read_text())
    findings, count = [], 0
    for room, hidden, seen in RULES:
        entry = next((item for item in commands if str(pathlib.Path(item["file"]).parent).endswith("/" + room)), None)
        hidden_header = next((path for path in sorted((root / hidden).glob("*.hpp"))), None)
        seen_header = next((path for path in sorted((root / seen).glob("*.hpp"))), None)
        if entry is None or hidden_header is None or seen_header is None:
            findings.append(f"{room}:1: no compile command of this room, or no header in {hidden} or {seen}, expected all three")
            continue
        count += 1
        if compiles(entry["command"], entry["directory"], hidden_header.relative_to(root).as_posix())[0]:
            findings.append(f"{room}:1: compiles #include \"{hidden_header.relative_to(root)}\", expected that it does not see {hidden}")
        done, errors = compiles(entry["command"], entry["directory"], seen_header.relative_to(root).as_posix())
        if not done:
            findings.append(f"{room}:1: does not compile #include \"{seen_header.relative_to(root)}\": {errors.strip()[:200]}")
    return findings, f"{count} rules"


run_gate(gate)
