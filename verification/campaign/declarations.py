#!/usr/bin/env python3
"""Writes a source that knows where each member is declared that a campaign hits, for its list of survivors.

    python3 verification/campaign/declarations.py ROOT SOURCE

Members are found where the campaign names them: channels.cpp, kernel_places.cpp, pins_output.cpp. One that is not declared where
it is looked for ends this with status 1.
"""
import pathlib
import re
import sys

# Of kernel and pins: file, and the name that the declaration has there.
OTHERS = {
    "flow_monitor": ("safety_core/kernel/flow_monitor.hpp", "signature_"),
    "kernel.run": ("safety_core/kernel/kernel.hpp", "run_"),
    "kernel.second_nmt": ("safety_core/kernel/kernel.hpp", "second_nmt_"),
    "kernel.parts": ("safety_core/kernel/kernel_context.hpp", "parts"),
    "kernel.seal": ("safety_core/kernel/kernel_context.hpp", "seal"),
    "kernel.config": ("safety_core/kernel/kernel_context.hpp", "config"),
    "latch": ("safety_core/kernel/kernel_context.hpp", "latch"),
    "guard": ("safety_core/kernel/kernel_context.hpp", "guard"),
    "clocks": ("safety_core/kernel/kernel.hpp", "clocks_"),
    "kernel.reporting": ("safety_core/kernel/kernel.hpp", "reporting_"),
    "kernel.production": ("safety_core/kernel/kernel.hpp", "production_"),
    "kernel.windows": ("safety_core/kernel/kernel_parts.hpp", "windows"),
    "kernel.committed": ("safety_core/kernel/decision.hpp", "committed_"),
    "kernel.demotions": ("safety_core/kernel/decision.hpp", "demotions_"),
    "comparator.verdict": ("safety_core/kernel/decision.hpp", "verdict_"),
    "comparator.self_test": ("safety_core/kernel/decision.hpp", "self_test_"),
    "comparator.object": ("safety_core/kernel/decision.hpp", "comparator_"),
    "cross_link": ("safety_core/crosslink/peer.hpp", "own_"),
}
for each in ("clocks", "setup", "copy", "gate", "driven", "driven_copy", "live"):
    OTHERS[f"pins.{each}"] = ("hal/tms570/output/safety_pins.hpp", each + "_")

HEAD = """// Made by verification/campaign/declarations.py.
#include "verification/campaign/summary.hpp"

#include <utility>

namespace counterpoint::campaign
{
std::string DeclarationOf(const std::string& member)
{
    constexpr std::pair<const char*, const char*> kDeclarations[] = {
"""
TAIL = """
    };
    // Of two CPUs both have it where one has.
    const bool is_of_cpu = member.rfind("cpu_", 0U) == 0U;
    const std::string of_one = is_of_cpu ? member.substr(member.find('.') + 1U) : member;
    for (const auto& [name, place] : kDeclarations)
    {
        if (of_one == name)
        {
            return place;
        }
    }
    return "";
}
} // namespace counterpoint::campaign
"""


def line_of(text, begin, name):
    """Number of the first line from `begin` on that declares the name; None: there is none."""
    found = re.compile(rf"^[ ]+(?![ ]|return\b)[\w:<>,&* ]+\b({name})\s*(\[[^;]*\])?\s*(\{{[^;]*\}})?;", re.MULTILINE).search(
        text, text.index(begin))
    return text.count("\n", 0, found.start(1)) + 1 if found else None


def members(root):
    """Name, file, text from which on, name of the declaration."""
    made = (root / "verification/campaign/channels.cpp").read_text(encoding="utf-8")
    for channel in ("a", "b"):
        part = made[made.index(f"Make{channel.upper()}(Region"):]
        for name, member in re.findall(r'add\("(\w+)", memory\.(\w+)\)', part[:part.index("return made")]):
            yield f"channel_{channel}.{name}", f"channel_{channel}/storage.hpp", "struct StorageFor", member
        yield f"channel_{channel}.object", f"channel_{channel}/channel.hpp", "class Channel", None
    for name, (file, member) in OTHERS.items():
        yield name, file, "", member


def main(arguments):
    root, source = pathlib.Path(arguments[0]), pathlib.Path(arguments[1])
    lines, missing = [], []
    for name, file, begin, member in members(root):
        text = (root / file).read_text(encoding="utf-8")
        line = text.count("\n", 0, text.index(begin)) + 1 if member is None else line_of(text, begin, member)
        if line is None:
            missing.append(f"{file}: no declaration of {member}, expected that of {name}")
        lines.append(f'        {{"{name}", "{file}:{line}"}},')
    for text in missing:
        print(text, file=sys.stderr)
    source.write_text(HEAD + "\n".join(lines) + TAIL, encoding="utf-8")
    return 1 if missing else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
