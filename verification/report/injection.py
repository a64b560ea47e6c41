"""The page of faults in the code of the target: what ./dev inject recorded. Nothing is measured here."""
import json
import shutil

WIDTH, HEIGHT, BASE, TOP, MARGIN = 900, 200, 170, 24, 40


def histogram(times, kind):
    """Bars of the detection times of one kind of fault, in the picture's units; heights by the logarithm, as most are told at once."""
    counts = {}
    for row in times:
        if row["fault"] == kind:
            for step, count in row["steps"].items():
                counts[int(step)] = counts.get(int(step), 0) + count
    last = max(counts, default=0) + 1
    highest = max([1, *(count.bit_length() for count in counts.values())])
    width = (WIDTH - 2 * MARGIN) / last
    return {"last": last - 1, "bars": [{"x": round(MARGIN + step * width, 1), "width": round(max(1.0, width - 1.0), 1),
                                        "height": round((BASE - TOP) * count.bit_length() / highest, 1),
                                        "text": f"{step} ms: {count}"} for step, count in sorted(counts.items())]}


def page_of(folder, evidence):
    """What the template needs, and the gaps; the rows of the run are laid beside the page."""
    path = folder / "injection.json"
    record = json.loads(path.read_text()) if path.exists() else None
    if record is None:
        return {"record": None, "histograms": {}, "has_rows": False}, ["injection: nothing was run"]
    rows = folder / "injection.csv.gz"
    if rows.exists():
        shutil.copyfile(rows, evidence / "injection.csv.gz")
    gaps = [f"injection: {problem}" for problem in record["problems"]]
    gaps += [f"injection: {name}: {told}" for name, _, _, told in record["controls"] if told != "told"]
    return {"record": record, "histograms": {row["fault"]: histogram(record["times"], row["fault"]) for row in record["table"]},
            "has_rows": rows.exists(), "width": WIDTH, "height": HEIGHT, "base": BASE, "margin": MARGIN}, gaps
