#!/usr/bin/env python3
"""Writes requirement_ids.hpp from docs/requirements/*.sdoc.

    python3 verification/trace/generate_ids.py            write the header
    python3 verification/trace/generate_ids.py --check    fail when the committed header differs

Needs nothing but Python, so that everybody can run it after editing a requirement. Whether the files are valid
StrictDoc is checked by the trace gate, which lets StrictDoc itself read them.
Exit status: 0 done, 1 the committed header differs, 2 a requirement file cannot be used (file:line is printed).
"""
import argparse
import difflib
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
HEADER = "verification/trace/requirement_ids.hpp"
UID = re.compile(r"SRS-[A-Z][A-Z0-9]*-[0-9]{3}")
METHODS = ("test", "bench", "gate", "analysis", "scenario")


class BadInput(Exception):
    """A requirement file that cannot be used; the text names file and line."""


class Requirement:
    """One [REQUIREMENT] block: its fields, and where it stands."""

    def __init__(self, path, line):
        self.path = path
        self.line = line
        self.fields = {}

    @property
    def uid(self):
        return self.fields["UID"]

    @property
    def methods(self):
        return [method.strip() for method in self.fields["VERIFICATION"].split(",")]


def parse_file(path, name):
    """The requirements of one file, in its order. Multi-line values stand between >>> and <<<."""
    requirements = []
    current = None
    multiline = None
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), start=1):
        if multiline is not None:
            if line.strip() == "<<<":
                multiline = None
            elif current is not None:
                current.fields[multiline] = (current.fields[multiline] + " " + line.strip()).strip()
            continue
        # Ends whatever block stood before, [[SECTION]] and [/SECTION] included.
        if re.fullmatch(r"\[\[?/?[A-Z_]+\]\]?", line):
            current = Requirement(name, number) if line == "[REQUIREMENT]" else None
            if current is not None:
                requirements.append(current)
            continue
        field = re.match(r"([A-Z][A-Z0-9_]*): ?(.*)$", line)
        if not field:
            continue
        key, value = field.groups()
        if value == ">>>":
            multiline = key
            value = ""
        if current is not None:
            if key in current.fields:
                raise BadInput(f"{name}:{number}: field {key} stands twice in this requirement, expected once")
            current.fields[key] = value.strip()
    if multiline is not None:
        raise BadInput(f"{name}: field {multiline} is opened by >>> and never closed, expected a line <<<")
    return requirements


def check(requirement):
    where = f"{requirement.path}:{requirement.line}"
    for key in ("UID", "STATEMENT", "RATIONALE", "SOURCE", "VERIFICATION"):
        if not requirement.fields.get(key):
            raise BadInput(f"{where}: requirement without {key}, expected fields UID, STATEMENT, RATIONALE, SOURCE, "
                           "VERIFICATION")
    if not UID.fullmatch(requirement.uid):
        raise BadInput(f"{where}: UID '{requirement.uid}', expected the form SRS-AREA-001")
    for method in requirement.methods:
        if method not in METHODS:
            raise BadInput(f"{where}: {requirement.uid}: VERIFICATION '{method}', expected one of {', '.join(METHODS)}")


def read_requirements(root):
    """Every requirement below root/docs/requirements, by identifier."""
    by_uid = {}
    folder = root / "docs" / "requirements"
    for path in sorted(folder.glob("*.sdoc")):
        for requirement in parse_file(path, path.relative_to(root).as_posix()):
            check(requirement)
            if requirement.uid in by_uid:
                first = by_uid[requirement.uid]
                raise BadInput(f"{requirement.path}:{requirement.line}: {requirement.uid} is defined a second time, "
                               f"first at {first.path}:{first.line}")
            by_uid[requirement.uid] = requirement
    if not by_uid:
        raise BadInput(f"{folder}: no requirement found, expected *.sdoc with [REQUIREMENT] blocks")
    return dict(sorted(by_uid.items()))


def header_text(requirements):
    lines = [
        "// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0",
        "// Generated from docs/requirements/*.sdoc by verification/trace/generate_ids.py. Do not edit.",
        "#ifndef VERIFICATION_TRACE_REQUIREMENT_IDS_HPP",
        "#define VERIFICATION_TRACE_REQUIREMENT_IDS_HPP",
        "",
        "namespace counterpoint::req",
        "{",
        "/// Names one requirement; only this header makes one, so that an unknown or retired identifier does not compile.",
        "struct RequirementId",
        "{",
        "    const char* text;",
        "};",
        "",
    ]
    for uid in requirements:
        lines.append(f'inline constexpr RequirementId {uid.replace("-", "_")}{{"{uid}"}};')
    lines += ["} // namespace counterpoint::req", "", "#endif", ""]
    return "\n".join(lines)


def main(arguments):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", action="store_true", help="compare with the committed header, write nothing")
    parser.add_argument("--root", type=pathlib.Path, default=ROOT, help="root of the tree (for the gate's fixtures)")
    parser.add_argument("--list", action="store_true", help="print the identifiers, write nothing")
    options = parser.parse_args(arguments)
    try:
        requirements = read_requirements(options.root.resolve())
    except BadInput as error:
        print(error, file=sys.stderr)
        return 2
    if options.list:
        print("\n".join(requirements))
        return 0
    text = header_text(requirements)
    target = options.root / HEADER
    before = target.read_text(encoding="utf-8") if target.exists() else ""
    if options.check:
        for line in difflib.unified_diff(before.splitlines(), text.splitlines(), HEADER, "generated", lineterm="", n=0):
            print(line)
        return 0 if before == text else 1
    if before != text:
        target.write_text(text, encoding="utf-8")
    print(f"{HEADER}: {len(requirements)} requirements{'' if before != text else ', unchanged'}")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
