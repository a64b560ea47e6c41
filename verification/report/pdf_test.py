#!/usr/bin/env python3
"""Which pages are printed, in which order, what is refused, and where links lead; the browser is played by a script."""
import os
import pathlib
import tempfile
import unittest

import pdf

PRINTS = '#!/bin/sh\nfor word; do case $word in --print-to-pdf=*) out=${word#*=};; esac; done\nprintf "%%PDF of %s" "$word" >"$out"\n'


class Reference(dict):
    def get_object(self):
        return self


class Printing(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory(prefix="pdf_test_")
        self.addCleanup(scratch.cleanup)
        self.folder = pathlib.Path(scratch.name).resolve()
        self.addCleanup(os.environ.__setitem__, "PATH", os.environ["PATH"])
        for name, title in (("index", "Evidence"), ("trace", "Trace <code>matrix</code>")):
            (self.folder / f"{name}.html").write_text(f"<body><h1>{title}</h1></body>")

    def browser(self, text):
        place = self.folder / "bin/chromium"
        place.parent.mkdir()
        place.write_text(text)
        place.chmod(0o755)
        os.environ["PATH"] = f"{place.parent}:{os.environ['PATH']}"

    def printed(self):
        return [(title, path.read_text()) for title, path in pdf.printed(self.folder, ("index", "trace"), self.folder)]

    def test_each_page_in_its_order_with_its_title(self):
        self.browser(PRINTS)
        self.assertEqual(self.printed(), [("Evidence", f"%PDF of file://{self.folder}/index.html"), ("Trace matrix", f"%PDF of file://{self.folder}/trace.html")])

    def test_browser_that_fails(self):
        self.browser("#!/bin/sh\necho no display >&2\nexit 3\n")
        with self.assertRaisesRegex(pdf.CannotPrint, "index.html: no PDF by chromium, exit status 3: no display"):
            self.printed()

    def test_browser_that_prints_nothing(self):
        self.browser("#!/bin/sh\nexit 0\n")
        with self.assertRaisesRegex(pdf.CannotPrint, "index.html: no PDF by chromium, exit status 0"):
            self.printed()

    def test_no_browser(self):
        os.environ["PATH"] = str(self.folder)
        with self.assertRaisesRegex(pdf.CannotPrint, "chromium is not installed"):
            self.printed()

    def test_links_lead_beside_the_pdf(self):
        page = {"/Annots": [Reference({"/A": Reference({"/URI": f"file://{self.folder}/walk/a_requirement.html#shown"})}), Reference({"/A": Reference({"/URI": "https://example.org/"})}),
                            Reference({"/Dest": "top"})]}
        self.assertEqual([pdf.beside(target, self.folder) for _, target in pdf.links(page)], ["walk/a_requirement.html#shown", "https://example.org/"])


if __name__ == "__main__":
    unittest.main()
