#!/usr/bin/env python3
"""Writes verification/trace/ids/NAME.hpp from each docs/requirements/NAME.sdoc.

An identifier is spelled SRS_AREA_001 everywhere: in the documents, in comments, in tests. One header for each document, so that
a new requirement rebuilds only the tests of its document.

    python3 verification/trace/generate_ids.py            write the headers
    python3 verification/trace/generate_ids.py --check    fail when the committed headers differ

Needs nothing but Python, so that everybody can run it after editing a requirement. Whether the files are valid
StrictDoc is checked by the trace gate, which lets StrictDoc itself read them.
Exit status: 0 done, 1 a committed header differs, 2 a requirement file cannot be used (file:line is printed).
"""
import argparse
import difflib
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
FOLDER = "verification/trace/ids"
UID = re.compile(r"SRS_[A-Z][A-Z0-9]*_[0-9]{3}")
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
        raise BadInput(f"{where}: UID '{requirement.uid}', expected the form SRS_AREA_001")
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


def header_text(name, uids):
    guard = f"VERIFICATION_TRACE_IDS_{name.upper()}_HPP"
    lines = [
        "// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0",
        f"// Generated from docs/requirements/{name}.sdoc by verification/trace/generate_ids.py. Do not edit.",
        f"#ifndef {guard}",
        f"#define {guard}",
        "",
        '#include "verification/trace/requirement_id.hpp"',
        "",
        "namespace counterpoint::req",
        "{",
    ]
    lines += [f'inline constexpr RequirementId {uid}{{"{uid}"}};' for uid in uids]
    lines += ["} // namespace counterpoint::req", "", "#endif", ""]
    return "\n".join(lines)


def header_texts(requirements):
    """Path -> text of the header of each document."""
    documents = {}
    for uid, requirement in requirements.items():
        documents.setdefault(pathlib.PurePosixPath(requirement.path).stem, []).append(uid)
    return {f"{FOLDER}/{name}.hpp": header_text(name, uids) for name, uids in sorted(documents.items())}


def main(arguments):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", action="store_true", help="compare with the committed headers, write nothing")
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
    texts = header_texts(requirements)
    folder = options.root / FOLDER
    old = {path.relative_to(options.root).as_posix() for path in folder.glob("*.hpp")}
    status = 0
    for name in sorted(old | texts.keys()):
        target = options.root / name
        before = target.read_text(encoding="utf-8") if target.exists() else ""
        text = texts.get(name, "")
        if before == text:
            continue
        if options.check:
            status = 1
            for line in difflib.unified_diff(before.splitlines(), text.splitlines(), name, "generated", lineterm="", n=0):
                print(line)
        elif text:
            target.parent.mkdir(parents=True, exist_ok=True)
            target.write_text(text, encoding="utf-8")
        else:
            target.unlink()
    return status


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
