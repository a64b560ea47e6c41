#!/usr/bin/env python3
"""A release is the same bytes in any folder, and refused when something does not fit."""
import hashlib
import json
import pathlib
import subprocess
import sys
import tarfile
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent / "coverage")]
import bill  # noqa: E402
import measure  # noqa: E402

HOST, TARGET = "ab" * 32, "cd" * 32
GIT = ("git", "-c", "user.name=somebody", "-c", "user.email=somebody@example.org", "-c", "commit.gpgsign=false")
TIME = {"GIT_AUTHOR_DATE": "2026-01-02T03:04:05Z", "GIT_COMMITTER_DATE": "2026-01-02T03:04:05Z", "PATH": "/usr/bin:/bin", "HOME": "/nonexistent"}


def write(path, text):
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text, encoding="utf-8")


def git(root, *words):
    return subprocess.run([*GIT, *words], cwd=root, check=True, capture_output=True, text=True, env=TIME).stdout.strip()


def committed(root, changelog="# Changelog\n\n## Unreleased\n\n## 1.2.3, 2026-01-01\n\n- Something.\n"):
    """A repository with one commit, and evidence of it."""
    write(root / "CMakeLists.txt", "project(Counterpoint VERSION 1.2.3 LANGUAGES CXX)\n")
    write(root / "CHANGELOG.md", changelog)
    write(root / "LICENSE", "a licence\n")
    write(root / "dev", "PACKAGES=(cmake)\n")
    write(root / "requirements.txt", "Jinja2==3.1.6\n")
    write(root / ".gitignore", "build/\n")
    git(root, "init", "--quiet")
    git(root, "add", ".")
    git(root, "commit", "--quiet", "--message", "All")
    commit = git(root, "rev-parse", "HEAD")
    data = root / "build/evidence/data"
    write(root / "build/evidence/index.html", "<p>Nothing is missing.</p>\n")
    write(root / "build/evidence/walk/a_requirement.html", "<p>A requirement.</p>\n")
    write(data / "package/bin/counterpoint", f"counterpoint 1.2.3 (commit {commit[:12]}, objects {HOST[:16]})\0")
    write(data / "package/lib/libchannel_a.a", "objects\n")
    write(data / "images/sensor_be32.elf", f"counterpoint 1.2.3 (commit {commit[:12]}, objects {TARGET[:16]})\0")
    identity = {"version": "1.2.3", "commit": commit, "commit_time": "2026-01-02T03:04:05Z", "changed_files": 0, "digest": HOST, "target_digest": TARGET}
    write(data / "identity.json", json.dumps(identity))
    write(data / "verdict.json", '{"gaps": []}')
    write(data / bill.NAME, json.dumps(bill.made(root, data, identity, {"cmake": "3.25.1"})))
    return root


def release(root, *words):
    return subprocess.run([sys.executable, HERE / "release.py", "--root", root, *words], capture_output=True, text=True, check=False)


def archive_of(root):
    archives = list((root / "build/release").glob("*.tar.gz"))
    assert len(archives) == 1, archives
    return archives[0]


class TwoFolders(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory(prefix="release_")
        self.addCleanup(scratch.cleanup)
        self.one, self.other = pathlib.Path(scratch.name) / "one", pathlib.Path(scratch.name) / "deeper/in/another"

    def test_same_commit_and_evidence_give_the_same_bytes(self):
        digests = []
        for root in (committed(self.one), committed(self.other), self.one):
            done = release(root)
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            digests.append(hashlib.sha256(archive_of(root).read_bytes()).hexdigest())
            self.assertIn(digests[-1], done.stdout)
        self.assertEqual(set(digests), {digests[0]})

    def test_archive_holds_each_part_and_its_sums(self):
        root = committed(self.one)
        release(root)
        commit = git(root, "rev-parse", "HEAD")[:12]
        top = f"counterpoint-1.2.3-{commit}"
        self.assertEqual(archive_of(root).name, f"{top}.tar.gz")
        with tarfile.open(archive_of(root)) as archive:
            texts = {member.name.removeprefix(f"{top}/"): archive.extractfile(member).read() for member in archive.getmembers()}
            owners = {(member.uid, member.uname, member.mtime) for member in archive.getmembers()}
        self.assertEqual(sorted(texts), sorted([
            "CHANGELOG.md", "LICENSE", "SHA256SUMS", "bill.spdx.json", "evidence/index.html", "evidence/walk/a_requirement.html", "images/sensor_be32.elf",
            "install/bin/counterpoint", "install/lib/libchannel_a.a", "source/.gitignore", "source/CHANGELOG.md", "source/CMakeLists.txt", "source/LICENSE",
            "source/dev", "source/requirements.txt"]))
        self.assertEqual(owners, {(0, "", 1767323045)})
        for name, place in (("source/CHANGELOG.md", "CHANGELOG.md"), ("CHANGELOG.md", "CHANGELOG.md"), ("LICENSE", "LICENSE"), ("source/dev", "dev"),
                            ("evidence/walk/a_requirement.html", "build/evidence/walk/a_requirement.html"),
                            ("images/sensor_be32.elf", "build/evidence/data/images/sensor_be32.elf"),
                            ("install/bin/counterpoint", "build/evidence/data/package/bin/counterpoint"),
                            ("bill.spdx.json", f"build/evidence/data/{bill.NAME}")):
            self.assertEqual(texts[name], (root / place).read_bytes(), name)
        sums = dict(reversed(line.split("  ")) for line in texts.pop("SHA256SUMS").decode().splitlines())
        self.assertEqual(sums, {name: hashlib.sha256(text).hexdigest() for name, text in texts.items()})
        told = {entry["fileName"]: entry["checksums"][1]["checksumValue"] for entry in json.loads(texts["bill.spdx.json"])["files"]}
        self.assertEqual(told, {f"./{name}": sums[name] for name in sums if name.startswith(("install/", "images/"))})

    def test_pages_of_coverage_name_neither_place_nor_time(self):
        texts = []
        for root, time in ((self.one, "2026-01-01 01:01"), (self.other, "2026-02-02 02:02")):
            html, source = root / "html", f"{root}/channel_a/state.cpp"
            up = "../" * (len(pathlib.Path(source).parts))
            write(html / "index.html", f"<link href='style.css'><h4>Created: {time}</h4><a href='coverage{source}.html'>state.cpp</a>")
            write(html / f"coverage{source}.html", f"<link href='{up}style.css'><h4>Created: {time}</h4><pre>{source}</pre>")
            measure.without_place(html, root)
            texts.append({path.relative_to(html).as_posix(): path.read_text() for path in html.rglob("*.html")})
        self.assertEqual(texts[0], texts[1])
        self.assertEqual(texts[0], {"index.html": "<link href='style.css'><a href='sources/channel_a/state.cpp.html'>state.cpp</a>",
                                    "sources/channel_a/state.cpp.html": "<link href='../../style.css'><pre>channel_a/state.cpp</pre>"})


class Refused(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory(prefix="release_")
        self.addCleanup(scratch.cleanup)
        self.root = pathlib.Path(scratch.name)

    def refused(self, text):
        done = release(self.root)
        self.assertEqual(done.returncode, 1, done.stdout)
        self.assertIn(f"refused: {text}", done.stderr)
        self.assertFalse((self.root / "build/release").exists())

    def changed(self, name, **fields):
        path = committed(self.root) / "build/evidence/data" / name
        write(path, json.dumps({**json.loads(path.read_text()), **fields}))

    def test_changed_file(self):
        write(committed(self.root) / "LICENSE", "another licence\n")
        self.refused("1 files are not those of the commit, the first: M LICENSE")

    def test_evidence_of_another_commit(self):
        self.changed("identity.json", commit="0" * 40)
        self.refused("the evidence is of commit 000000000000 with 0 changed files")

    def test_evidence_of_changed_files(self):
        self.changed("identity.json", changed_files=2)
        self.refused("the evidence is of commit")

    def test_gap(self):
        self.changed("verdict.json", gaps=["gate size: 1 findings"])
        self.refused("gap of the evidence: gate size: 1 findings")

    def test_program_of_other_objects(self):
        self.changed("identity.json", digest="12" * 32)
        self.refused("counterpoint does not tell 'counterpoint 1.2.3 (commit ")

    def test_image_of_other_objects(self):
        self.changed("identity.json", target_digest="12" * 32)
        self.refused("sensor_be32.elf does not tell 'counterpoint 1.2.3 (commit ")

    def test_program_and_image_of_another_commit(self):
        """Everything else is of this one: the text in the file alone tells another."""
        for name, value in (("package/bin/counterpoint", HOST), ("images/sensor_be32.elf", TARGET)):
            with self.subTest(name), tempfile.TemporaryDirectory(prefix="release_") as scratch:
                self.root = pathlib.Path(scratch)
                write(committed(self.root) / "build/evidence/data" / name, f"counterpoint 1.2.3 (commit 000000000000, objects {value[:16]})\0")
                commit = git(self.root, "rev-parse", "HEAD")[:12]
                self.refused(f"{pathlib.Path(name).name} does not tell 'counterpoint 1.2.3 (commit {commit}, objects {value[:16]})'\n")

    def test_no_image(self):
        (committed(self.root) / "build/evidence/data/images/sensor_be32.elf").unlink()
        self.refused("no image for silicon")

    def test_unreleased_lines(self):
        committed(self.root, "# Changelog\n\n## Unreleased\n\n### Changed\n- More.\n\n## 1.2.3, 2026-01-01\n\n- Something.\n")
        self.refused("CHANGELOG.md has unreleased lines")

    def test_version_without_its_section(self):
        committed(self.root, "# Changelog\n\n## 1.2.2, 2026-01-01\n\n- Something.\n")
        self.refused("CHANGELOG.md has no section 1.2.3")

    def test_page_that_names_the_folder(self):
        write(committed(self.root) / "build/evidence/walk/a_requirement.html", f"<p>{self.root}/channel_a</p>")
        self.refused("evidence/walk/a_requirement.html names the folder of the build")

    def test_draft_is_packed_and_says_why_it_is_none(self):
        self.changed("verdict.json", gaps=["gate size: 1 findings"])
        write(self.root / "LICENSE", "another licence\n")
        done = release(self.root, "--draft")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertTrue(archive_of(self.root).name.endswith("-draft.tar.gz"))
        with tarfile.open(archive_of(self.root)) as archive:
            told = next(member for member in archive.getmembers() if member.name.endswith("-draft/DRAFT"))
            self.assertEqual(archive.extractfile(told).read(),
                             b"1 files are not those of the commit, the first: M LICENSE\ngap of the evidence: gate size: 1 findings\n")

    def test_without_evidence_nothing_is_packed(self):
        (committed(self.root) / "build/evidence/data/identity.json").unlink()
        done = release(self.root)
        self.assertEqual((done.returncode, done.stderr), (2, "release: identity.json is not there, expected it from ./dev verify\n"))


if __name__ == "__main__":
    unittest.main()
