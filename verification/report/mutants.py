"""The page of systematic mutants: the record of the last whole run, and what of it still describes the code."""
import collections
import json
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "verification/mutation"))
from generate import mutants_of  # noqa: E402
from record import VERDICTS, keys_of  # noqa: E402


def row_of(root, file, functions):
    """Counts of one file, and its functions whose text is another one now."""
    counts = collections.Counter()
    for of_function in functions.values():
        counts.update(of_function)
    source = (root / file).read_bytes() if (root / file).exists() else b""
    keys = set(keys_of(source, mutants_of(file, source)).values())
    return {"file": file, "functions": len(functions), "mutants": sum(counts.values()), **{verdict: counts[verdict] for verdict in VERDICTS},
            "changed": sorted(key.rsplit(" ", 1)[0] for key in keys - set(functions))}


def page_of(root):
    """What the template needs, and the gaps."""
    path = root / "verification/mutation/record.json"
    if not path.exists():
        return {"made": None}, ["mutants: no whole run is on record"]
    record = json.loads(path.read_text(encoding="utf-8"))
    rows = [row_of(root, file, functions) for file, functions in record["files"].items()]
    equivalent = json.loads((root / "verification/mutation/equivalent.json").read_text(encoding="utf-8"))["equivalent"]
    totals = {name: sum(row[name] for row in rows) for name in ("functions", "mutants", *VERDICTS)}
    return {"made": record["made"], "rows": rows, "totals": totals, "survivors": record["survivors"], "not_judged": len(record["not_judged"]), "equivalent": sorted(equivalent, key=lambda entry: (entry["file"], entry["change"]))}, []
