#!/usr/bin/env python3
"""Line and branch coverage by GCC 12 and gcovr, from the same GoogleTest programs: a second opinion by another compiler.

    measure_gcov.py BUILD OUT [--html FOLDER] [--jobs N]

BUILD is a build folder of preset `gcov`. Writes OUT/summary.json (gcovr --json-summary).
Exit status: 0 measured, 1 a test failed, 2 nothing could be measured.
"""
import argparse
import pathlib
import shutil
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from measure import ROOT, SAFETY_ROOMS, CannotMeasure, google_tests, run, run_tests  # noqa: E402


def commit_time():
    """Of the pages: when the measured state was committed, so that two runs write the same."""
    done = subprocess.run(["git", "-c", "safe.directory=*", "log", "-1", "--format=%ct"], cwd=ROOT, capture_output=True, text=True, check=False)
    return done.stdout.strip() or "0"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("out", type=pathlib.Path)
    parser.add_argument("--html", type=pathlib.Path)
    parser.add_argument("--jobs", type=int, default=2)
    options = parser.parse_args()
    build, out = options.build.resolve(), options.out.resolve()
    out.mkdir(parents=True, exist_ok=True)
    try:
        for path in build.rglob("*.gcda"):
            path.unlink()
        failed = run_tests(google_tests(build), out, options.jobs)
        filters = [word for room in SAFETY_ROOMS for word in ("--filter", f"{ROOT}/{room}/")]
        # One thread: when one of several cannot run its gcov, gcovr waits for it for ever.
        command = ["gcovr", "--gcov-executable", "gcov-12", "--root", ROOT, "--object-directory", build, *filters,
                   "--branches", "--exclude-throw-branches", "--exclude-unreachable-branches", "--json-summary", out / "summary.json"]
        if options.html:
            shutil.rmtree(options.html, ignore_errors=True)
            options.html.mkdir(parents=True)
            command += ["--html-details", options.html.resolve() / "index.html", "--html-self-contained", "--timestamp", commit_time()]
        print(run([*command, build], cwd=build))
    except CannotMeasure as problem:
        print(problem, file=sys.stderr)
        return 2
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
