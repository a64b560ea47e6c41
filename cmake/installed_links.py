#!/usr/bin/env python3
"""installed_links.py FOLDER: in the documents of an installed package, a link to what is not installed becomes its text."""
import pathlib
import re
import sys

LINK = re.compile(r"\[([^\]\n]*)\]\(([^)\s#]+)(#[^)\s]*)?\)")
FENCED = re.compile(r"(^```.*?^```[^\n]*$)", re.MULTILINE | re.DOTALL)


def main(root):
    for document in sorted(root.rglob("*.md")):
        def shown(found, folder=document.parent):
            place = (folder / found[2]).resolve()
            is_there = ":" in found[2] or (place.exists() and root in place.parents)
            return found[0] if is_there else found[1]
        parts = FENCED.split(document.read_text(encoding="utf-8"))
        parts[::2] = [LINK.sub(shown, part) for part in parts[::2]]
        document.write_text("".join(parts), encoding="utf-8")


main(pathlib.Path(sys.argv[1]).resolve())
