#!/usr/bin/env python3
"""What is handed out in other ways than as an installed folder: as sources of another project (FetchContent), as Debian packages with and without
CMake (pkg-config), by Conan. In each way examples/first_device is built and prints what the user's guide says. The Debian packages
are those in DATA/debian, made by cpack; Conan is that of requirements.txt."""
import os
import pathlib
import re
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from common import CannotLook, read, run_gate  # noqa: E402

TREE = pathlib.Path(__file__).resolve().parents[3]
PROJECT = "tests/integration/subproject"
EXAMPLE = "examples/first_device"
GUIDE = "docs/user_guide.md"
PACKAGES = ("libcounterpoint-dev", "counterpoint")
SHOWN = re.compile(r"^<!-- output: build/first_device -->\n```\w*\n(.*?)^```$", re.MULTILINE | re.DOTALL)
COMPILER = "g++-12"


class Fails(Exception):
    """A command that has to work does not; the text is the end of what it said."""


def run(*command, env=None):
    """All that the command says."""
    done = subprocess.run([str(word) for word in command], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False, env=env)
    if done.returncode != 0:
        lines = [line for line in done.stdout.splitlines() if line.strip()]
        raise Fails(f"{pathlib.Path(str(command[0])).name} {command[1] if len(command) > 1 else ''} fails: " + " | ".join(lines[-8:]))
    return done.stdout


def cmake(source, folder, *options):
    run("cmake", "-G", "Unix Makefiles", "-S", source, "-B", folder, f"-DCMAKE_CXX_COMPILER={COMPILER}", *options)
    run("cmake", "--build", folder, "--parallel", "2")


def compare(findings, way, shown, printed):
    if printed != shown:
        findings.append(f"{way}: first_device prints '{printed.strip()}', expected '{shown.strip()}' as in {GUIDE}")


def check_sources(findings, root, shown, work):
    """As a part of another project, with the tools of every system: Makefiles, one compiler."""
    cmake(root / PROJECT, work / "sources", f"-DCOUNTERPOINT_TREE={root}")
    compare(findings, "as sources", shown, run(work / "sources/first_device/first_device"))


def unpack(findings, archives, system):
    """Lays the packages out in `system` as dpkg would; none may own a file of another one."""
    owners = {}
    for archive in archives:
        name = run("dpkg-deb", "--field", archive, "Package").strip()
        run("dpkg-deb", "--extract", archive, system / name)
        for path in sorted(path for path in (system / name).rglob("*") if path.is_file()):
            inside = path.relative_to(system / name)
            if inside in owners:
                findings.append(f"{archive.name}: /{inside} is in {owners[inside]}, too, expected it in one package")
            owners[inside] = name
        if not (system / name / f"usr/share/doc/{name}/copyright").is_file():
            findings.append(f"{archive.name}: no /usr/share/doc/{name}/copyright, expected the licence")
        run("cp", "-a", f"{system / name}/.", system / "root")
    for name in PACKAGES:
        if name not in owners.values():
            findings.append(f"debian/: no package {name}, expected one each of {', '.join(PACKAGES)}")


def check_debian(findings, root, data, shown, work):
    system = work / "debian"
    (system / "root").mkdir(parents=True)
    unpack(findings, sorted((data / "debian").glob("*.deb")), system)
    if findings:
        return
    usr = system / "root/usr"
    cmake(root / EXAMPLE, work / "found", f"-DCMAKE_PREFIX_PATH={usr}")
    compare(findings, "Debian package, CMake", shown, run(work / "found/first_device"))
    environment = os.environ | {"PKG_CONFIG_PATH": str(usr / "lib/pkgconfig"), "PKG_CONFIG_SYSROOT_DIR": ""}
    flags = run("pkg-config", "--cflags", "--libs", "counterpoint", env=environment).split()
    sources = sorted((root / EXAMPLE).glob("*.cpp"))
    run(COMPILER, "-std=c++17", *sources, "-o", work / "linked", *flags)
    compare(findings, "Debian package, pkg-config", shown, run(work / "linked"))
    version = re.search(r"project\(Counterpoint VERSION ([0-9.]+)", read(root, "CMakeLists.txt")).group(1)
    told = run(usr / "bin/counterpoint", "--version")
    if not told.startswith(f"counterpoint {version} "):
        findings.append(f"Debian package: counterpoint --version prints '{told.strip()}', expected version {version}")


def check_conan(findings, root, shown, work):
    conan = TREE / ".venv/bin/conan"
    if not conan.is_file():
        raise CannotLook(".venv/bin/conan of requirements.txt")
    environment = os.environ | {"CONAN_HOME": str(work / "conan"), "CXX": COMPILER, "CC": "gcc-12"}
    run(conan, "profile", "detect", env=environment)
    printed = run(conan, "create", root, "-c", "tools.build:jobs=2", "-c", "tools.cmake.cmake_layout:test_folder=$TMP", env=environment)
    if shown not in printed:
        findings.append(f"Conan: the test of the package prints no '{shown.strip()}', expected it as in {GUIDE}")


def gate(root, data):
    if not list((data / "debian").glob("*.deb")):
        raise CannotLook("debian/*.deb (cpack -G DEB)")
    shown = SHOWN.search(read(root, GUIDE))
    if not shown:
        raise CannotLook(f"'<!-- output: build/first_device -->' and its block in {GUIDE}")
    findings = []
    ways = {"as sources": lambda work: check_sources(findings, root, shown[1], work),
            "Debian package": lambda work: check_debian(findings, root, data, shown[1], work),
            "Conan": lambda work: check_conan(findings, root, shown[1], work)}
    for way, check in ways.items():
        with tempfile.TemporaryDirectory(prefix="packages_") as folder:
            try:
                check(pathlib.Path(folder))
            except Fails as failure:
                findings.append(f"{way}: {failure}")
    return findings, "sources in another project, Debian packages by CMake and pkg-config, Conan"


run_gate(gate)
