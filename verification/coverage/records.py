"""Coverage of the rooms outside of the safety rooms: what ran, what is recorded in gaps.json as not covered, and what is neither.

A room of MEASURED_FOLDERS is in gaps.json under "rooms", in one of three ways: "gated": each place is covered or recorded; a number:
so many places are neither, and may not become more; a text: it is not measured, and why.
A record under "gaps": id, file, function, what (the text that uncovered.py gives), reason, reviewer (empty until a person has read
it), places where the same text is not covered more than once in the function, varies where a run may cover it or not.
"""
import collections
import json
import re

from uncovered import GATED, MEASURED_FOLDERS, RECORDS, FileGaps, Place, gaps_of, room_of  # First: it tells where common.py is.
from common import cpp_files, functions, read

FIELDS = {"id": str, "file": str, "function": str, "what": str, "reason": str, "reviewer": str}
OPTIONAL = {"places": int, "varies": bool}
ID = re.compile(r"GAP_[A-Z0-9]+_\d{3}")
LEAST_REASON = 20  # Letters: less is no sentence.
METRICS = ("functions", "lines", "branches")


class Room:
    """Raw and effective counts of one room, and its places without a record."""

    def __init__(self, name, state):
        self.name, self.state = name, state
        self.raw = {metric: [0, 0] for metric in METRICS}
        self.effective = {metric: 0 for metric in METRICS}
        self.records, self.open = [], []

    @property
    def is_gated(self):
        return self.state == GATED

    @property
    def why_not_measured(self):
        return self.state if isinstance(self.state, str) and not self.is_gated else ""


class Coverage:
    def __init__(self, root, export):
        path = root / RECORDS
        self.text = path.read_text(encoding="utf-8") if path.is_file() else "{}"
        kept = json.loads(self.text)
        self.findings = []
        self.records = [record for record in kept.get("gaps", []) if self.is_whole(record)]
        self.rooms = {name: Room(name, state) for name, state in sorted(kept.get("rooms", {}).items())}
        self.files = gaps_of(root, export)
        self.look_at_rooms(root)
        self.add_files_without_data(root)
        self.match()

    def at(self, text):
        """Where a text of the records stands."""
        before = self.text.find(f'"{text}"')
        return f"{RECORDS}:{self.text.count(chr(10), 0, max(before, 0)) + 1}"

    def is_whole(self, record):
        name = record.get("id", "?")
        wrong = [field for field, kind in FIELDS.items() if not isinstance(record.get(field), kind)]
        wrong += [field for field, value in record.items() if field not in FIELDS and not isinstance(value, OPTIONAL.get(field, ()))]
        if wrong:
            self.findings.append(f"{self.at(name)}: {name}: {', '.join(wrong)} missing, unknown or of another type, expected {', '.join(FIELDS)}")
        elif not ID.fullmatch(name):
            self.findings.append(f"{self.at(name)}: {name}: expected an id like GAP_HAL_001")
        elif len(record["reason"].strip()) < LEAST_REASON:
            self.findings.append(f"{self.at(name)}: {name}: no reason, expected one sentence why nothing covers this place")
        else:
            return True
        return False

    def look_at_rooms(self, root):
        for folder in MEASURED_FOLDERS:
            for path in sorted((root / folder).glob("*")):
                name = path.relative_to(root).as_posix()
                if any(path.rglob("*.cpp")) and name not in self.rooms:
                    self.findings.append(f"{RECORDS}:1: {name} is not among the rooms, expected \"gated\", a number of open places, or why it is not measured")
        for name, room in self.rooms.items():
            measured = any(room_of(file) == name for file in self.files)
            if bool(room.why_not_measured) == measured:
                self.findings.append(f"{self.at(name)}: {name} is {'' if measured else 'not '}measured, and its entry says something else")

    def add_files_without_data(self, root):
        """A file that defines functions and is in no measured program is one place."""
        for room in self.rooms.values():
            if room.why_not_measured or not (root / room.name).is_dir():
                continue
            for name in cpp_files(root, [room.name]):
                if name not in self.files and functions(read(root, name)):
                    self.files[name] = FileGaps({"segments": []}, "")
                    self.files[name].places.append(Place(1, 0, "", "no data"))

    def match(self):
        """Each place with its record; what is left on either side is a finding."""
        ids = collections.Counter(record["id"] for record in self.records)
        self.findings += [f"{self.at(name)}: {name} is the id of {count} records, expected one" for name, count in ids.items() if count > 1]
        by_key = {(record["file"], record["function"], record["what"]): record for record in self.records}
        found = collections.Counter()
        for file, gaps in sorted(self.files.items()):
            room = self.rooms.get(room_of(file))
            if room is not None and not room.why_not_measured:
                self.add(room, file, gaps, by_key, found)
        for key, record in by_key.items():
            self.judge_record(key, record, found[key])
        for room in self.rooms.values():
            self.judge_room(room)

    def add(self, room, file, gaps, by_key, found):
        for metric, (covered, count) in gaps.counts.items():
            room.raw[metric][0] += covered
            room.raw[metric][1] += count
            room.effective[metric] += covered
        for place in gaps.places:
            key = (file, place.function, place.what)
            found[key] += 1
            if key not in by_key or found[key] > by_key[key].get("places", 1):
                room.open.append(f"{file}:{place.line}: {place.function + ': ' if place.function else ''}{place.what}")
                continue
            room.effective["functions"] += place.what == "never called"
            room.effective["lines"] += place.lines
            room.effective["branches"] += place.sides

    def judge_record(self, key, record, count):
        where, room = f"{self.at(record['id'])}: {record['id']}", self.rooms.get(room_of(record["file"]) or "")
        if room is None:
            self.findings.append(f"{where}: {record['file']} is in no room that is listed, expected one")
            return
        room.records.append(record)
        expected = record.get("places", 1)
        if count < expected and not (record.get("varies") and record["file"] in self.files):
            self.findings.append(f"{where} is stale: {record['file']} has {count} such places, expected {expected}; what is covered or gone needs no record")

    def judge_room(self, room):
        if room.is_gated:
            self.findings += [f"{place}; not covered, and no record in {RECORDS}" for place in room.open]
        elif isinstance(room.state, int) and len(room.open) > room.state:
            self.findings.append(f"{self.at(room.name)}: {room.name} has {len(room.open)} places without a record, expected at most {room.state}")
            self.findings += room.open
