#!/usr/bin/env python3
"""markdown.py FILE: prints a document as Doxygen has to read it.

Headings get labels of their own, links within and between documents lead to these, and a link to what is no page of the reference becomes its text.
A link to a heading that is not there stays, so that Doxygen tells it. README.md is the first page.
"""
import pathlib
import re
import sys

ROOT = pathlib.Path.cwd()
FENCED = re.compile(r"(^```.*?^```[^\n]*$)", re.MULTILINE | re.DOTALL)
HEADING = re.compile(r"^(#{1,5}) +(.+?) *$", re.MULTILINE)
LINK = re.compile(r"\[([^\]\n]*)\]\(([^)\s#]*)(#[^)\s]*)?\)")
PAGES = ("README.md", "CHANGELOG.md")
LEFT_OUT = ("docs/requirements", "docs/facts")


def anchor(heading):
    """The anchor of a heading as repositories make it."""
    text = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading)
    return re.sub(r"[^\w\- ]", "", text.lower()).replace(" ", "-")


def is_page(name):
    return name in PAGES or (name.startswith("docs/") and name.endswith(".md") and not name.startswith(LEFT_OUT))


def title_of(document):
    """The anchor of the first heading, which leads to the page itself."""
    heading = HEADING.search((ROOT / document).read_text(encoding="utf-8"))
    return anchor(heading[2]) if heading else ""


def label(document, name):
    if not name or name == title_of(document):
        return "mainpage" if document == "README.md" else re.sub(r"\W", "_", document)
    return re.sub(r"\W", "_", f"{document}_{name}")


def linked(document, found):
    text, target, fragment = found[1], found[2], found[3] or ""
    if ":" in target:
        return found[0]
    plain = text.replace("`", "")
    place = document
    if target:
        joined = (ROOT / document).parent.joinpath(target).resolve()
        place = joined.relative_to(ROOT).as_posix() if ROOT in joined.parents else ""
        if not is_page(place) or not joined.is_file():
            return text
    return f"[{plain}](@ref {'index' if label(place, fragment[1:]) == 'mainpage' else label(place, fragment[1:])})"


def main(path):
    document = path.resolve().relative_to(ROOT).as_posix()
    seen = {}

    def labelled(found):
        name = anchor(found[2])
        seen[name] = seen.get(name, -1) + 1
        return f"{found[1]} {found[2]} {{#{label(document, f'{name}-{seen[name]}' if seen[name] else name)}}}"

    parts = FENCED.split(path.read_text(encoding="utf-8"))
    for number in range(0, len(parts), 2):
        parts[number] = HEADING.sub(labelled, LINK.sub(lambda found: linked(document, found), parts[number]))
    sys.stdout.write("".join(parts))


main(pathlib.Path(sys.argv[1]))
