"""Prints the lists of the evidence into one PDF for paper: headless Chromium prints each page, pypdf joins them, a bookmark each. [SRS_VER_149]

The pages of the walk are thousands and are not printed; a link to one of them leads to its file beside the PDF.
"""
import pathlib
import re
import shutil
import subprocess
import tempfile

NAME = "evidence.pdf"
BROWSER = "chromium"
TIMEOUT_S = 300
TITLE = re.compile(r"<h1>(.*?)</h1>", re.DOTALL)


class CannotPrint(Exception):
    """No PDF was made; the text says why."""


def print_page(page, target):
    """One page by a browser of its own, which keeps nothing."""
    browser = shutil.which(BROWSER)
    if browser is None:
        raise CannotPrint(f"{BROWSER} is not installed")
    with tempfile.TemporaryDirectory(prefix="print_") as profile:
        command = [browser, "--headless=new", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", "--no-first-run", f"--user-data-dir={profile}",
                   "--no-pdf-header-footer", f"--print-to-pdf={target}", page.as_uri()]
        try:
            done = subprocess.run(command, capture_output=True, text=True, check=False, timeout=TIMEOUT_S)
        except subprocess.TimeoutExpired as problem:
            raise CannotPrint(f"{page.name}: not printed within {TIMEOUT_S} s") from problem
    if done.returncode != 0 or not target.is_file() or not target.read_bytes().startswith(b"%PDF"):
        raise CannotPrint(f"{page.name}: no PDF by {BROWSER}, exit status {done.returncode}: {done.stderr.strip()[-300:]}")


def links(page):
    """The actions of a printed page that lead to an address, each with it."""
    for annotation in page.get("/Annots") or []:
        action = annotation.get_object().get("/A")
        if action is not None and "/URI" in action.get_object():
            yield action.get_object(), str(action.get_object()["/URI"])


def beside(target, folder):
    """An address in the folder of the evidence as one beside the PDF, wherever both are taken to."""
    return target.removeprefix(folder.as_uri() + "/")


def title_of(page):
    found = TITLE.search(page.read_text(encoding="utf-8"))
    return " ".join(re.sub(r"<[^>]+>", "", found.group(1)).split()) if found else page.stem


def printed(evidence, names, scratch):
    """(title, PDF) of each page, in their order."""
    for name in names:
        page, target = evidence / f"{name}.html", pathlib.Path(scratch) / f"{name}.pdf"
        print_page(page, target)
        yield title_of(page), target


def write(evidence, names):
    """Writes NAME into the folder of the evidence; the number of its sheets."""
    import pypdf
    from pypdf.generic import NameObject, TextStringObject
    folder, writer, sheets = evidence.resolve(), pypdf.PdfWriter(), 0
    with tempfile.TemporaryDirectory(prefix="pages_") as scratch:
        for title, target in printed(folder, names, scratch):
            writer.append(target, outline_item=title)
            sheets += len(pypdf.PdfReader(target).pages)
        for page in writer.pages:
            for action, target in links(page):
                action[NameObject("/URI")] = TextStringObject(beside(target, folder))
        writer.metadata = {"/Title": "Counterpoint evidence"}
        writer.write(folder / NAME)
    made = pypdf.PdfReader(folder / NAME)
    if len(made.pages) != sheets or any(target.startswith("file:") for page in made.pages for _, target in links(page)):
        raise CannotPrint(f"{NAME}: {len(made.pages)} sheets, expected {sheets} and no link into the folder of the build")
    return sheets
