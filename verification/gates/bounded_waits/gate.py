#!/usr/bin/env python3
"""Every loop of the port to a controller has a bound that its head shows: a counter that the loop moves is compared with what it
may reach, whatever else is waited for; or a range. In assembly: what goes back to a label counts or compares on the way, and
leaves. Endless are only the loops in which the safe state stands, and the device's own."""
import pathlib
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from common import CannotLook, files, read, run_gate, without_comments  # noqa: E402
from loop_heads import HEAD, head_of, split  # noqa: E402

UNDER = ["hal/tms570", "hal/zynqmp", "examples/firmware"]
# File, and the text of the loop's place. The first two stand still in the safe state; the last one is the life of the device.
ENDLESS = [("hal/zynqmp/silicon/exception_hooks.cpp", "for (;;)", "WaitForInterrupt"), ("examples/firmware/zynqmp/silicon_main.cpp", "for (;;)", "executive.Cycle"),
           ("hal/tms570/silicon/exception_hooks.cpp", "for (;;)", "WaitForInterrupt"), ("hal/tms570/start/start_up.S", "Stopped", "1b"),
           ("examples/firmware/common/silicon_main.cpp", "for (;;)", "executive.Cycle")]
# A counter, alone or with a constant added, against its end.
BOUND = re.compile(r"^\(*(\w+)(?: \+ \w+\))? (?:<=?|>) \(?[\w.:]+(?: - \w+)?\)*$")
WINDOW = 900
LABEL = re.compile(r"^(\d+):")
BACK = re.compile(r"^(?:\d+:)?\s*(b\w*|cbn?z)\s+(?:\w+,\s*)?(\d+)b\b")
COUNTS = re.compile(r"\s(subs|adds|cmp|ands)\s")
LEAVES = re.compile(r"^(?:\d+:)?\s*(b(?:eq|ne|hs|lo|cs|cc|mi|pl|hi|ls|ge|lt|gt|le)|cbn?z)\s")


def is_permitted(name, loop, near):
    return any(name == file and loop.startswith(head) and what in near for file, head, what in ENDLESS)


def ends(condition, moved):
    """Whether a condition becomes false by a counter alone."""
    either, both = split(condition, "||"), split(condition, "&&")
    if len(either) > 1:
        return all(ends(part, moved) for part in either)
    if len(both) > 1:
        return any(ends(part, moved) for part in both)
    match = BOUND.match(both[0].strip())
    return bool(match) and re.search(rf"(\+\+|--){match.group(1)}\b|\b{match.group(1)} [+-]= ", moved) is not None


def cpp_findings(name, code):
    for match in HEAD.finditer(code):
        head = head_of(code, match.end() - 1)
        line = code.count("\n", 0, match.start()) + 1
        parts = head.split(";")
        is_range = match.group(1) == "for" and len(parts) == 1 and re.search(r"[^:]:[^:]", head)
        condition = parts[1] if match.group(1) == "for" and len(parts) == 3 else head
        behind = match.end() + len(head) + 1
        is_do = match.group(1) == "while" and code[behind:behind + 2].lstrip().startswith(";")
        near = code[max(0, match.start() - WINDOW):match.start()] if is_do else code[behind:behind + WINDOW]
        has_bound = ends(" ".join(condition.split()), head + near)
        if not is_range and not has_bound and not is_permitted(name, code[match.start():match.end() + len(head) + 1], code[match.end():match.end() + 120]):
            yield f"{name}:{line}: '{match.group(1)} ({' '.join(head.split())})' has no bound, expected a comparison with '<' that ends it"


def assembly_findings(name, text):
    lines = [re.split(r"@|//", line)[0].rstrip() for line in text.splitlines()]
    function = ""
    for number, line in enumerate(lines):
        named = re.match(r"\s*begin (\w+)|^(\w+):", line)
        if named and not LABEL.match(line):
            function = named.group(1) or named.group(2)
        back = BACK.match(line.strip())
        if not back:
            continue
        start = next((place for place in range(number, -1, -1) if (LABEL.match(lines[place]) or [None, None])[1] == back.group(2)), None)
        body = lines[start:number + 1] if start is not None else []
        counts = any(COUNTS.search(part + " ") for part in body)
        leaves = any(LEAVES.match(part) for part in body)
        if not (counts and leaves) and not is_permitted(name, function, line):
            yield f"{name}:{number + 1}: '{line.strip()}' in {function} has no bound, expected a loop that counts or compares, and leaves"


def gate(root, _data):
    findings = []
    names = files(root, "*.cpp", "*.hpp", "*.S", under=UNDER)
    if not names:
        raise CannotLook(f"no file below {', '.join(UNDER)}")
    loops = 0
    for name in names:
        text = read(root, name)
        if name.endswith(".S"):
            findings += assembly_findings(name, text)
            loops += sum(bool(BACK.match(line.strip())) for line in text.splitlines())
        else:
            code = without_comments(text)
            findings += [f"{name}:{code.count(chr(10), 0, match.start()) + 1}: a do loop, expected a for loop with its bound in its head"
                         for match in re.finditer(r"\bdo\s*\{", code) if not has_bound_behind(code, match.end())]
            findings += cpp_findings(name, code)
            loops += len(HEAD.findall(code))
    return findings, f"{loops} loops in {len(names)} files"


def has_bound_behind(code, start):
    """Of a do loop: its `while` is looked at as a head of its own."""
    return re.search(r"\}\s*while\s*\(", code[start:]) is not None


run_gate(gate)
