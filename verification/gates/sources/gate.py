#!/usr/bin/env python3
"""The SOURCE of each requirement resolves: to a numbered section of a document of the project, to a decision, to another requirement, or to an
entry of the bibliography and a section that the entry lists. Items are separated by semicolons, sections by commas."""
import pathlib
import re
import sys

HERE = pathlib.Path(__file__).resolve()
sys.path.insert(0, str(HERE.parents[1]))
sys.path.insert(0, str(HERE.parents[2] / "trace"))
from common import CannotLook, files, read, run_gate  # noqa: E402
from generate_ids import BadInput, read_requirements  # noqa: E402

BIBLIOGRAPHY = "docs/bibliography.md"


def own_documents(root):
    """Name (semantics, facts/network) -> numbers of its headings; a document without numbered headings cannot be cited."""
    documents = {}
    for name in files(root, "*.md", under=["docs"]):
        numbers = set(re.findall(r"^#{2,5} (\d+(?:\.\d+)*)\.? ", read(root, name), re.MULTILINE))
        if numbers and not name.startswith("docs/decisions/"):
            documents[name.removeprefix("docs/").removesuffix(".md")] = numbers
    return documents


def decisions(root):
    return {path.name[:4] for path in (root / "docs/decisions").glob("[0-9][0-9][0-9][0-9]-*.md")}


def entries(root):
    """Short name -> sections that may be cited."""
    if not (root / BIBLIOGRAPHY).is_file():
        raise CannotLook(f"no {BIBLIOGRAPHY}")
    found = {}
    for name, body in re.findall(r"^### (.+?)\n(.*?)(?=^##|\Z)", read(root, BIBLIOGRAPHY), re.MULTILINE | re.DOTALL):
        listed = re.search(r"^- Sections cited: (.*?)(?=^- |\n\n|\Z)", body, re.MULTILINE | re.DOTALL)
        found[name] = {" ".join(section.split()) for section in listed.group(1).split(",")} if listed else set()
    return found


class Sources:
    def __init__(self, root, uids):
        self.own, self.decisions, self.entries, self.uids = own_documents(root), decisions(root), entries(root), uids

    def problem(self, item, uid):
        """What is wrong with an item of a SOURCE, or nothing."""
        if item.startswith("SRS_"):
            return None if item in self.uids and item != uid else f"'{item}', expected the id of another requirement"
        if item.startswith("decision "):
            return None if item.removeprefix("decision ") in self.decisions else f"'{item}', expected a decision in docs/decisions"
        names = [name for name in [*self.own, *self.entries] if item == name or item.startswith(name + " ")]
        if not names:
            return f"'{item}' is no document of the project and no entry of {BIBLIOGRAPHY}"
        name = max(names, key=len)
        sections = [section.strip() for section in item[len(name):].split(",")] if item != name else []
        known = self.own.get(name, self.entries.get(name))
        if name in self.own and not sections:
            return f"'{item}', expected a section of docs/{name}.md"
        missing = [section for section in sections if section not in known]
        return f"'{name}' has no section '{missing[0]}'" + ("" if name in self.own else f" in {BIBLIOGRAPHY}") if missing else None


def gate(root, _data):
    try:
        by_uid = read_requirements(root)
    except BadInput as problem:
        return [str(problem)], "files that cannot be read"
    sources = Sources(root, by_uid.keys())
    findings, count = [], 0
    for requirement in by_uid.values():
        where = f"{requirement.path}:{requirement.line}: {requirement.uid}"
        items = [item.strip() for item in requirement.fields["SOURCE"].split(";")]
        count += len(items)
        for item in items:
            problem = sources.problem(item, requirement.uid) if item else "an empty SOURCE, expected where the requirement comes from"
            if problem:
                findings.append(f"{where}: {problem}")
    return findings, f"{count} sources of {len(by_uid)} requirements"


run_gate(gate)
