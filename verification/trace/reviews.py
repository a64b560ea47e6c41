#!/usr/bin/env python3
"""Reviews of links from a requirement to what shows it (verification/trace/reviews.yaml, which people write).

    .venv/bin/python verification/trace/reviews.py ID [DATA]    the links of a requirement, each as a record to fill in by who reviewed it

DATA is what ./dev verify collected, build/evidence/data unless it is named. Exit status: 0 printed, 2 there is nothing to print.
"""
import datetime
import hashlib
import pathlib
import re
import sys

import yaml

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "gates"))
from common import functions, read  # noqa: E402

FILE = "verification/trace/reviews.yaml"
FIELDS = ("requirement", "evidence", "by", "date", "hash")
ASKED = ("TITLE", "STATEMENT", "RATIONALE", "SOURCE", "VERIFICATION")


class Bodies:
    """The text of what shows a requirement: the body of a test, the whole file of another check."""

    def __init__(self, root):
        self.root, self.of_file = root, {}

    def of(self, item):
        if not item.path.endswith((".cpp", ".hpp")):
            return read(self.root, item.path) if item.path and item.link.startswith(("gate ", "check ")) else item.name
        if item.path not in self.of_file:
            text = read(self.root, item.path)
            self.of_file[item.path] = text.splitlines(), functions(text)
        lines, found = self.of_file[item.path]
        test = next((function for function in found if function.first_line <= item.line <= function.last_line), None)
        return "\n".join(lines[test.first_line - 1:test.last_line]) if test else ""


def hash_of(requirement, body):
    """Over the words of both: a line that is broken elsewhere is no change."""
    text = "\0".join([*(requirement.fields.get(field, "") for field in ASKED), body])
    return hashlib.sha256(" ".join(text.split()).encode()).hexdigest()[:16]


def record_problem(record):
    if not isinstance(record, dict) or set(record) != set(FIELDS):
        return f"expected the fields {', '.join(FIELDS)}"
    empty = [field for field in FIELDS if not str(record[field] or "").strip()]
    if empty:
        return f"{empty[0]} is empty"
    if not re.fullmatch(r"\d{4}-\d{2}-\d{2}", str(record["date"])):
        return f"date '{record['date']}', expected YYYY-MM-DD"
    return ""


class Reviews:
    """The state of each link, and what is wrong with the records. [SRS_VER_092, SRS_VER_093]"""

    def __init__(self, root, requirements, rows):
        self.requirements, self.bodies, self.problems, self.records = requirements, Bodies(root), [], {}
        path = root / FILE
        content = (yaml.safe_load(path.read_text()) if path.exists() else None) or {}
        for number, record in enumerate(content.get("reviews") or [], start=1):
            problem = record_problem(record)
            if not problem:
                key = (record["requirement"], record["evidence"])
                problem = "the link has a record already" if key in self.records else ""
                self.records.setdefault(key, record)
            if problem:
                self.problems.append(f"{FILE}: record {number}: {problem}")
        by_link = {(uid, item.link): item for uid, items in rows.items() for item in items}
        for (uid, link), record in self.records.items():
            where = f"{FILE}: {uid}: {link}"
            if (uid, link) not in by_link:
                self.problems.append(f"{where}: there is no such link, expected its record to be removed")
            elif self.state(by_link[uid, link])["state"] == "suspect":
                self.problems.append(f"{where}: requirement or test have changed since {record['by']} reviewed the link on {record['date']}, "
                                     "expected another review")

    def hash(self, item):
        return hash_of(self.requirements[item.uid], self.bodies.of(item))

    def state(self, item):
        """unreviewed, reviewed or suspect, with who and when."""
        record = self.records.get((item.uid, item.link))
        if record is None:
            return {"state": "unreviewed", "by": "", "date": ""}
        same = str(record["hash"]) == self.hash(item)
        return {"state": "reviewed" if same else "suspect", "by": record["by"], "date": str(record["date"])}


def main(arguments):
    from matrix import repository_matrix
    root = pathlib.Path(__file__).resolve().parents[2]
    if len(arguments) not in (1, 2):
        print(__doc__, file=sys.stderr)
        return 2
    matrix = repository_matrix(root, arguments[1] if len(arguments) == 2 else root / "build/evidence/data")
    links = {item.link: item for item in matrix.rows.get(arguments[0], [])}
    if not links:
        print(f"{arguments[0]}: no such requirement, or nothing that shows it was collected by ./dev verify", file=sys.stderr)
        return 2
    for link, item in sorted(links.items()):
        print(yaml.safe_dump([{"requirement": item.uid, "evidence": link, "by": "", "date": datetime.date.today(), "hash": matrix.reviews.hash(item)}],
                             sort_keys=False, width=200), end="")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
