"""Where code of a file did not run, as places that a record can name: by their text, so that a record survives other edits of the file.

A place is one of: a function that was never called; a condition that was never true or never false; a region that never ran
though no such condition stands right before it. Each line that did not run and each side of a branch that was not taken belongs
to the place that begins last before it, so that a place which is recorded, or covered, settles them all.
"""
import collections
import json
import os
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "gates"))
from common import functions, read  # noqa: E402

MEASURED_FOLDERS = ("hal", "canopen", "runtime")
RECORDS = "verification/coverage/gaps.json"
GATED = "gated"


class Place:
    def __init__(self, line, column, function, what):
        self.line, self.column, self.function, self.what = line, column, function, what
        self.lines = self.sides = 0  # What of the file belongs to it: lines that did not run, sides of branches not taken.


class FileGaps:
    """The places of one file, and what of it ran: (covered, count) of functions, lines and branches."""

    def __init__(self, entry, text):
        self.text = text.splitlines()
        self.lines = line_counts(entry["segments"])
        self.branches = branch_counts(entry)
        self.entries = [segment for segment in entry["segments"] if segment[3] and segment[4] and not (len(segment) > 5 and segment[5])]
        self.places = []
        measured = []
        for function in sorted(functions(text), key=lambda function: function.first_line):
            lines = [line for line in self.lines if function.first_line <= line <= function.last_line]
            if lines:
                measured.append(function)
                self.look_at(function, lines)
        covered = len(measured) - sum(place.what == "never called" for place in self.places)
        self.places.sort(key=lambda place: (place.line, place.column))
        self.share_out()
        sides = [side for pair in self.branches.values() for side in pair]
        self.counts = {"functions": (covered, len(measured)), "lines": (sum(count > 0 for count in self.lines.values()), len(self.lines)),
                       "branches": (sum(side > 0 for side in sides), len(sides))}

    def look_at(self, function, lines):
        if not any(self.lines[line] for line in lines):
            self.places.append(Place(function.first_line, 0, function.name, "never called"))
            return
        inside = {place: sides for place, sides in self.branches.items() if function.first_line <= place[0] <= function.last_line}
        one_sided = {place: sides for place, sides in inside.items() if (sides[0] == 0) != (sides[1] == 0)}
        for place, sides in one_sided.items():
            self.places.append(Place(place[0], place[1], function.name, self.named(place, "true" if sides[0] == 0 else "false")))
        idle = False
        for line, column, count, *_ in self.entries:
            if not function.first_line <= line <= function.last_line:
                continue
            if count == 0 and not idle and not follows(line, column, inside, one_sided):
                self.places.append(Place(line, column, function.name, f"never ran: {self.first_words(line, column)}"))
            idle = count == 0

    def named(self, place, side):
        """A condition by its text in one line; what a switch takes for a value without a case of its own is a condition too."""
        first, begin, last, end = place
        rows = self.text[first - 1:last]
        rows[-1] = rows[-1][:end - 1]
        rows[0] = rows[0][begin - 1:]
        text = " ".join(" ".join(rows).split()) or self.text[first - 1].strip()  # A macro has no end of its own.
        before = self.text[first - 1][:begin - 1].rstrip()
        return f"never another value: {text}" if before.endswith("switch (") else f"never {side}: {text}"

    def first_words(self, line, column):
        """The first line of a region that has more than a brace."""
        for row in [self.text[line - 1][column - 1:], *self.text[line:]]:
            if row.strip(" \t{}();"):
                return " ".join(row.split())
        return ""

    def share_out(self):
        missing = [((line, 10 ** 6), "lines") for line, count in self.lines.items() if count == 0]
        missing += [(place[:2], "sides") for place, sides in self.branches.items() for side in sides if side == 0]
        for position, kind in missing:
            before = [place for place in self.places if (place.line, place.column) <= position]
            owner = before[-1] if before else None
            if owner is None:  # Code outside of every function that the outline of the file knows.
                owner = Place(position[0], 0, "", f"never ran: {self.first_words(position[0], 1)}")
                self.places.insert(0, owner)
            setattr(owner, kind, getattr(owner, kind) + 1)


def follows(line, column, inside, one_sided):
    """Whether a region that never ran is what a condition with one side leads to: then that condition is the place."""
    if any(place[:2] == (line, column) for place in one_sided):  # A case of a switch is both.
        return True
    before = [place for place in inside if (place[2], place[3]) <= (line, column)]
    if not before:
        return False
    nearest = max(before, key=lambda place: (place[2], place[3]))
    return nearest in one_sided and line - nearest[2] <= 1


def line_counts(segments):
    """Line -> how often it ran, as llvm-cov shows it: the greatest count of a region that begins in the line, else the one around it."""
    by_line = {}
    for segment in segments:
        by_line.setdefault(segment[0], []).append(segment)
    counts, around = {}, None
    for line in range(1, max(by_line, default=0) + 1):
        here = by_line.get(line, [])
        starting = [segment[2] for segment in here if segment[3] and segment[4] and not (len(segment) > 5 and segment[5])]
        inside = [around[2]] if around is not None and around[3] else []
        skipped = bool(here) and here[0][4] and not here[0][3]
        if not skipped and (starting or inside):
            counts[line] = max(starting + inside)
        around = here[-1] if here else around
    return counts


def branch_counts(entry):
    """Place of a condition -> how often true, how often false, over all instances of a template."""
    counts = collections.defaultdict(lambda: [0, 0])
    for branch in entry.get("branches", []):
        sides = counts[tuple(branch[:4])]
        counts[tuple(branch[:4])] = [sides[0] + branch[4], sides[1] + branch[5]]
    return dict(counts)


def name_below(root, filename):
    """The file's path below the root, whatever link it was compiled through; None outside."""
    path = pathlib.Path(os.path.realpath(filename))
    return path.relative_to(root).as_posix() if path.is_relative_to(root) else None


def room_of(name):
    """hal/host/live/bus.cpp is of the room hal/host; None for a file of no measured room."""
    parts = name.split("/")
    return "/".join(parts[:2]) if len(parts) > 2 and parts[0] in MEASURED_FOLDERS else None


def measured_rooms(root):
    """The rooms that gaps.json lists as gated or with a number, not with a reason why they are not measured."""
    path = root / RECORDS
    rooms = json.loads(path.read_text(encoding="utf-8")).get("rooms", {}) if path.is_file() else {}
    return sorted(name for name, state in rooms.items() if state == GATED or isinstance(state, int))


def gaps_of(root, export):
    """File -> FileGaps of the rooms outside of the safety rooms."""
    found = {}
    for entry in export["data"][0]["files"]:
        name = name_below(root, entry["filename"])
        if name is not None and room_of(name) and (root / name).is_file():
            found[name] = FileGaps(entry, read(root, name))
    return found
