"""What became of the faults: rows of the injector to counts, times, bounds, survivors and a CSV file."""
import collections
import csv
import gzip
import heapq
import io
import math
import posixpath
import re

CLASSES = ("masked", "latent", "benign", "detected", "crash, ends safe", "lost frame", "pair check only", "silent")
# What counts for a bound: something dangerous or wrong came of it, and somebody told it or nobody did.
EFFECTIVE = ("detected", "crash, ends safe", "lost frame", "pair check only", "silent")
CODE = ("skip", "invert", "register", "opcode", "flash")
COLUMNS = ("number", "fault", "step", "scene", "instruction", "address", "bit", "function", "line", "kind", "what", "steps")
CLOSED = ", output closed"
OUTPUT = ("hal/", "faulted_pins")  # Gate and pins.
SENT = "frame under a foreign identifier"  # By the CAN port, not by the gate.
LASTING = ("flash", "stuck")

Row = collections.namedtuple("Row", COLUMNS)


def bound(silent, effective, confidence=0.99):
    """Greatest share of silent ones that fits to what was seen (Clopper-Pearson, one-sided); 1 of none."""
    if effective == 0 or silent >= effective:
        return 1.0

    def at_most(share):
        """Probability of so few silent ones."""
        terms = [math.lgamma(effective + 1) - math.lgamma(k + 1) - math.lgamma(effective - k + 1) + k * math.log(share)
                 + (effective - k) * math.log1p(-share) for k in range(silent + 1)]
        return sum(map(math.exp, terms))

    low, high = 0.0, 1.0
    for _ in range(60):
        middle = (low + high) / 2
        low, high = (middle, high) if at_most(middle) > 1 - confidence else (low, middle)
    return high


def percentile(steps, share):
    left = share * sum(steps.values())
    for step in sorted(steps):
        left -= steps[step]
        if left <= 0:
            return step
    return 0


class Places:
    """Function and line of an address of the code; part and byte of one of the RAM."""

    def __init__(self, code, parts):
        self.code, self.parts = code, parts

    def of(self, fault, instruction, address):
        if fault in CODE:
            function, line = self.code.get(instruction if fault == "flash" else address, ("", ""))
            return function, re.sub(r"^.*/((safety_core|channel_a|channel_b|hal|verification)/)", r"\1", posixpath.normpath(line))
        begin, name = next((begin, name) for begin, end, name in self.parts if begin <= address < end)
        return name, f"byte {address - begin}"


def rows_of(path, places):
    with open(path, encoding="utf-8") as text:
        for line in text:
            if line.startswith("row\t"):
                fields = line.rstrip("\n").split("\t")[1:]
                function, line_of = places.of(fields[1], int(fields[4]), int(fields[5]))
                yield Row(int(fields[0]), fields[1], int(fields[2]), fields[3], int(fields[4]), int(fields[5]), int(fields[6]), function, line_of,
                          fields[7], fields[8], int(fields[9]))


class Summary:
    """Counts while rows go by."""

    def __init__(self):
        self.classes = collections.defaultdict(collections.Counter)
        self.mechanisms = collections.defaultdict(lambda: collections.defaultdict(collections.Counter))
        self.silent_kinds = collections.defaultdict(collections.Counter)
        self.survivors = collections.OrderedDict()
        self.unsheltered = collections.Counter()

    def see(self, row, mechanism):
        self.classes[row.fault][row.kind] += 1
        if row.kind in ("detected", "crash, ends safe"):
            self.mechanisms[row.fault][mechanism][row.steps] += 1
        if row.kind == "silent":
            self.silent_kinds[row.fault][row.what] += 1
            self.keep(row)

    def keep(self, row):
        is_sheltered = row.what.endswith(CLOSED) or row.what == SENT or row.line.startswith(OUTPUT[0]) or row.function == OUTPUT[1]
        self.unsheltered[row.fault] += not is_sheltered
        key = (row.fault, row.function, row.line, row.what)
        entry = self.survivors.setdefault(key, {
            "fault": row.fault, "function": row.function, "line": row.line, "what": row.what, "behind_ideal_gate": not is_sheltered, "count": 0,
            "scenes": [], "example": {"step": row.step, "fault": row.fault, "instruction": row.instruction, "address": f"{row.address:#x}",
                                      "number": row.bit}})
        entry["count"] += 1
        if row.scene not in entry["scenes"]:
            entry["scenes"].append(row.scene)

    def table(self):
        """One record a kind of fault, as the page and the terminal show it."""
        records = []
        for fault, counts in self.classes.items():
            effective = sum(counts[name] for name in EFFECTIVE)
            times = sum(self.mechanisms[fault].values(), collections.Counter())
            records.append({"fault": fault, "injected": sum(counts.values()), "effective": effective, **{name: counts[name] for name in CLASSES},
                            "bound": bound(counts["silent"], effective), "median": percentile(times, 0.5), "most": percentile(times, 0.999),
                            "worst": max(times, default=0)})
        return records

    def times(self):
        return [{"fault": fault, "mechanism": name, "count": sum(steps.values()), "median": percentile(steps, 0.5),
                 "most": percentile(steps, 0.999), "worst": max(steps), "steps": {str(step): steps[step] for step in sorted(steps)}}
                for fault, found in self.mechanisms.items() for name, steps in sorted(found.items(), key=lambda item: -sum(item[1].values()))]


def summarise(paths, places, mechanism_of, to):
    """Rows of all shards in the order of their numbers, also written as CSV; the same bytes for any number of shards."""
    summary = Summary()
    with open(to, "wb") as raw, gzip.GzipFile("", "wb", compresslevel=3, fileobj=raw, mtime=0) as packed, \
            io.TextIOWrapper(packed, encoding="utf-8", newline="") as text:
        table = csv.writer(text, lineterminator="\n")
        table.writerow("class" if name == "kind" else name for name in COLUMNS)
        for row in heapq.merge(*(rows_of(path, places) for path in paths), key=lambda row: row.number):
            mechanism = mechanism_of(row.what)
            summary.see(row, mechanism)
            table.writerow(row._replace(address=f"{row.address:#x}", what=mechanism))
    return summary
