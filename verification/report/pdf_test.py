#!/usr/bin/env python3
"""Which pages are printed, in which order, what is refused, how they are joined, and where links lead; the browser is played by a script, what joins by a model of it."""
import contextlib
import io
import os
import pathlib
import sys
import tempfile
import types
import unittest
from unittest import mock

import make_evidence
import pdf

PRINTS = '#!/bin/sh\nfor word; do case $word in --print-to-pdf=*) out=${word#*=};; esac; done\nprintf "%%PDF of %s" "$word" >"$out"\n'


class Reference(dict):
    def get_object(self):
        return self


def library(sheets):
    """pypdf as far as it is used: `sheets` are the pages of each file by its name. Returns the module, and what was joined."""
    joined = types.SimpleNamespace(bookmarks=[], pages=[])

    class PdfWriter:
        def __init__(self):
            self.pages = joined.pages

        def append(self, target, outline_item):
            joined.bookmarks.append((outline_item, len(self.pages)))
            self.pages += sheets[target.name]

        def write(self, path):
            path.write_text("joined")

    class PdfReader:
        def __init__(self, path):
            self.pages = joined.pages if path.name == pdf.NAME else sheets[path.name]

    module, generic = types.ModuleType("pypdf"), types.ModuleType("pypdf.generic")
    module.PdfWriter, module.PdfReader, generic.NameObject, generic.TextStringObject = PdfWriter, PdfReader, str, str
    return {"pypdf": module, "pypdf.generic": generic}, joined


def sheet(*addresses):
    return {"/Annots": [Reference({"/A": Reference({"/URI": address})}) for address in addresses]}


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

    def test_one_pdf_with_a_bookmark_for_each_page(self):
        self.browser(PRINTS)
        modules, joined = library({"index.pdf": [sheet(f"file://{self.folder}/trace.html#top"), sheet()],
                                   "trace.pdf": [sheet("https://example.org/", f"file://{self.folder}/walk/a.html")]})
        with mock.patch.dict(sys.modules, modules):
            self.assertEqual(pdf.write(self.folder, ("index", "trace")), 3)
        self.assertEqual((self.folder / pdf.NAME).read_text(), "joined")
        self.assertEqual(joined.bookmarks, [("Evidence", 0), ("Trace matrix", 2)])
        self.assertEqual([target for page in joined.pages for _, target in pdf.links(page)], ["trace.html#top", "https://example.org/", "walk/a.html"])

    def test_link_into_another_folder_of_this_machine(self):
        self.browser(PRINTS)
        modules, _ = library({"index.pdf": [sheet("file:///elsewhere/a.html")], "trace.pdf": [sheet()]})
        with mock.patch.dict(sys.modules, modules), self.assertRaisesRegex(pdf.CannotPrint, "evidence.pdf: 2 sheets, expected 2 and no link into the folder of the build"):
            pdf.write(self.folder, ("index", "trace"))


class Asked(unittest.TestCase):
    """What ./dev verify makes of --pdf."""

    def evidence(self, *words, problem=None):
        """Exit status, what was printed, and what is told, where printing ends with `problem`."""
        pages = types.SimpleNamespace(write=lambda *_: [], LISTS=("index", "trace"))
        progress, written, told = mock.Mock(), mock.Mock(return_value=7, side_effect=problem), io.StringIO()
        progress.return_value.run.return_value = 0
        with tempfile.TemporaryDirectory(prefix="pdf_test_") as folder, contextlib.ExitStack() as patches:
            for patch in (mock.patch.object(make_evidence, "EVIDENCE", pathlib.Path(folder)), mock.patch.object(make_evidence, "DATA", pathlib.Path(folder) / "data"),
                          mock.patch.object(make_evidence, "Progress", progress), mock.patch.dict(sys.modules, {"pages": pages}),
                          mock.patch.object(pdf, "write", written), mock.patch.object(sys, "argv", ["make_evidence.py", "--quick", *words]),
                          contextlib.redirect_stdout(told), contextlib.redirect_stderr(told)):
                patches.enter_context(patch)
            status = make_evidence.main()
        return status, [call.args[1] for call in written.call_args_list], told.getvalue()

    def test_lists_are_printed_where_that_is_asked(self):
        status, printed, told = self.evidence("--pdf")
        self.assertEqual((status, printed), (0, [("index", "trace")]))
        self.assertIn("Printed: build/evidence/evidence.pdf, 7 sheets\n", told)
        self.assertEqual(self.evidence()[:2], (0, []))

    def test_a_page_that_is_not_printed_fails_with_the_reason(self):
        status, _, told = self.evidence("--pdf", problem=pdf.CannotPrint("index.html: no PDF by chromium, exit status 3: no display"))
        self.assertEqual(status, 2)
        self.assertIn("The evidence cannot be made: index.html: no PDF by chromium, exit status 3: no display\n", told)


if __name__ == "__main__":
    unittest.main()
