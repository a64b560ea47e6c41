#!/usr/bin/env python3
"""The objects of core and channels, and the text that tells their digest, are the same wherever the tree stands: two copies of it in
folders of other name and depth are built as what ships is."""
import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "version"))
import digest  # noqa: E402

FOLDERS = ("version", "names", "safety_core", "channel_a", "channel_b", "hal", "canopen", "cmake", "examples", "docs", "CMakeLists.txt", "CMakePresets.json",
           "LICENSE", "CHANGELOG.md")


def run(root, *words):
    done = subprocess.run(words, cwd=root, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise AssertionError(f"{' '.join(words)}: exit status {done.returncode}\n" + "\n".join((done.stdout + done.stderr).splitlines()[-20:]))
    return done.stdout


def built(root):
    """Digest and number of objects, and the text of the version, of a copy of the tree."""
    root.mkdir(parents=True)
    run(ROOT, "cp", "-r", *FOLDERS, str(root))
    run(root, "cmake", "--preset", "product", "-DCOUNTERPOINT_HOST=OFF")
    run(root, "cmake", "--build", "build/product", "--parallel", "2", "--target", "version")
    text = (root / "build/product/version/version.cpp").read_text(encoding="utf-8")
    return *digest.digest(root / "build/product"), text


class Folders(unittest.TestCase):
    def test_same_objects_in_two_folders(self):
        with tempfile.TemporaryDirectory(prefix="folders_") as scratch:
            one, other = built(pathlib.Path(scratch) / "one"), built(pathlib.Path(scratch) / "deeper/in/another")
        self.assertEqual(one, other)
        self.assertGreater(one[1], 50)
        # The copies are no repositories: only the commit is not known there.
        self.assertIn(f'"counterpoint 0.1.0 (commit unknown, objects {one[0][:16]})"', one[2])


if __name__ == "__main__":
    unittest.main()
