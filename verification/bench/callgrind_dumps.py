"""Reads callgrind's dumps: one a repetition's item of the benchmark, costs by function."""
import collections
import re

LABEL = re.compile(r"item=(\w+) srdos=(\d+) repetitions=(\d+)")
FUNCTION = re.compile(r"^(c?fn)=\((\d+)\)(?: (.*))?$")
COST = re.compile(r"^[+\-*\d]\S* (\d+)$")


def own_costs(path):
    """(item, SRDOs), repetitions, instructions of each function itself. A line after calls= is cost of the callee."""
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
        return None, 0, {}
    by_name = collections.Counter()
    for key, value in costs.items():
        by_name[names[key]] += value
    return (label.group(1), int(label.group(2))), int(label.group(3)), by_name
