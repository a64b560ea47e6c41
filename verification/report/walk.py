"""Writes the pages on which an assessor walks: clause -> requirement -> test and its result, function and its coverage, line, and back. [SRS_VER_090]

One page for each requirement, for each document that is cited, and for each file that realises or tests a requirement, all in one folder. Nothing is
measured here; verification/report/check_links.py walks every link in both directions.
"""
import collections
import pathlib
import re
import shutil
import sys

import markdown_it

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "trace"))
import neighbours  # noqa: E402
from common import PRODUCT_FOLDERS, files, read  # noqa: E402
from line_coverage import changed_since, file_coverages  # noqa: E402
from common import CannotLook  # noqa: E402
from system_level import SystemLevel  # noqa: E402
from places import CPP, Functions, below, places_of, told_paths  # noqa: E402
from source_items import BIBLIOGRAPHY, Sources  # noqa: E402
from walk_files import file_page, file_rows, page_of  # noqa: E402

CODE = (*CPP, ".py", ".sh", ".S", ".ld")


def anchor(section):
    """The place of a section on the page of its document."""
    return "s" + re.sub(r"[^A-Za-z0-9.]+", "-", section) if section else "top"


class Link:
    """What shows a requirement, all its cases and programs together."""

    def __init__(self, items, matrix):
        first = items[0]
        self.name, self.kind, self.items, self.path, self.line = first.link, first.kind, items, first.path, first.line
        self.short = first.link.split(" ", 1)[-1] if first.path.endswith(CPP) else first.link
        self.passed = sum(item.passed for item in items)
        self.good = self.passed == len(items)
        self.review, self.hash = matrix.reviews.state(first), matrix.reviews.hash(first)

    @property
    def page(self):
        return f"{page_of(self.path)}#L{self.line}" if self.path else ""


class Walk:
    """What the pages show, and how it hangs together."""

    def __init__(self, root, data, matrix):
        self.root, self.matrix = root, matrix
        self.functions = Functions(root)
        self.coverage, self.stale = file_coverages(root, data), set(changed_since(root, data))
        self.sources = Sources(root, matrix.requirements.keys())
        self.places = places_of(root, matrix.requirements, self.functions)
        self.clauses = {uid: self.sources.clauses(requirement) for uid, requirement in matrix.requirements.items()}
        self.tracked = files(root)
        try:
            self.level = SystemLevel(root)
        except CannotLook:
            self.level = None  # A tree of a fixture.
        self.told = {uid: self.told_files(requirement) for uid, requirement in matrix.requirements.items()}
        self.links = {uid: self.links_of(uid) for uid in matrix.requirements}
        self.citing = collections.defaultdict(lambda: collections.defaultdict(list))  # path or "" -> section or id -> ids of requirements
        for uid, clauses in self.clauses.items():
            for clause in clauses:
                self.citing[clause.path][clause.section or clause.uid].append(uid)
        self.by_file = collections.defaultdict(list)  # file -> (id, line or 0, function or None)
        for uid, places in self.places.items():
            self.by_file_of(uid, places)

    def told_files(self, requirement):
        """What REALISED names: files, and of a folder the files of code."""
        found = []
        for told in told_paths(requirement):
            inside = [name for name in self.tracked if below(name, told)]
            found += [name for name in inside if name.endswith(CODE)] or inside
        return found

    def links_of(self, uid):
        groups = collections.OrderedDict()
        for item in self.matrix.rows[uid]:
            groups.setdefault(item.link, []).append(item)
        return [Link(items, self.matrix) for items in groups.values()]

    def by_file_of(self, uid, places):
        for place in places:
            self.by_file[place.path].append((uid, place.line, place.function))
        for name in self.told[uid]:
            self.by_file[name].append((uid, 0, None))
        for link in self.links[uid]:
            if link.path:
                self.by_file[link.path].append((uid, link.line, self.functions.around(link.path, link.line)))

    def realised(self, uid):
        """Rows of the table "realised in": where, and the coverage of the function or of the whole file."""
        rows, seen = [], set()
        for place in self.places[uid]:
            measured, function = self.coverage.get(place.path), place.function
            counts = measured.within(function.first_line, function.last_line) if measured and function else measured and measured.within(1, 10 ** 9)
            line = function.first_line if function else place.line
            rows.append({"path": place.path, "line": line, "name": function.name if function else "", "coverage": counts, "page": f"{page_of(place.path)}#L{line}"})
            seen.add(place.path)
        for name in self.told[uid]:
            if name not in seen:
                measured = self.coverage.get(name)
                rows.append({"path": name, "line": 0, "name": "", "coverage": measured and measured.within(1, 10 ** 9), "page": page_of(name)})
        return rows

    def clause_page(self, clause):
        return f"{clause.uid}.html" if clause.uid else f"{page_of(clause.path)}#{anchor(clause.section)}"

    def siblings(self, uid):
        """Requirements that come from a clause of this one, in their order."""
        return sorted({other for clause in self.clauses[uid] if not clause.uid for other in self.citing[clause.path][clause.section]} - {uid})

    def picture(self, uid):
        box = neighbours.Box
        above = [box(clause.label, self.clause_page(clause)) for clause in self.clauses[uid]]
        shown = [box(link.short, link.page or "#shown", "passes" if link.good else "fails", link.name) for link in self.links[uid]]
        children = [box(child, f"{child}.html") for child in self.citing[""][uid]]
        siblings = self.siblings(uid)
        before, after = [[box(other, f"{other}.html") for other in siblings if (other > uid) == is_after] for is_after in (False, True)]
        return neighbours.picture(uid, above, before, after, [*children, *shown])

    def file_names(self):
        """Files with a page: what realises or tests a requirement, and all code of the product."""
        product = [name for name in self.tracked if name.endswith(CPP) and any(below(name, folder) for folder in PRODUCT_FOLDERS)]
        return sorted({name for name in self.by_file if name} | set(product))



def rendered(text):
    """A document as HTML, without links into the tree: only what stands in the evidence can be followed."""
    parser = markdown_it.MarkdownIt("commonmark", {"html": False}).enable("table")
    tokens = parser.parse(text)
    for token in (child for block in tokens if block.children for child in block.children):
        if token.type in ("link_open", "link_close"):
            token.tag = "span"
            token.attrs = {}
        elif token.type == "image":
            token.type, token.tag, token.attrs = "text", "", {}
    return parser.renderer.render(tokens, parser.options, {})


def pieces(path, text):
    """A document cut where a section begins: (section or "", its text). The sections of an entry of the bibliography stand in its own piece."""
    heading = r"^### (.+)$" if path == BIBLIOGRAPHY else r"^#{2,5} (\d+(?:\.\d+)*)\.? .*$"
    starts = list(re.finditer(heading, text, re.MULTILINE))
    cuts = [match.start() for match in starts] + [len(text)]
    yield "", text[:cuts[0]]
    for number, match in enumerate(starts):
        yield match.group(1), text[cuts[number]:cuts[number + 1]]


def document_page(walk, path):
    """What the template of a document needs: its pieces, each with the sections that are cited in it and their requirements."""
    citing = walk.citing[path]
    shown = []
    for section, text in pieces(path, read(walk.root, path)):
        inside = [section] if section in citing else []
        if path == BIBLIOGRAPHY and section:
            inside += sorted((cited for cited in citing if walk.sources.named(cited)[0] == section and cited != section), key=natural)
        cited = [{"section": one, "anchor": anchor(one), "uids": citing[one]} for one in inside]
        shown.append({"html": rendered(text), "cited": cited})
    return {"path": path, "pieces": shown}


def natural(text):
    return [int(part) if part.isdigit() else part for part in re.split(r"(\d+)", text)]


def write(root, folder, data, matrix, environment):
    """Writes the pages into an empty folder; the name of each page is that of the file with __ for /."""
    walk = Walk(root, data, matrix)
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)

    def page(name, template, **context):
        text = environment.get_template(template).render(page=name, up="../", walk=walk, page_of=page_of, anchor=anchor, **context)
        (folder / name).write_text(text, encoding="utf-8")

    for uid, requirement in matrix.requirements.items():
        page(f"{uid}.html", "walk_requirement.html.j2", uid=uid, requirement=requirement, status=matrix.status(uid), picture=walk.picture(uid))
    for path in sorted(path for path in walk.citing if path):
        page(page_of(path), "walk_document.html.j2", document=document_page(walk, path))
    for path in walk.file_names():
        page(page_of(path), "walk_file.html.j2", file=file_page(walk, path))
    page("sources.html", "walk_sources.html.j2", natural=natural)
    page("files.html", "walk_files.html.j2", rows=file_rows(walk))
