#!/usr/bin/env python3
"""The MISRA compliance plan names every guideline once, and what it says is switched on is switched on."""
import collections
import pathlib
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from common import CannotLook, read, run_gate  # noqa: E402

EXPECTED = {"mandatory": 5, "required": 124, "advisory": 50}
ROW = re.compile(r"^\| ((?:D )?\d+\.\d+\.\d+) \| (\w+) \| (\w+) \| (.*) \|$")


def enabled(root):
    """What the configuration files switch on, by the words of the plan."""
    needed = {name: root / name for name in (".clang-tidy", "cmake/Room.cmake", "CMakeLists.txt",
                                              "verification/gates/clang_tidy/warnings.txt")}
    for name, path in needed.items():
        if not path.exists():
            raise CannotLook(f"{name} is not there")
    tidy = re.search(r"^Checks:.*?(?=^\w)", read(root, ".clang-tidy"), re.MULTILINE | re.DOTALL).group(0)
    patterns = [word.strip().strip(",") for word in tidy.replace("Checks: >", "").split()]
    build = read(root, "cmake/Room.cmake") + read(root, "CMakeLists.txt")
    options = set(re.findall(r"-[Wf][\w=+-]+", build))
    if "CMAKE_CXX_STANDARD 17" in build and "CMAKE_CXX_EXTENSIONS OFF" in build:
        options.add("-std=c++17")
    return {
        "clang-tidy": lambda check: any(check == p or (p.endswith("*") and check.startswith(p[:-1]) and p != "-*")
                                        for p in patterns),
        "warning": lambda name: name in read(root, "verification/gates/clang_tidy/warnings.txt").split(),
        "compiler": lambda name: name in options,
        "gate": lambda name: (root / "verification/gates" / name / "gate.py").exists(),
    }


def gate(root, _data):
    name = "MISRA/compliance_plan.md"
    if not (root / name).exists():
        raise CannotLook(f"{name} is not there")
    findings, counts, seen = [], collections.Counter(), {}
    switches = enabled(root)
    disapplied = read(root, "MISRA/recategorization.md") if (root / "MISRA/recategorization.md").exists() else ""
    for number, line in enumerate(read(root, name).splitlines(), start=1):
        row = ROW.match(line)
        if not row:
            continue
        guideline, category, _, means = row.groups()
        if guideline in seen:
            findings.append(f"{name}:{number}: {guideline} stands twice, first in line {seen[guideline]}")
        seen[guideline] = number
        counts[category] += 1
        for mean in means.split("; "):
            named = re.fullmatch(r"(clang-tidy|warning|compiler|gate) `([^`]+)`", mean)
            if named and not switches[named.group(1)](named.group(2)):
                findings.append(f"{name}:{number}: {guideline}: {mean} is not switched on")
            elif mean.startswith("none: disapplied") and f"| {guideline} | advisory | disapplied |" not in disapplied:
                findings.append(f"{name}:{number}: {guideline} is disapplied here and not in MISRA/recategorization.md")
            elif not named and not re.match(r"manual review|none: disapplied|ASan, UBSan|valgrind", mean):
                findings.append(f"{name}:{number}: {guideline}: '{mean}', expected a word of the table above")
    for category, expected in EXPECTED.items():
        if counts[category] != expected:
            findings.append(f"{name}:1: {counts[category]} {category} guidelines, expected {expected}")
    return findings, f"{len(seen)} guidelines"


run_gate(gate)
