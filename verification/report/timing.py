"""The page of times: the dearest cycle on the target, its stack, the bound of each loop, against the budget. Nothing is measured here: the numbers are
those that ./dev bench and ./dev firmware recorded, of the objects that the evidence names."""
import json
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "gates"))
from common import cpp_files, read  # noqa: E402
from loop_heads import ROOMS, constants, function_at, loops_of, number_of  # noqa: E402

WORST = "own_device_worst"
SCENARIOS = "verification/target/firmware/scenarios"
MAIN = "FirmwareMain"
# Rows of the bench that are budgets of time and stack on the target.
BUDGETS = ("fixed", "fw_cycle", "fw_stack_a", "fw_stack_b", "fixed_target", "load", "services")


def record_of(path):
    return json.loads(path.read_text(encoding="utf-8")) if path.exists() else None


def loop_rows(root):
    """File, line, function, head, bound and the bound as a number of each loop."""
    texts = {name: read(root, name) for name in cpp_files(root, ROOMS)}
    known = constants(texts.values())
    for name, text in texts.items():
        near = {**known, **constants([text])}
        for loop in loops_of(text):
            yield {"path": name, "line": loop.line, "function": function_at(text, loop.line), "head": f"{loop.keyword} ({loop.head})", "bound": loop.bound,
                   "number": number_of(loop.bound, near)}


def how_built(root):
    """What the head of the worst scenario says of it."""
    lines = (root / SCENARIOS / f"{WORST}.txt").read_text(encoding="utf-8").splitlines()
    return " ".join(line[1:].strip() for line in lines if line.startswith("#"))


def cycle_rows(target):
    rows = [{"scenario": name, "instructions": cost[0], "cycles": cost[1], "stack": cost[2]} for name, cost in target["firmware_cycles"].items()]
    return sorted(rows, key=lambda row: (-row["instructions"], row["scenario"]))


def gaps_of(identity, bench, target, loops):
    """One text each."""
    for name, told, expected in (("bench, host", bench["digest"]["product"], identity.get("digest")), ("bench, target", bench["digest"]["target"], identity.get("target_digest")),
                                 ("target run", target["digest"], identity.get("target_digest"))):
        if expected is not None and told != expected:
            yield f"timing: the {name}, measured objects {told[:16]}, expected {expected[:16]}"
    rows = cycle_rows(target)
    if not rows or rows[0]["scenario"] != WORST:
        yield f"timing: the dearest cycle is of {rows[0]['scenario'] if rows else 'no scenario'}, expected {WORST}, which is built to be it"
    for entry, (depth, given) in bench["firmware"]["entry_points"].items():
        if depth > given:
            yield f"timing: {entry} needs {depth} bytes of stack, expected at most {given}"
    given = bench["firmware"]["entry_points"][MAIN][1]
    yield from (f"timing: {row['scenario']} used {row['stack']} bytes of stack, expected at most {given}" for row in rows if row["stack"] > given)
    yield from (f"timing: {row['path']}:{row['line']}: a loop without a bound" for row in loops if not row["bound"])
    broken = [row for row in bench["rows"] if row["id"] in BUDGETS and not row["kept"] and not row.get("known")]
    yield from (f"timing: {row['text']}: {row['measured']:.0f} {row['unit']}, must be at most {row['must']}" for row in broken)


def page_of(root, data):
    """What the template needs, and the gaps."""
    bench, target = record_of(root / "build/bench/bench.json"), record_of(root / "build/target/target.json")
    loops = list(loop_rows(root))
    if bench is None or target is None:
        return {"bench": None, "loops": loops}, ["timing: nothing was measured"]
    identity = record_of(data / "identity.json") or {}
    stacks = sorted(({"entry": row["entry"], "bytes": row["bytes"], "path": row["path"]} for row in target["stack"]), key=lambda row: (-row["bytes"], row["entry"]))
    return {"bench": bench, "loops": loops, "cycles": cycle_rows(target), "worst": WORST, "how": how_built(root), "stacks": stacks, "scenarios": SCENARIOS,
            "main": bench["firmware"]["entry_points"][MAIN], "budgets": [row for row in bench["rows"] if row["id"] in BUDGETS],
            "numbered": sum(row["number"] is not None for row in loops)}, list(gaps_of(identity, bench, target, loops))
