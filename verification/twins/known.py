"""What stands on record of the twin table: known.json, its entries and what each covers."""
import json
import re

from build_tree import BadInput

# Sequences of the first step, all that --quick drives.
FIRST = 100
ONLY_AT = "only_at"  # Of an entry that is shared by the first step's sequences and told apart by more of them.
NOTE = "Wrong traces that a mutant of A and one of B share and that no requirement mutant shows, by the names of the mutants. A known gap, no excuse."


def read_known(path):
    if not path.exists():
        return []
    entries = json.loads(path.read_text(encoding="utf-8"))["known"]
    for entry in entries:
        if not all(entry.get(field) for field in ("a", "b", "slip")):
            raise BadInput(f"{path}: {entry}: expected a, b (names of mutants) and slip")
        if entry.get(ONLY_AT, FIRST) != FIRST:
            raise BadInput(f"{path}: {ONLY_AT} {entry[ONLY_AT]}: expected {FIRST}, the sequences of --quick")
    return entries


def fits(entry, names):
    """Whether it has some of each side."""
    return all(names[side] & set(entry[side]) for side in "ab")


def covers(entries, names):
    """Whether all names of both sides stand in entries that fit."""
    fitting = [entry for entry in entries if fits(entry, names)]
    return all(names[side] <= {name for entry in fitting for name in entry[side]} for side in "ab")


def names_of(row):
    return {side: {re.search(r"\[(\w+)\]$", line).group(1) for line in row[side]} for side in "ab"}


def record(path, rows, at_first):
    """Every row without a requirement mutant, and what is shared by the first step's sequences only; a slip that stands there keeps its words."""
    words = {name: entry["slip"] for entry in read_known(path) for name in (*entry["a"], *entry["b"])}

    def entry_of(names, more):
        slip = next((words[name] for side in "ab" for name in sorted(names[side]) if name in words), "not yet told")
        return {**{side: sorted(names[side]) for side in "ab"}, "slip": slip, **more}

    known = [entry_of(names_of(row), {}) for row in rows if not row["requirement"]]
    known += [entry_of(names, {ONLY_AT: FIRST}) for names in at_first if not covers(known, names)]
    lines = ",\n".join("  " + json.dumps(entry) for entry in known)
    path.write_text('{"note": "' + NOTE + '",\n "known": [' + (f"\n{lines}\n " if known else "") + "]}\n", encoding="utf-8")
