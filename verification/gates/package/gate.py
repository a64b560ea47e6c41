#!/usr/bin/env python3
"""A project outside the tree finds the installed package, links kernel, channels and contract, runs, and needs no library
of the host tools. Uses DATA/package, the installation of the product build."""
import pathlib
import re
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from common import CannotLook, run_gate  # noqa: E402

CONSUMER = "tests/integration/package"
SYSTEM = re.compile(r"lib(c|m|gcc_s|stdc\+\+)\.so|ld-linux")


def step(findings, what, command):
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        lines = [line for line in (done.stdout + done.stderr).splitlines() if line.strip()]
        findings.append(f"{CONSUMER}: {what} fails: " + " | ".join(lines[-8:]))
    return done.returncode == 0


def gate(root, data):
    package = data / "package"
    if not package.is_dir() or not (root / CONSUMER / "CMakeLists.txt").exists():
        raise CannotLook(f"package/ (installed product) and {CONSUMER}/CMakeLists.txt")
    findings = []
    with tempfile.TemporaryDirectory(prefix="consumer_") as build:
        program = pathlib.Path(build) / "consumer"
        done = (step(findings, "configuring", ["cmake", "-G", "Ninja", "-S", root / CONSUMER, "-B", build,
                                               "-DCMAKE_CXX_COMPILER=g++-12", f"-DCMAKE_PREFIX_PATH={package}"])
                and step(findings, "building", ["cmake", "--build", build])
                and step(findings, "running", [program]))
        if done:
            dynamic = subprocess.run(["readelf", "-d", program], capture_output=True, text=True, check=True).stdout
            for library in re.findall(r"NEEDED.*\[(.*)\]", dynamic):
                if not SYSTEM.match(library):
                    findings.append(f"{CONSUMER}: the program needs {library}, expected only the language's own libraries")
    return findings, "configure, build, run, needed libraries"


run_gate(gate)
