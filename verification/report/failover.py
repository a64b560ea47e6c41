"""The page of failover times: what counterpoint_elections --failovers recorded, as a picture. Nothing is measured here."""
import json

WIDTH, HEIGHT, BASE, TOP, MARGIN = 900, 240, 210, 34, 60


def is_good(series, cycle_us):
    """Recomputed from the times themselves, whatever the record says of itself."""
    in_time = all(time["computed_us"] <= time["least_us"] and time["greatest_us"] <= time["computed_us"] + cycle_us
                  for time in series["times"])
    counted = sum(time["runs"] for time in series["times"])
    return bool(series["times"]) and in_time and series["failed"] == 0 and counted == series["runs"]


def drawn(series, cycle_us, bin_us):
    """Bars and marks in the picture's units; the computed time and one cycle are always in it."""
    starts = [place["from_us"] for place in series["bins"]]
    first = min([0, *starts])
    last = max([cycle_us, *(start + bin_us for start in starts)])
    scale = (WIDTH - 2 * MARGIN) / (last - first)
    highest = max([1, *(place["count"] for place in series["bins"])])

    def at(us):
        return round(MARGIN + (us - first) * scale, 1)

    bars = []
    for place in series["bins"]:
        start = place["from_us"]
        height = round((BASE - TOP) * place["count"] / highest, 1)
        bars.append({"x": at(start), "y": BASE - height, "width": round(max(1.0, bin_us * scale - 1.0), 1), "height": height,
                     "middle": at(start + bin_us / 2), "count": place["count"], "good": 0 <= start <= cycle_us,
                     "text": f"{start} to {start + bin_us} us after the computed time: {place['count']}"})
    marks = [{"x": at(0), "us": 0, "text": "computed"}, {"x": at(cycle_us), "us": cycle_us, "text": "one cycle later"}]
    return dict(series, good=is_good(series, cycle_us), bars=bars, marks=marks)


def page_of(path):
    """What the template needs, and the gaps."""
    record = json.loads(path.read_text()) if path.exists() else {"cycle_us": 0, "bin_us": 1, "series": []}
    series = [drawn(one, record["cycle_us"], record["bin_us"]) for one in record["series"]]
    gaps = [f"failover: {one['name']}: from {one['least_late_us']} to {one['greatest_late_us']} us after the computed time, "
            f"expected 0 to {record['cycle_us']} us; {one['failed']} failed" for one in series if not one["good"]]
    if not series:
        gaps.append("failover: no times were measured")
    return {"cycle_us": record["cycle_us"], "series": series, "width": WIDTH, "height": HEIGHT, "base": BASE}, gaps
