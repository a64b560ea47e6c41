#!/usr/bin/env python3
"""No C++ file of the product beyond 400 lines, no function beyond 60 (from its signature to its closing brace)."""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from common import PRODUCT_FOLDERS, CannotLook, cpp_files, functions, read, run_gate  # noqa: E402

MAX_FILE_LINES = 400
MAX_FUNCTION_LINES = 60


def gate(root, _data):
    findings = []
    names = cpp_files(root, PRODUCT_FOLDERS)
    count = 0
    for name in names:
        text = read(root, name)
        lines = text.count("\n")
        if lines > MAX_FILE_LINES:
            findings.append(f"{name}:{lines}: the file has {lines} lines, expected at most {MAX_FILE_LINES}")
        for function in functions(text):
            count += 1
            if function.length > MAX_FUNCTION_LINES:
                findings.append(f"{name}:{function.first_line}: {function.name} has {function.length} lines, "
                                f"expected at most {MAX_FUNCTION_LINES}")
    if count == 0:
        raise CannotLook("no function found in the product's files")
    return findings, f"{count} functions in {len(names)} files"


run_gate(gate)
