#!/usr/bin/env python3
"""The pages of requirements, documents and files are made from the tree and what was collected, and walked: every link leads to a place that is there and leads
back, from a clause to a line and from a line to a clause in three links. Each requirement's page shows its text, the goals above it, whether safety rests on it, its evidence and the state of its reviews. No file has changed since its coverage was measured.

DATA/walk, where it is there, holds pages to look at instead."""
import html
import pathlib
import re
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve()
for folder in ("gates", "trace", "report"):
    sys.path.insert(0, str(HERE.parents[2] / folder))
import check_links  # noqa: E402
import pages  # noqa: E402
import walk  # noqa: E402
from line_coverage import changed_since  # noqa: E402
from common import CannotLook, run_gate  # noqa: E402
from matrix import repository_matrix  # noqa: E402
from system_level import DOCUMENT, SystemLevel  # noqa: E402

# The lists are made with the evidence itself.
LIST = re.compile(rf": \.\./({'|'.join(pages.LISTS)})\.html(#\S+)? leads")


def told(matrix, uid, level):
    """What the page of a requirement has to say."""
    requirement = matrix.requirements[uid]
    if level:
        yield f"Safety-relevant: {level.relevance(uid)}."
        yield from level.parents(uid)
    yield requirement.fields["STATEMENT"]
    yield requirement.fields["RATIONALE"]
    for item in matrix.rows[uid]:
        yield item.name
        yield matrix.reviews.state(item)["state"]


def gate(root, data):
    matrix = repository_matrix(root, data)
    if not matrix.requirements:
        raise CannotLook("no requirement")
    level = SystemLevel(root) if (root / DOCUMENT).is_file() else None  # Trees of fixtures have none.
    with tempfile.TemporaryDirectory(prefix="walk_") as scratch:
        evidence = pathlib.Path(scratch)
        made = data / "walk"
        if made.is_dir():
            evidence = data
        else:
            made = evidence / "walk"
            walk.write(root, made, data, matrix, pages.templates())
        findings = [finding for finding in check_links.check(evidence) if not LIST.search(finding)]
        findings += [f"{name}: the file has changed since its coverage was measured, expected ./dev verify without --quick" for name in changed_since(root, data)]
        for uid in matrix.requirements:
            page = made / f"{uid}.html"
            text = html.unescape(page.read_text(encoding="utf-8")) if page.is_file() else ""
            missing = [wanted for wanted in told(matrix, uid, level) if wanted not in text]
            findings += [f"{uid}: its page does not show '{wanted}'" for wanted in missing]
        return findings, f"{len(matrix.requirements)} requirements, {sum(1 for _ in made.glob('*.html'))} pages"


run_gate(gate)
