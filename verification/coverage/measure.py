#!/usr/bin/env python3
"""MC/DC, branch, line and function coverage by Clang 19 from the GoogleTest programs of a coverage build.

    measure.py BUILD OUT [--root ROOT] [--html FOLDER] [--jobs N]

BUILD is a build folder of preset `coverage`, in which freestanding rooms (KERNEL) count without locks, in a quarter of the time: tests run them in one
thread. One that a test runs in two wants `-fprofile-update=atomic`, as the hosted rooms have it.
Runs the GoogleTest programs of TEST_FOLDERS that ctest knows there without SWEEPS, the longest first (COST in their CMakeLists.txt), merges the profiles, and
writes OUT/export.json (llvm-cov export), OUT/tests/*.xml (results) and OUT/compile.log: every file of the safety rooms
compiled anew, because Clang tells only while compiling which decisions it leaves out of MC/DC.
The rooms that gaps.json lists as measured are exported as well, by these programs and those of FURTHER_FOLDERS.
With --html also the annotated sources of the safety rooms, each decision with its executed vectors and independence pairs.
Exit status: 0 measured (whether it is enough, the gates say), 1 a test failed, 2 nothing could be measured.
"""
import argparse
import collections
import concurrent.futures
import json
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys

from uncovered import measured_rooms

ROOT = pathlib.Path(__file__).resolve().parents[2]
# Whose tests count: those of the rooms themselves and the suites both channels share. Whole devices, the simulator and the
# tools run the same code and do not count, so that nothing is covered by accident; preset coverage need not build them.
TEST_FOLDERS = ("tests/safety_core", "tests/channel_a", "tests/channel_b", "tests/hal", "verification/conformance",
                "verification/differential")
SAFETY_ROOMS = ("safety_core/contract", "safety_core/comparator", "safety_core/kernel", "safety_core/selftest", "safety_core/crosslink", "channel_a", "channel_b")
# Run beyond these for the rooms that gaps.json lists as measured; they never count for a safety room.
FURTHER_FOLDERS = ("tests/canopen/cia301", "tests/canopen/cia302", "tests/canopen/cia305", "tests/canopen/cia306", "tests/canopen/device",
                   "tests/canopen/start_up", "tests/canopen/manager", "tests/canopen/monitor", "tests/canopen/network_plan",
                   "tests/canopen/generate/text", "tests/runtime/console", "tests/runtime/device", "tests/runtime/manager",
                   "tests/runtime/network_files", "tests/runtime/node", "tests/runtime/yaml")
# Tests that go through the same code at many instants: they show a requirement, and no line that others do not. Each of them runs in the
# product; half of the time of a measurement was theirs. Should one be the only one of a place, the gate says that nothing covers it.
SWEEPS = ("*AtEachInstant*", "Profiles/Foreign*BootUpMessageWasLost*", *(f"Phases/*NothingWrong/{phase}" for phase in range(1, 14) if phase != 11))
TIMEOUT_S = 1800
Test = collections.namedtuple("Test", "name command directory cost environment")


class CannotMeasure(Exception):
    pass


def run(command, **options):
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True, check=False, **options)
    if done.returncode != 0:
        raise CannotMeasure(f"{command[0]} ended with exit status {done.returncode}: {(done.stderr + done.stdout).strip()[-600:]}")
    return done.stdout


def google_tests(build, folders=TEST_FOLDERS):
    """Commands of the ctest entries of TEST_FOLDERS whose program is a GoogleTest."""
    listing = json.loads(run(["ctest", "--test-dir", build, "--show-only=json-v1"]))
    commands = []
    for test in listing["tests"]:
        command = test.get("command")
        if not command or not any(f"/{folder}" in command[0] for folder in folders):
            continue
        if not os.path.exists(command[0]):
            raise CannotMeasure(f"{test['name']} is not built in {build}")
        with open(command[0], "rb") as program:
            if b"gtest_output" not in program.read():
                continue
        properties = {item["name"]: item["value"] for item in test["properties"]}
        environment = dict(pair.split("=", 1) for pair in properties.get("ENVIRONMENT", []))
        commands.append(Test(test["name"], command, properties.get("WORKING_DIRECTORY", str(build)), properties.get("COST", 0), environment))
    if not commands:
        raise CannotMeasure(f"{build}: ctest lists no GoogleTest program, expected the tests to be built there")
    return commands


def run_tests(commands, out, jobs):
    """Every program once, the longest first, so that no core waits for them at the end; returns the names of those that failed."""
    profiles, results = out / "profiles", out / "tests"
    for folder in (profiles, results):
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir(parents=True)

    def one(test):
        name, command, directory, _, of_test = test
        environment = dict(os.environ, **of_test, LLVM_PROFILE_FILE=str(profiles / f"{name}-%p.profraw"),
                           GTEST_OUTPUT=f"xml:{results / name}.xml", GTEST_FILTER="-" + ":".join(SWEEPS))
        done = subprocess.run(command, cwd=directory, env=environment, capture_output=True, text=True, check=False,
                              stdin=subprocess.DEVNULL, timeout=TIMEOUT_S)
        if done.returncode != 0:
            print(f"{name} failed:\n" + "\n".join((done.stdout + done.stderr).splitlines()[-30:]), flush=True)
        return None if done.returncode == 0 else name

    with concurrent.futures.ThreadPoolExecutor(max_workers=jobs) as pool:
        return [name for name in pool.map(one, sorted(commands, key=lambda test: -test.cost)) if name]


def compile_again(build, root, out, jobs):
    """Compiles every file of the safety rooms with its own command, for the warnings alone."""
    wanted = []
    for entry in json.loads((build / "compile_commands.json").read_text()):
        path = pathlib.Path(os.path.realpath(entry["file"]))
        if not path.is_relative_to(root):
            continue
        name = path.relative_to(root).as_posix()
        if not any(name.startswith(room + "/") for room in SAFETY_ROOMS):
            continue
        words = shlex.split(entry["command"])
        words[words.index("-o") + 1] = os.devnull
        wanted.append((name, words, entry["directory"]))

    def one(file):
        name, words, directory = file
        done = subprocess.run(words, cwd=directory, capture_output=True, text=True, check=False)
        return f"{'COMPILED' if done.returncode == 0 else 'FAILED'} {name}\n{done.stderr}"

    with concurrent.futures.ThreadPoolExecutor(max_workers=jobs) as pool:
        (out / "compile.log").write_text("".join(pool.map(one, wanted)))


def without_place(html, root):
    """The pages of llvm-cov name their place and time: without them they are the same wherever and whenever they were made. [SRS_VER_141]"""
    pages, made = html / "sources", html / "coverage" / root.relative_to("/")
    if made.is_dir():
        made.rename(pages)
        shutil.rmtree(html / "coverage")
    for page in html.rglob("*.html"):
        up = "../" * (len(page.relative_to(html).parts) - 1)
        text = re.sub(r"<h4>Created: [^<]*</h4>", "", page.read_text(encoding="utf-8", errors="replace"))
        text = re.sub(r"'(?:\.\./)*(style\.css|control\.js)'", rf"'{up}\1'", text)
        page.write_text(text.replace(f"coverage{root}/", "sources/").replace(f"{root}/", ""), encoding="utf-8")


def merge(commands, out, name):
    """Program files of these tests, and their profiles in one."""
    raw = sorted(path for test in commands for path in (out / "profiles").glob(f"{test.name}-*.profraw"))
    if not raw:
        raise CannotMeasure("the tests wrote no profile, expected a build of preset coverage")
    profile, listing = out / f"{name}.profdata", out / f"{name}_profiles.txt"
    listing.write_text("\n".join(str(path) for path in raw))
    run(["llvm-profdata-19", "merge", "-sparse", f"--input-files={listing}", "-o", profile])
    programs = sorted({test.command[0] for test in commands})
    objects = [programs[0]] + [word for program in programs[1:] for word in ("-object", program)]
    return [*objects, f"-instr-profile={profile}"]


def sources(build, root, rooms):
    """The rooms' own files, by their place in the tree and by the links that other rooms include them through."""
    places = [place for room in rooms for place in [root / room, *sorted((build / "include").glob(f"*/{room}"))] if place.is_dir()]
    return ["-sources", *places] if places else []


def export(commands, further, build, root, out, html, jobs):
    """OUT/export.json: the safety rooms by their own tests, the further rooms by all."""
    safety = merge(commands, out, "merged")
    of_safety = sources(build, root, SAFETY_ROOMS)
    of_further = sources(build, root, measured_rooms(root))

    def export_further():
        every = merge(commands + further, out, "further")
        return json.loads(run(["llvm-cov-19", "export", *every, *of_further]))["data"][0]["files"]

    def export_safety():
        return json.loads(run(["llvm-cov-19", "export", *safety, *of_safety]))

    def show_safety():
        shutil.rmtree(html, ignore_errors=True)
        run(["llvm-cov-19", "show", *safety, "--show-mcdc", "--show-mcdc-summary",
             "--show-branches=count", "--format=html", f"-output-dir={html}", "--project-title=Counterpoint safety rooms", *of_safety])
        without_place(html, root)

    with concurrent.futures.ThreadPoolExecutor(max_workers=jobs) as pool:
        files = pool.submit(export_further) if of_further else None
        whole = pool.submit(export_safety)
        shown = pool.submit(show_safety) if html else None
        result = whole.result()
        if files:
            result["data"][0]["files"] += files.result()
        if shown:
            shown.result()
    (out / "export.json").write_text(json.dumps(result))
    shutil.rmtree(out / "profiles")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("out", type=pathlib.Path)
    parser.add_argument("--root", type=pathlib.Path, default=ROOT)
    parser.add_argument("--html", type=pathlib.Path)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--all-tests", action="store_true", help="every GoogleTest program counts (fixtures of the gates)")
    options = parser.parse_args()
    build, out = options.build.resolve(), options.out.resolve()
    out.mkdir(parents=True, exist_ok=True)
    try:
        commands = google_tests(build, ("",) if options.all_tests else TEST_FOLDERS)
        further = [] if options.all_tests else google_tests(build, FURTHER_FOLDERS)
        failed = run_tests(commands + further, out, options.jobs)
        compile_again(build, options.root.resolve(), out, options.jobs)
        export(commands, further, build, options.root.resolve(), out, options.html.resolve() if options.html else None, options.jobs)
    except CannotMeasure as problem:
        print(problem, file=sys.stderr)
        return 2
    print(f"{len(commands) + len(further)} test programs, {len(failed)} failed{': ' + ', '.join(failed) if failed else ''}")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
