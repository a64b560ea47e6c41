#!/usr/bin/env python3
"""What ships for the target needs nothing but memcpy, memset, memmove, memcmp and its own objects; each channel not even those
of others. And nothing in it runs before main or on an exception."""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from common import run_gate  # noqa: E402
from objects import demangle, room_objects, sections, symbols  # noqa: E402

MEMORY = {"memcpy", "memset", "memmove", "memcmp"}
LINKER = {"_GLOBAL_OFFSET_TABLE_"}
# Room -> rooms whose symbols it may need.
MAY_NEED = {
    "channel_a": [],
    "channel_b": [],
    "safety_core_comparator": [],
    "hal_api": [],
    "safety_core_kernel": ["safety_core_comparator", "hal_api"],
    "safety_core_selftest": ["hal_api"],
    "safety_core_crosslink": ["safety_core_comparator", "hal_api"],
}
REFUSED_SECTIONS = (".init_array", ".ctors", ".fini_array", ".dtors", ".gcc_except_table", ".tdata", ".tbss")


def gate(_root, data):
    findings, defined, needed, count = [], {}, {}, 0
    for room in MAY_NEED:
        for path in room_objects(data, "objects", room):
            count += 1
            for symbol in symbols(path):
                if symbol.defined:
                    defined.setdefault(room, set()).add(symbol.name)
                else:
                    needed.setdefault(room, {}).setdefault(symbol.name, path.name)
            for section in sections(path):
                if section.startswith(REFUSED_SECTIONS):
                    findings.append(f"objects/{room}/{path.name}: section {section}, expected nothing that runs by itself")
    for room, others in MAY_NEED.items():
        allowed = MEMORY | LINKER | defined.get(room, set())
        for other in others:
            allowed |= defined.get(other, set())
        for name, path in sorted(needed.get(room, {}).items()):
            if name not in allowed:
                findings.append(f"objects/{room}/{path}: needs {demangle(name)}, expected only {', '.join(sorted(MEMORY))} and "
                                f"symbols of {', '.join([room] + others)}")
    return findings, f"{count} objects of {len(MAY_NEED)} rooms"


run_gate(gate)
