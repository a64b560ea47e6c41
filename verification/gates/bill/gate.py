#!/usr/bin/env python3
"""The bill of materials is SPDX that another tool reads without a complaint, and names each file that is handed out by its digest, each
package that ./dev installs, and each pin of requirements.txt; docs/dependencies.md says of each of these packages why."""
import hashlib
import json
import pathlib
import re
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE.parent), str(HERE.parents[1] / "release")]
import bill  # noqa: E402
from common import CannotLook, read, run_gate  # noqa: E402


def complaints(path):
    """Of spdx-tools, one text each."""
    from spdx_tools.spdx.parser.error import SPDXParsingError
    from spdx_tools.spdx.parser.parse_anything import parse_file
    from spdx_tools.spdx.validation.document_validator import validate_full_spdx_document
    try:
        document = parse_file(str(path))
    except SPDXParsingError as problem:
        return list(problem.get_messages())
    return [message.validation_message for message in validate_full_spdx_document(document)]


def named_files(record, data):
    told = {entry["fileName"]: {one["algorithm"]: one["checksumValue"] for one in entry["checksums"]} for entry in record.get("files", [])}
    there = {name: hashlib.sha256(path.read_bytes()).hexdigest() for name, path in bill.handed_out(data)}
    for name in sorted(told.keys() | there.keys()):
        if told.get(name, {}).get("SHA256") != there.get(name):
            yield f"{bill.NAME}: {name}: SHA-256 {told.get(name, {}).get('SHA256', 'not named')}, expected {there.get(name, 'no such file')}"


def named_packages(root, record):
    told = {package["SPDXID"]: package.get("versionInfo") for package in record.get("packages", [])}
    debian = bill.debian_packages(read(root, "dev"))
    for name in debian:
        if f"SPDXRef-deb-{bill.identifier(name)}" not in told:
            yield f"{bill.NAME}: no package {name}, expected each one that ./dev installs"
    for name, pin in bill.pins(read(root, "requirements.txt")).items():
        version = told.get(f"SPDXRef-pypi-{bill.identifier(name)}", "not named")
        if version != pin:
            yield f"{bill.NAME}: {name} {version}, expected {pin} as in requirements.txt"
    reasons = set(re.findall(r"[\w.+-]+", " ".join(re.findall(r"^\| (.*?) \|", read(root, "docs/dependencies.md"), re.MULTILINE))))
    every = {name for _, names in bill.package_lists(read(root, "dev")) for name in names.split()}
    for name in sorted(every - reasons):
        yield f"docs/dependencies.md: no row for {name}, expected why ./dev installs it"


def gate(root, data):
    path = data / bill.NAME
    if not path.is_file():
        raise CannotLook(f"{bill.NAME} among the collected data, expected it from ./dev verify")
    record = json.loads(path.read_text(encoding="utf-8"))
    findings = [f"{bill.NAME}: {text}" for text in complaints(path)] + list(named_files(record, data)) + list(named_packages(root, record))
    return findings, f"{len(record.get('files', []))} files, {len(record.get('packages', []))} packages"


run_gate(gate)
