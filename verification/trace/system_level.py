"""The system level above the requirements, from docs/safety/requirements.md: goals, and of each area which goals it serves and whether safety rests on it.

Used by the gate `safety_requirements` and by the evidence pages."""
import pathlib
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "gates"))
from common import CannotLook, read, table_rows  # noqa: E402

DOCUMENT = "docs/safety/requirements.md"
RELEVANCES = ("yes", "guarded", "tool", "evidence", "no")
# Sources that are not the project's own documents.
REFERENCE = re.compile(r"^(?:EN|IEC|ISO|CiA|SO-|SPN|EL6751|PLC )")


def listed(cell):
    """What a cell lists; "-" is nothing."""
    return [] if cell == "-" else [part.strip() for part in cell.split(",")]


def area_of(uid):
    return uid.split("_")[1]


class SystemLevel:
    """Rows of the three tables, each with its line."""

    def __init__(self, root):
        if not (root / DOCUMENT).is_file():
            raise CannotLook(f"no {DOCUMENT}")
        self.goals, self.areas, self.single, self.twice = {}, {}, {}, []
        for line, header, cells in table_rows(read(root, DOCUMENT)):
            if header[0] == "goal":
                self.keep(self.goals, cells[0], {"line": line, "text": cells[1], "against": listed(cells[2]), "reference": [part.strip() for part in cells[3].split(";")],
                                                 "rests_on": listed(cells[4])})
            elif header[0] == "area":
                self.keep(self.areas, cells[0], {"line": line, "relevance": cells[1], "goals": listed(cells[2]), "why": cells[3]})
            elif header[0] == "requirement":
                self.keep(self.single, cells[0], {"line": line, "relevance": cells[1], "why": cells[2]})

    def keep(self, table, name, row):
        if name in table:
            self.twice.append((row["line"], name))
        table[name] = row

    def relevance(self, uid):
        row = self.single.get(uid) or self.areas.get(area_of(uid))
        return row["relevance"] if row else "not allocated"

    def parents(self, uid):
        row = self.areas.get(area_of(uid))
        return row["goals"] if row else []


def references(requirement):
    """The clauses of standards and texts of others that a requirement names."""
    return [item.strip() for item in requirement.fields["SOURCE"].split(";") if REFERENCE.match(item.strip())]
