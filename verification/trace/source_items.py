"""What the SOURCE of a requirement names: a numbered section of a document of the project, a decision, another requirement, or an entry of the
bibliography and a section that the entry lists. Items are separated by semicolons, sections by commas.

Used by verification/gates/sources (fails on what does not resolve) and by the evidence pages (link each clause to its requirements).
"""
import pathlib
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "gates"))
from common import CannotLook, files, read  # noqa: E402

BIBLIOGRAPHY = "docs/bibliography.md"
NUMBERED = re.compile(r"^#{2,5} (\d+(?:\.\d+)*)\.? ", re.MULTILINE)
ENTRY = re.compile(r"^### (.+?)\n(.*?)(?=^##|\Z)", re.MULTILINE | re.DOTALL)


def own_documents(root):
    """Name (semantics, facts/network) -> numbers of its headings; a document without numbered headings cannot be cited."""
    documents = {}
    for name in files(root, "*.md", under=["docs"]):
        numbers = set(NUMBERED.findall(read(root, name)))
        if numbers and not name.startswith("docs/decisions/"):
            documents[name.removeprefix("docs/").removesuffix(".md")] = numbers
    return documents


def decisions(root):
    """Number -> file."""
    return {path.name[:4]: path.relative_to(root).as_posix() for path in (root / "docs/decisions").glob("[0-9][0-9][0-9][0-9]-*.md")}


def entries(root):
    """Short name -> sections that may be cited."""
    if not (root / BIBLIOGRAPHY).is_file():
        raise CannotLook(f"no {BIBLIOGRAPHY}")
    found = {}
    for name, body in ENTRY.findall(read(root, BIBLIOGRAPHY)):
        listed = re.search(r"^- Sections cited: (.*?)(?=^- |\n\n|\Z)", body, re.MULTILINE | re.DOTALL)
        found[name] = {" ".join(section.split()) for section in listed.group(1).split(",")} if listed else set()
    return found


def items_of(requirement):
    return [item.strip() for item in requirement.fields["SOURCE"].split(";")]


class Clause:
    """One place that a SOURCE names: a section of a file of the project ("" for the whole), or a requirement."""

    def __init__(self, label, path="", section="", uid=""):
        self.label, self.path, self.section, self.uid = label, path, section, uid


class Sources:
    def __init__(self, root, uids):
        self.own, self.decisions, self.entries, self.uids = own_documents(root), decisions(root), entries(root), uids

    def named(self, item):
        """Name and sections of an item; no name where it is neither a document of the project nor an entry."""
        names = [name for name in [*self.own, *self.entries] if item == name or item.startswith(name + " ")]
        name = max(names, key=len, default="")
        return name, [section.strip() for section in item[len(name):].split(",")] if item != name else []

    def problem(self, item, uid):
        """What is wrong with an item of a SOURCE, or nothing."""
        if item.startswith("SRS_"):
            return None if item in self.uids and item != uid else f"'{item}', expected the id of another requirement"
        if item.startswith("decision "):
            return None if item.removeprefix("decision ") in self.decisions else f"'{item}', expected a decision in docs/decisions"
        name, sections = self.named(item)
        if not name:
            return f"'{item}' is no document of the project and no entry of {BIBLIOGRAPHY}"
        known = self.own.get(name, self.entries.get(name))
        if name in self.own and not sections:
            return f"'{item}', expected a section of docs/{name}.md"
        missing = [section for section in sections if section not in known]
        return f"'{name}' has no section '{missing[0]}'" + ("" if name in self.own else f" in {BIBLIOGRAPHY}") if missing else None

    def clauses(self, requirement):
        """Each place that the SOURCE names, in its order; what does not resolve is left to the gate."""
        found = []
        for item in items_of(requirement):
            if not item or self.problem(item, requirement.uid):
                continue
            if item.startswith("SRS_"):
                found.append(Clause(item, uid=item))
            elif item.startswith("decision "):
                found.append(Clause(item, self.decisions[item.removeprefix("decision ")]))
            else:
                name, sections = self.named(item)
                path = f"docs/{name}.md" if name in self.own else BIBLIOGRAPHY
                found += [Clause(f"{name} {section}".strip(), path, section if name in self.own else f"{name} {section}".strip())
                          for section in sections or [""]]
        return found
