#!/usr/bin/env python3
"""Who may include whom: reads every #include of the product, relative ones too, and what each room is linked with."""
import pathlib
import posixpath
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from common import cpp_files, files, read, run_gate, without_comments  # noqa: E402

# Room -> rooms that it may see beside itself; a folder stands for every room below it.
CONTRACT = ["safety_core/contract"]
SERVICES = ["safety_core/contract", "safety_core/kernel", "hal/api", "canopen/cia301"]
MANAGER = [*SERVICES, "canopen/cia302/network"]
DEVICE = ["safety_core", "channel_a", "channel_b", "hal", "canopen"]
MAY_SEE = {
    "safety_core/contract": [],
    "safety_core/comparator": CONTRACT,
    "safety_core/kernel": [*CONTRACT, "safety_core/comparator", "hal/api"],
    "safety_core/selftest": [*CONTRACT, "safety_core/kernel", "hal/api"],
    "safety_core/crosslink": [*CONTRACT, "safety_core/comparator", "hal/api"],
    "channel_a": CONTRACT,
    "channel_b": CONTRACT,
    "hal/api": CONTRACT,
    "hal/absent": [*CONTRACT, "hal/api"],
    "hal/contract_test": [*CONTRACT, "hal/api"],
    "hal/tms570": [*CONTRACT, "hal/api"],
    "hal/zynqmp": [*CONTRACT, "hal/api", "hal/tms570"],
    "hal/host": [*CONTRACT, "hal/api"],
    "canopen/cia301": [*CONTRACT, "safety_core/kernel", "hal/api"],
    "canopen/cia302/network": SERVICES,
    "canopen/cia302/safety_gate": [*MANAGER, "canopen/start_up/el6751"],
    "canopen/cia302/flying_master": [*MANAGER, "canopen/cia302/safety_gate", "canopen/start_up/el6751", "canopen/start_up/plc_designer"],
    "canopen/start_up/cia302": MANAGER,
    "canopen/start_up/el6751": MANAGER,
    "canopen/start_up/plc_designer": MANAGER,
    "canopen/manager": [*MANAGER, "canopen/cia302/safety_gate", "canopen/cia302/flying_master"],
    "canopen/cia305": SERVICES,
    "canopen/device": [*SERVICES, "canopen/cia305"],
    "canopen/generated": SERVICES,
    "canopen/cia306": [],
    "canopen/generate": ["canopen/cia306"],
    "canopen/monitor": ["canopen/cia306"],
    "canopen/network_plan": ["canopen/cia301", "canopen/cia302", "canopen/cia306", "canopen/manager", "canopen/start_up"],
    "names": [],
    "runtime": [*DEVICE, "names"],
    "simulator": [*DEVICE, "names", "runtime"],
    "tools": ["version", "names", "safety_core", "hal", "canopen", "runtime", "simulator"],
    "examples": [*DEVICE, "names"],
}
PRODUCT = sorted({room.split("/")[0] for room in MAY_SEE})
# Rooms of the host may use libraries, which DEPENDS cannot name.
HOST = ("canopen/cia306", "canopen/generate", "canopen/monitor", "hal/host", "runtime", "simulator", "tools", "examples")
# What runs on the target has these headers of the standard library and no other: constants, types, std::array.
FREESTANDING = ["safety_core", "channel_a", "channel_b", "hal/api", "hal/absent", "hal/contract_test", "hal/tms570", "hal/zynqmp"]
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
        if re.match(r"(safety_core|channel_[ab]|hal|canopen|runtime|simulator|tools|examples|verification|tests)/", header):
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
    made_by_the_build = mine in HOST and target.split("/")[0] not in (*PRODUCT, "verification", "tests")
    if not made_by_the_build and not may_see(mine, theirs):
        return f'{where}: {mine} includes "{header}" of {theirs}, expected only {", ".join([mine] + MAY_SEE[mine])}'
    return None


def may_see(room, other):
    return any(other == seen or other.startswith(seen + "/") for seen in [room, *MAY_SEE[room]])


def targets(root):
    """CMake target of each room -> its folder."""
    found = {}
    for name in files(root, "CMakeLists.txt"):
        for target in re.findall(r"counterpoint_room\(\s*(\w+)", read(root, name)):
            found[target] = posixpath.dirname(name)
    return found


def check_depends(root, name, folder_of):
    room = room_of(name)
    if room not in MAY_SEE:
        return
    text = re.sub(r"#[^\n]*", "", read(root, name))
    allowed = [seen.replace("/", "_") for seen in MAY_SEE[room]]

    def line_of(call):
        return f"{name}:{text.count(chr(10), 0, call.start()) + 1}"

    for call in re.finditer(r"counterpoint_room\(\s*(\w+)(.*?)\)", text, re.DOTALL):
        depends = re.search(r"\bDEPENDS\b(.*)$", call.group(2), re.DOTALL)
        for other in (depends.group(1).split() if depends else []):
            if not other.startswith("$") and not may_see(room, folder_of.get(other, other)) and other not in allowed:
                yield f"{line_of(call)}: room {call.group(1)} depends on {other}, expected only {', '.join(allowed) or 'nothing'}"
    for call in re.finditer(r"(?:target_include_directories|include_directories|target_link_libraries)\s*\(([^)]*)\)", text):
        if room not in HOST:
            yield f"{line_of(call)}: {call.group(0)[:60]}, expected that a room says what it sees by DEPENDS alone"
        for other in call.group(1).split()[1:]:
            if other in folder_of and not may_see(room, folder_of[other]):
                yield f"{line_of(call)}: {room} is linked with {other}, expected only {', '.join(MAY_SEE[room])}"


def gate(root, _data):
    findings = []
    names = cpp_files(root, PRODUCT)
    count = 0
    for name in names:
        if room_of(name) not in MAY_SEE:
            findings.append(f"{name}:1: a folder that no room's rule covers, expected one in MAY_SEE")
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
    folder_of = targets(root)
    for name in files(root, "CMakeLists.txt", under=PRODUCT):
        findings += check_depends(root, name, folder_of)
    return findings, f"{count} includes in {len(names)} files"


run_gate(gate)
