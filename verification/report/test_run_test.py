#!/usr/bin/env python3
"""Whatever changes behind a run of the tests makes them run again: a program, the tree, the commit, the list of tests; so does one that failed. Where results come from is told."""
import json
import pathlib
import subprocess
import tempfile
import unittest
from unittest import mock

import make_evidence
import test_run


class TestRun(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="test_run_")
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        self.build = self.root / "build"
        self.program = self.build / "tests/some_test"
        self.program.parent.mkdir(parents=True)
        self.program.write_bytes(b"program")
        self.program.chmod(0o755)
        (self.build / "tests/libsome.so").write_bytes(b"library")
        (self.root / ".gitignore").write_text("build\n")
        (self.root / "data.dcf").write_text("one")
        self.git("init", "-q")
        self.commit()
        self.tests = [["some_test", str(self.program)]]
        listing = mock.patch.object(test_run, "tests_of", lambda build: self.tests)
        listing.start()
        self.addCleanup(listing.stop)
        run = self.build / "results/run"
        run.mkdir(parents=True)
        self.report = run / "ctest.xml"
        self.report.write_text('<testsuite><testcase name="some_test" status="run"/><testcase name="left_out" status="notrun"/></testsuite>')
        (run / "state.json").write_text(json.dumps(test_run.state(self.root, self.build)))

    def git(self, *words):
        subprocess.run(["git", "-c", "user.name=x", "-c", "user.email=x", *words], cwd=self.root, check=True, capture_output=True)

    def commit(self):
        self.git("add", "-A")
        self.git("commit", "-q", "--allow-empty", "-m", "x")

    def expect(self, is_taken):
        found = test_run.passed_run(self.root, self.build)
        self.assertEqual(found, self.build / "results" if is_taken else None)

    def test_same(self):
        self.expect(True)

    def test_changed_program(self):
        self.program.write_bytes(b"Program")
        self.expect(False)

    def test_changed_library(self):
        (self.build / "tests/libsome.so").write_bytes(b"Library")
        self.expect(False)

    def test_lost_program(self):
        self.program.unlink()
        self.expect(False)

    def test_program_made_by_a_test(self):
        made = self.build / "tests/made"
        made.write_bytes(b"made")
        made.chmod(0o755)
        self.expect(True)

    def test_changed_data(self):
        (self.root / "data.dcf").write_text("two")
        self.expect(False)

    def test_new_file(self):
        (self.root / "more.dcf").write_text("one")
        self.expect(False)

    def test_other_commit(self):
        self.commit()
        self.expect(False)

    def test_other_list(self):
        self.tests = [*self.tests, ["another", "true"]]
        self.expect(False)

    def test_no_record(self):
        (self.build / "results/run/state.json").unlink()
        self.expect(False)

    def test_no_results(self):
        self.report.unlink()
        self.expect(False)

    def test_failed_run(self):
        self.report.write_text('<testsuite><testcase name="some_test" status="fail"/></testsuite>')
        self.expect(False)


class Told(unittest.TestCase):
    """What the evidence holds of where its results come from."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="test_run_")
        self.addCleanup(folder.cleanup)
        self.data = pathlib.Path(folder.name) / "data"
        self.results = pathlib.Path(folder.name) / "results"
        (self.results / "run").mkdir(parents=True)
        self.earlier = self.results / "run/ctest.xml"
        self.earlier.write_text('<testsuite><testcase name="earlier" status="run"/></testsuite>')

    def collected(self, passed_run):
        """Origin and names of the results, where `passed_run` is the folder of an earlier run or None."""
        progress = mock.Mock()
        progress.run.side_effect = lambda *_, **__: (self.data / "ctest.xml").write_text('<testsuite><testcase name="own" status="run"/></testsuite>')
        listing = mock.Mock(stdout='{"tests": []}')
        with mock.patch.object(make_evidence, "DATA", self.data), mock.patch.object(test_run, "passed_run", lambda *_: passed_run), \
                mock.patch.object(make_evidence.subprocess, "run", return_value=listing), mock.patch("builtins.print"):
            make_evidence.collect_tests(progress, 1)
        origin = json.loads((self.data / "test_run.json").read_text())["origin"]
        return origin, [entry["name"] for entry in json.loads((self.data / "ctest.json").read_text())]

    def test_earlier_run(self):
        self.assertEqual(self.collected(self.results), ("a run of ./dev test: same commit, files, tests and programs", ["earlier"]))

    def test_own_run(self):
        self.assertEqual(self.collected(None), ("a run by ./dev verify itself", ["own"]))


if __name__ == "__main__":
    unittest.main()
