#!/usr/bin/env python3
"""installed_links.py FOLDER: in the documents of an installed package, a link to what is not installed becomes its text, and a
document with paths of the source tree says so behind its first heading."""
import pathlib
import re
import sys

LINK = re.compile(r"\[([^\]\n]*)\]\(([^)\s#]+)(#[^)\s]*)?\)")
FENCED = re.compile(r"(^```.*?^```[^\n]*$)", re.MULTILINE | re.DOTALL)
# What a package has not, or has elsewhere.
TREE_PATH = re.compile(r"(?<![\w./-])(\./dev\b|build/(counterpoint|product|target|evidence)\b|(tests|examples|verification)/\w)")
NOTE = """
> In this package: paths and commands of this page are those of the source tree. `./dev`, `build/`, `tests/` and what else is not here are there alone;
> `build/counterpoint` is `bin/counterpoint`, `examples/` is `share/counterpoint/examples`, with the scenarios, the device files and the projects of their own.
"""


def with_note(text):
    if NOTE in text or not TREE_PATH.search(text):
        return text
    heading, _, rest = text.partition("\n")
    return heading + "\n" + NOTE + ("" if rest.startswith("\n") else "\n") + rest


def main(root):
    for document in sorted(root.rglob("*.md")):
        def shown(found, folder=document.parent):
            place = (folder / found[2]).resolve()
            is_there = ":" in found[2] or (place.exists() and root in place.parents)
            return found[0] if is_there else found[1]
        parts = FENCED.split(document.read_text(encoding="utf-8"))
        parts[::2] = [LINK.sub(shown, part) for part in parts[::2]]
        text = "".join(parts)
        document.write_text(text if document.parent == root else with_note(text), encoding="utf-8")


main(pathlib.Path(sys.argv[1]).resolve())
