#!/usr/bin/env python3
"""make.py FOLDER: the reference of the public headers, with guide, semantics, glossary and all other documents, as HTML with a search, in FOLDER/html.

Doxygen makes it; a warning of it is an error. Each page tells the version. Exit status: 0 made, 1 Doxygen warns, 2 it could not be made.
"""
import pathlib
import re
import shutil
import subprocess
import sys

ROOT = pathlib.Path.cwd()


def main(folder):
    project = re.search(r"project\(Counterpoint VERSION ([0-9.]+)", (ROOT / "CMakeLists.txt").read_text(encoding="utf-8"))
    if not project or not shutil.which("doxygen"):
        print(f"{ROOT}: no project(Counterpoint VERSION ...) in CMakeLists.txt, or no doxygen, expected both")
        return 2
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    setup = (ROOT / "tools/reference/Doxyfile").read_text(encoding="utf-8")
    setup += f'PROJECT_NUMBER = {project.group(1)}\nOUTPUT_DIRECTORY = "{folder}"\n'
    done = subprocess.run(["doxygen", "-"], input=setup, capture_output=True, text=True, check=False)
    warnings = [line.replace(f"{ROOT}/", "") for line in done.stderr.splitlines() if line.strip()]
    print("\n".join(warnings))
    if done.returncode != 0 or warnings:
        return 1
    print(f"{folder}/html/index.html: {len(list((folder / 'html').glob('*.html')))} pages, version {project.group(1)}")
    return 0


sys.exit(main(pathlib.Path(sys.argv[1]).resolve()))
