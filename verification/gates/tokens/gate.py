#!/usr/bin/env python3
"""What must not stand in the sources: heap, exceptions, RTTI and the like in the certified part, notes of unfinished
work anywhere, suppressions without a deviation, header guards that do not name their file."""
import pathlib
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from common import cpp_files, files, read, run_gate, without_comments  # noqa: E402

CERTIFIED = ["safety_core", "channel_a", "channel_b", "hal/api", "hal/absent", "hal/tms570", "hal/zynqmp"]
BANNED = [
    (re.compile(r"\bnew\b"), "new"),
    (re.compile(r"(?<!=)(?<!=\s)\bdelete\b"), "delete"),
    (re.compile(r"\b(malloc|calloc|realloc|free)\s*\("), "heap"),
    (re.compile(r"\b(throw|try|catch)\b"), "exception"),
    (re.compile(r"\b(dynamic_cast|typeid)\b"), "RTTI"),
    (re.compile(r"\bgoto\b"), "goto"),
    (re.compile(r"\bstd::(vector|string|map|set|list|deque|function|unique_ptr|shared_ptr|optional|variant|any)\b"), "hosted type"),
    (re.compile(r"\b(abort|exit|assert)\s*\("), "program termination"),
    (re.compile(r"^\s*#\s*define\s+\w+\("), "function-like macro"),
    (re.compile(r"^\s*#\s*pragma\b"), "#pragma"),
    (re.compile(r"\b(thread_local|asm|__asm__)\b"), "thread or assembler"),
    (re.compile(r"\b(float|double)\b"), "floating point"),
    (re.compile(r"\bunion\b"), "union"),
    (re.compile(r"(?<![\w\])\[])\[[&=]?[\w\s,&]*\]\s*[({]"), "lambda"),
    (re.compile(r"^\s*static\s+(?!const(?:expr)?\b|inline\s+constexpr\b)[^()]*[;={]"), "static variable"),
    (re.compile(r"\bnoexcept\s*\(\s*false\b"), "noexcept(false)"),
    (re.compile(r"\binitializer_list\b|\bmain\s*\("), "what only a hosted program has"),
]
# Put together here, so that this file does not find itself.
UNFINISHED = re.compile(r"\b(" + "|".join(["TO" + "DO", "FIX" + "ME", "XX" + "X", "HA" + "CK"]) + r")\b|\bnot " + r"implemented\b")
SUPPRESSION = re.compile("NO" + "LINT|cppcheck-" + "suppress")
TEXT = ("*.cpp", "*.hpp", "*.S", "*.ld", "*.py", "*.sh", "*.cmake", "CMakeLists.txt", "*.md", "*.sdoc", "*.yaml", "*.yml",
        "*.dcf", "*.eds", "dev", "run")


def guard_findings(name, code):
    """A header's guard is its path, so that no two are the same."""
    expected = re.sub(r"[^A-Z0-9]", "_", name.upper())
    lines = [line.strip() for line in code.splitlines() if line.strip()]
    opens = lines[:2] == [f"#ifndef {expected}", f"#define {expected}"]
    conditionals = [line for line in lines if re.match(r"#\s*(if|ifdef|ifndef|elif)\b", line)]
    if not opens or not lines[-1].startswith("#endif"):
        yield f"{name}:1: the header is not guarded by {expected}, expected #ifndef, #define first and #endif last"
    for line in conditionals[1:]:
        yield f"{name}:1: '{line}', expected no conditional compilation besides the guard"


def certified_findings(root, name):
    text = read(root, name)
    code = without_comments(text)
    lines = code.splitlines()
    for number, line in enumerate(lines, start=1):
        for pattern, what in BANNED:
            found = pattern.search(line)
            if found:
                yield f"{name}:{number}: {what}: '{found.group(0).strip()}', expected none in this part"
        if re.search(r"\bvolatile\b", line) and not name.startswith("hal/"):
            yield f"{name}:{number}: volatile, expected only in the hardware layer"
        if name.endswith(".cpp") and re.match(r"\s*#\s*(if|ifdef|ifndef|elif|else)\b", line):
            yield f"{name}:{number}: conditional compilation, expected variants to be chosen by the linked file"
    for number, line in enumerate(text.splitlines(), start=1):
        if SUPPRESSION.search(line):
            yield f"{name}:{number}: a suppression, expected a deviation: // MISRA D-NNN"
    if name.endswith(".hpp"):
        yield from guard_findings(name, code)


def gate(root, _data):
    findings = []
    names = cpp_files(root, CERTIFIED)
    for name in names:
        findings += certified_findings(root, name)
    texts = files(root, *TEXT)
    for name in texts:
        for number, line in enumerate(read(root, name).splitlines(), start=1):
            found = UNFINISHED.search(line)
            if found:
                findings.append(f"{name}:{number}: '{found.group(0)}', expected no note of unfinished work")
    return findings, f"{len(names)} files of the certified part, {len(texts)} text files"


run_gate(gate)
