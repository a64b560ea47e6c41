#!/usr/bin/env python3
"""No finding of clang-tidy (checks of .clang-tidy) or of Clang's warnings that stand for MISRA guidelines, unless the line
or the one before names a deviation whose record lists the check."""
import concurrent.futures
import pathlib
import re
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from common import cpp_files, read, run_gate  # noqa: E402

HERE = pathlib.Path(__file__).resolve().parent
CONFIGURATION = HERE.parents[2] / ".clang-tidy"
FOLDERS = ["safety_core", "channel_a", "channel_b", "hal/api", "hal/absent", "hal/tms570", "hal/zynqmp"]
FINDING = re.compile(r"^(?P<file>[^:\n]+):(?P<line>\d+):\d+: (?:warning|error): (?P<text>.*) \[(?P<checks>[\w.,+-]+)\]$", re.MULTILINE)
MARKER = re.compile(r"MISRA (D-\d{3})")


def warnings():
    return [line for line in (HERE / "warnings.txt").read_text().splitlines() if line.startswith("-W")]


def run_tidy(root, names):
    # A header looked at alone uses few of its own constants.
    alone = ["-Wno-unused-const-variable"] if names[0].endswith(".hpp") else []
    # Exceptions are on here: without them the checks of noexcept say nothing. The compilers have them off.
    command = ["clang-tidy-19", "--quiet", f"--config-file={CONFIGURATION}", *names, "--", "-x", "c++", "-std=c++17", "-I.",
               "-ffreestanding", "-fno-rtti", *warnings(), *alone]
    return subprocess.run(command, cwd=root, capture_output=True, text=True, check=False)


def deviates(root, name, line, checks):
    """Whether this line, or a neighbour that clang-format moved the mark to, names a deviation that covers the check."""
    lines = read(root, name).splitlines()
    for text in lines[max(0, line - 2):line + 1]:
        for identifier in MARKER.findall(text):
            record = root / "MISRA/deviations" / f"{identifier}.md"
            if record.exists() and any(f"`{check}`" in record.read_text() for check in checks):
                return True
    return False


def gate(root, _data):
    names = cpp_files(root, FOLDERS)
    halves = [half for half in ([name for name in names if name.endswith(".cpp")],
                                [name for name in names if name.endswith(".hpp")]) if half]
    findings = set()
    with concurrent.futures.ThreadPoolExecutor(max_workers=2) as pool:
        for done in pool.map(lambda half: run_tidy(root, half), halves):
            if done.returncode not in (0, 1) or "error: no such file" in done.stderr:
                findings.add(f"clang-tidy-19: exit status {done.returncode}: {done.stderr.strip()[-200:]}")
            for found in FINDING.finditer(done.stdout):
                path = pathlib.Path(found["file"])
                name = (path if path.is_absolute() else root / path).resolve()
                if not name.is_relative_to(root):
                    continue
                name, line = name.relative_to(root).as_posix(), int(found["line"])
                checks = [check for check in found["checks"].split(",") if check != "-warnings-as-errors"]
                if not any(name.startswith(folder + "/") for folder in FOLDERS) or deviates(root, name, line, checks):
                    continue
                findings.add(f"{name}:{line}: {found['text']} [{','.join(checks)}]")
    return sorted(findings), f"{len(names)} files"


run_gate(gate)
