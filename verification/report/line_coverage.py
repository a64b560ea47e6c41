"""Coverage of lines and functions by llvm-cov's export, for the pages of files. Nothing is measured here."""
import json

from matrix import name_in


class Counts:
    """Covered and all of lines, branches and MC/DC conditions of some lines."""

    def __init__(self, lines, branches, conditions):
        self.parts = [("lines", lines), ("branches", branches), ("MC/DC", conditions)]
        self.full = all(covered == count for _, (covered, count) in self.parts)

    def __str__(self):
        return ", ".join(f"{covered} of {count} {name}" for name, (covered, count) in self.parts if count) or "no code"


class FileCoverage:
    def __init__(self, entry):
        self.lines = line_counts(entry["segments"])
        self.branches = entry.get("branches", [])
        self.decisions = entry.get("mcdc_records", [])

    def within(self, first, last):
        lines = [count for line, count in self.lines.items() if first <= line <= last]
        sides = [side > 0 for branch in self.branches if first <= branch[0] <= last for side in branch[4:6]]
        conditions = [shown for record in self.decisions if first <= record[0] <= last for shown in record[-1]]
        return Counts((sum(count > 0 for count in lines), len(lines)), (sum(sides), len(sides)), (sum(conditions), len(conditions)))


def line_counts(segments):
    """Line -> how often it ran, as llvm-cov shows it: the greatest count of a region that begins in the line, else the one around it."""
    by_line = {}
    for segment in segments:
        by_line.setdefault(segment[0], []).append(segment)
    counts, around = {}, None
    for line in range(1, max(by_line, default=0) + 1):
        here = by_line.get(line, [])
        starting = [segment[2] for segment in here if segment[3] and segment[4] and not (len(segment) > 5 and segment[5])]
        inside = [around[2]] if around is not None and around[3] else []
        if starting or inside:
            counts[line] = max(starting + inside)
        around = here[-1] if here else around
    return counts


def file_coverages(root, data):
    """File -> FileCoverage, for the files that were measured."""
    path = data / "coverage/export.json"
    if not path.exists():
        return {}
    found = {}
    for entry in json.loads(path.read_text())["data"][0]["files"]:
        name = name_in(root, entry["filename"])
        if name:
            found[name] = FileCoverage(entry)
    return found
