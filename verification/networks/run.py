#!/usr/bin/env python3
"""Draws networks with faults, runs them with `counterpoint simulate`, and judges what the manager did.

    run.py --program build/product/tools/counterpoint                          100 networks of seed 1
    run.py --program build/product/tools/counterpoint --seed 7 --runs 10000    many
    run.py --program ... --seed 7 --first 17 --runs 1 --keep /tmp/network      one again, its files kept
    run.py --program ... --self-test                                           logs that break a rule are told

Each network has a manager of one of the three profiles, 1 to 6 slaves, and 0 to 8 faults and orders at drawn instants. The
frames of its bus, the events of its manager and the devices' own states are judged by the rules of README.md, which know
nothing of the manager's code. A broken rule is one line: seed, network, time, rule, and how to run it again.
Needs nothing but Python. Exit status: 0 every rule holds; 1 one is broken; 2 bad input.
"""
import argparse
import collections
import pathlib
import sys
import tempfile
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import bounds  # noqa: E402
import devices  # noqa: E402
import draw  # noqa: E402
import judge  # noqa: E402
import self_test  # noqa: E402

TWICE = 20  # Each so manieth network is run twice.


class BadInput(Exception):
    """Arguments that cannot be used."""


def progress(done, count):
    if sys.stderr.isatty():
        filled = 40 * done // count
        sys.stderr.write(f"\r[{'#' * filled}{' ' * (40 - filled)}] {done} of {count} networks" + ("\n" if done == count else ""))
        sys.stderr.flush()


def number_of(least):
    def parse(text):
        if not text.isdecimal() or int(text) < least:
            raise argparse.ArgumentTypeError(f"'{text}', expected a whole number of at least {least}")
        return int(text)
    return parse


def arguments_of(words):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", type=pathlib.Path, required=True, help="the built `counterpoint`")
    parser.add_argument("--seed", type=number_of(0), default=1, help="everything is drawn from it (default 1)")
    parser.add_argument("--runs", type=number_of(1), default=100, help="how many networks (default 100)")
    parser.add_argument("--first", type=number_of(0), default=0, help="number of the first one (default 0)")
    parser.add_argument("--keep", type=pathlib.Path, metavar="DIR",
                        help="write the files here and keep them; of several networks each in a folder named by its number")
    parser.add_argument("--self-test", action="store_true", help="shows that every rule can be broken, and ends")
    options = parser.parse_args(words)
    if not options.program.is_file():
        parser.error(f"--program {options.program}: no such file, expected the built program, "
                     "build/product/tools/counterpoint")
    if options.keep is not None and options.keep.exists() and not options.keep.is_dir():
        parser.error(f"--keep {options.keep}: this is no folder, expected one or a new name")
    return options


def again(options, number):
    return f"run.py --program {options.program} --seed {options.seed} --first {number} --runs 1 --keep DIR"


def run_all(options, work):
    """All networks. Returns the counts and the number of broken rules."""
    catalogue = devices.Catalogue(options.program, work)
    counts, broken = collections.Counter(), 0
    for done, number in enumerate(range(options.first, options.first + options.runs), start=1):
        plan = draw.draw(options.seed, number, bounds.rest_us)
        folder = work / "network" if options.keep is None else options.keep
        folder = folder / str(number) if options.keep is not None and options.runs > 1 else folder
        folder.mkdir(parents=True, exist_ok=True)
        outcome = judge.run_network(options.program, catalogue, plan, folder, number % TWICE == 0)
        counts.update(outcome.counts)
        counts["longest rest after the last fault [ms]"] = max(counts["longest rest after the last fault [ms]"],
                                                               (plan.duration_us - plan.last_us) // bounds.MS)
        for violation in outcome.violations:
            broken += 1
            print(f"BROKEN  seed {options.seed} network {number} ({plan.profile}) {violation.t_us / 1e6:.6f} s, rule "
                  f"{violation.rule}: {violation.text}; {again(options, number)}", flush=True)
        progress(done, options.runs)
    return counts, broken


def main(words):
    options = arguments_of(words)
    started = time.monotonic()
    try:
        with tempfile.TemporaryDirectory() as folder:
            if options.self_test:
                return self_test.run(options.program, pathlib.Path(folder))
            counts, broken = run_all(options, pathlib.Path(folder))
    except (devices.BadDevice, judge.wire.BadLog, OSError) as error:
        print(error, file=sys.stderr)
        return 2
    for name in sorted(counts):
        print(f"{counts[name]:9d}  {name}")
    print(f"{options.runs} networks, seed {options.seed}, {broken} broken rules, {time.monotonic() - started:.0f} s: "
          f"{'FAIL' if broken else 'pass'}")
    return 1 if broken else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
