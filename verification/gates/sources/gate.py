#!/usr/bin/env python3
"""The SOURCE of each requirement resolves: to a numbered section of a document of the project, to a decision, to another requirement, or to an
entry of the bibliography and a section that the entry lists. Items are separated by semicolons, sections by commas."""
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve()
sys.path.insert(0, str(HERE.parents[1]))
sys.path.insert(0, str(HERE.parents[2] / "trace"))
from common import run_gate  # noqa: E402
from generate_ids import BadInput, read_requirements  # noqa: E402
from source_items import Sources, items_of  # noqa: E402


def gate(root, _data):
    try:
        by_uid = read_requirements(root)
    except BadInput as problem:
        return [str(problem)], "files that cannot be read"
    sources = Sources(root, by_uid.keys())
    findings, count = [], 0
    for requirement in by_uid.values():
        where = f"{requirement.path}:{requirement.line}: {requirement.uid}"
        items = items_of(requirement)
        count += len(items)
        for item in items:
            problem = sources.problem(item, requirement.uid) if item else "an empty SOURCE, expected where the requirement comes from"
            if problem:
                findings.append(f"{where}: {problem}")
    return findings, f"{count} sources of {len(by_uid)} requirements"


run_gate(gate)
