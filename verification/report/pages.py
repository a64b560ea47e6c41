"""Writes the evidence pages from collected data, by the templates beside this file. Nothing is measured here."""
import collections
import json
import os
import pathlib
import re
import shutil
import sys

import jinja2
import markupsafe

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "trace"))
sys.path.insert(0, str(HERE.parent / "gates"))
sys.path.insert(0, str(HERE.parent / "coverage"))
sys.path.insert(0, str(HERE.parent / "release"))
import bill  # noqa: E402
from common import SAFETY_ROOMS  # noqa: E402
from campaign import page_of as campaign_page  # noqa: E402
import check_links  # noqa: E402
import walk  # noqa: E402
from failover import page_of as failover_page  # noqa: E402
from injection import page_of as injection_page  # noqa: E402
from matrix import UID, repository_matrix  # noqa: E402
from records import METRICS as ROOM_METRICS, Coverage  # noqa: E402
from interfaces import page_of as interfaces_page  # noqa: E402
from system_level import SystemLevel, references  # noqa: E402
from timing import page_of as timing_page  # noqa: E402
from walk_files import page_of  # noqa: E402

LISTS = ("index", "trace", "safety_requirements", "interfaces", "coverage", "gates", "misra", "failover", "injection", "campaign", "mutants", "timing", "tools")
METRICS = ("functions", "lines", "branches", "mcdc")
PLAN_ROW = re.compile(r"^\| ((?:D )?\d+\.\d+\.\d+) \| (\w+) \| (\w+) \| (.*) \|$", re.MULTILINE)


def read_json(path, default):
    return json.loads(path.read_text()) if path.exists() else default


def mutants_page(root):
    """Imported here: what reads the sources is needed for this page alone."""
    from mutants import page_of as of_mutants
    return of_mutants(root)


def gates(data):
    rows = read_json(data / "gates_final.json", [])
    for row in rows:
        row["fixtures_passed"] = all(record["passed"] for record in row["fixtures"])
        row["passed"] = row["fixtures_passed"] and row.get("tree", {}).get("passed", False)
        lines = row.get("tree", {}).get("output", "").splitlines()
        row["looked_at"] = lines[-1] if lines else "did not run"
        row["findings"] = lines[:-1]
    return rows


def coverage(root, data):
    """Rows of the safety rooms by Clang, and of the same files by GCC."""
    export = read_json(data / "coverage/export.json", {"data": [{"files": []}]})
    gcov = {os.path.realpath(root / entry["filename"]): entry
            for entry in read_json(data / "gcov/summary.json", {"files": []})["files"]}
    rows, totals = [], collections.Counter()
    for entry in export["data"][0]["files"]:
        path = pathlib.Path(os.path.realpath(entry["filename"]))
        name = path.relative_to(root).as_posix() if path.is_relative_to(root) else None
        if name is None or not any(name.startswith(room + "/") for room in SAFETY_ROOMS):
            continue
        row = {"name": name, "gcov": gcov.get(str(path)), "page": html_of(data.parent, root, entry["filename"])}
        for metric in METRICS:
            row[metric] = (entry["summary"][metric]["covered"], entry["summary"][metric]["count"])
            totals[metric + "_covered"] += row[metric][0]
            totals[metric] += row[metric][1]
        row["full"] = all(row[metric][0] == row[metric][1] for metric in METRICS)
        rows.append(row)
    return sorted(rows, key=lambda row: row["name"]), totals


def html_of(evidence, root, filename):
    """Where the annotated source by llvm-cov is, as a link from the evidence folder; empty if it is not there."""
    place = f"coverage_clang/sources/{filename.removeprefix(f'{root}/')}.html"
    return place if (evidence / place).exists() else ""


def deviations(root):
    """Guideline -> records, and each record with the number of places that name it."""
    uses = collections.Counter()
    for folder in ("safety_core", "channel_a", "channel_b", "hal"):
        for path in (root / folder).rglob("*.[ch]pp"):
            uses.update(re.findall(r"MISRA (D-\d{3})", path.read_text(errors="replace")))
    records = []
    for path in sorted((root / "MISRA/deviations").glob("D-*.md")):
        fields = dict(re.findall(r"^- \*\*(\w+)\*\*: *(\S.*)$", path.read_text(), re.MULTILINE))
        records.append({"id": path.stem, "uses": uses[path.stem], "fields": fields,
                        "guidelines": re.findall(r"(?:D )?\d+\.\d+\.\d+", fields.get("Guideline", ""))})
    return records


def misra(root, gate_rows):
    """The compliance summary: what can be said of each guideline, and no more."""
    passed = {row["gate"]: row["passed"] for row in gate_rows}
    records = deviations(root)
    rows = []
    for guideline, category, decidability, means in PLAN_ROW.findall((root / "MISRA/compliance_plan.md").read_text()):
        of_it = [record for record in records if guideline in record["guidelines"]]
        automatic = [mean for mean in means.split("; ") if not mean.startswith(("manual review", "none"))]
        needed = {"clang_tidy" for mean in automatic if mean.startswith(("clang-tidy", "warning"))}
        needed |= {name for name in re.findall(r"gate `(\w+)`", means)}
        failing = sorted(name for name in needed if not passed.get(name, False))
        if means.startswith("none: disapplied"):
            status = "disapplied"
        elif failing:
            status = f"finding open ({', '.join(failing)})"
        elif of_it:
            status = f"deviations: {', '.join(record['id'] for record in of_it)} ({sum(record['uses'] for record in of_it)} places)"
        elif not automatic:
            status = "manual review only, no evidence by a tool"
        elif "manual review" in means:
            status = "no finding by tools; the rest by review"
        else:
            status = "no finding by tools"
        rows.append({"guideline": guideline, "category": category, "decidability": decidability, "means": means, "status": status})
    return rows, records, collections.Counter(re.sub(r"[:(].*", "", row["status"]).strip() for row in rows)


def templates():
    environment = jinja2.Environment(loader=jinja2.FileSystemLoader(HERE / "templates"), autoescape=True, trim_blocks=True, lstrip_blocks=True,
                                     undefined=jinja2.StrictUndefined)
    environment.filters["linked"] = linked
    environment.filters["allocated"] = lambda uid, level: level.relevance(uid)
    return environment


def linked(text, requirements):
    """A message whose ids lead to the pages of these requirements."""
    def link(match):
        return f'<a href="walk/{match[0]}.html">{match[0]}</a>' if match[0] in requirements else match[0]
    return markupsafe.Markup(UID.sub(link, str(markupsafe.escape(text))))


def reviewed(matrix):
    """How many links from a requirement to what shows it are in each state."""
    counts = collections.Counter({"unreviewed": 0, "reviewed": 0, "suspect": 0})
    for items in matrix.rows.values():
        counts.update(matrix.reviews.state(item)["state"] for item in {item.link: item for item in items}.values())
    return counts


def write(root, evidence, data):
    """Writes the pages and returns the gaps, one text each."""
    environment = templates()
    gate_rows = gates(data)
    matrix = repository_matrix(root, data)
    coverage_rows, totals = coverage(root, data)
    beyond = Coverage(root, read_json(data / "coverage/export.json", {"data": [{"files": []}]}))
    misra_rows, records, misra_counts = misra(root, gate_rows)
    tests = read_json(data / "ctest.json", [])
    test_origin = read_json(data / "test_run.json", {"origin": "an unknown run"})["origin"]
    commands = read_json(data / "commands.json", {})
    gaps = [f"gate {row['gate']}: {row['looked_at']}" for row in gate_rows if not row["passed"]]
    gaps += [f"test program {test['name']} failed" for test in tests if not test["passed"]]
    gaps += [f"command {result['command']} ended with exit status {result['status']}" for result in commands.values()
             if result["status"] != 0]
    failover, failover_gaps = failover_page(root / "build/elections/failovers.json")
    injection, injection_gaps = injection_page(root / "build/injection", evidence)
    campaign, campaign_gaps = campaign_page(root, evidence)
    timing, timing_gaps = timing_page(root, data)
    interfaces, interface_gaps = interfaces_page(root)
    mutants, mutant_gaps = mutants_page(root)
    gaps += mutant_gaps + failover_gaps + injection_gaps + campaign_gaps + timing_gaps + interface_gaps
    if not gate_rows:
        gaps.append("no gate has run")
    context = {
        "identity": read_json(data / "identity.json", {}), "gates": gate_rows, "matrix": matrix, "coverage": coverage_rows,
        "totals": totals, "metrics": METRICS, "rooms": list(beyond.rooms.values()), "room_metrics": ROOM_METRICS, "misra": misra_rows, "deviations": records, "misra_counts": misra_counts,
        "tests": tests, "test_origin": test_origin, "commands": commands, "gaps": gaps, "failover": failover, "injection": injection,
        "campaign": campaign, "mutants": mutants, "timing": timing, "interfaces": interfaces,
        "level": SystemLevel(root), "references": references, "areas": areas(matrix),
        "gcov_totals": read_json(data / "gcov/summary.json", {}),
        "has_gcov": (evidence / "coverage_gcov/index.html").exists(),
        "has_clang": (evidence / "coverage_clang/index.html").exists(), "reviewed": reviewed(matrix), "page_of": page_of, "up": "",
    }
    if (data / bill.NAME).exists():
        shutil.copy(data / bill.NAME, evidence)
    for name in LISTS:
        page = environment.get_template(f"{name}.html.j2").render(page=name, **context)
        (evidence / f"{name}.html").write_text(page, encoding="utf-8")
    walk.write(root, evidence / "walk", data, matrix, environment)
    return gaps + [f"link of the evidence: {finding}" for finding in check_links.check(evidence)]


def areas(matrix):
    """Counts of shown requirements an area, for the first page."""
    counts = collections.OrderedDict()
    for uid, requirement in matrix.requirements.items():
        row = counts.setdefault(uid.split("_")[1], {"file": requirement.path, "all": 0, "shown": 0, "links": 0})
        row["all"] += 1
        row["links"] += len(matrix.rows[uid])
        row["shown"] += matrix.status(uid) == "shown"
    return counts
