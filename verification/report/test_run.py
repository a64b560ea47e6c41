#!/usr/bin/env python3
"""What a run of the tests was a run of, so that its results are used again for exactly that and for nothing else.

    test_run.py BUILD FILE     writes FILE: commit, digest of every file of the tree, the list of tests with their commands,
                               and the digest of every program and library in BUILD

`./dev test` writes it before all tests run, and puts it beside the results once all have passed. `./dev verify` takes these results
when it finds the same state, and runs the tests otherwise. [SRS_VER_033]
"""
import hashlib
import json
import pathlib
import subprocess
import sys
import xml.etree.ElementTree as ElementTree

ROOT = pathlib.Path(__file__).resolve().parents[2]
RECORD = "run/state.json"  # In the folder of the results; with it run/ctest.xml.
NO_PROGRAMS = ("CMakeFiles", "results", "Testing")


def digest_of(path):
    digest = hashlib.sha256()
    with open(path, "rb") as file:
        for block in iter(lambda: file.read(1 << 20), b""):
            digest.update(block)
    return digest.hexdigest()


def tests_of(build):
    """Name and command of each test that ctest knows."""
    listing = json.loads(subprocess.run(["ctest", "--test-dir", build, "--show-only=json-v1"], check=True, capture_output=True, text=True).stdout)
    return [[test["name"], *test.get("command", [])] for test in listing["tests"]]


def git(root, *words):
    return subprocess.run(["git", "-c", "safe.directory=*", *words], cwd=root, check=True, capture_output=True, text=True).stdout


def tree_of(root):
    """One digest over the files that are tracked or could be, with their names."""
    digest = hashlib.sha256()
    for name in sorted(set(git(root, "ls-files", "-z", "-co", "--exclude-standard").split("\0")) - {""}):
        path = root / name
        digest.update(f"{name} {digest_of(path) if path.is_file() else 'none'}\n".encode())
    return digest.hexdigest()


def programs_of(build):
    files = (path for path in build.rglob("*") if path.is_file() and not path.is_symlink() and not set(path.relative_to(build).parts) & set(NO_PROGRAMS))
    return {str(path.relative_to(build)): digest_of(path) for path in sorted(files) if path.stat().st_mode & 0o111 or ".so" in path.suffixes}


def state(root, build):
    return {"commit": git(root, "rev-parse", "HEAD").strip(), "tree": tree_of(root), "tests": tests_of(build), "programs": programs_of(build)}


def passed_run(root, build):
    """The folder with the results of a run of exactly what is there now; None: there is none."""
    results = build / "results"
    record = results / RECORD
    if not record.exists() or not (record.parent / "ctest.xml").exists():
        return None
    if any(case.get("status") == "fail" for case in ElementTree.parse(record.parent / "ctest.xml").iter("testcase")):
        return None
    then, now = json.loads(record.read_text()), state(root, build)
    # Programs that the tests themselves have made since were no part of the run.
    programs = {name: now["programs"].get(name) for name in then["programs"]}
    return results if then == {**now, "programs": programs} else None


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    pathlib.Path(sys.argv[2]).write_text(json.dumps(state(ROOT, pathlib.Path(sys.argv[1]).resolve()), indent=1))
