#!/usr/bin/env python3
"""What is handed out in other ways than as an installed folder: as sources of another project (by FetchContent and by add_subdirectory), as
Debian packages with and without CMake (pkg-config), by Conan. In each way examples/first_device is built and prints what the user's guide says. The Debian packages
are those in DATA/debian, made by cpack; Conan is that of requirements.txt.

As sources, only first_device and the libraries that it links may be built, and no compiler may be told -Werror.

All of it runs in a copy of DATA/clean_root, a Debian 12 that has a compiler and CMake and nothing of what developers install here, so that
what a package does not name is missed; the Debian packages are installed there by apt, with what they depend on. Fixtures, whose packages
are empty, have a file DATA/this_machine instead and run on the machine itself."""
import json
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
MAKEFILES = "Unix Makefiles"
WAYS = {"FetchContent": MAKEFILES, "add_subdirectory": "Ninja"}  # Each way, and the generator it is tried with.
LIBRARY = re.compile(r"\blib\w+\.a\b")


class Fails(Exception):
    """A command that has to work does not; the text is the end of what it said."""


class Machine:
    """Where the commands run: this machine (clean_root is None), or in a clean root, where the tree can be read and `work` be written."""

    def __init__(self, clean_root, readable, work):
        self.clean_root, self.work = clean_root, work
        self.readable = [word for path in sorted(set(readable)) for word in ("--ro-bind", path, path)]

    def words(self, command, env):
        if self.clean_root is None:
            return command, os.environ | env
        variables = [word for name, value in env.items() for word in ("--setenv", name, value)]
        return ["bwrap", "--unshare-pid", "--die-with-parent", "--bind", self.clean_root, "/", "--proc", "/proc", "--dev", "/dev", "--perms", "1777", "--tmpfs", "/tmp",
                *self.readable, "--bind", self.work, self.work, "--ro-bind", "/etc/resolv.conf", "/etc/resolv.conf",
                "--clearenv", "--setenv", "PATH", "/usr/sbin:/usr/bin:/sbin:/bin", "--setenv", "HOME", self.work, *variables, *command], None

    def run(self, *command, **env):
        """All that the command says."""
        words, environment = self.words(command, env)
        done = subprocess.run([str(word) for word in words], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False, env=environment)
        if done.returncode != 0:
            lines = [line for line in done.stdout.splitlines() if line.strip()]
            lines = [line for line in lines if "error:" in line][:4] + lines[-8:]
            raise Fails(f"{pathlib.Path(str(command[0])).name} {command[1] if len(command) > 1 else ''} fails: " + " | ".join(lines))
        return done.stdout

    def cmake(self, source, folder, *options, generator=MAKEFILES):
        self.run("cmake", "-G", generator, "-S", source, "-B", folder, f"-DCMAKE_CXX_COMPILER={COMPILER}", *options)
        self.run("cmake", "--build", folder, "--parallel", "2")


def compare(findings, way, shown, printed):
    if printed != shown:
        findings.append(f"{way}: first_device prints '{printed.strip()}', expected '{shown.strip()}' as in {GUIDE}")


def link_of(folder):
    """What first_device is linked of, as the generator has written it."""
    words = folder / "first_device/CMakeFiles/first_device.dir/link.txt"
    if words.is_file():
        return words.read_text()
    rule = re.search(r"^build first_device/first_device: .*\n(?:  .*\n)*", (folder / "build.ninja").read_text(), re.MULTILINE)
    return rule[0] if rule else ""


def check_built(findings, way, folder):
    """Programs and libraries that are there, outside CMake's own folders, and the options of the compiler."""
    linked = set(LIBRARY.findall(link_of(folder)))
    files = [path for path in sorted(folder.rglob("*")) if path.is_file() and not path.is_symlink() and "CMakeFiles" not in path.parts]
    for path in files:
        is_more = path.name not in linked if path.suffix == ".a" else os.access(path, os.X_OK) and path.name != "first_device"
        if is_more:
            findings.append(f"{way}: builds {path.relative_to(folder)}, expected first_device and what it links")
    strict = [entry for entry in json.loads((folder / "compile_commands.json").read_text()) if "-Werror" in entry["command"].split()]
    if strict:
        findings.append(f"{way}: {len(strict)} files, {pathlib.Path(strict[0]['file']).name} first, are compiled with -Werror, expected none")


def check_sources(findings, root, _, shown, machine):
    """As a part of another project, with one compiler."""
    for way, generator in WAYS.items():
        folder = machine.work / way
        machine.cmake(root / PROJECT, folder, f"-DCOUNTERPOINT_TREE={root}", f"-DCOUNTERPOINT_WAY={way}", "-DCMAKE_EXPORT_COMPILE_COMMANDS=ON",
                      generator=generator)
        compare(findings, f"as sources by {way}", shown, machine.run(folder / "first_device/first_device"))
        check_built(findings, f"as sources by {way}", folder)


def unpack(findings, archives, system):
    """Lays the packages out in `system` as dpkg would; none may own a file of another one."""
    owners = {}
    for archive in archives:
        name = subprocess.run(["dpkg-deb", "--field", archive, "Package"], check=True, capture_output=True, text=True).stdout.strip()
        subprocess.run(["dpkg-deb", "--extract", archive, system / name], check=True)
        for path in sorted(path for path in (system / name).rglob("*") if path.is_file()):
            inside = path.relative_to(system / name)
            if inside in owners:
                findings.append(f"{archive.name}: /{inside} is in {owners[inside]}, too, expected it in one package")
            owners[inside] = name
        if not (system / name / f"usr/share/doc/{name}/copyright").is_file():
            findings.append(f"{archive.name}: no /usr/share/doc/{name}/copyright, expected the licence")
        subprocess.run(["cp", "-a", f"{system / name}/.", system / "root"], check=True)
    for name in PACKAGES:
        if name not in owners.values():
            findings.append(f"debian/: no package {name}, expected one each of {', '.join(PACKAGES)}")


def check_debian(findings, root, data, shown, machine):
    system = machine.work / "debian"
    (system / "root").mkdir(parents=True)
    archives = sorted((data / "debian").glob("*.deb"))
    unpack(findings, archives, system)
    if findings:
        return
    usr, found, environment = system / "root/usr", [f"-DCMAKE_PREFIX_PATH={system}/root/usr"], {}
    if machine.clean_root is None:
        environment = {"PKG_CONFIG_PATH": str(usr / "lib/pkgconfig"), "PKG_CONFIG_SYSROOT_DIR": ""}
    else:
        machine.run("apt-get", "update", "-q")
        machine.run("apt-get", "install", "-q", "-y", "--no-install-recommends", *archives, DEBIAN_FRONTEND="noninteractive")
        usr, found = pathlib.Path("/usr"), []
    machine.cmake(root / EXAMPLE, machine.work / "found", *found)
    compare(findings, "Debian package, CMake", shown, machine.run(machine.work / "found/first_device"))
    flags = machine.run("pkg-config", "--cflags", "--libs", "counterpoint", **environment).split()
    sources = sorted((root / EXAMPLE).glob("*.cpp"))
    machine.run(COMPILER, "-std=c++17", *sources, "-o", machine.work / "linked", *flags)
    compare(findings, "Debian package, pkg-config", shown, machine.run(machine.work / "linked"))
    version = re.search(r"project\(Counterpoint VERSION ([0-9.]+)", read(root, "CMakeLists.txt")).group(1)
    told = machine.run(usr / "bin/counterpoint", "--version")
    if not told.startswith(f"counterpoint {version} "):
        findings.append(f"Debian package: counterpoint --version prints '{told.strip()}', expected version {version}")


def installed_conan(machine):
    """That of requirements.txt, for the Python of the clean root."""
    wheels, environment = machine.work / "wheels", machine.work / "python"
    wanted = next(line for line in read(TREE, "requirements.txt").splitlines() if line.startswith("conan=="))
    subprocess.run([TREE / ".venv/bin/pip", "wheel", "--quiet", "--wheel-dir", wheels, wanted], check=True)
    machine.run("python3", "-m", "venv", environment)
    machine.run(environment / "bin/pip", "install", "--no-index", "--find-links", wheels, "conan")
    return environment / "bin/conan"


def check_conan(findings, root, _, shown, machine):
    conan = TREE / ".venv/bin/conan"
    if not conan.is_file():
        raise CannotLook(".venv/bin/conan of requirements.txt")
    if machine.clean_root is not None:
        conan = installed_conan(machine)
    environment = {"CONAN_HOME": str(machine.work / "conan"), "CXX": COMPILER, "CC": "gcc-12"}
    machine.run(conan, "profile", "detect", **environment)
    printed = machine.run(conan, "create", root, "-c", "tools.build:jobs=2", "-c", "tools.cmake.cmake_layout:test_folder=$TMP", **environment)
    if shown not in printed:
        findings.append(f"Conan: the test of the package prints no '{shown.strip()}', expected it as in {GUIDE}")


def copy_of(clean_root, work):
    if clean_root is None:
        return None
    subprocess.run(["cp", "-a", "--reflink=auto", clean_root, work / "root"], check=True)
    return work / "root"


def clean_root_of(data):
    """None is this machine."""
    if (data / "this_machine").is_file():
        return None
    if not (data / "clean_root/usr/bin").is_dir():
        raise CannotLook("clean_root (verification/gates/packages/clean_root.sh)")
    return (data / "clean_root").resolve()


def gate(root, data):
    if not list((data / "debian").glob("*.deb")):
        raise CannotLook("debian/*.deb (cpack -G DEB)")
    shown = SHOWN.search(read(root, GUIDE))
    if not shown:
        raise CannotLook(f"'<!-- output: build/first_device -->' and its block in {GUIDE}")
    clean_root = clean_root_of(data)
    findings = []
    with tempfile.TemporaryDirectory(prefix="packages_") as folder:
        work = pathlib.Path(folder)
        machine = Machine(copy_of(clean_root, work), (root, TREE, data / "debian"), work)
        # What installs comes last: the others find a machine without it.
        for way, check in {"as sources": check_sources, "Conan": check_conan, "Debian package": check_debian}.items():
            try:
                check(findings, root, data, shown[1], machine)
            except Fails as failure:
                findings.append(f"{way}: {failure}")
    where = "this machine" if clean_root is None else "a clean root"
    return findings, f"sources in another project, Conan, Debian packages by CMake and pkg-config, on {where}"


run_gate(gate)
