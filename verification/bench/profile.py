#!/usr/bin/env python3
"""Where an item of the benchmark spends its instructions, by function, from the dumps of the last run of bench.py.

    profile.py ITEM [MINUS [TIMES]] [--srdos N] [--folder build/bench]

`profile.py pair idle` shows what a pair adds to an idle cycle; `profile.py send idle_producers 2` what sending adds to two.
Exit status: 0, or 2 if there is no such dump.
"""
import argparse
import collections
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
LABEL = re.compile(r"item=(\w+) srdos=(\d+) repetitions=(\d+)")
FUNCTION = re.compile(r"^(c?fn)=\((\d+)\)(?: (.*))?$")
COST = re.compile(r"^[+\-*\d]\S* (\d+)$")


def own_costs(path):
    """Label, and instructions of each function itself in one repetition. A line after calls= is cost of the callee."""
    names, costs = {}, collections.Counter()
    label, current, of_callee = None, None, False
    for line in path.read_text(encoding="utf-8").splitlines():
        label = label or LABEL.search(line)
        function, cost = FUNCTION.match(line), COST.match(line)
        if function:
            if function.group(3):
                names[function.group(2)] = function.group(3)
            if function.group(1) == "fn":
                current = function.group(2)
        elif line.startswith("calls="):
            of_callee = True
        elif cost and of_callee:
            of_callee = False
        elif cost:
            costs[current] += int(cost.group(1))
    if label is None:
        return None, {}
    return (label.group(1), label.group(2)), {names[key]: value / int(label.group(3)) for key, value in costs.items()}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("item")
    parser.add_argument("minus", nargs="?")
    parser.add_argument("times", nargs="?", type=int, default=1)
    parser.add_argument("--srdos", default="64")
    parser.add_argument("--folder", type=pathlib.Path, default=ROOT / "build/bench")
    arguments = parser.parse_args()
    dumps = dict(own_costs(path) for path in arguments.folder.glob("callgrind.out.*"))
    wanted = [arguments.item] + ([arguments.minus] if arguments.minus else [])
    for item in wanted:
        if (item, arguments.srdos) not in dumps:
            print(f"profile.py: {arguments.folder}: no dump of item={item} srdos={arguments.srdos}, expected after bench.py",
                  file=sys.stderr)
            return 2
    costs = collections.Counter(dumps[(arguments.item, arguments.srdos)])
    for name, value in dumps.get((arguments.minus, arguments.srdos), {}).items():
        costs[name] -= arguments.times * value
    for name, value in costs.most_common():
        if abs(value) >= 0.5:
            print(f"{value:9.1f}  {name}")
    print(f"{sum(costs.values()):9.1f}  in all, with what the bench itself does between kernel calls")
    return 0


if __name__ == "__main__":
    sys.exit(main())
