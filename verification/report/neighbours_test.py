#!/usr/bin/env python3
"""What the picture of a requirement's neighbours holds and where: sources above, requirements of the same source beside, what shows it below with its result."""
import unittest

import neighbours
from neighbours import Box


def boxes(kind, count):
    return [Box(f"{kind} {number}", f"{kind}{number}.html") for number in range(1, count + 1)]


class Neighbours(unittest.TestCase):
    def setUp(self):
        self.below = [Box("Suite.Good", "a.html#L1", "passes"), Box("Suite.Bad", "b.html#L2", "fails")]
        self.picture = neighbours.picture("SRS_AREA_002", boxes("clause", 2), boxes("before", 3), boxes("after", 3), self.below)

    def box(self, text):
        found = [box for box in self.picture["boxes"] if box.text == text]
        self.assertEqual(len(found), 1, text)
        return found[0]

    def test_sources_stand_above_and_evidence_below(self):
        own = self.box("SRS_AREA_002")
        self.assertEqual((own.href, own.kind), ("", "own"))
        for text in ("clause 1", "clause 2"):
            self.assertLess(self.box(text).y + self.box(text).height, own.y)
        for text in ("Suite.Good", "Suite.Bad"):
            self.assertGreater(self.box(text).y, own.y + own.height)

    def test_requirements_of_the_same_source_stand_beside_it(self):
        """The two before it and the two behind it."""
        own = self.box("SRS_AREA_002")
        for text in ("before 2", "before 3"):
            self.assertLess(self.box(text).x + self.box(text).width, own.x)
        for text in ("after 1", "after 2"):
            self.assertGreater(self.box(text).x, own.x + own.width)
        for text in ("before 2", "before 3", "after 1", "after 2"):
            self.assertTrue(own.y <= self.box(text).y < own.y + own.height, text)
        self.assertFalse({"before 1", "after 3"} & {box.text for box in self.picture["boxes"]})

    def test_each_neighbour_is_a_link_and_tells_its_result(self):
        links = {box.text: box.href for box in self.picture["boxes"] if box.text != "SRS_AREA_002"}
        self.assertEqual(links, {"clause 1": "clause1.html", "clause 2": "clause2.html", "before 2": "before2.html", "before 3": "before3.html",
                                 "after 1": "after1.html", "after 2": "after2.html", "Suite.Good": "a.html#L1", "Suite.Bad": "b.html#L2"})
        self.assertEqual([self.box(text).kind for text in ("Suite.Good", "Suite.Bad")], ["passes", "fails"])

    def test_what_finds_no_room_is_counted_with_a_link_to_the_list(self):
        picture = neighbours.picture("SRS_AREA_002", boxes("clause", 8), [], [], boxes("Suite", 7))
        texts = {box.text: box.href for box in picture["boxes"]}
        self.assertEqual((texts["3 more"], texts["2 more"]), ("#sources", "#shown"))
        self.assertNotIn("clause 6", texts)


if __name__ == "__main__":
    unittest.main()
