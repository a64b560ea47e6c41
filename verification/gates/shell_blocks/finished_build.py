#!/usr/bin/env python3
"""Stands before cmake on the path of a document's blocks, so that they need not build the product once more: where ROOT has a
finished build of a preset, that one is used. All else goes to cmake itself.

    cmake --preset P                    build/P is the finished one
    cmake --build build/P --target T    built there, which is nothing when it is up to date; T is remembered
    cmake --install build/P ...         refused for a file that no remembered target makes: in a fresh build it would not be there

COUNTERPOINT_CMAKE is cmake itself, COUNTERPOINT_ROOT the tree, COUNTERPOINT_BUILT the file of what was built."""
import fcntl
import os
import pathlib
import re
import subprocess
import sys

CMAKE = os.environ["COUNTERPOINT_CMAKE"]
ROOT = pathlib.Path(os.environ["COUNTERPOINT_ROOT"])
BUILT = pathlib.Path(os.environ["COUNTERPOINT_BUILT"])


def configured(preset):
    """Whether build/PRESET is there now, as the finished build."""
    finished, here = ROOT / "build" / preset, pathlib.Path("build") / preset
    if not (finished / "build.ninja").is_file() or here.exists():
        return here.is_symlink()
    here.parent.mkdir(exist_ok=True)
    here.symlink_to(finished)
    return True


def targets(words):
    """The words behind --target, up to the next option; `all` without one."""
    if "--target" not in words:
        return ["all"]
    rest = words[words.index("--target") + 1:]
    return rest[:next((place for place, word in enumerate(rest) if word.startswith("-")), len(rest))]


def missing(build):
    """Files that the install rules want from the build and that no remembered target makes."""
    names = BUILT.read_text(encoding="utf-8").split() if BUILT.exists() else []
    if "all" in names:
        return []
    made = subprocess.run(["ninja", "-C", build, "-t", "commands", *names], capture_output=True, text=True, check=True).stdout if names else ""
    rules = "\n".join(path.read_text(encoding="utf-8") for path in build.resolve().rglob("cmake_install.cmake"))
    wanted = re.findall(rf'TYPE (?:EXECUTABLE|STATIC_LIBRARY).* FILES "{re.escape(str(build.resolve()))}/([^"]+)"', rules)
    return [name for name in wanted if not re.search(rf"(?<!\S){re.escape(name)}(?!\S)", made)]


def build_alone(words):
    """Documents run beside each other, and a build folder stands one build at a time."""
    with (pathlib.Path(words[1]) / "build.ninja").open(encoding="utf-8") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        return subprocess.run([CMAKE, *words], check=False).returncode


def main(words):
    if words[:1] == ["--preset"] and configured(words[1]):
        return 0
    if words[:1] == ["--build"] and pathlib.Path(words[1]).is_symlink():
        with BUILT.open("a", encoding="utf-8") as record:
            record.write("\n".join(targets(words)) + "\n")
        return build_alone(words)
    if words[:1] == ["--install"] and pathlib.Path(words[1]).is_symlink():
        absent = missing(pathlib.Path(words[1]))
        if absent:
            print(f"cmake --install: {absent[0]} is not built by the targets of this document", file=sys.stderr)
            return 1
    return subprocess.run([CMAKE, *words], check=False).returncode


sys.exit(main(sys.argv[1:]))
