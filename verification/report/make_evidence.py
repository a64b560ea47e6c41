#!/usr/bin/env python3
"""Makes the evidence: build/evidence/index.html. Called by ./dev verify, which tells what it does.

Collects (builds, tests, coverage, objects, registered commands) into build/evidence/data, runs every gate on its fixtures and
on the tree, and writes pages from what was collected. The pages hold nothing that was not in the data.
"""
import argparse
import concurrent.futures
import datetime
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import time
import xml.etree.ElementTree as ElementTree

ROOT = pathlib.Path(__file__).resolve().parents[2]
for folder in ("verification/coverage", "verification/trace", "verification/release", "version"):
    sys.path.insert(0, str(ROOT / folder))
import bill  # noqa: E402
import digest  # noqa: E402
import pdf  # noqa: E402
import test_run  # noqa: E402
from measure import FURTHER_FOLDERS, TEST_FOLDERS  # noqa: E402

EVIDENCE = ROOT / "build/evidence"
DATA = EVIDENCE / "data"
LOGS = ROOT / "build/log"
ROOMS = {"channel_a": "channel_a", "channel_b": "channel_b", "safety_core_comparator": "safety_core/comparator",
         "safety_core_kernel": "safety_core/kernel", "safety_core_selftest": "safety_core/selftest",
         "safety_core_crosslink": "safety_core/crosslink",
         "hal_api": "hal/api"}


class StepFailed(Exception):
    """A step that the evidence cannot do without."""


class Progress:
    """Tells what is done on the terminal; long output goes to build/log."""

    def __init__(self):
        self.steps = []

    def run(self, title, log, command, environment=None, may_fail=False, beside=False):
        """One step. With `beside` others run meanwhile, and it is told in one line once it has ended."""
        LOGS.mkdir(parents=True, exist_ok=True)
        if not beside:
            print(f"{title} ...", end=" ", flush=True)
        started = time.monotonic()
        with open(LOGS / f"{log}.log", "w", encoding="utf-8") as output:
            status = subprocess.run([str(word) for word in command], cwd=ROOT, stdin=subprocess.DEVNULL, stdout=output,
                                    stderr=subprocess.STDOUT, env=dict(os.environ, **(environment or {})), check=False).returncode
        seconds = round(time.monotonic() - started)
        outcome = f"{'done' if status == 0 else f'exit status {status}'}, {seconds} s"
        print(f"{title} ... {outcome}" if beside else outcome, flush=True)
        self.steps.append({"title": title, "status": status, "log": f"build/log/{log}.log"})
        if status != 0 and not may_fail:
            lines = (LOGS / f"{log}.log").read_text(errors="replace").splitlines()[-30:]
            raise StepFailed(f"{title} failed, build/log/{log}.log ends with:\n" + "\n".join(lines))
        return status


def build(progress, preset, jobs, folders=None):
    """Everything, or what the tests of some folders need."""
    progress.run(f"Configuring build/{preset}", f"configure-{preset}", ["cmake", "--preset", preset])
    targets = [f"{folder}/all" for folder in folders or [] if (ROOT / folder / "CMakeLists.txt").exists()]
    progress.run(f"Building {'tests of the safety rooms' if targets else 'everything'} in build/{preset}", f"build-{preset}",
                 ["cmake", "--build", f"build/{preset}", "--parallel", str(jobs), "--target", *(targets or ["all"])])


def fresh(folder):
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    return folder


def collect_tests(progress, jobs):
    """Every test of the product build: GoogleTest's XML, and result and labels of each ctest entry. [SRS_VER_033]"""
    results = fresh(DATA / "tests")
    junit = DATA / "ctest.xml"
    passed = test_run.passed_run(ROOT, ROOT / "build/product")
    if passed is not None:
        for report in passed.glob("*.xml"):
            shutil.copy(report, results)
        shutil.copy(passed / "run/ctest.xml", junit)
        ended = datetime.datetime.fromtimestamp((passed / "run/ctest.xml").stat().st_mtime, datetime.timezone.utc)
        origin = "a run of ./dev test: same commit, files, tests and programs"
        print(f"Tests of the product: results of {origin}, which ended {ended:%Y-%m-%d %H:%M:%S} UTC", flush=True)
    else:
        progress.run("Running the tests of the product", "verify-test",
                     ["ctest", "--test-dir", "build/product", "--parallel", str(jobs), "--output-on-failure", "--no-tests=error",
                      "--output-junit", junit], {"GTEST_OUTPUT": f"xml:{results}/"}, may_fail=True)
        origin = "a run by ./dev verify itself"
    (DATA / "test_run.json").write_text(json.dumps({"origin": origin}))
    listing = json.loads(subprocess.run(["ctest", "--test-dir", "build/product", "--show-only=json-v1"], cwd=ROOT,
                                        check=True, capture_output=True, text=True).stdout)
    labels = {test["name"]: next((item["value"] for item in test["properties"] if item["name"] == "LABELS"), [])
              for test in listing["tests"]}
    entries = [{"name": case.get("name"), "passed": case.get("status") == "run", "labels": labels.get(case.get("name"), [])}
               for case in ElementTree.parse(junit).iter("testcase")]
    (DATA / "ctest.json").write_text(json.dumps(entries, indent=1))


def collect_objects(progress):
    """The objects that ship, the same rooms not optimised, the package as installed, the compile commands."""
    for folder, preset in (("objects", "product"), ("objects_plain", "coverage")):
        for room, place in ROOMS.items():
            target = fresh(DATA / folder / room)
            subprocess.run(["ar", "x", ROOT / "build" / preset / place / f"lib{room}.a"], cwd=target, check=True)
    shutil.copy(ROOT / "build/product/compile_commands.json", DATA / "compile_commands.json")
    fresh(DATA / "package")
    progress.run("Installing the package", "install", ["cmake", "--install", "build/product", "--prefix", DATA / "package"])
    debian = fresh(DATA / "debian")
    progress.run("Making Debian packages", "cpack", ["cpack", "-G", "DEB", "--config", "build/product/CPackConfig.cmake", "-B", debian])
    shutil.rmtree(debian / "_CPack_Packages")
    progress.run("Making a clean Debian 12 for what is handed out", "clean_root",
                 ["bash", "verification/gates/packages/clean_root.sh", ROOT / "build/clean_root"])
    (DATA / "clean_root").unlink(missing_ok=True)
    (DATA / "clean_root").symlink_to(ROOT / "build/clean_root")


def collect_coverage(progress, jobs):
    build(progress, "coverage", jobs, [*TEST_FOLDERS, *FURTHER_FOLDERS])
    progress.run("Measuring MC/DC, branches, lines, functions (Clang 19)", "coverage",
                 [sys.executable, "verification/coverage/measure.py", "build/coverage", DATA / "coverage", "--jobs", str(jobs),
                  "--html", EVIDENCE / "coverage_clang"], may_fail=True)
    import line_coverage
    line_coverage.record(ROOT, DATA)


def collect_gcov(progress, jobs, wanted):
    """A second view by another compiler; without it no page shows figures of an older run."""
    for old in (DATA / "gcov", EVIDENCE / "coverage_gcov"):
        shutil.rmtree(old, ignore_errors=True)
    if not wanted:
        return
    build(progress, "gcov", jobs, TEST_FOLDERS)
    progress.run("Measuring lines and branches (GCC 12, gcovr)", "gcovr",
                 [sys.executable, "verification/coverage/measure_gcov.py", "build/gcov", DATA / "gcov", "--jobs", str(jobs),
                  "--html", EVIDENCE / "coverage_gcov"], may_fail=True)


def collect_commands(progress, jobs):
    """What the registry of other evidence wants to be run; each command once, those that keep one core busy beside others."""
    import yaml
    registry = yaml.safe_load((ROOT / "verification/trace/other_evidence.yaml").read_text()) or {}
    commands = registry.get("commands") or {}
    single = registry.get("one_core") or []
    if not set(single) <= set(commands):
        raise StepFailed(f"verification/trace/other_evidence.yaml: one_core names {sorted(set(single) - set(commands))}, expected names of commands")

    started = {}

    def run(name, beside):
        started[name] = time.time()
        return progress.run(f"Running {commands[name]}", f"evidence-{name}", ["bash", "-c", commands[name]], may_fail=True, beside=beside)

    with concurrent.futures.ThreadPoolExecutor(max_workers=jobs) as pool:
        statuses = dict(zip(single, pool.map(lambda name: run(name, True), single)))
    statuses.update((name, run(name, False)) for name in commands if name not in single)
    results = {name: {"command": command, "status": statuses[name], "started": started[name]} for name, command in commands.items()}
    (DATA / "commands.json").write_text(json.dumps(results, indent=1))


def told_versions():
    """What the command line prints and what each image for silicon holds, by the name of the file."""
    tool, images = ROOT / "build/product/tools/counterpoint", fresh(DATA / "images")
    texts = {tool.name: subprocess.run([tool, "--version"], check=True, capture_output=True, text=True).stdout.strip()}
    for image in sorted((ROOT / "build/target/verification/target/firmware").glob("*_be32.elf")):
        found = re.findall(rb"counterpoint \d[\w.]* \(commit \w+, objects \w+\)(?=\0)", image.read_bytes())
        shutil.copy(image, images)
        texts[image.name] = " and ".join(text.decode() for text in found) or "no version"
    return texts


def collect_identity():
    def text(*command):
        return subprocess.run(command, cwd=ROOT, check=False, capture_output=True, text=True).stdout.strip()
    tools = [("g++-12", "--version"), ("clang++-19", "--version"), ("clang-tidy-19", "--version"), ("llvm-cov-19", "--version"),
             ("cppcheck", "--version"), ("spin", "-V"), ("gcovr", "--version"), ("valgrind", "--version"), ("cmake", "--version"),
             ("ninja", "--version"), ("arm-none-eabi-g++", "--version"), ("ld.lld-19", "--version"),
             ("qemu-system-arm", "--version"), (sys.executable, "--version"),
             (pathlib.Path(sys.executable).parent / "strictdoc", "version")]
    versions = []
    for command in tools:
        try:
            lines = text(*command).splitlines()
        except FileNotFoundError:
            lines = ["not found"]
        line = next((line.strip() for line in lines if any(character.isdigit() for character in line)), "not found")
        versions.append({"tool": pathlib.Path(command[0]).name, "version": line})
    value, count = digest.digest(ROOT / "build/product")
    git = ("git", "-c", "safe.directory=*")
    changed = text(*git, "status", "--porcelain").splitlines()
    committed = datetime.datetime.fromtimestamp(int(text(*git, "log", "-1", "--format=%ct") or 0), datetime.timezone.utc)
    identity = {
        "version": re.search(r"project\(Counterpoint VERSION (\S+)", (ROOT / "CMakeLists.txt").read_text()).group(1),
        "commit": text(*git, "rev-parse", "HEAD"), "commit_date": text(*git, "log", "-1", "--format=%cI"), "commit_time": f"{committed:%Y-%m-%dT%H:%M:%SZ}",
        "changed_files": len(changed), "versions": told_versions(), "digest": value, "object_count": count,
        "target_digest": digest.digest(ROOT / "build/target")[0], "tools": versions}
    (DATA / "identity.json").write_text(json.dumps(identity, indent=1))
    bill.write(ROOT, DATA, identity)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--quick", action="store_true", help="use the data of the last run, repeat only gates and pages")
    parser.add_argument("--gcc", action="store_true", help="measure lines and branches of the safety rooms with GCC 12 and gcovr, too")
    parser.add_argument("--pdf", action="store_true", help="print the lists into build/evidence/evidence.pdf, too")
    options = parser.parse_args()
    progress = Progress()
    DATA.mkdir(parents=True, exist_ok=True)
    try:
        if not options.quick:
            build(progress, "product", options.jobs)
            collect_tests(progress, options.jobs)
            collect_coverage(progress, options.jobs)
            collect_gcov(progress, options.jobs, options.gcc)
            collect_objects(progress)
            collect_commands(progress, options.jobs)
            collect_identity()
        status = progress.run("Running every gate on its fixtures and on the tree", "gates",
                              [sys.executable, "verification/gates/run.py", "--tree", DATA, "--results", DATA / "gates_final.json"],
                              may_fail=True)
        import pages
        gaps = pages.write(ROOT, EVIDENCE, DATA)
        (DATA / "verdict.json").write_text(json.dumps({"gaps": gaps}, indent=1))
        (EVIDENCE / pdf.NAME).unlink(missing_ok=True)
        if options.pdf:
            print(f"Printed: build/evidence/{pdf.NAME}, {pdf.write(EVIDENCE, pages.LISTS)} sheets", flush=True)
    except (pdf.CannotPrint, StepFailed, FileNotFoundError, subprocess.CalledProcessError) as problem:
        print(f"The evidence cannot be made: {problem}", file=sys.stderr)
        return 2
    for gap in gaps:
        print(f"GAP  {gap}")
    print(f"Evidence: build/evidence/index.html ({'no gap that is not recorded' if not gaps else f'{len(gaps)} gaps; details: build/log/gates.log'})")
    return 1 if gaps or status != 0 else 0


if __name__ == "__main__":
    sys.exit(main())
