#!/usr/bin/env python3
"""What two pages say of a small tree: the list of requirements with goals, relevance, clauses and result, and which version everything is of."""
import importlib.util
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve()
NEEDED = ("jinja2", "markdown_it", "yaml")
HAS_PACKAGES = all(importlib.util.find_spec(name) for name in NEEDED)
OTHERS = (HERE.parents[2] / ".venv/bin/python", pathlib.Path("/usr/bin/python3"))  # Where they may be.
FIRST, SECOND, THIRD = (f"SRS_{area}_001" for area in ("FIX", "TOL", "OLD"))
REQUIREMENT = "[REQUIREMENT]\nUID: {}\nTITLE: {}\nSTATEMENT: {}\nRATIONALE: Because.\nSOURCE: {}\nVERIFICATION: test\n"
TREE = {
    "docs/requirements/a.sdoc": "[DOCUMENT]\nTITLE: Small\n\n" + "\n".join((
        REQUIREMENT.format(FIRST, "Stop", "It shall stop.", "semantics 1; CiA 304 figure 9; EN 50325-5 6.2"),
        REQUIREMENT.format(SECOND, "Tell", "It shall tell.", "design 5.2"), REQUIREMENT.format(THIRD, "Last", "It shall end.", "design 5.2"))),
    "docs/safety/requirements.md": "| goal | the device | against | reference | rests on |\n|---|---|---|---|---|\n| SG-1 | stops | H1, H2 | semantics 1 | - |\n| SG-2 | tells | H1 | design | SG-1 |\n\n"
                                   "| area | relevance | goals | why |\n|---|---|---|---|\n| FIX | yes | SG-1, SG-2 | it stops |\n| TOL | tool | - | it tells |\n| OLD | no | SG-2 | it ends |\n\n"
                                   f"| requirement | relevance | why |\n|---|---|---|\n| {THIRD} | guarded | it is checked |\n",
    "tests/s_test.cpp": "TEST(S, Case)\n{\n}\n",
}
REPORT = ('<testsuites tests="1"><testsuite name="S" tests="1"><testcase name="Case" file="tests/s_test.cpp" line="1" status="run" classname="S"><properties>'
          f'<property name="requirement-1" value="{FIRST}"/></properties></testcase></testsuite></testsuites>')


def cells(row):
    return [" ".join(re.sub(r"<[^>]+>", " ", cell).split()) for cell in re.findall(r"<td.*?>(.*?)</td>", row, re.DOTALL)]


class Pages(unittest.TestCase):
    def page(self, name, **context):
        import pages
        return pages.templates().get_template(f"{name}.html.j2").render(page=name, up="", **context)

    def test_list_of_requirements(self):
        import pages
        with tempfile.TemporaryDirectory(prefix="pages_test_") as scratch:
            root = pathlib.Path(scratch)
            for name, text in {**TREE, "data/tests/t.xml": REPORT}.items():
                (root / name).parent.mkdir(parents=True, exist_ok=True)
                (root / name).write_text(text, encoding="utf-8")
            page = self.page("safety_requirements", matrix=pages.repository_matrix(root, root / "data"), level=pages.SystemLevel(root), references=pages.references)
        rows = {cells(row)[0]: cells(row)[1:] for row in re.findall(r"<tr.*?>(.*?)</tr>", page, re.DOTALL) if "<td" in row}
        self.assertEqual(rows["SG-1"], ["stops", "H1, H2", "semantics 1", "", "FIX"])
        self.assertEqual(rows["SG-2"], ["tells", "H1", "design", "SG-1", "FIX , OLD"])
        self.assertEqual(rows[FIRST], ["Stop. It shall stop.", "CiA 304 figure 9; EN 50325-5 6.2", "shown"])
        self.assertEqual(rows[SECOND], ["Tell. It shall tell.", "-", "gap"])
        self.assertEqual(rows[f"{THIRD} guarded: it is checked"], ["Last. It shall end.", "-", "gap"])
        heads = [" ".join(re.sub(r"<[^>]+>", " ", head).split()) for head in re.findall(r"<h2 id.*?>(.*?)</h2>", page, re.DOTALL)]
        self.assertEqual(heads, ["FIX safety-relevant: yes; SG-1 , SG-2 ; it stops", "TOL safety-relevant: tool; no goal; it tells", "OLD safety-relevant: no; SG-2 ; it ends"])
        # Each stands under its area.
        self.assertEqual(re.findall(r'<h2 id="(\w+)"|walk/(SRS_\w+)\.html', page), [("FIX", ""), ("", FIRST), ("TOL", ""), ("", SECOND), ("OLD", ""), ("", THIRD)])

    def test_versions(self):
        page = self.page("tools", identity={"commit": "0123", "changed_files": 0, "digest": "ab", "object_count": 1, "target_digest": "cd", "tools": [{"tool": "g++", "version": "12"}],
                                            "versions": {"counterpoint": "counterpoint 1.2.3 (commit 0123)", "sensor.elf": "counterpoint 1.2.4 (commit 0123)"}})
        rows = [cells(row) for row in re.findall(r"<tr>(.*?)</tr>", page, re.DOTALL) if "<td" in row]
        self.assertEqual(rows, [["counterpoint", "counterpoint 1.2.3 (commit 0123)"], ["sensor.elf", "counterpoint 1.2.4 (commit 0123)"], ["g++", "12"]])


if __name__ == "__main__":
    for other in OTHERS if not HAS_PACKAGES else ():
        probe = [other, "-c", "; ".join(f"import {name}" for name in NEEDED)]
        if other.exists() and subprocess.run(probe, capture_output=True, check=False).returncode == 0:
            os.execv(other, [other, *sys.argv])
    unittest.main()
