#!/usr/bin/env python3
"""Runs the gates: each on its fixtures, which it must refuse, then on the tree, which it must accept.

    run.py --fixtures                     only the fixtures
    run.py --tree build/evidence/data     fixtures, then the tree with the data collected by ./dev verify
    run.py ... GATE...                    only these gates

A fixture is verification/gates/<gate>/fixture/<case>/: `expected`, a text that the gate must print; `tree/`, the root it looks
at; `data/`, collected results; `prepare`, a script called with the case's folder and an empty folder, where it makes
what cannot be kept as files (objects, profiles): there, `tree/` and `data/` come before the case's own.
A case whose name begins with near_miss must pass: it stands for what a gate may not refuse.
With --results FILE the outcome is also written as JSON.
Exit status: 0 every gate does as it should, 1 one does not.
"""
import argparse
import concurrent.futures
import json
import pathlib
import subprocess
import sys
import tempfile
import time

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
LAST = "trace"  # Reads the results of the others.


def call(gate, root, data):
    started = time.monotonic()
    done = subprocess.run([sys.executable, HERE / gate / "gate.py", root, data], capture_output=True, text=True, check=False)
    output = (done.stdout + done.stderr).strip()
    return done.returncode, output, round(time.monotonic() - started, 1)


def run_case(gate, case):
    """One fixture. Returns the record that the evidence page shows."""
    with tempfile.TemporaryDirectory(prefix="gate_") as scratch:
        made = pathlib.Path(scratch)
        if (case / "prepare").exists():
            done = subprocess.run(["bash", case / "prepare", case, made], capture_output=True, text=True, cwd=ROOT, check=False)
            if done.returncode != 0:
                return {"case": case.name, "passed": False, "output": "prepare failed: " + (done.stdout + done.stderr)[-600:]}
        root = made / "tree" if (made / "tree").exists() else case / "tree"
        data = made / "data" if (made / "data").exists() else case / "data"
        status, output, _ = call(gate, root, data)
        output = output.replace(str(made), "<made>")
    if case.name.startswith("near_miss"):
        return {"case": case.name, "wants": "acceptance", "passed": status == 0, "output": output}
    expected = (case / "expected").read_text().strip()
    passed = status == 1 and expected in output
    return {"case": case.name, "wants": f"refusal: {expected}", "passed": passed, "output": output}


def run_fixtures(gate):
    cases = sorted(path for path in (HERE / gate / "fixture").glob("*") if path.is_dir())
    records = [run_case(gate, case) for case in cases]
    if not any(not case.name.startswith("near_miss") for case in cases):
        records.append({"case": "-", "passed": False, "output": "the gate has no fixture that it must refuse"})
    return records


def description(gate):
    text = (HERE / gate / "gate.py").read_text().split('"""')[1]
    return " ".join(text.split())


def show(gate, what, passed, output):
    print(f"{'ok    ' if passed else 'FAILED'}  {gate:20} {what}", flush=True)
    if not passed:
        lines = output.splitlines()
        for line in lines[:40]:
            print(f"        {line}")
        if len(lines) > 40:
            print(f"        ... {len(lines) - 40} more lines")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--fixtures", action="store_true", help="only the fixtures")
    parser.add_argument("--tree", type=pathlib.Path, metavar="DATA", help="also the tree, with collected data")
    parser.add_argument("--results", type=pathlib.Path, help="write the outcome as JSON")
    parser.add_argument("gates", nargs="*", metavar="GATE")
    options = parser.parse_args()
    gates = options.gates or sorted(path.parent.name for path in HERE.glob("*/gate.py"))
    unknown = [gate for gate in gates if not (HERE / gate / "gate.py").exists()]
    if unknown or not (options.fixtures or options.tree):
        parser.error(f"no gate {', '.join(unknown)}" if unknown else "expected --fixtures or --tree DATA")
    results = {gate: {"gate": gate, "what": description(gate)} for gate in gates}
    with concurrent.futures.ThreadPoolExecutor(max_workers=2) as pool:
        for gate, records in zip(gates, pool.map(run_fixtures, gates)):
            results[gate]["fixtures"] = records
            for record in records:
                show(gate, f"fixture {record['case']}", record["passed"], record["output"])
        if options.tree:
            data = options.tree.resolve()
            order = [gate for gate in gates if gate != LAST]
            for gate, (status, output, seconds) in zip(order, pool.map(lambda gate: call(gate, ROOT, data), order)):
                results[gate]["tree"] = {"passed": status == 0, "status": status, "output": output, "seconds": seconds}
                show(gate, f"tree ({seconds} s): {output.splitlines()[-1] if output else ''}", status == 0, output)
            if LAST in gates:
                (data / "gates.json").write_text(json.dumps(list(results.values()), indent=1))
                status, output, seconds = call(LAST, ROOT, data)
                results[LAST]["tree"] = {"passed": status == 0, "status": status, "output": output, "seconds": seconds}
                show(LAST, f"tree ({seconds} s): {output.splitlines()[-1] if output else ''}", status == 0, output)
    passed = all(record["passed"] for result in results.values() for record in result["fixtures"])
    if options.tree:
        passed = passed and all(result["tree"]["passed"] for result in results.values())
    if options.results:
        options.results.write_text(json.dumps(list(results.values()), indent=1))
    print(f"{'every gate does as it should' if passed else 'a gate does not do as it should'} ({len(gates)} gates)")
    return 0 if passed else 1


if __name__ == "__main__":
    sys.exit(main())
