"""The page of fault campaigns: what verification/campaign/run.py judged, its reports, and the recorded result of the long plans."""
import json
import shutil

NOTHING = {"holds": False, "injected": 0, "plans": [], "planted": [], "commit": ""}


def record_of(path):
    return {**NOTHING, **json.loads(path.read_text(encoding="utf-8"))} if path.exists() else dict(NOTHING)


def page_of(root, evidence):
    """What the template needs, and the gaps. The reports are copied, so that the evidence opens without the build."""
    made = root / "build/campaign"
    short = record_of(made / "campaign.json")
    target = evidence / "campaign"
    target.mkdir(parents=True, exist_ok=True)
    for plan in short["plans"]:
        for kind in ("html", "json", "csv"):
            file = made / f"{plan['plan']}.{kind}"
            if file.exists():
                shutil.copy(file, target / file.name)
    gaps = [f"campaign: {plan['plan']} does not hold" for plan in short["plans"] if not plan["holds"]]
    gaps += [f"campaign: planted defect {defect['program']} was not found" for defect in short["planted"] if not defect["found"]]
    if not short["plans"] or not short["planted"]:
        gaps.append("campaign: no campaign has run")
    return {"short": short, "long": record_of(root / "verification/campaign/long/result.json")}, gaps
