#!/usr/bin/env python3
"""What docs/safety says can be followed. Every table of techniques is there, and each technique has a link or says why it is not done; each failure
mode has a part, requirements, a limit and evidence that exist; no file of kernel, comparator, self tests, cross link, channels or hal/api is without
a failure mode or a reason; each tool has a class and what finds its failure; each folder of the tree has a row that says what to run after a change."""
import json
import pathlib
import re
import sys

HERE = pathlib.Path(__file__).resolve()
sys.path.insert(0, str(HERE.parents[1]))
sys.path.insert(0, str(HERE.parents[2] / "trace"))
from common import TEST_CASE, CannotLook, files, read, run_gate, table_rows  # noqa: E402
from generate_ids import BadInput, UID, read_requirements  # noqa: E402

FOLDER = "docs/safety"
TECHNIQUES, FMEA, TOOLS, PLAN = (f"{FOLDER}/{name}.md" for name in ("techniques", "fmea", "tools", "plan"))
TABLES = [f"A.{number}" for number in range(1, 11)] + [f"B.{number}" for number in range(1, 10)]
PARTS = ("safety_core/comparator", "safety_core/kernel", "safety_core/selftest", "safety_core/crosslink", "channel_a", "channel_b", "hal/api")
MANUAL = "docs/safety_manual.md"
LIMITS = "safety_core/kernel/limits.hpp"
OTHER_LIMITS = ("cycle", "start", "none")
CAMPAIGN = "verification/campaign/plan.cpp"
MANAGED = "verification/campaign/managed/plan.cpp"
VERIFIES = re.compile(rf"\breq::({UID.pattern})")
CONFORMANCE = "verification/conformance/"
CONFORMANCE_TESTS = ("ChannelAConformance.Case", "ChannelBConformance.Case")
INJECTION = ("skips", "inversions", "registers", "memory")
CLASSES = ("T1", "T2", "T3")
LINK = re.compile(r"\]\([^)]+\)")
QUOTED = re.compile(r"`([^`]+)`")
TEST = re.compile(r"[A-Z]\w+\.(?:\*|[A-Z]\w+)")
COUNT = re.compile(r"(\d+) entries of \[?`([\w/]+\.json)`")
VERB = re.compile(r"`\./dev ([a-z]+)(?: -R (\w+))?")
ROW = re.compile(r"^\| ((?:AU-|F-[A-Z])\d\d) \|", re.MULTILINE)
NAMED_ROW = re.compile(r"\b(?:AU-|F-[A-Z])\d\d\b")
CTEST = re.compile(r"\b(?:counterpoint_test\w*\(|add_test\(NAME )\s*(\w+)")


def rows(root, name):
    return table_rows(read(root, name))


def has_reason(cell):
    """Whether a cell that says no also says why."""
    return len(cell.partition(":")[2].split()) >= 3


def techniques(root):
    text = read(root, TECHNIQUES)
    for table in TABLES:
        if not re.search(rf"^#+ (?:\d+(?:\.\d+)* )?Table {re.escape(table)}\b", text, re.MULTILINE):
            yield f"{TECHNIQUES}:1: there is no table {table}, expected a heading 'Table {table}'"
    for number, _header, cells in rows(root, TECHNIQUES):
        told = cells[-1]
        if told.startswith("not done"):
            if not has_reason(told):
                yield f"{TECHNIQUES}:{number}: '{cells[0]}' is not done without a reason, expected 'not done: why'"
        elif not LINK.search(told):
            yield f"{TECHNIQUES}:{number}: '{cells[0]}' leads nowhere, expected a link, or 'not done: why'"


def tests(root):
    """Test -> the requirements that it names; `Suite.*` stands for all of a suite. Both conformance tests run all cases of the table."""
    found, table = {}, set()
    for name in files(root, "*.cpp", under=("tests", "verification")):
        text = read(root, name)
        cases = list(TEST_CASE.finditer(text))
        if name.startswith(CONFORMANCE):
            table |= set(VERIFIES.findall(text))
        for case, end in zip(cases, [other.start() for other in cases[1:]] + [len(text)]):
            for suite in (case[1], case[1].rstrip("_")):
                for test in (f"{suite}.{case[2]}", f"{suite}.*"):
                    found.setdefault(test, set()).update(VERIFIES.findall(text, case.end(), end))
    for test in CONFORMANCE_TESTS:
        if test in found:
            found[test] |= table
    return found


class Names:
    """What the documents may name."""

    def __init__(self, root):
        self.requirements = set(read_requirements(root))
        self.tests = tests(root)
        listed = re.search(r"enum class FaultClass\b.*?\};", read(root, LIMITS), re.DOTALL)
        self.limits = set(re.findall(r"\b(k\w+) =", listed.group(0)) if listed else []) - {"kInvalid"} | set(OTHER_LIMITS)
        self.rows = set(ROW.findall(read(root, MANUAL)) + ROW.findall(read(root, FMEA)))
        self.campaign = set(re.findall(r'\{"(\w+)", Part::', read(root, CAMPAIGN)))
        if (root / MANAGED).is_file():
            self.campaign |= set(re.findall(r'\{"(\w+)", Target::', read(root, MANAGED)))
        self.programs = {word for name in files(root, "CMakeLists.txt") for word in CTEST.findall(read(root, name))}
        self.verbs = set(re.findall(r"^help_(\w+)\(\)", read(root, "dev"), re.MULTILINE))

    def is_evidence(self, word):
        kind, _, what = word.partition(" ")
        return word in self.tests or (kind == "./dev" and what in self.verbs) or (kind == "campaign" and what in self.campaign) or (kind == "inject" and what in INJECTION)


def parts_of(cell):
    return [word for word in QUOTED.findall(cell) if "/" in word]


def is_part(root, part):
    return any((root / f"{part}{suffix}").is_file() for suffix in (".hpp", ".cpp"))


def failure_mode(root, names, where, cells):
    """What is wrong with a row of the FMEA."""
    if len(cells) != 8 or not all(cells):
        yield f"{where}: a row of {len(cells)} cells, expected 8 with a text in each"
        return
    identity, part, _failure, _found, requirements, limit, shown, _remains = cells
    if not parts_of(part):
        yield f"{where}: {identity} names no part, expected files of the safety rooms"
    if not UID.search(requirements):
        yield f"{where}: {identity} names no requirement, expected one"
    if not QUOTED.findall(limit) or any(word not in names.limits for word in QUOTED.findall(limit)):
        yield f"{where}: {identity} has the limit '{limit}', expected a class of {LIMITS} or one of {', '.join(OTHER_LIMITS)}"
    evidence = QUOTED.findall(shown)
    if not evidence:
        yield f"{where}: {identity} shows nothing, expected a test, a part of the campaign, a class of the injection or a verb of ./dev"
    run = [word for word in evidence if word in names.tests]
    if run and not any(names.tests[word] & set(UID.findall(requirements)) for word in run):
        yield f"{where}: no test of {identity} names one of its requirements"
    yield from (f"{where}: {identity} is shown by '{word}', expected a test, a part of the campaign, a class of the injection or a verb of ./dev"
                for word in evidence if not names.is_evidence(word))


def fmea(root, names):
    told, seen = set(), set()
    for number, header, cells in rows(root, FMEA):
        where = f"{FMEA}:{number}"
        if header[0] not in ("id", "part"):
            continue
        named = parts_of(cells[1] if header[0] == "id" else cells[0])
        yield from (f"{where}: there is no part '{part}', expected a file of the tree" for part in named if not is_part(root, part))
        told |= set(named)
        if header[0] == "id":
            if cells[0] in seen:
                yield f"{where}: {cells[0]} stands twice, expected each id once"
            seen.add(cells[0])
            yield from failure_mode(root, names, where, cells)
    for name in files(root, "*.cpp", "*.hpp", under=PARTS):
        if name.rpartition(".")[0] not in told:
            yield f"{FMEA}:1: {name} has no failure mode, expected a row that names it, or the reason in the list of parts without one"


def tools(root):
    for number, header, cells in rows(root, TOOLS):
        if header[0] != "tool":
            continue
        identity, found = cells[0], cells[-1]
        if cells[2] not in CLASSES:
            yield f"{TOOLS}:{number}: {identity} has the class '{cells[2]}', expected one of {', '.join(CLASSES)}"
        if not LINK.search(found) and not (found.startswith("nobody") and has_reason(found)):
            yield f"{TOOLS}:{number}: nothing finds a failure of {identity}, expected a link, or 'nobody: what follows'"


def plan(root):
    changed = {word.strip("/") for _number, header, cells in rows(root, PLAN) if header[0] == "changed" for word in QUOTED.findall(cells[0])}
    for folder in sorted({name.split("/")[0] for name in files(root) if "/" in name}):
        if not any(word == folder or word.startswith(folder + "/") for word in changed):
            yield f"{PLAN}:1: folder {folder} has no row of what to run after a change, expected one"


def everywhere(root, names, name):
    """Names and numbers that any of the documents may have."""
    for number, line in enumerate(read(root, name).splitlines(), start=1):
        where = f"{name}:{number}"
        yield from (f"{where}: there is no requirement {uid}" for uid in UID.findall(line) if uid not in names.requirements)
        yield from (f"{where}: there is no row {row}, neither in {MANUAL} nor in {FMEA}" for row in NAMED_ROW.findall(line) if row not in names.rows)
        yield from (f"{where}: there is no test '{word}'" for word in QUOTED.findall(line) if TEST.fullmatch(word) and word not in names.tests)
        for verb, program in VERB.findall(line):
            if verb not in names.verbs:
                yield f"{where}: ./dev has no verb '{verb}'"
            if program and not any(program in known for known in names.programs):
                yield f"{where}: no program of the tests has '{program}' in its name"
        for told, path in COUNT.findall(line):
            held = json.loads(read(root, path)) if (root / path).is_file() else []
            held = next((value for value in held.values() if isinstance(value, list)), []) if isinstance(held, dict) else held
            if len(held) != int(told):
                yield f"{where}: {path} has {len(held)} entries, {told} are told"


def gate(root, _data):
    missing = [name for name in (TECHNIQUES, FMEA, TOOLS, PLAN, MANUAL, LIMITS, CAMPAIGN, "dev") if not (root / name).is_file()]
    if missing:
        raise CannotLook(", ".join(missing))
    try:
        names = Names(root)
    except BadInput as problem:
        return [str(problem)], "files that cannot be read"
    documents = files(root, "*.md", under=(FOLDER,))
    findings = [*techniques(root), *fmea(root, names), *tools(root), *plan(root)]
    findings += [text for name in documents for text in everywhere(root, names, name)]
    return findings, f"{len(documents)} documents, {sum(1 for name in documents for _ in rows(root, name))} rows"


run_gate(gate)
