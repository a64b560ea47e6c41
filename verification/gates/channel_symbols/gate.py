#!/usr/bin/env python3
"""No code symbol, weak or not, that the objects of both channels define: the linker would keep one for both.

Looked at in the objects that ship, and, for functions of this tree, in objects that were not optimised: there an inline
function of the contract shows up that optimisation would have hidden in both channels.
"""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from common import run_gate  # noqa: E402
from objects import demangle, room_objects, symbols  # noqa: E402

# Not optimised, each channel has the constructor of the interface, which the language demands: it sets the pointer to the
# virtual table and nothing else. In what ships it must be gone as well.
OF_THE_LANGUAGE = {"_ZN12counterpoint7ChannelC1Ev", "_ZN12counterpoint7ChannelC2Ev"}


def code_of(data, folder, room):
    found = {}
    for path in room_objects(data, folder, room):
        for symbol in symbols(path):
            if symbol.defined and symbol.kind in ("FUNC", "IFUNC"):
                found[symbol.name] = symbol
    return found


def gate(_root, data):
    findings, counts = [], []
    for folder in ("objects", "objects_plain"):
        a, b = code_of(data, folder, "channel_a"), code_of(data, folder, "channel_b")
        counts.append(f"{folder}: {len(a)} functions of channel A, {len(b)} of channel B")
        for name in sorted(set(a) & set(b)):
            if folder == "objects" or ("12counterpoint" in name and name not in OF_THE_LANGUAGE):
                findings.append(f"{folder}/channel_a/{a[name].path.name}: both channels define {demangle(name)} "
                                f"({a[name].binding.lower()}), expected no shared code")
        if not a or not b:
            findings.append(f"{folder}: a channel without functions, expected both to have some")
    return findings, "; ".join(counts)


run_gate(gate)
