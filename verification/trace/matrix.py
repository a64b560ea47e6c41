"""Requirement -> what shows it -> result, from the reports of all tests and the registry of other evidence.

Used by verification/gates/trace (fails on gaps) and by the evidence pages (shows the matrix).
"""
import json
import pathlib
import re
import xml.etree.ElementTree as ElementTree

import yaml

import generate_ids

REGISTRY = "verification/trace/other_evidence.yaml"
KNOWN_GAPS = "docs/known_gaps.json"
UID = re.compile(r"SRS_[A-Z0-9]+_\d{3}")


class Evidence:
    """One thing that shows a requirement: a test case, or an entry of the registry."""

    def __init__(self, uid, kind, name, passed, note=""):
        self.uid = uid
        self.kind = kind
        self.name = name
        self.passed = passed
        self.note = note


def gtest_evidence(data):
    for path in sorted(data.glob("tests/*.xml")):
        for case in ElementTree.parse(path).iter("testcase"):
            failed = case.find("failure") is not None or case.find("error") is not None
            ran = case.get("status") == "run" and case.find("skipped") is None
            name = f"{path.stem}: {case.get('classname')}.{case.get('name')}"
            for item in case.iter("property"):
                if item.get("name", "").startswith("requirement-"):
                    yield Evidence(item.get("value"), "test", name, ran and not failed, "" if ran else "did not run")


def ctest_evidence(data):
    """Programs that are no GoogleTest name requirements as labels of their ctest entry."""
    path = data / "ctest.json"
    if not path.exists():
        return
    for entry in json.loads(path.read_text()):
        for label in entry["labels"]:
            if UID.fullmatch(label):
                yield Evidence(label, "test", f"ctest: {entry['name']}", entry["passed"])


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


def check_entry(root, data, entry, uid):
    """Whether the artefact of a registry entry exists and shows its pass mark for this requirement."""
    if entry["kind"] == "gate" and "pass_mark" not in entry:
        return gate_result(data, entry["artefact"])
    command = entry.get("command")
    if command:
        statuses = json.loads((data / "commands.json").read_text()) if (data / "commands.json").exists() else {}
        if command not in statuses:
            return False, f"command {command} was not run"
        if statuses[command]["status"] != 0:
            return False, f"command {command} ended with exit status {statuses[command]['status']}"
    path = root / entry["artefact"]
    if not path.is_file():
        return False, f"{entry['artefact']} is not there"
    pass_mark = entry["pass_mark"].replace("{id}", uid)
    if not re.search(pass_mark, path.read_text(errors="replace"), re.MULTILINE):
        return False, f"{entry['artefact']} does not show its pass mark /{pass_mark}/"
    return True, ""


def read_registry(root, problems):
    """Entries of the registry that are well formed; the others become problems."""
    path = root / REGISTRY
    content = yaml.safe_load(path.read_text()) if path.exists() else None
    entries = []
    for number, entry in enumerate((content or {}).get("evidence", []), start=1):
        where = f"{REGISTRY}: entry {number}"
        needed = {"ids", "kind", "artefact", "shows"} | (set() if entry.get("kind") == "gate" else {"pass_mark"})
        if not needed <= set(entry):
            problems.append(f"{where}: has {', '.join(sorted(entry))}, expected {', '.join(sorted(needed))}")
        elif entry["kind"] not in generate_ids.METHODS or entry["kind"] == "test":
            problems.append(f"{where}: kind {entry['kind']}, expected bench, gate, analysis or scenario")
        else:
            entries.append(entry)
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
        evidence = list(gtest_evidence(data)) + list(ctest_evidence(data))
        self.test_count = len(evidence)
        for entry in read_registry(root, self.problems):
            for uid in entry["ids"]:
                passed, note = check_entry(root, data, entry, uid)
                name = f"{entry['artefact']}: {entry['shows']}"
                evidence.append(Evidence(uid, entry["kind"], name, passed, note))
        for uid in self.requirements:
            self.rows[uid] = []
        for item in evidence:
            if item.uid not in self.rows:
                self.problems.append(f"{item.name}: names {item.uid}, which is no requirement")
            else:
                self.rows[item.uid].append(item)
        self.known_gaps = read_known_gaps(root)
        for uid, requirement in self.requirements.items():
            found = list(self.gaps(requirement, self.rows[uid]))
            if uid not in self.known_gaps:
                self.problems += found
            elif not found:
                self.problems.append(f"{KNOWN_GAPS}: {uid} is met, expected its record to be removed")
        for uid in sorted(set(self.known_gaps) - set(self.requirements)):
            self.problems.append(f"{KNOWN_GAPS}: {uid} is no requirement")

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
            if not item.passed and item.kind == "test":
                yield f"{where}: fails in {item.name} {item.note}".rstrip()
            elif item.kind not in requirement.methods and item.kind != "test":
                yield f"{where}: {item.kind} is registered, expected its VERIFICATION to name it"

    def status(self, uid):
        if uid in self.known_gaps:
            return f"known gap: {self.known_gaps[uid]}"
        return "gap" if any(f" {uid}:" in problem for problem in self.problems) else "shown"


def repository_matrix(root, data):
    return Matrix(pathlib.Path(root), pathlib.Path(data))
