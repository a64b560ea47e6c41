#!/usr/bin/env python3
"""Every shell block of every document can be copied: the blocks of a document, in their order, run in one shell in an empty folder
that holds a clean copy of the tree. A block that cannot run here says so to its reader in its first line: `# takes long: WHY`,
`# needs a board: WHY`, `# needs a live bus: WHY`; those are counted. Commands in a block without the word `sh` are refused.

/opt/counterpoint is a folder of the gate's own. Where the tree has a finished build it stands for the one that a block makes
(finished_build.py), so that nothing is compiled twice."""
import collections
import concurrent.futures
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))
from common import CannotLook, files, read, run_gate  # noqa: E402

FENCE = re.compile(r"^( *)```([\w-]*)\n(.*?)^\1``` *$", re.MULTILINE | re.DOTALL)
MARK = re.compile(r"# (takes long|needs a board|needs a live bus): \S")
SHELL = ("sh", "bash", "shell", "console")
COMMAND = re.compile(r"^\s*(?:\$ |\./dev\b|cmake |ctest |ninja |counterpoint |python3 |bash |tshark |mkdir |cp |build/\S+ |\.venv/)", re.MULTILINE)
PREFIX = "/opt/counterpoint"
PATIENCE_S = 1200  # Against a command that never ends; no verdict depends on how long one takes.
Block = collections.namedtuple("Block", "line word text")


def blocks_of(text):
    return [Block(text.count("\n", 0, found.start()) + 1, found[2], found[3]) for found in FENCE.finditer(text)]


def script_of(blocks, opt):
    """One shell for all blocks: `cd` and `export` of one hold for the next. The line of the block goes to channel 3 first."""
    parts = [f"echo {block.line} >&3\n{block.text.replace(PREFIX, str(opt))}" for block in blocks]
    return "set -euo pipefail\nexec 3>\"$COUNTERPOINT_LINE\"\n" + "\n".join(parts)


def copy_tree(root, names, target):
    for name in names:
        (target / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(root / name, target / name)


def surroundings(root, made):
    cmake = shutil.which("cmake")
    if cmake is None:
        raise CannotLook("cmake")
    shutil.copy(HERE / "finished_build.py", made / "bin" / "cmake")
    (made / "bin/cmake").chmod(0o755)
    return {**os.environ, "PATH": f"{made / 'bin'}:{os.environ['PATH']}", "COUNTERPOINT_CMAKE": cmake, "COUNTERPOINT_ROOT": str(root),
            "COUNTERPOINT_BUILT": str(made / "built"), "COUNTERPOINT_LINE": str(made / "line"), "HOME": str(made / "home")}


def run_document(root, names, name, blocks):
    """None, or the finding of the first block that fails."""
    with tempfile.TemporaryDirectory(prefix="blocks_") as folder:
        made = pathlib.Path(folder)
        for part in ("tree", "bin", "home"):
            (made / part).mkdir()
        copy_tree(root, names, made / "tree")
        try:
            done = subprocess.run(["bash", "-c", script_of(blocks, made / "opt")], cwd=made / "tree", env=surroundings(root, made), stdin=subprocess.DEVNULL,
                                  capture_output=True, text=True, errors="replace", check=False, timeout=PATIENCE_S)
        except subprocess.TimeoutExpired:
            return f"{name}:{(made / 'line').read_text().split()[-1]}: the block does not end, expected that it does or says in its first line why not"
        if done.returncode == 0:
            return None
        said = [line for line in (done.stdout + done.stderr).replace(str(made), "<made>").splitlines() if line.strip()]
        line = (made / "line").read_text().split()[-1]
        return f"{name}:{line}: the block ends with {done.returncode}, expected 0: " + " | ".join(said[-4:])


def gate(root, _data):
    names = [name for name in files(root) if not name.startswith("build/")]
    documents = [name for name in names if name.endswith(".md")]
    if not documents:
        raise CannotLook("a document (*.md)")
    findings, runs, marked = [], {}, collections.Counter()
    for name in documents:
        for block in blocks_of(read(root, name)):
            mark = MARK.match(block.text)
            if block.word not in SHELL:
                if block.word == "" and COMMAND.search(block.text):
                    findings.append(f"{name}:{block.line}: commands in a block without a word, expected ```sh, so that they are run")
            elif mark:
                marked[mark[1]] += 1
            else:
                runs.setdefault(name, []).append(block)
    with concurrent.futures.ThreadPoolExecutor(max_workers=2) as pool:
        outcomes = pool.map(lambda name: run_document(root, names, name, runs[name]), runs)
        findings += [outcome for outcome in outcomes if outcome]
    told = ", ".join(f"{count} {mark}" for mark, count in sorted(marked.items())) or "none"
    return findings, f"{sum(map(len, runs.values()))} shell blocks of {len(runs)} documents run; not run and marked: {told}"


run_gate(gate)
