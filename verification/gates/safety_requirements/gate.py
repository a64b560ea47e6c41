#!/usr/bin/env python3
"""Each requirement has a goal above it and says whether safety rests on it: each area has one row with goals that are there and a reason, each goal stands
against hazards of the safety concept, names sources that resolve and is served by an area that safety rests on; what a safety room realises is called
safety-relevant, or has a reason of its own."""
import pathlib
import re
import sys

HERE = pathlib.Path(__file__).resolve()
sys.path[:0] = [str(HERE.parents[1]), str(HERE.parents[2] / "trace")]
from common import SAFETY_ROOMS, CannotLook, read, run_gate  # noqa: E402
from generate_ids import BadInput, read_requirements  # noqa: E402
from places import below, naming_lines, told_paths  # noqa: E402
from source_items import Sources  # noqa: E402
from system_level import DOCUMENT, RELEVANCES, SystemLevel, area_of  # noqa: E402

CONCEPT, MANUAL = "docs/safety/safety_concept.md", "docs/safety_manual.md"
ROOMS = (*SAFETY_ROOMS, "hal/api")


def of_goals(root, level, uids):
    hazards = set(re.findall(r"^\| (H\d+) \|", read(root, CONCEPT), re.MULTILINE))
    assumptions = set(re.findall(r"^\| (AU-\d\d) \|", read(root, MANUAL), re.MULTILINE))
    sources = Sources(root, uids)
    for goal, row in level.goals.items():
        for name in [*row["against"], *row["rests_on"]]:
            if name not in hazards | assumptions:
                yield row["line"], f"{goal}: {name}, expected a hazard of {CONCEPT} or an assumption of {MANUAL}"
        for item in row["reference"]:
            if problem := sources.problem(item, ""):
                yield row["line"], f"{goal}: {problem}"
        if not any(goal in area["goals"] and area["relevance"] == "yes" for area in level.areas.values()):
            yield row["line"], f"{goal}: no area with relevance yes serves it"
    for hazard in sorted(hazards - {name for row in level.goals.values() for name in row["against"]}):
        yield 1, f"no goal stands against {hazard}"


def of_areas(level, requirements):
    areas = {area_of(uid) for uid in requirements}
    for area in sorted(areas - set(level.areas)):
        yield 1, f"no row for the area {area}"
    for area, row in level.areas.items():
        if area not in areas:
            yield row["line"], f"{area}: no requirement is of this area"
        for goal in row["goals"]:
            if goal not in level.goals:
                yield row["line"], f"{area}: {goal}, expected a goal of section 1"
        if not row["goals"] and row["relevance"] != "no":
            yield row["line"], f"{area}: no goal, expected one for relevance {row['relevance']}"
    for name, row in [*level.areas.items(), *level.single.items()]:
        if row["relevance"] not in RELEVANCES:
            yield row["line"], f"{name}: relevance '{row['relevance']}', expected one of {', '.join(RELEVANCES)}"
        if len(row["why"].split()) < 2:
            yield row["line"], f"{name}: no reason"


def of_places(root, level, requirements):
    """Requirements that a safety room realises."""
    naming = naming_lines(root, ROOMS)
    safety = {uid for uid, requirement in requirements.items() if uid in naming or any(below(path, room) for path in told_paths(requirement) for room in ROOMS)}
    for uid in sorted(safety - set(level.single)):
        if level.relevance(uid) not in ("yes", "not allocated"):
            yield level.areas[area_of(uid)]["line"], f"{uid}: a safety room realises it, and its area is '{level.relevance(uid)}', expected yes, or a row of its own"
    for uid, row in level.single.items():
        if uid not in requirements:
            yield row["line"], f"{uid}: no such requirement"
        elif level.areas.get(area_of(uid), row)["relevance"] == row["relevance"] and uid not in safety:
            yield row["line"], f"{uid}: what its area says, expected no row of its own"


def gate(root, _data):
    try:
        requirements = read_requirements(root)
    except BadInput as problem:
        raise CannotLook(str(problem)) from problem
    level = SystemLevel(root)
    found = [(line, f"{name}: a second row") for line, name in level.twice]
    found += [*of_goals(root, level, requirements.keys()), *of_areas(level, requirements), *of_places(root, level, requirements)]
    return [f"{DOCUMENT}:{line}: {text}" for line, text in found], f"{len(level.goals)} goals, {len(level.areas)} areas, {len(requirements)} requirements"


run_gate(gate)
