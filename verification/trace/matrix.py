"""Requirement -> what shows it -> result, from the reports of all tests and the registry of other evidence.

Used by verification/gates/trace (fails on gaps) and by the evidence pages (shows the matrix).
"""
import json
import pathlib
import re
import sys
import xml.etree.ElementTree as ElementTree

import yaml

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "gates"))
import generate_ids  # noqa: E402
import reviews  # noqa: E402
from common import files, read  # noqa: E402

REGISTRY = "verification/trace/other_evidence.yaml"
KNOWN_GAPS = "docs/known_gaps.json"
UID = re.compile(r"SRS_[A-Z0-9]+_\d{3}")


class Evidence:
    """One check that shows a requirement: a test case, a gate, a check of a command, or an artefact of the registry.

    `link` names it without program and parameters, so that it stays the same from run to run; `path` and `line` say where it is written
    ("" and 0: nowhere in the tree)."""

    def __init__(self, uid, kind, name, passed, note="", link="", path="", line=0):
        self.uid = uid
        self.kind = kind
        self.name = name
        self.passed = passed
        self.note = note
        self.link = link or name
        self.path = path
        self.line = line


def name_in(root, filename):
    """A recorded path below the root, wherever the tree stood when it was recorded; "" when the tree has no such file."""
    parts = pathlib.PurePosixPath(filename).parts
    starts = range(1 if filename.startswith("/") else 0, len(parts))
    names = (pathlib.PurePosixPath(*parts[start:]).as_posix() for start in starts)
    return next((name for name in names if ".." not in name and (root / name).is_file()), "")


def bare(name):
    """A test's name without prefix and parameter of an instantiation."""
    parts = name.split("/")
    return next((part for part in parts[1:] if not part.isdigit()), parts[0]) if len(parts) > 1 else name


def gtest_evidence(root, data):
    paths = {}
    for path in sorted(data.glob("tests/*.xml")):
        for case in ElementTree.parse(path).iter("testcase"):
            failed = case.find("failure") is not None or case.find("error") is not None
            ran = case.get("status") == "run" and case.find("skipped") is None
            name = f"{path.stem}: {case.get('classname')}.{case.get('name')}"
            recorded = case.get("file", "")
            if recorded not in paths:
                paths[recorded] = name_in(root, recorded)
            link = f"{paths[recorded]} {bare(case.get('classname'))}.{case.get('name').split('/')[0]}".strip()
            for item in case.iter("property"):
                if item.get("name", "").startswith("requirement-"):
                    yield Evidence(item.get("value"), "test", name, ran and not failed, "" if ran else "did not run", link,
                                   paths[recorded], int(case.get("line", 0)) if paths[recorded] else 0)


def registrations(root):
    """Where each ctest entry that is no GoogleTest is written: name -> (file, line)."""
    found = {}
    for name in files(root, "CMakeLists.txt"):
        for number, line in enumerate(read(root, name).splitlines(), start=1):
            for test in re.findall(r"\badd_test\(\s*NAME (\w+)", line):
                found[test] = (name, number)
    return found


def ctest_evidence(root, data):
    """Programs that are no GoogleTest name requirements as labels of their ctest entry."""
    path = data / "ctest.json"
    if not path.exists():
        return
    written = registrations(root)
    for entry in json.loads(path.read_text()):
        place, line = written.get(entry["name"], ("", 0))
        for label in entry["labels"]:
            if UID.fullmatch(label):
                yield Evidence(label, "test", f"ctest: {entry['name']}", entry["passed"], "", f"ctest {entry['name']}", place, line)


def gate_result(data, name):
    path = data / "gates.json"
    if not path.exists():
        return False, "no gate has run"
    for result in json.loads(path.read_text()):
        if result["gate"] == name:
            fixtures = all(record["passed"] for record in result["fixtures"])
            # The trace gate cannot read its own result of the run that it is part of.
            tree = result["tree"]["passed"] if "tree" in result else name == "trace"
            return fixtures and tree, "" if fixtures and tree else "the gate or its fixture fails"
    return False, "no such gate"


def judges_each(entry):
    """Whether the artefact has a verdict of its own for each requirement or check, so that another one that fails says nothing of this one."""
    return "{id}" in entry.get("pass_mark", "")


def command_problem(root, data, entry):
    """Why the run of an entry's command shows nothing, or "". An artefact that judges each requirement only has to be of that run. [SRS_VER_094]"""
    command = entry.get("command")
    if not command:
        return ""
    statuses = json.loads((data / "commands.json").read_text()) if (data / "commands.json").exists() else {}
    if command not in statuses:
        return f"command {command} was not run"
    run = statuses[command]
    if run["status"] == 0:
        return ""
    if not judges_each(entry) or "started" not in run:
        return f"command {command} ended with exit status {run['status']}"
    path = root / entry["artefact"]
    if path.is_file() and path.stat().st_mtime < run["started"]:
        return f"command {command} ended with exit status {run['status']}, and {entry['artefact']} is older than this run"
    return ""


def check_entry(root, data, entry, uid):
    """Whether the artefact of a registry entry exists and shows its pass mark for this requirement."""
    if entry["kind"] == "gate" and "pass_mark" not in entry:
        return gate_result(data, entry["artefact"])
    problem = command_problem(root, data, entry)
    if problem:
        return False, problem
    path = root / entry["artefact"]
    if not path.is_file():
        return False, f"{entry['artefact']} is not there"
    pass_mark = entry["pass_mark"].replace("{id}", uid)
    if not re.search(pass_mark, path.read_text(errors="replace"), re.MULTILINE):
        return False, f"{entry['artefact']} does not show its pass mark /{pass_mark}/"
    return True, ""


def entry_evidence(root, data, entry):
    """What an entry shows of each of its requirements."""
    is_gate = entry["kind"] == "gate" and "pass_mark" not in entry
    path, line = (f"verification/gates/{entry['artefact']}/gate.py", 1) if is_gate else (REGISTRY, entry["line"])
    for uid in entry["ids"]:
        passed, note = check_entry(root, data, entry, uid)
        link = f"gate {entry['artefact']}" if is_gate else f"{entry['kind']} {entry['artefact']}"
        yield Evidence(uid, entry["kind"], f"{entry['artefact']}: {entry['shows']}", passed, note, link, path if (root / path).is_file() else "", line)


def checks_evidence(root, data, entry):
    """The checks of a command, each with a verdict of its own under "checks" in the artefact: those that name a requirement at their head.
    For a requirement that the entry does not list a check is a test like others. [SRS_VER_094]"""
    problem, artefact = command_problem(root, data, entry), root / entry["artefact"]
    verdicts = json.loads(artefact.read_text())["checks"] if not problem and artefact.is_file() else {}
    for path in sorted((root / entry["checks"]).iterdir()):
        for number, text in enumerate(path.read_text(errors="replace").splitlines(), start=1):
            for uid in UID.findall(text) if text.startswith("# Requirements:") else []:
                note = problem or ("" if path.stem in verdicts else "was not run")
                yield Evidence(uid, entry["kind"] if uid in entry["ids"] else "test", f"{entry['checks']}: {path.stem}", verdicts.get(path.stem, False),
                               note, f"check {path.stem}", path.relative_to(root).as_posix(), number)


def told_failures(root, data, entry):
    """Requirements of which an artefact says that they do not hold, though the entry does not list them. [SRS_VER_094]"""
    artefact = root / entry["artefact"]
    if "checks" in entry or not judges_each(entry) or not artefact.is_file() or command_problem(root, data, entry):
        return set()
    return set(re.findall(r'"(SRS_[A-Z0-9]+_\d{3})": false', artefact.read_text(errors="replace")))


def read_registry(root, problems):
    """Entries of the registry that are well formed; the others become problems."""
    path = root / REGISTRY
    text = path.read_text() if path.exists() else ""
    content = yaml.safe_load(text)
    lines = [number for number, line in enumerate(text.splitlines(), start=1) if line.startswith("  - {ids:")]
    entries = []
    for number, entry in enumerate((content or {}).get("evidence", []), start=1):
        where = f"{REGISTRY}: entry {number}"
        needed = {"ids", "kind", "artefact", "shows"} | (set() if entry.get("kind") == "gate" else {"pass_mark"})
        if not needed <= set(entry):
            problems.append(f"{where}: has {', '.join(sorted(entry))}, expected {', '.join(sorted(needed))}")
        elif entry["kind"] not in generate_ids.METHODS or entry["kind"] == "test":
            problems.append(f"{where}: kind {entry['kind']}, expected bench, gate, analysis or scenario")
        else:
            entries.append({**entry, "line": lines[number - 1] if number <= len(lines) else 1})
    return entries


def read_known_gaps(root):
    """Requirement -> recorded reason for which it is not met. The page shows it as a gap; the gate lets it pass."""
    path = root / KNOWN_GAPS
    if not path.exists():
        return {}
    return {gap["id"]: gap["reason"] for gap in json.loads(path.read_text())["gaps"]}


class Matrix:
    def __init__(self, root, data):
        self.problems = []
        self.rows = {}
        try:
            self.requirements = generate_ids.read_requirements(root)
        except generate_ids.BadInput as error:
            self.requirements = {}
            self.problems.append(str(error))
        evidence = list(gtest_evidence(root, data)) + list(ctest_evidence(root, data))
        self.test_count = len(evidence)
        evidence += self.registered(root, data)
        for uid in self.requirements:
            self.rows[uid] = []
        for item in evidence:
            if item.uid not in self.rows:
                self.problems.append(f"{item.name}: names {item.uid}, which is no requirement")
            else:
                self.rows[item.uid].append(item)
        self.reviews = reviews.Reviews(root, self.requirements, self.rows)
        self.problems += self.reviews.problems
        self.known_gaps = read_known_gaps(root)
        for uid, requirement in self.requirements.items():
            found = list(self.gaps(requirement, self.rows[uid]))
            if uid not in self.known_gaps:
                self.problems += found
            elif not found:
                self.problems.append(f"{KNOWN_GAPS}: {uid} is met, expected its record to be removed")
        for uid in sorted(set(self.known_gaps) - set(self.requirements)):
            self.problems.append(f"{KNOWN_GAPS}: {uid} is no requirement")

    def registered(self, root, data):
        """Evidence of the registry."""
        found, false_of, listed = [], {}, {}
        for entry in read_registry(root, self.problems):
            listed.setdefault(entry["artefact"], set()).update(entry["ids"])
            false_of.setdefault(entry["artefact"], set()).update(told_failures(root, data, entry))
            found += checks_evidence(root, data, entry) if "checks" in entry else []
            found += entry_evidence(root, data, entry)
        for artefact, uids in sorted(false_of.items()):
            self.problems += [f"{uid}: {artefact} says that it does not hold, and no entry of {REGISTRY} lists it there" for uid in sorted(uids - listed[artefact])]
        return found

    @staticmethod
    def gaps(requirement, items):
        """What is missing for one requirement, one text each. Every method it names has to succeed."""
        where = f"{requirement.path}:{requirement.line}: {requirement.uid}"
        for method in requirement.methods:
            of_kind = [item for item in items if item.kind == method]
            if not of_kind:
                what = "no test names it" if method == "test" else f"no {method} is registered for it in {REGISTRY}"
                yield f"{where}: {what}"
            elif not any(item.passed for item in of_kind):
                yield f"{where}: no {method} of it passes ({of_kind[0].name}{': ' + of_kind[0].note if of_kind[0].note else ''})"
        for item in items:
            if not item.passed and (item.kind == "test" or item.link.startswith("check ")):
                yield f"{where}: fails in {item.name} {item.note}".rstrip()
            elif item.kind not in requirement.methods and item.kind != "test":
                yield f"{where}: {item.kind} is registered, expected its VERIFICATION to name it"

    def status(self, uid):
        if uid in self.known_gaps:
            return f"known gap: {self.known_gaps[uid]}"
        return "gap" if any(f" {uid}:" in problem for problem in self.problems) else "shown"


def repository_matrix(root, data):
    return Matrix(pathlib.Path(root), pathlib.Path(data))
