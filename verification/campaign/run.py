#!/usr/bin/env python3
"""Runs campaigns, judges them, and writes build/campaign/index.html with a page for each.

    python3 verification/campaign/run.py                     the plans of examples/campaigns, and the planted defects
    python3 verification/campaign/run.py PLAN ...            these plans alone
    python3 verification/campaign/run.py --long [--record]   the long plans, millions of faults; goes on where it was stopped

A plan has to hold. Each program with a planted defect has to fail on its plan and to say why, and the real one has to hold on it.
Exit status: 0 all of this is so; 1 something is not; 2 bad input.
"""
import argparse
import html
import json
import pathlib
import subprocess
import sys
import time

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
COUNTED = ("injected", "effective", "detected", "safe_other", "listed", "silent", "exposed", "late")
RECORD = HERE / "long/result.json"
HEAD = """<!DOCTYPE html><html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width, initial-scale=1">
<title>Fault campaigns</title><style>:root{color-scheme:light dark}body{font:16px/1.4 sans-serif;margin:1em auto;max-width:60em;
padding:0 .6em;overflow-wrap:anywhere}.wide{overflow-x:auto}table{border-collapse:collapse}td,th{border-bottom:1px solid #8888;
padding:.2em .6em;text-align:right}td:first-child,th:first-child,.text td{text-align:left}.good{color:#080}.bad{color:#c00;
font-weight:bold}@media(prefers-color-scheme:dark){.good{color:#6c6}.bad{color:#f77}}</style></head><body><h1>Fault campaigns</h1>
"""


def short_plans():
    """What people start from; scenarios and networks beside them name neither."""
    plans = sorted((ROOT / "examples/campaigns").glob("*.yaml"))
    return [plan for plan in plans if any(line.startswith(("device:", "network:")) for line in plan.read_text(encoding="utf-8").splitlines())]


def run_plan(program, plan, out, options):
    """One campaign: its report as a dictionary, with the name of its page."""
    begun = time.monotonic()
    files = {kind: out / f"{plan.stem}.{kind}" for kind in ("html", "json", "csv")}
    # Below the root by a name that is the same wherever the tree stands: the report tells it.
    told = plan.relative_to(ROOT) if plan.is_relative_to(ROOT) else plan
    words = [str(program), "campaign", str(told), "--jobs", str(options.jobs)]
    for kind, file in files.items():
        file.unlink(missing_ok=True)
        if kind != "csv" or not options.long:
            words += [f"--{kind}", str(file)]
    if options.long:
        words += ["--out", str(out / f"{plan.stem}.results")]
    done = subprocess.run(words, cwd=ROOT, capture_output=True, text=True, check=False)
    (out / f"{plan.stem}.txt").write_text(done.stdout + done.stderr, encoding="utf-8")
    report = json.loads(files["json"].read_text(encoding="utf-8")) if files["json"].exists() else {"title": plan.stem, "strata": []}
    total = {key: sum(stratum[key] for stratum in report["strata"]) for key in COUNTED}
    result = {"plan": plan.stem, "title": report["title"], "holds": done.returncode == 0 and report.get("holds") is True, **total,
              "known": sum(1 for each in report.get("survivors", []) if each["known"]), "seconds": round(time.monotonic() - begun, 1)}
    print(f"{'holds' if result['holds'] else 'DOES NOT HOLD':14} {plan.stem}: {total['injected']} injected, {total['effective']} effective, "
          f"{total['listed']} listed, {total['silent']} silent, {total['exposed']} exposed, {total['late']} late, {result['known']} known, {result['seconds']} s", flush=True)
    return result


def run_planted(program, folder, defect, options):
    """The real program holds the plan, the broken one does not and says why."""
    plan = HERE / "planted" / defect["plan"]

    def answer(of):
        return subprocess.run([str(of), "campaign", str(plan), "--jobs", str(options.jobs)], cwd=ROOT, capture_output=True, text=True, check=False)

    sound, broken = answer(program), answer(folder / f"counterpoint_campaign_{defect['program']}")
    is_found = sound.returncode == 0 and broken.returncode == 1 and defect["told"] in broken.stdout
    print(f"{'found' if is_found else 'NOT FOUND':14} {defect['program']}: {defect['told']}", flush=True)
    return {"program": defect["program"], "plan": defect["plan"], "told": defect["told"], "found": is_found}


def page(results, planted):
    text = HEAD + '<div class="wide"><table><tr><th>plan</th><th>verdict</th><th>injected</th><th>effective</th><th>silent</th><th>exposed</th>' \
        "<th>late</th><th>of these known</th><th>detected</th><th>safe by others</th><th>listed</th></tr>\n"
    for each in results:
        name = html.escape(each["plan"])
        text += f'<tr><td><a href="{name}.html">{html.escape(each["title"])}</a> (<a href="{name}.csv">CSV</a>, <a href="{name}.json">JSON</a>)</td>' \
            f'<td class="{"good" if each["holds"] else "bad"}">{"holds" if each["holds"] else "does not hold"}</td>'
        text += "".join(f"<td>{each[key]}</td>" for key in ("injected", "effective", "silent", "exposed", "late", "known", "detected", "safe_other", "listed")) + "</tr>\n"
    text += '</table></div><h2>Planted defects</h2><div class="wide"><table class="text"><tr><th>defect</th><th>found</th><th>told</th></tr>\n'
    for each in planted:
        text += f'<tr><td>{each["program"]}</td><td class="{"good" if each["found"] else "bad"}">{"found" if each["found"] else "NOT FOUND"}</td>' \
            f'<td>{html.escape(each["told"])}</td></tr>\n'
    return text + "</table></div></body></html>\n"


def write_record(results):
    """The record with these results in place of those of the same plans; each tells the commit that it is of."""
    commit = subprocess.run(["git", "-C", str(ROOT), "rev-parse", "--short=12", "HEAD"], capture_output=True, text=True, check=False).stdout.strip()
    kept = json.loads(RECORD.read_text(encoding="utf-8"))["plans"] if RECORD.exists() else []
    plans = {each["plan"]: each for each in kept if (RECORD.parent / f"{each['plan']}.yaml").exists()}
    plans |= {each["plan"]: {**each, "commit": commit} for each in results}
    plans = [plans[name] for name in sorted(plans)]
    record = {"commit": ", ".join(sorted({each["commit"] for each in plans})), "holds": all(each["holds"] for each in plans),
              "injected": sum(each["injected"] for each in plans), "plans": plans, "planted": []}
    RECORD.write_text(json.dumps(record, indent=1) + "\n", encoding="utf-8")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("plans", nargs="*", type=pathlib.Path, metavar="PLAN")
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build/product")
    parser.add_argument("--jobs", type=int, default=0, help="processes at a time; 0: one for each processor")
    parser.add_argument("--long", action="store_true")
    parser.add_argument("--record", action="store_true", help=f"write the result of --long to {RECORD.relative_to(ROOT)}; of PLANs alone, in place of theirs")
    options = parser.parse_args()
    program = options.build / "tools/counterpoint_campaign"
    missing = [str(file) for file in (program, *options.plans) if not file.exists()]
    if missing or (options.record and not options.long):
        print(f"run.py: {missing[0] + ' is not there' if missing else '--record without --long'}", file=sys.stderr)
        return 2
    out = ROOT / ("build/campaign/long" if options.long else "build/campaign")
    out.mkdir(parents=True, exist_ok=True)
    plans = options.plans or (sorted((HERE / "long").glob("*.yaml")) if options.long else short_plans())
    begun = time.monotonic()
    results = [run_plan(program, plan.resolve(), out, options) for plan in plans]
    planted = []
    if not options.long and not options.plans:
        defects = json.loads((HERE / "planted/expected.json").read_text(encoding="utf-8"))["defects"]
        planted = [run_planted(program, options.build / "verification/campaign/planted", defect, options) for defect in defects]
    holds = all(each["holds"] for each in results) and all(each["found"] for each in planted)
    record = {"holds": holds, "injected": sum(each["injected"] for each in results), "plans": results, "planted": planted}
    (out / "campaign.json").write_text(json.dumps(record, indent=1) + "\n", encoding="utf-8")
    (out / "index.html").write_text(page(results, planted), encoding="utf-8")
    if options.record:
        write_record(results)
    print(f"{len(results)} plans, {record['injected']} faults, {sum(each['found'] for each in planted)} of {len(planted)} planted defects found, "
          f"{time.monotonic() - begun:.0f} s, {(out / 'index.html').relative_to(ROOT)}: {'pass' if holds else 'FAIL'}")
    return 0 if holds else 1


if __name__ == "__main__":
    sys.exit(main())
