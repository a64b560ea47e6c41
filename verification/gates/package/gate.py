#!/usr/bin/env python3
"""A project outside the tree finds the installed package, links kernel, channels and contract, and the network manager, runs,
and needs no library of the host tools. The user's guide is such a project too: its files are taken out of the guide, built, run, and its output
is compared. The package has its licence, manual page and completion where shells look, documents without dead links, examples that configure, a program whose `demo`
finds its files, and in no file the place of the build. Uses DATA/package, the installation of the product build.

In the guide the line `<!-- file: PATH -->` before a code block says that the block is this file, `<!-- part: PATH -->` that
it is a piece of it, and `<!-- output: COMMAND -->` that it is what the command prints in a folder with the guide's files;
`counterpoint` is the program of the package. `<!-- changed: FILE: OLD => NEW -->` says that it is what the guide's program prints
when NEW stands in FILE in place of OLD, which is there once."""
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from common import CannotLook, run_gate  # noqa: E402

CONSUMER = "tests/integration/package"
LINKS = pathlib.Path(__file__).resolve().parents[1] / "links/gate.py"
PROGRAMS = ("consumer", "manager_consumer")
GUIDE = "docs/user_guide.md"
SYSTEM = re.compile(r"lib(c|m|gcc_s|stdc\+\+)\.so|ld-linux")
PROGRAM = "first_device"
# Where shells look, and what `counterpoint` prints.
SHELL_TEXTS = {"share/man/man1/counterpoint.1": ["man"], "share/bash-completion/completions/counterpoint": ["completion", "bash"],
               "share/zsh/site-functions/_counterpoint": ["completion", "zsh"], "share/fish/vendor_completions.d/counterpoint.fish": ["completion", "fish"]}
BLOCK = re.compile(r"^<!-- (file|part|output|changed): (.+?) -->\n```\w*\n(.*?)^```$", re.MULTILINE | re.DOTALL)


def step(findings, project, what, command, **options):
    done = subprocess.run(command, capture_output=True, text=True, check=False, **options)
    if done.returncode != 0:
        lines = [line for line in (done.stdout + done.stderr).splitlines() if line.strip()]
        findings.append(f"{project}: {what} fails: " + " | ".join(lines[-8:]))
    return done.returncode == 0


def build(findings, project, source, folder, package):
    return (step(findings, project, "configuring", ["cmake", "-G", "Ninja", "-S", source, "-B", folder,
                                                    "-DCMAKE_CXX_COMPILER=g++-12", f"-DCMAKE_PREFIX_PATH={package}"])
            and step(findings, project, "building", ["cmake", "--build", folder]))


def check_libraries(findings, project, program):
    dynamic = subprocess.run(["readelf", "-d", program], capture_output=True, text=True, check=True).stdout
    for library in re.findall(r"NEEDED.*\[(.*)\]", dynamic):
        if not SYSTEM.match(library):
            findings.append(f"{project}: the program needs {library}, expected only the language's own libraries")


def first_difference(shown, real):
    """Number of the first line that differs, from 0, and both lines."""
    shown, real = shown.splitlines(), real.splitlines()
    for number in range(max(len(shown), len(real))):
        left = shown[number] if number < len(shown) else "nothing more"
        right = real[number] if number < len(real) else "nothing more"
        if left != right:
            return number, left, right
    return None


def guide_blocks(root):
    text = (root / GUIDE).read_text(encoding="utf-8")
    marks = len(re.findall(r"^<!-- (?:file|part|output|changed): ", text, re.MULTILINE))
    blocks = [(text.count("\n", 0, match.start(3)) + 1, match[1], match[2], match[3]) for match in BLOCK.finditer(text)]
    if not blocks or len(blocks) != marks:
        raise CannotLook(f"a code block after each of the {marks} marks in {GUIDE}, there are {len(blocks)}")
    return blocks


def compare_with_files(findings, root, blocks, work):
    """Lays out what the guide shows as files; what it does not show (a DCF) is copied from the package by the caller."""
    for line, kind, name, shown in blocks:
        if kind in ("output", "changed"):
            continue
        if not (root / name).is_file():
            findings.append(f"{GUIDE}:{line}: there is no {name}, expected the file of this block")
            continue
        real = (root / name).read_text(encoding="utf-8")
        if kind == "file":
            (work / pathlib.PurePath(name).name).write_text(shown, encoding="utf-8")
            difference = first_difference(shown, real)
            if difference:
                findings.append(f"{GUIDE}:{line + difference[0]}: '{difference[1]}', expected '{difference[2]}' as in {name}")
        elif shown not in real:
            findings.append(f"{GUIDE}:{line}: the block is no piece of {name}, expected that it is")


def compare_output(findings, blocks, work, package):
    path = f"{package / 'bin'}:{os.environ['PATH']}"
    for line, kind, command, shown in blocks:
        if kind != "output":
            continue
        words = shlex.split(command)
        words[0] = shutil.which(words[0], path=path) or words[0]
        try:
            done = subprocess.run(words, cwd=work, capture_output=True, text=True, check=False, timeout=1800)
        except OSError as problem:
            findings.append(f"{GUIDE}:{line}: {command} cannot be run: {problem.strerror}")
            continue
        difference = first_difference(shown, done.stdout + done.stderr)
        if difference:
            findings.append(f"{GUIDE}:{line + difference[0]}: the guide shows '{difference[1]}', {command} prints "
                            f"'{difference[2]}'")


def compare_changed(findings, blocks, work, package):
    """The guide's program with each change that the guide tells: what it prints, whatever its exit status."""
    for line, kind, change, shown in blocks:
        if kind != "changed":
            continue
        told = re.fullmatch(r"([\w.]+): (.+) => (.+)", change)
        text = (work / told[1]).read_text(encoding="utf-8") if told and (work / told[1]).is_file() else ""
        if not told or text.count(told[2]) != 1:
            findings.append(f"{GUIDE}:{line}: '{change}', expected FILE: OLD => NEW with OLD once in a file of the guide")
            continue
        with tempfile.TemporaryDirectory(prefix="changed_") as folder:
            copy = pathlib.Path(folder)
            for path in work.iterdir():
                if path.is_file():
                    shutil.copy(path, copy)
            (copy / told[1]).write_text(text.replace(told[2], told[3]), encoding="utf-8")
            if build(findings, f"{GUIDE}:{line}", copy, copy / "build", package):
                done = subprocess.run([copy / "build" / PROGRAM], capture_output=True, text=True, check=False, timeout=1800)
                difference = first_difference(shown, done.stdout + done.stderr)
                if difference:
                    findings.append(f"{GUIDE}:{line + difference[0]}: the guide shows '{difference[1]}', the program with "
                                    f"'{told[3]}' in {told[1]} prints '{difference[2]}'")


def check_guide(findings, root, package):
    blocks = guide_blocks(root)
    with tempfile.TemporaryDirectory(prefix="guide_") as folder:
        work = pathlib.Path(folder)
        for sample in sorted((package / "share/counterpoint/examples/first_device").glob("*.dcf")):
            shutil.copy(sample, work)
        compare_with_files(findings, root, blocks, work)
        if build(findings, GUIDE, work, work / "build", package):
            compare_output(findings, blocks, work, package)
            compare_changed(findings, blocks, work, package)
            for program in sorted((work / "build").glob(PROGRAM)):
                check_libraries(findings, GUIDE, program)
    return len(blocks)


def check_shell_texts(findings, package):
    """Manual page and completion stand in their places, as the program of the package prints them."""
    for name, words in SHELL_TEXTS.items():
        command = ["counterpoint", *words]
        if not (package / name).is_file():
            findings.append(f"package: no {name}, expected what `{' '.join(command)}` prints")
            continue
        printed = subprocess.run([package / "bin/counterpoint", *words], capture_output=True, check=False).stdout
        if (package / name).read_bytes() != printed:
            findings.append(f"{name}: it is not what `{' '.join(command)}` prints")


def check_share(findings, root, package):
    """What comes beside the libraries: licence, documents without dead links, examples that configure, a program that finds them."""
    share = package / "share/counterpoint"
    if not (share / "LICENSE").is_file():
        findings.append("package: no share/counterpoint/LICENSE, expected the licence")
    step(findings, "package", "looking at the links of the documents", [sys.executable, LINKS, share, package])
    with tempfile.TemporaryDirectory(prefix="share_") as folder:
        for project in sorted(share.glob("examples/**/CMakeLists.txt")):
            name = project.parent.relative_to(package).as_posix()
            step(findings, name, "configuring", ["cmake", "-G", "Ninja", "-S", project.parent, "-B", f"{folder}/{project.parent.name}",
                                                 "-DCMAKE_CXX_COMPILER=g++-12", f"-DCMAKE_PREFIX_PATH={package}"])
        step(findings, "package", "counterpoint demo", [package / "bin/counterpoint", "demo", "--html", folder], cwd=folder)
    for path in sorted(path for path in package.rglob("*") if path.is_file()):
        if str(root).encode() in path.read_bytes():
            findings.append(f"{path.relative_to(package)}: the place of the build stands in it, expected that it does not")


def gate(root, data):
    package = data / "package"
    for needed in (CONSUMER + "/CMakeLists.txt", GUIDE):
        if not (root / needed).exists():
            raise CannotLook(needed)
    if not package.is_dir():
        raise CannotLook("package/ (installed product)")
    findings = []
    with tempfile.TemporaryDirectory(prefix="consumer_") as folder:
        if build(findings, CONSUMER, root / CONSUMER, folder, package):
            for program in (pathlib.Path(folder) / name for name in PROGRAMS):
                if step(findings, CONSUMER, f"running {program.name}", [program]):
                    check_libraries(findings, CONSUMER, program)
    blocks = check_guide(findings, root, package)
    check_share(findings, root, package)
    check_shell_texts(findings, package)
    return findings, f"configure, build, run, needed libraries; licence, manual page, completion, links, examples, demo; {blocks} blocks of {GUIDE}"


run_gate(gate)
