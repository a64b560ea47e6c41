#!/usr/bin/env python3
"""Who may include whom: reads every #include of the product, relative ones too, and every DEPENDS of a room."""
import pathlib
import posixpath
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from common import cpp_files, files, read, run_gate, without_comments  # noqa: E402

# Room -> rooms it may see. A room not named here (tools, verification, tests, examples) may see all.
MAY_SEE = {
    "safety_core/contract": [],
    "safety_core/comparator": ["safety_core/contract"],
    "safety_core/kernel": ["safety_core/contract", "safety_core/comparator", "hal/api"],
    "safety_core/crosslink": ["safety_core/contract", "safety_core/comparator", "hal/api"],
    "channel_a": ["safety_core/contract"],
    "channel_b": ["safety_core/contract"],
    "hal/api": ["safety_core/contract"],
    "hal/absent": ["safety_core/contract", "hal/api"],
    "hal/tms570": ["safety_core/contract", "hal/api"],
    "hal/host": ["safety_core/contract", "hal/api"],
    "canopen/cia301": ["safety_core/contract", "safety_core/kernel", "hal/api"],
    "canopen/cia302/network": ["safety_core/contract", "safety_core/kernel", "hal/api", "canopen/cia301"],
    "canopen/cia302/safety_gate": ["safety_core/contract", "safety_core/kernel", "hal/api", "canopen/cia301", "canopen/cia302/network", "canopen/start_up/el6751"],
    "canopen/cia302/flying_master": ["safety_core/contract", "safety_core/kernel", "hal/api", "canopen/cia301", "canopen/cia302/network", "canopen/cia302/safety_gate", "canopen/start_up/el6751",
                                     "canopen/start_up/plc_designer"],
    "canopen/start_up/cia302": ["safety_core/contract", "safety_core/kernel", "hal/api", "canopen/cia301", "canopen/cia302/network"],
    "canopen/start_up/el6751": ["safety_core/contract", "safety_core/kernel", "hal/api", "canopen/cia301", "canopen/cia302/network"],
    "canopen/start_up/plc_designer": ["safety_core/contract", "safety_core/kernel", "hal/api", "canopen/cia301", "canopen/cia302/network"],
    "canopen/manager": ["safety_core/contract", "safety_core/kernel", "hal/api", "canopen/cia301", "canopen/cia302/network", "canopen/cia302/safety_gate", "canopen/cia302/flying_master"],
    "canopen/cia305": ["safety_core/contract", "safety_core/kernel", "hal/api", "canopen/cia301"],
    "canopen/device": ["safety_core/contract", "safety_core/kernel", "hal/api", "canopen/cia301", "canopen/cia305"],
    "canopen/cia306": ["safety_core/contract", "safety_core/kernel", "hal/api"],
}
# What runs on the target has these headers of the standard library and no other: constants, types, std::array.
FREESTANDING = ["safety_core", "channel_a", "channel_b", "hal/api", "hal/absent", "hal/tms570"]
STANDARD_HEADERS = {"array", "cstddef", "cstdint", "limits", "type_traits", "utility"}


def room_of(name):
    for room in MAY_SEE:
        if name.startswith(room + "/"):
            return room
    return posixpath.dirname(name) or "."


def check_include(root, name, number, directive):
    where = f"{name}:{number}"
    form = re.match(r'(?:(?P<quote>")(?P<own>[^"]+)"|<(?P<system>[^>]+)>)\s*$', directive)
    if not form:
        return f"{where}: #include {directive.strip()}, expected a name in quotes or angle brackets"
    if form.group("system"):
        header = form.group("system")
        if any(name.startswith(folder + "/") for folder in FREESTANDING):
            if header not in STANDARD_HEADERS:
                return f"{where}: <{header}> in code that runs on the target, expected one of {', '.join(sorted(STANDARD_HEADERS))}"
        if re.match(r"(safety_core|channel_[ab]|hal|canopen|runtime|simulator|tools|verification|tests)/", header):
            return f"{where}: <{header}>, expected quotes for a header of this tree"
        return None
    header = form.group("own")
    beside = posixpath.normpath(posixpath.join(posixpath.dirname(name), header))
    target = beside if (root / beside).is_file() else posixpath.normpath(header)
    mine, theirs = room_of(name), room_of(target)
    if mine not in MAY_SEE:
        return None
    if ".." in header.split("/"):
        return f'{where}: "{header}", expected a path from the root of the tree'
    if theirs != mine and theirs not in MAY_SEE[mine]:
        return f'{where}: {mine} includes "{header}" of {theirs}, expected only {", ".join([mine] + MAY_SEE[mine])}'
    return None


def check_depends(root, name):
    room = posixpath.dirname(name)
    if room not in MAY_SEE:
        return
    allowed = {other.replace("/", "_") for other in MAY_SEE[room]}
    text = re.sub(r"#[^\n]*", "", read(root, name))
    for call in re.finditer(r"counterpoint_room\(\s*(\w+)(.*?)\)", text, re.DOTALL):
        depends = re.search(r"\bDEPENDS\b(.*)$", call.group(2), re.DOTALL)
        for other in (depends.group(1).split() if depends else []):
            if other not in allowed:
                yield (f"{name}:{text.count(chr(10), 0, call.start()) + 1}: room {call.group(1)} depends on {other}, "
                       f"expected only {', '.join(sorted(allowed)) or 'nothing'}")
    for line in re.finditer(r"(?:target_include_directories|include_directories|target_link_libraries)\s*\([^)]*\)", text):
        if room not in ("canopen/cia306", "hal/host"):
            yield (f"{name}:{text.count(chr(10), 0, line.start()) + 1}: {line.group(0)[:60]}, expected that a room says what "
                   "it sees by DEPENDS alone")


def gate(root, _data):
    findings = []
    names = cpp_files(root, ["safety_core", "channel_a", "channel_b", "hal", "canopen"])
    count = 0
    for name in names:
        text = without_comments(read(root, name), keep_strings=True)
        for number, line in enumerate(text.splitlines(), start=1):
            directive = re.match(r"\s*#\s*include(?:_next)?\b\s*(.*)$", line)
            if directive:
                count += 1
                finding = check_include(root, name, number, directive.group(1))
                if finding:
                    findings.append(finding)
            elif "__has_include" in line:
                findings.append(f"{name}:{number}: __has_include, expected a plain #include")
    for name in files(root, "CMakeLists.txt", under=["safety_core", "channel_a", "channel_b", "hal", "canopen"]):
        findings += check_depends(root, name)
    return findings, f"{count} includes in {len(names)} files"


run_gate(gate)
