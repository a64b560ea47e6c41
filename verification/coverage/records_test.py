#!/usr/bin/env python3
"""What the page Coverage shows of a room: raw and effective counts, and records, from the tree and the measurement of the gate's fixture."""
import json
import pathlib
import shutil
import tempfile
import unittest

from records import Coverage

VERIFICATION = pathlib.Path(__file__).resolve().parents[1]
GATE = VERIFICATION / "gates/coverage"


class Rooms(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory(prefix="records_")
        self.addCleanup(scratch.cleanup)
        self.root = pathlib.Path(scratch.name).resolve()
        shutil.copytree(GATE / "fixture/near_miss_recorded/tree", self.root, dirs_exist_ok=True)
        self.kept = self.root / "verification/coverage/gaps.json"
        self.gaps = json.loads(self.kept.read_text())
        self.export = json.loads((GATE / "rooms_export.json").read_text().replace("@TREE@", str(self.root)))

    def room(self):
        self.kept.write_text(json.dumps(self.gaps))
        coverage = Coverage(self.root, self.export)
        return coverage, coverage.rooms["hal/host"]

    def test_recorded_places_count_as_effective(self):
        # Of Limited lines 4, 5, 9 and 10 run, 6 to 8 do not; of Unused none of 13 to 15.
        coverage, room = self.room()
        self.assertEqual(coverage.findings, [])
        self.assertEqual(room.raw, {"functions": [1, 2], "lines": [4, 10], "branches": [1, 2]})
        self.assertEqual(room.effective, {"functions": 2, "lines": 10, "branches": 2})
        self.assertEqual([record["id"] for record in room.records], ["GAP_FIX_001", "GAP_FIX_002"])
        self.assertEqual(room.open, [])

    def test_without_a_record_a_place_is_open(self):
        del self.gaps["gaps"][1]
        coverage, room = self.room()
        self.assertEqual(room.effective, {"functions": 1, "lines": 7, "branches": 2})
        self.assertEqual(room.open, ["hal/host/measured.cpp:12: Unused: never called"])
        self.assertEqual(coverage.findings, ["hal/host/measured.cpp:12: Unused: never called; not covered, and no record in verification/coverage/gaps.json"])

    def test_a_number_is_enough_for_open_places(self):
        self.gaps["rooms"]["hal/host"], self.gaps["gaps"] = 2, []
        coverage, room = self.room()
        self.assertEqual(coverage.findings, [])
        self.assertFalse(room.is_gated)
        self.assertEqual(len(room.open), 2)

    def test_a_record_survives_other_edits_of_its_file(self):
        # Three lines more above: the measurement moves with them.
        source = self.root / "hal/host/measured.cpp"
        source.write_text("\n\n\n" + source.read_text())
        for entry in self.export["data"][0]["files"]:
            if entry["filename"].endswith("hal/host/measured.cpp"):
                entry["segments"] = [[segment[0] + 3, *segment[1:]] for segment in entry["segments"]]
                entry["branches"] = [[branch[0] + 3, branch[1], branch[2] + 3, *branch[3:]] for branch in entry["branches"]]
        self.assertEqual(self.room()[0].findings, [])

    def test_the_page_shows_all_of_it(self):
        page = (VERIFICATION / "report/templates/coverage.html.j2").read_text()
        for shown in ("room.name", "room.raw[metric]", "room.effective[metric]", "room.records|length", "room.open|length", "room.why_not_measured",
                      "record.id", "record.what", "record.reason", "record.reviewer"):
            self.assertIn(shown, page)


if __name__ == "__main__":
    unittest.main()
