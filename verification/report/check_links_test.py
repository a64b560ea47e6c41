#!/usr/bin/env python3
"""What the check of links finds on small pages: each kind of link that leads nowhere or does not lead back, and nothing on pages that are whole."""
import pathlib
import tempfile
import unittest

import check_links

REQUIREMENT = """<svg id="picture"><a href="docs__semantics.md.html#s1">semantics 1</a></svg>
<section id="sources"><a href="docs__semantics.md.html#s1">semantics 1</a></section>
<section id="realised"><a href="room__a.cpp.html#L2">a.cpp</a></section>
<section id="shown"><a href="tests__a_test.cpp.html#L1">S.Case</a></section>"""
DOCUMENT = '<section id="s1"><a href="SRS_AREA_001.html">SRS_AREA_001</a></section>'
CODE = """<section id="file"><a href="SRS_AREA_001.html">SRS_AREA_001</a></section>
<div><a id="L1" href="#file">1</a><code>// &lt;a&gt;</code></div><div><a id="L2" href="#file">2</a><code>int a;</code></div>"""


class CheckLinks(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="check_links_")
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        (self.folder / "walk").mkdir()
        (self.folder / "trace.html").write_text('<a href="walk/SRS_AREA_001.html#shown">SRS_AREA_001</a> <a href="https://example.org/none">far away</a>')
        self.pages = {"SRS_AREA_001": REQUIREMENT, "docs__semantics.md": DOCUMENT, "room__a.cpp": CODE, "tests__a_test.cpp": CODE}

    def expect(self, *findings):
        for name, text in self.pages.items():
            (self.folder / f"walk/{name}.html").write_text(text)
        self.assertEqual(check_links.check(self.folder), list(findings))

    def change(self, name, old, new):
        self.assertIn(old, self.pages[name])
        self.pages[name] = self.pages[name].replace(old, new)

    def test_whole(self):
        self.expect()

    def test_no_such_page(self):
        (self.folder / "trace.html").write_text('<a href="walk/SRS_AREA_002.html">SRS_AREA_002</a>')
        self.expect("trace.html: walk/SRS_AREA_002.html leads to no page")

    def test_no_such_place(self):
        self.change("SRS_AREA_001", "room__a.cpp.html#L2", "room__a.cpp.html#L3")
        self.expect("walk/SRS_AREA_001.html: room__a.cpp.html#L3 leads to no place of walk/room__a.cpp.html",
                    "walk/room__a.cpp.html: leads to walk/SRS_AREA_001.html, which does not lead back",
                    "walk/SRS_AREA_001.html: leads to nothing that is what realises it, and does not say so")

    def test_document_does_not_lead_back(self):
        self.pages["docs__semantics.md"] = '<section id="s1"></section>'
        self.expect("walk/SRS_AREA_001.html: leads to walk/docs__semantics.md.html, which does not lead back")

    def test_requirement_does_not_lead_back(self):
        self.pages["tests__b_test.cpp"] = CODE
        self.expect("walk/tests__b_test.cpp.html: leads to walk/SRS_AREA_001.html, which does not lead back")

    def test_line_of_no_requirement(self):
        self.change("room__a.cpp", '<div><a id="L2" href="#file">', '<section id="F2"></section><div><a id="L2" href="#F2">')
        self.expect("walk/room__a.cpp.html: line L2 leads to no requirement, and does not say so")

    def test_line_that_says_so(self):
        self.pages["room__b.cpp"] = '<section id="file"><span class="gap soft">None.</span></section><div><a id="L1" href="#file">1</a></div>'
        self.expect()

    def test_no_test_and_says_so(self):
        self.pages.pop("tests__a_test.cpp")
        self.change("SRS_AREA_001", '<a href="tests__a_test.cpp.html#L1">S.Case</a>', '<p class="gap bad">Nothing shows it.</p>')
        self.expect()

    def test_no_test(self):
        self.pages.pop("tests__a_test.cpp")
        self.change("SRS_AREA_001", '<a href="tests__a_test.cpp.html#L1">S.Case</a>', "")
        self.expect("walk/SRS_AREA_001.html: leads to nothing that is what shows it, and does not say so")

    def test_no_picture(self):
        self.change("SRS_AREA_001", 'id="picture"', "")
        self.expect("walk/SRS_AREA_001.html: has no part 'picture'")


if __name__ == "__main__":
    unittest.main()
