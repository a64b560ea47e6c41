#!/usr/bin/env python3
"""What the page Coverage shows of a room: raw and effective counts, and records, from the tree and the measurement of the gate's fixture."""
import importlib.util
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

from records import METRICS, Coverage

VERIFICATION = pathlib.Path(__file__).resolve().parents[1]
GATE = VERIFICATION / "gates/coverage"
OWN_PYTHON = VERIFICATION.parent / ".venv/bin/python"
NEEDED = ("jinja2", "markdown_it")
HAS_PACKAGES = all(importlib.util.find_spec(name) for name in NEEDED)
# Where they may be: the pinned ones, and Debian's python3-jinja2 and python3-markdown-it.
OTHERS = (OWN_PYTHON, pathlib.Path("/usr/bin/python3"))


def rendered(coverage):
    """The page as the evidence has it, line by line."""
    sys.path.insert(0, str(VERIFICATION / "report"))
    import pages
    context = {"page": "coverage", "up": "", "coverage": [], "metrics": pages.METRICS, "rooms": list(coverage.rooms.values()), "room_metrics": METRICS,
               "has_clang": False, "has_gcov": False, "page_of": pages.page_of}
    return pages.templates().get_template("coverage.html.j2").render(**context).splitlines()


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
        # Given the first record with a reviewer and a reason of its own, and the second one without a reviewer
        self.gaps["gaps"][0].update(reason="Nothing sends it on this machine.", reviewer="R. Eader")
        self.gaps["gaps"][1].update(reason="Kept for another <board> only.", reviewer="")
        page = rendered(self.room()[0])
        name = page.index("<tr><td><code>hal/host</code></td>")
        self.assertEqual(page[name + 1:name + 3],
                         ['<td class="">gated</td>',
                          '<td class="n">1/2</td><td class="n ">2/2</td><td class="n">4/10</td><td class="n ">10/10</td><td class="n">1/2</td><td class="n ">2/2</td>'
                          '<td class="n">2</td><td class="n ">0</td></tr>'])
        for record, reason, reviewer in (("GAP_FIX_001", "Nothing sends it on this machine.", "R. Eader"),
                                         ("GAP_FIX_002", "Kept for another &lt;board&gt; only.", "nobody yet")):
            row = next(number for number, line in enumerate(page) if line.startswith(f'<tr id="{record}"><td>{record}</td><td><code>hal/host/measured.cpp</code>'))
            self.assertEqual(page[row + 1], f"<td>{reason}</td><td>{reviewer}</td></tr>")

    def test_the_page_shows_places_without_a_record_and_rooms_that_are_not_measured(self):
        del self.gaps["gaps"][1]
        self.gaps["rooms"]["hal/other"] = "Runs on the target alone."
        page = rendered(self.room()[0])
        name = page.index("<tr><td><code>hal/host</code></td>")
        self.assertEqual(page[name + 2],
                         '<td class="n">1/2</td><td class="n bad">1/2</td><td class="n">4/10</td><td class="n bad">7/10</td><td class="n">1/2</td><td class="n ">2/2</td>'
                         '<td class="n">1</td><td class="n bad">1</td></tr>')
        self.assertIn("<h3>hal/host: 1 places without a record</h3>", page)
        self.assertIn("<ul><li><code>hal/host/measured.cpp:12: Unused: never called</code></li></ul>", page)
        other = page.index("<tr><td><code>hal/other</code></td>")
        self.assertEqual(page[other + 1], '<td class="bad">not measured</td><td colspan="8">Runs on the target alone.</td></tr>')


if __name__ == "__main__":
    for other in OTHERS if not HAS_PACKAGES else ():
        probe = [other, "-c", "; ".join(f"import {name}" for name in NEEDED)]
        if other.exists() and subprocess.run(probe, capture_output=True, check=False).returncode == 0:
            os.execv(other, [other, *sys.argv])
    unittest.main()
