#!/usr/bin/env python3
"""Walks the links of the evidence pages in both directions. [SRS_VER_091]

    check_links.py FOLDER     build/evidence, for example; the pages of requirements, files and documents are in FOLDER/walk

Finds: a link to a page or place that is not there; a page of a requirement that leads to a file or document which does not lead back, and the other
way round; a clause from which a line that realises or tests it, or a line from which a clause, is more than three links away.
Exit status: 0 nothing found, 1 findings, one a line.
"""
import collections
import html.parser
import pathlib
import re
import sys
import urllib.parse

WALK = "walk"
BLOCKS = ("section", "svg")
UID = re.compile(r"SRS_[A-Z0-9]+_\d{3}")
LINE = re.compile(r'<div><a id="(L\d+)" href="([^"]*)">.*?</div>', re.DOTALL)  # A line of code, as walk_files.py writes it.


class Page(html.parser.HTMLParser):
    """Places (ids) and links of a page, each link with the innermost block (section, picture) that it stands in."""

    def __init__(self, text):
        super().__init__()
        self.links, self.blocks, self.gaps = [], [], set()
        self.lines = dict(LINE.findall(text))
        self.ids = set(self.lines)
        self.feed(LINE.sub("", text))
        self.links += [("", href) for href in set(self.lines.values())]

    def handle_starttag(self, tag, attributes):
        of = dict(attributes)
        if of.get("id"):
            self.ids.add(of["id"])
        if tag in BLOCKS:
            self.blocks.append(of.get("id", ""))
        href = of.get("href")
        if href:
            self.links.append((self.blocks[-1] if self.blocks else "", href))
        if "gap" in (of.get("class") or "").split():
            self.gaps.add(self.blocks[-1] if self.blocks else "")

    def handle_endtag(self, tag):
        if tag in BLOCKS and self.blocks:
            self.blocks.pop()


def split(name, href):
    """Page and place of a link that stands on the page `name`; None: it leads out of the evidence."""
    parts = urllib.parse.urlsplit(href)
    if parts.scheme or parts.netloc:
        return None
    path = pathlib.PurePosixPath(name).parent / urllib.parse.unquote(parts.path) if parts.path else pathlib.PurePosixPath(name)
    kept = []
    for part in path.parts:
        if part == ".." and kept:
            kept.pop()
        else:
            kept.append(part)
    return "/".join(kept), urllib.parse.unquote(parts.fragment)


class Links:
    def __init__(self, folder):
        self.folder = pathlib.Path(folder)
        names = sorted(path.relative_to(self.folder).as_posix() for where in ("", WALK) for path in (self.folder / where).glob("*.html"))
        self.pages = {name: Page((self.folder / name).read_text(encoding="utf-8")) for name in names}
        self.to = {name: collections.defaultdict(set) for name in names}  # page -> page that it leads to -> blocks that the links stand in
        self.findings = []
        for name, page in self.pages.items():
            for block, href in page.links:
                self.follow(name, block, href)

    def follow(self, name, block, href):
        target = split(name, href)
        if target is None:
            return
        page, place = target
        if page not in self.pages:
            if not (self.folder / page).is_file():
                self.findings.append(f"{name}: {href} leads to no page")
        elif place and place not in self.pages[page].ids:
            self.findings.append(f"{name}: {href} leads to no place of {page}")
        else:
            self.to[name][page].add(block)

    def walked(self):
        """Pages of the walk that are no lists: those of requirements, and the others."""
        pages = [name for name in self.pages if name.startswith(f"{WALK}/") and "__" in name or UID.fullmatch(pathlib.PurePosixPath(name).stem)]
        own = [name for name in pages if UID.fullmatch(pathlib.PurePosixPath(name).stem)]
        return own, [name for name in pages if name not in set(own)]

    def check(self):
        own, others = self.walked()
        for one, another in self.pairs(own, others):
            if (another in self.to[one]) != (one in self.to[another]):
                there, back = (one, another) if another in self.to[one] else (another, one)
                self.findings.append(f"{there}: leads to {back}, which does not lead back")
        for name in own:
            self.check_requirement(name)
        for name in others:
            self.check_lines(name, set(own))
        return self.findings

    def pairs(self, own, others):
        """The pairs of which one leads to the other."""
        kept, of_own = set(others), set(own)
        found = {(one, another) for one in own for another in self.to[one] if another in kept}
        return sorted(found | {(one, another) for another in others for one in self.to[another] if one in of_own})

    def check_requirement(self, name):
        """From a clause to the requirement is one link, from there to a line another."""
        for part, what in (("picture", "a neighbour"), ("sources", "a source"), ("realised", "what realises it"), ("shown", "what shows it")):
            if part not in self.pages[name].ids:
                self.findings.append(f"{name}: has no part '{part}'")
            elif part not in self.pages[name].gaps and not any(part in blocks for blocks in self.to[name].values()):
                self.findings.append(f"{name}: leads to nothing that is {what}, and does not say so")

    def check_lines(self, name, own):
        """From a line to its block, from there to a requirement, from there to a clause."""
        page = self.pages[name]
        leading = {block for requirement, blocks in self.to[name].items() if requirement in own for block in blocks}
        for line, href in page.lines.items():
            block = href.removeprefix("#")
            if block not in leading and block not in page.gaps:
                self.findings.append(f"{name}: line {line} leads to no requirement, and does not say so")


def check(folder):
    """Findings, one text each."""
    return Links(folder).check()


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    found = check(sys.argv[1])
    print("\n".join([*found, f"{len(found)} findings"]))
    sys.exit(1 if found else 0)
