"""The page of a file: each line with how often it ran, and a way from each line to the requirements that it stands for. [SRS_VER_090]"""
import html

from common import read


def page_of(path):
    """The name of the page of a file or document; a page of the walk is in one folder with all others."""
    return path.replace("/", "__") + ".html"


class Block:
    """Lines that lead to the same requirements: a function, or the file itself."""

    def __init__(self, place, title, uids, coverage=None):
        self.place, self.title, self.uids, self.coverage = place, title, sorted(set(uids)), coverage
        self.rows = []


def blocks_of(walk, path):
    """The file's own block, and by first line those of functions that a requirement is named for."""
    entries, measured = walk.by_file[path], walk.coverage.get(path)
    own = Block("file", path, [uid for uid, _, _ in entries], measured and measured.within(1, 10 ** 9))
    of_functions = {}
    for uid, _, function in entries:
        if function is not None:
            block = of_functions.setdefault(function.first_line, (function, []))
            block[1].append(uid)
    return own, {first: (function, Block(f"F{first}", function.name, uids, measured and measured.within(function.first_line, function.last_line)))
                 for first, (function, uids) in of_functions.items()}


def line_html(number, text, place, count):
    """Without `count` the file is not measured, with "" the line holds no code."""
    counted = "" if count is None else f'<i{" class=bad" if count == 0 else ""}>{count if count == "" or count < 10000 else "many"}</i>'
    return f'<div><a id="L{number}" href="#{place}">{number}</a>{counted}<code>{html.escape(text) or " "}</code></div>'


def file_page(walk, path):
    """What the template of a file needs: parts in their order, each with its block (None: lines of the file's own block)."""
    own, of_functions = blocks_of(walk, path)
    counts = walk.coverage[path].lines if path in walk.coverage else None
    parts, current, end = [{"block": None, "html": []}], own, 0
    for number, text in enumerate(read(walk.root, path).splitlines(), start=1):
        if number in of_functions:
            function, current = of_functions[number]
            end = function.last_line
            parts.append({"block": current, "html": []})
        elif current is not own and number > end:
            current = own
            parts.append({"block": None, "html": []})
        count = None if counts is None else counts.get(number, "")
        parts[-1]["html"].append(line_html(number, text, current.place, count))
    for part in parts:
        part["html"] = "".join(part["html"])
    return {"path": path, "own": own, "parts": parts, "measured": counts is not None, "stale": path in walk.stale}


def file_rows(walk):
    """Rows of the list of files: how many requirements name each, and its coverage."""
    rows = []
    for path in walk.file_names():
        measured = walk.coverage.get(path)
        rows.append({"path": path, "count": len({uid for uid, _, _ in walk.by_file[path]}), "coverage": measured and measured.within(1, 10 ** 9)})
    return rows
