#!/usr/bin/env python3
"""Checks the models of the protocols with spin, and drives each of their transitions through the code that ships.

    check.py --replay build/product/verification/proof/protocols/counterpoint_replay [--work FOLDER] [MODEL ...]

For each model, which is a NAME.pml beside this file:
  1. spin looks at every state that the model can reach; no assertion may fail, no end state may be invalid;
  2. the same run tells each transition, and counterpoint_replay drives all of them through the code;
  3. each defect of the model, a PLANTED_... of its text, must make spin tell a failed assertion;
  4. each defect of the code that counterpoint_replay knows for it must be refused.
Where a model says "Each state lets in N inputs", so many different ones leave each of its states: none was lost between two choices.
Exit status: 0 all holds, 1 something does not, 2 it could not be run. docs/proof.md says what is shown and what not.
"""
import argparse
import pathlib
import re
import resource
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
MODELS = sorted(path.stem for path in HERE.glob("*.pml"))
PREPROCESSOR = "-Pgcc-12 -E -x c"
COMPILE = ["gcc-12", "-O1", "-w", "-DSAFETY", "-DNOREDUCE"]
DEPTH, HASH_BITS = "-m2000000", "-w22"


class CannotRun(Exception):
    """A tool is missing or ended in a way that tells nothing."""


def call(command, folder, **more):
    try:
        return subprocess.run(command, cwd=folder, stderr=subprocess.STDOUT, check=False, **more)
    except FileNotFoundError as problem:
        raise CannotRun(f"{command[0]} is not there: {problem}") from problem


def explore(model, folder, defines, tells):
    """Every reachable state of the model. Returns what the verifier printed, transitions apart, and where these are."""
    folder.mkdir(parents=True, exist_ok=True)
    made = call(["spin", PREPROCESSOR, *[f"-D{name}" for name in defines], "-a", HERE / f"{model}.pml"], folder, stdout=subprocess.PIPE, text=True)
    built = call([*COMPILE, *(["-DPRINTF"] if tells else []), "-o", "pan", "pan.c"], folder, stdout=subprocess.PIPE, text=True)
    if made.returncode != 0 or built.returncode != 0:
        raise CannotRun(f"{model}: {made.stdout}{built.stdout}")
    lines = folder / "transitions"
    with lines.open("w", encoding="ascii") as file:
        call([folder / "pan", DEPTH, HASH_BITS], folder, stdout=file)
    report = [line for line in lines.open(encoding="ascii") if not line.startswith("T ")]
    return "".join(report), lines


def verdict(report):
    """(states, what failed); nothing failed only where the search was complete."""
    states = re.search(r"^\s*(\d+) states, stored", report, re.MULTILINE)
    errors = re.search(r"errors: (\d+)", report)
    if not states or not errors:
        raise CannotRun(f"the verifier did not tell how it ended: {report[-400:]}")
    failed = re.search(r"^pan:1: (.*?)(?: \(at depth.*)?$", report, re.MULTILINE)
    is_cut = "max search depth too small" in report or "Search not completed" in report
    text = failed.group(1) if failed else ("the search was not complete" if is_cut or errors.group(1) != "0" else "")
    return int(states.group(1)), text


def show(passed, text, details=""):
    print(f"{'ok    ' if passed else 'FAILED'}  {text}", flush=True)
    for line in details.splitlines()[:30] if not passed else []:
        print(f"        {line}")
    return passed


def replay(program, model, lines, defect=None):
    with lines.open(encoding="ascii") as file:
        done = call([program, model, *([defect] if defect else [])], HERE, stdin=file, stdout=subprocess.PIPE, text=True)
    if done.returncode not in (0, 1):
        raise CannotRun(f"{program}: {done.stdout}")
    return done.returncode == 0, done.stdout.strip()


def inputs_lost(model, lines):
    """What is wrong with the number of inputs of a state, by what the model says of it; empty: nothing."""
    said = re.search(r"Each state lets in (\d+) inputs", (HERE / f"{model}.pml").read_text())
    if not said:
        return ""
    let_in = {}
    for line in lines.open(encoding="ascii"):
        if line.startswith("T "):
            before, given = line[2:].split("|")[:2]
            let_in.setdefault(before, set()).add(given)
    return "".join(f"state {state}lets in {len(given)} inputs, expected {said.group(1)}\n" for state, given in let_in.items()
                   if len(given) != int(said.group(1)))


def check(model, program, work):
    """The lines of one model. Returns a list of (is a defect, passed)."""
    report, lines = explore(model, work / model, [], True)
    states, failed = verdict(report)
    results = [(False, show(not failed, f"{model}: {states} states of the model, every assertion holds", failed + "\n" + report))]
    lost = inputs_lost(model, lines)
    if failed or lost:
        return results + ([(False, show(False, f"{model}: inputs are missing", lost))] if lost else [])
    passed, output = replay(program, model, lines)
    results.append((False, show(passed, f"{model}: replayed, {output.splitlines()[0].split(': ', 1)[1]}", output)))
    planted = sorted(set(re.findall(r"PLANTED_[A-Z_]+", (HERE / f"{model}.pml").read_text())))
    if not planted:
        results.append((True, show(False, f"{model}: no defect of the model")))
    for defect in planted:
        _, failed = verdict(explore(model, work / f"{model}_{defect}", [defect], False)[0])
        results.append((True, show("assertion violated" in failed, f"{model}: {defect} is found: {failed}", "expected a failed assertion")))
    defects = call([program, model, "--defects"], HERE, stdout=subprocess.PIPE, text=True).stdout.split()
    for defect in defects:
        passed, output = replay(program, model, lines, defect)
        results.append((True, show(not passed, f"{model}: code with {defect} is refused: {output.split('REFUSED: ')[-1].splitlines()[0]}", output)))
    if not defects:
        results.append((True, show(False, f"{model}: no defect of the code")))
    return results


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--replay", type=pathlib.Path, required=True, help="the program that drives the code")
    parser.add_argument("--work", type=pathlib.Path, default=HERE.parents[2] / "build/proof", help="folder for what is made")
    parser.add_argument("models", nargs="*", metavar="MODEL", help=f"of {', '.join(MODELS)}; all of them if none is named")
    options = parser.parse_args()
    unknown = sorted(set(options.models) - set(MODELS))
    if unknown:
        parser.error(f"no model {', '.join(unknown)}, expected {', '.join(MODELS)}")
    try:
        results = [result for model in options.models or MODELS
                   for result in check(model, options.replay.resolve(), options.work.resolve())]
    except CannotRun as problem:
        print(f"check.py: {problem}")
        return 2
    passed = all(result for _, result in results)
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    print(f"protocols: {len(options.models or MODELS)} models, {sum(is_defect for is_defect, _ in results)} planted defects, "
          f"{used.ru_utime + used.ru_stime:.1f} s: {'pass' if passed else 'FAIL'}")
    return 0 if passed else 1


if __name__ == "__main__":
    sys.exit(main())
