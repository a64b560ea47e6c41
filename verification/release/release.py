#!/usr/bin/env python3
"""Packs a release from what ./dev verify made: build/release/counterpoint-VERSION-COMMIT.tar.gz.

    release.py [--draft] [--root FOLDER]

In it: sources (git archive), install tree, images for silicon, evidence, bill of materials (SPDX), changelog, licence, SHA256SUMS over all.
Refused are: changed files, evidence of another commit or with a gap, a program that tells another commit or other objects than the evidence,
a version without its section of the changelog or with unreleased lines, a page that names the folder it was made in.
The same commit and evidence give the same bytes in any folder.
  --draft   packs in spite of that, says so in the name, and lists what a release would be refused for in DRAFT
Exit status: 0 packed, 1 refused, 2 there is nothing to pack. [SRS_VER_142]
"""
import argparse
import gzip
import hashlib
import io
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tarfile

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parents[1] / "version")]
import bill  # noqa: E402
import digest  # noqa: E402

TEXTS = (".html", ".css", ".js", ".json", ".csv", ".svg", ".txt")


class NothingToPack(Exception):
    """What is packed is not there; the text names it."""


def git(root, *words, text=True):
    return subprocess.run(["git", "-c", "safe.directory=*", *words], cwd=root, check=True, capture_output=True, text=text).stdout


def needed(path):
    if not path.exists():
        raise NothingToPack(f"{path.name} is not there, expected it from ./dev verify")
    return path


class Release:
    """What is packed, and what speaks against it."""

    def __init__(self, root):
        self.root, self.evidence = root, root / "build/evidence"
        self.data = self.evidence / "data"
        self.identity = json.loads(needed(self.data / "identity.json").read_text(encoding="utf-8"))
        self.commit = git(root, "rev-parse", "HEAD").strip()
        self.seconds = int(git(root, "log", "-1", "--format=%ct"))
        self.version = re.search(r"project\(Counterpoint VERSION (\S+)", (root / "CMakeLists.txt").read_text(encoding="utf-8")).group(1)

    def refusals(self):
        """One text each."""
        changed = git(self.root, "status", "--porcelain").splitlines()
        if changed:
            yield f"{len(changed)} files are not those of the commit, the first: {changed[0].strip()}"
        if self.identity["commit"] != self.commit or self.identity["changed_files"]:
            yield f"the evidence is of commit {self.identity['commit'][:12]} with {self.identity['changed_files']} changed files, expected {self.commit[:12]}"
        gaps = json.loads(needed(self.data / "verdict.json").read_text(encoding="utf-8"))["gaps"]
        yield from (f"gap of the evidence: {gap}" for gap in gaps)
        yield from self.of_programs()
        yield from self.of_changelog()
        yield from self.of_places()

    def of_programs(self):
        for value, paths in ((self.identity["digest"], [needed(self.data / "package/bin/counterpoint")]),
                             (self.identity["target_digest"], sorted((self.data / "images").glob("*.elf")))):
            told = f"counterpoint {self.version} (commit {self.commit[:12]}, objects {digest.told(value)})"
            if not paths:
                yield "no image for silicon, expected those of ./dev firmware"
            yield from (f"{path.name} does not tell '{told}'" for path in paths if told.encode() + b"\0" not in path.read_bytes())

    def of_changelog(self):
        sections = dict(re.findall(r"^## ([\w.]+)[^\n]*\n(.*?)(?=^## |\Z)", (self.root / "CHANGELOG.md").read_text(encoding="utf-8"), re.MULTILINE | re.DOTALL))
        if self.version not in sections:
            yield f"CHANGELOG.md has no section {self.version}"
        if re.search(r"^- ", sections.get("Unreleased", ""), re.MULTILINE):
            yield "CHANGELOG.md has unreleased lines, expected a version with them"

    def of_places(self):
        place = str(self.root).encode()
        yield from (f"{name} names the folder of the build" for name, path in self.pages() if path.suffix in TEXTS and place in path.read_bytes())

    def pages(self):
        """Name in the release and path of each page of the evidence; the collected data are not packed."""
        needed(self.evidence / "index.html")
        for path in sorted(self.evidence.rglob("*")):
            if path.is_file() and not path.is_relative_to(self.data):
                yield f"evidence/{path.relative_to(self.evidence).as_posix()}", path

    def contents(self):
        """Name -> bytes, mode of all but the sums."""
        found = {name: (path.read_bytes(), 0o644) for name, path in self.pages()}
        for name, path in bill.handed_out(self.data):
            found[name[2:]] = (path.read_bytes(), 0o755 if name.startswith("./install/bin/") else 0o644)
        for name in ("CHANGELOG.md", "LICENSE"):
            found[name] = ((self.root / name).read_bytes(), 0o644)
        found[bill.NAME] = (needed(self.data / bill.NAME).read_bytes(), 0o644)
        with tarfile.open(fileobj=io.BytesIO(git(self.root, "archive", "--format=tar", self.commit, text=False))) as sources:
            for member in sources.getmembers():
                if member.isfile():
                    found[f"source/{member.name}"] = (sources.extractfile(member).read(), 0o755 if member.mode & 0o100 else 0o644)
        return found


def sums(contents):
    return "".join(f"{hashlib.sha256(content).hexdigest()}  {name}\n" for name, (content, _) in sorted(contents.items())).encode()


def packed(contents, folder, seconds):
    """The archive: names in order, the time of the commit, no owner."""
    plain = io.BytesIO()
    with tarfile.open(fileobj=plain, mode="w", format=tarfile.PAX_FORMAT) as archive:
        for name, (content, mode) in sorted(contents.items()):
            entry = tarfile.TarInfo(f"{folder}/{name}")
            entry.size, entry.mode, entry.mtime = len(content), mode, seconds
            archive.addfile(entry, io.BytesIO(content))
    return gzip.compress(plain.getvalue(), compresslevel=6, mtime=seconds)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--draft", action="store_true")
    parser.add_argument("--root", type=pathlib.Path, default=HERE.parents[1])
    options = parser.parse_args()
    try:
        release = Release(options.root.resolve())
        refusals = list(release.refusals())
        for text in refusals:
            print(f"{'draft' if options.draft else 'refused'}: {text}", file=sys.stderr)
        if refusals and not options.draft:
            return 1
        contents = release.contents()
    except (NothingToPack, OSError, KeyError, subprocess.CalledProcessError) as problem:
        print(f"release: {problem}", file=sys.stderr)
        return 2
    name = f"counterpoint-{release.version}-{release.commit[:12]}" + ("-draft" if refusals else "")
    if refusals:
        contents["DRAFT"] = ("".join(f"{text}\n" for text in refusals).encode(), 0o644)
    contents["SHA256SUMS"] = (sums(contents), 0o644)
    archive = packed(contents, name, release.seconds)
    folder = release.root / "build/release"
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    (folder / f"{name}.tar.gz").write_bytes(archive)
    print(f"{len(contents)} files, {len(archive)} bytes: build/release/{name}.tar.gz\nSHA-256 {hashlib.sha256(archive).hexdigest()}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
