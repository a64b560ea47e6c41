#!/usr/bin/env python3
"""What the end of a program says of a mutant, and what it does not say."""
import pathlib
import tempfile
import unittest

from build_tree import BadInput, run_program


class RunProgram(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory(prefix="mutants_")
        self.addCleanup(scratch.cleanup)
        self.folder = pathlib.Path(scratch.name)

    def program(self, text):
        path = self.folder / "program"
        path.write_text("#!/bin/sh\n" + text, encoding="utf-8")
        path.chmod(0o755)
        return path

    def test_end_by_itself_is_a_verdict(self):
        self.assertEqual(run_program(self.program("exit 0\n"), [], 60), (False, ""))
        self.assertEqual(run_program(self.program("echo 'killed: case 7'; exit 1\n"), [], 60), (True, "case 7"))
        self.assertEqual(run_program(self.program("kill -s SEGV $$\n"), [], 60), (True, "status -11"))

    def test_end_by_the_limit_of_processor_time_is_one(self):
        self.assertEqual(run_program(self.program("while :; do :; done\n"), [], 1), (True, "status -24"))

    def test_program_that_is_killed_from_outside_is_tried_again(self):
        # Given one that is killed twice, and would pass
        text = (f"cd {self.folder}\nif [ -e second ]; then exit 0; fi\n"
                "if [ -e first ]; then touch second; else touch first; fi\nkill -s KILL $$\n")
        self.assertEqual(run_program(self.program(text), [], 60), (False, ""))

    def test_program_that_is_killed_each_time_has_no_verdict(self):
        for name, number in (("KILL", 9), ("TERM", 15), ("INT", 2), ("HUP", 1)):
            said = f"program: it was ended 3 times from outside \\(signal {number}\\), expected that it may run until its end"
            with self.assertRaisesRegex(BadInput, said):
                run_program(self.program(f"kill -s {name} $$\n"), [], 60)


if __name__ == "__main__":
    unittest.main()
