#!/usr/bin/env python3
"""Where an item of the benchmark spends its instructions, by function, from the dumps of the last run of bench.py.

    profile.py ITEM [MINUS [TIMES]] [--srdos N] [--folder build/bench]

`profile.py pair idle` shows what a pair adds to an idle cycle; `profile.py send idle_producers 2` what sending adds to two.
Exit status: 0, or 2 if there is no such dump.
"""
import argparse
import collections
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "verification/bench"))
import callgrind_dumps  # noqa: E402


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("item")
    parser.add_argument("minus", nargs="?")
    parser.add_argument("times", nargs="?", type=int, default=1)
    parser.add_argument("--srdos", type=int, default=64)
    parser.add_argument("--folder", type=pathlib.Path, default=ROOT / "build/bench")
    arguments = parser.parse_args()
    dumps = {}
    for path in arguments.folder.glob("callgrind.out.*"):
        label, repetitions, costs = callgrind_dumps.own_costs(path)
        dumps[label] = {name: cost / repetitions for name, cost in costs.items()} if label else {}
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
