"""Coverage of lines and functions by llvm-cov's export, for the pages of files. Nothing is measured here."""
import json
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "coverage"))
from uncovered import line_counts  # noqa: E402
from matrix import name_in  # noqa: E402
from test_run import digest_of  # noqa: E402

RECORD = "coverage/files.json"  # Below the collected data: what each file was when it was measured.


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
        self.branches = {}  # Place -> how often true, how often false; of several instances of a template the one that ran least.
        for branch in entry.get("branches", []):
            place, sides = tuple(branch[:4]), branch[4:6]
            self.branches[place] = [min(pair) for pair in zip(self.branches.get(place, sides), sides)]
        self.decisions = entry.get("mcdc_records", [])

    def within(self, first, last):
        lines = [count for line, count in self.lines.items() if first <= line <= last]
        sides = [side > 0 for place, counts in self.branches.items() if first <= place[0] <= last for side in counts]
        conditions = [shown for record in self.decisions if first <= record[0] <= last for shown in record[-1]]
        return Counts((sum(count > 0 for count in lines), len(lines)), (sum(sides), len(sides)), (sum(conditions), len(conditions)))


def measured_entries(root, data):
    """File -> its part of the export."""
    path = data / "coverage/export.json"
    entries = json.loads(path.read_text())["data"][0]["files"] if path.exists() else []
    named = [(name_in(root, entry["filename"]), entry) for entry in entries]
    return {name: entry for name, entry in named if name}


def record(root, data):
    """Notes what the measured files are now, right after the measurement."""
    digests = {name: digest_of(root / name) for name in sorted(measured_entries(root, data))}
    (data / RECORD).write_text(json.dumps(digests, indent=1))


def changed_since(root, data):
    """Measured files that have changed since; their counts stand for lines that are no more."""
    digests = json.loads((data / RECORD).read_text()) if (data / RECORD).exists() else {}
    return sorted(name for name, digest in digests.items() if not (root / name).is_file() or digest_of(root / name) != digest)


def file_coverages(root, data):
    """File -> FileCoverage, for the files that were measured as they are now."""
    stale = set(changed_since(root, data))
    return {name: FileCoverage(entry) for name, entry in measured_entries(root, data).items() if name not in stale}
