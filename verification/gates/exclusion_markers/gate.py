#!/usr/bin/env python3
"""No marker, attribute or flag that takes code out of the coverage figures."""
import pathlib
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from common import CannotLook, files, read, run_gate  # noqa: E402

MARKER = re.compile(r"(LCOV|GCOVR?|LLVM_COV)_EXCL|no_profile_instrument_function|no_instrument_function|clang\s+coverage"
                    r"|-fprofile-list|-fprofile-filter-files|-fprofile-exclude-files|-fno-coverage-mapping|-fno-profile")


def gate(root, _data):
    findings = []
    names = files(root, "*.cpp", "*.hpp", "*.cmake", "CMakeLists.txt", "CMakePresets.json", "*.cfg")
    if not names:
        raise CannotLook(f"no source file in {root.name}")
    for name in names:
        for number, line in enumerate(read(root, name).splitlines(), start=1):
            found = MARKER.search(line)
            if found:
                findings.append(f"{name}:{number}: '{found.group(0)}', expected nothing that is left out of coverage")
    return findings, f"{len(names)} files"


run_gate(gate)
