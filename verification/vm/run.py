#!/usr/bin/env python3
"""Boots Debian's kernel in an emulated PC and runs the checks of verification/vm/checks in it.

A check is one file, NAME.sh (BusyBox's shell) or NAME.py, which passes by exit status 0. Comments at its head:
  # Needs: PATH ...            files, programs, folders from the root of the tree, placed at the same path under /
  # Requirements: SRS_...      what a pass shows; written to build/vm/vm.json when all checks ran
  # Seconds: N                 its limit (default 180)
The first comment line that is none of these says in words what it checks. /lib.sh has functions for the shell.

Time in the emulated PC follows executed instructions, not the clock of this machine: a check's limits and waits are the same
however busy this machine is, and waiting costs nothing. A check that fails is told in one line; what it and the kernel said
is in build/vm/failed/NAME.log.

Exit status: 0 every check passed, 1 one did not, 2 the machine could not be made or did not boot.
"""
import argparse
import fcntl
import json
import pathlib
import re
import selectors
import shutil
import subprocess
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import image  # noqa: E402
from image import BUILD, ROOT, CannotMake  # noqa: E402

CHECKS = pathlib.Path(__file__).resolve().parent / "checks"
BOOT_SECONDS = 60
HOST_SECONDS = 10  # A second of the emulated PC takes at most so many of this machine, however busy both are.
FAILED = BUILD / "failed"


class Check:
    """One file of checks/, with what its head says."""

    def __init__(self, path):
        self.path = path
        self.name = path.stem
        self.needs, self.requirements, self.seconds, self.title = [], [], 180, ""
        for line in path.read_text(encoding="utf-8").splitlines():
            if line.startswith("#!"):
                continue
            if not line.startswith("#"):
                break
            key, _, value = line[1:].strip().partition(": ")
            if key == "Needs":
                self.needs += value.split()
            elif key == "Requirements":
                self.requirements += value.split()
            elif key == "Seconds":
                self.seconds = int(value)
            elif not self.title:
                self.title = line[1:].strip()
        for uid in self.requirements:
            if not re.fullmatch(r"SRS_[A-Z][A-Z0-9]*_[0-9]{3}", uid):
                raise CannotMake(f"{path.name}: requirement '{uid}', expected the form SRS_AREA_000")


def chosen(patterns):
    """The checks whose name contains one of the patterns; all without patterns."""
    found = [Check(path) for path in sorted(CHECKS.iterdir()) if path.suffix in (".sh", ".py")]
    picked = [check for check in found if not patterns or any(pattern in check.name for pattern in patterns)]
    if not picked:
        names = ", ".join(check.name for check in found)
        raise CannotMake(f"no check's name contains {' or '.join(patterns)}, expected one of: {names}")
    return picked


def command(kernel, disk):
    """One emulated PC: two Kvaser cards (SJA1000) on one CAN bus, console to a file, report to us."""
    return [image.tool("qemu-system-x86_64"), "-M", "pc", "-cpu", "max", "-accel", "tcg", "-icount", "shift=1,sleep=off", "-m", "1536", "-nodefaults", "-no-user-config",
            "-display", "none", "-no-reboot", "-kernel", str(kernel), "-initrd", str(disk),
            "-append", "console=ttyS0 loglevel=4 panic=-1 mitigations=off tsc=reliable random.trust_cpu=on",
            "-object", "can-bus,id=canbus0", "-device", "kvaser_pci,canbus=canbus0", "-device", "kvaser_pci,canbus=canbus0",
            "-serial", f"file:{BUILD / 'console.log'}", "-serial", "stdio"]


def report_lines(machine, limit):
    """Lines of the report as they come; CannotMake when the limit passes."""
    waiting = selectors.DefaultSelector()
    waiting.register(machine.stdout, selectors.EVENT_READ)
    end, rest = time.monotonic() + limit, b""
    while True:
        if not waiting.select(max(0.0, end - time.monotonic())):
            raise CannotMake(f"no end after {limit} s; console: build/vm/console.log")
        got = machine.stdout.read1(65536)
        if not got:
            return
        *lines, rest = (rest + got).split(b"\n")
        for line in lines:
            yield line.decode("utf-8", "replace").rstrip("\r")


def tell(check, verdict, seconds, detail):
    """One line a check; the detail of a failure goes to a file that the line names."""
    line = f"{verdict}  {check.name}: {check.title} ({seconds} s)"
    if verdict == "FAIL":
        path = FAILED / f"{check.name}.log"
        FAILED.mkdir(parents=True, exist_ok=True)
        path.write_text("".join(f"{text}\n" for text in detail), encoding="utf-8")
        said = [text.strip() for text in detail if text.strip() and not text.startswith("kernel: ")]
        line += f": {(said or ['it said nothing'])[-1]}; all of it: {path.relative_to(ROOT)}"
    print(line, flush=True)


def run(checks, kernel, disk):
    """Boots, prints what comes, returns {name: (passed, seconds)}."""
    results, detail = {}, []
    limit = HOST_SECONDS * (BOOT_SECONDS + sum(check.seconds for check in checks))
    shutil.rmtree(FAILED, ignore_errors=True)
    by_file = {check.path.name: check for check in checks}
    started = time.monotonic()
    with open(BUILD / "report.log", "w", encoding="utf-8") as log, \
            subprocess.Popen(command(kernel, disk), stdin=subprocess.DEVNULL, stdout=subprocess.PIPE) as machine:
        try:
            for line in report_lines(machine, limit):
                log.write(line + "\n")
                if line == "up":
                    print(f"booted after {time.monotonic() - started:.1f} s", flush=True)
                verdict = re.fullmatch(r"(pass|FAIL) (\S+) (\d+)", line)
                if verdict:
                    check = by_file[verdict[2]]
                    results[check.name] = (verdict[1] == "pass", int(verdict[3]))
                    tell(check, verdict[1], verdict[3], detail)
                    detail = []
                elif line.startswith("! "):
                    detail.append(line[2:])
                elif line.startswith("  "):
                    print(line, flush=True)
        finally:
            machine.kill()
    return results


def write_json(name, checks, results):
    """Requirements that every one of their checks shows, for the trace."""
    shown = {}
    for check in checks:
        for uid in check.requirements:
            shown[uid] = shown.get(uid, True) and results.get(check.name, (False, 0))[0]
    answer = {"checks": {name: passed for name, (passed, _) in results.items()}, "requirements": shown}
    (BUILD / name).write_text(json.dumps(answer, indent=1) + "\n", encoding="utf-8")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("pattern", nargs="*", help="run only checks whose name contains one of these")
    parser.add_argument("--build", default="build/product", help="take programs from this build folder instead of build/product")
    parser.add_argument("--list", action="store_true", help="list the checks and what they need")
    parser.add_argument("--needs", action="store_true", help="list only the programs of build/product that a run would use")
    arguments = parser.parse_args()
    try:
        checks = chosen(arguments.pattern)
        if arguments.needs:
            needed = sorted({name for check in checks for name in check.needs if name.startswith("build/product/")})
            print("\n".join([] if arguments.list else needed))
            return 0
        if arguments.list:
            for check in checks:
                print(f"{check.name}: {check.title}")
            return 0
        BUILD.mkdir(parents=True, exist_ok=True)
        # Its files are those of one run: a second one waits.
        lock = open(BUILD / "lock", "w", encoding="ascii")
        fcntl.flock(lock, fcntl.LOCK_EX)
        kernel, base = image.base(image.python_of(ROOT))
        disk = BUILD / "disk.cpio"
        disk.write_bytes(base.read_bytes() + image.load(checks, arguments.build).read_bytes())
        results = run(checks, kernel, disk)
    except CannotMake as problem:
        print(f"vm: {problem}", file=sys.stderr)
        return 2
    # A part of the checks is no evidence of requirements that others show too.
    write_json("part.json" if arguments.pattern else "vm.json", checks, results)
    if len(results) != len(checks):
        print(f"vm: {len(results)} of {len(checks)} checks reported; console: build/vm/console.log", file=sys.stderr)
        return 2 if not results else 1
    passed = sum(good for good, _ in results.values())
    print(f"{passed} passed, {len(results) - passed} failed")
    return 0 if passed == len(results) else 1


if __name__ == "__main__":
    sys.exit(main())
