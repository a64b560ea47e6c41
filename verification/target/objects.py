"""The objects of core and channels in a build folder: digest, size, and what they need from elsewhere."""
import pathlib
import re
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "version"))
from digest import CERTIFIED, BadInput, archives, digest, members  # noqa: E402, F401

# The services of a device and the network manager.
SERVICES = [("canopen/cia301", "canopen/cia301/libcanopen_cia301.a"),
            ("canopen/cia302/network", "canopen/cia302/network/libcanopen_cia302_network.a"),
            ("canopen/cia302/safety_gate", "canopen/cia302/safety_gate/libcanopen_cia302_safety_gate.a"),
            ("canopen/cia302/flying_master", "canopen/cia302/flying_master/libcanopen_cia302_flying_master.a"),
            ("canopen/start_up/cia302", "canopen/start_up/cia302/libcanopen_start_up_cia302.a"),
            ("canopen/start_up/el6751", "canopen/start_up/el6751/libcanopen_start_up_el6751.a"),
            ("canopen/start_up/plc_designer", "canopen/start_up/plc_designer/libcanopen_start_up_plc_designer.a"),
            ("canopen/manager", "canopen/manager/libcanopen_manager.a"),
            ("canopen/cia305", "canopen/cia305/libcanopen_cia305.a"),
            ("canopen/device", "canopen/device/libcanopen_device.a"),
            ("canopen/generated", "canopen/generated/libcanopen_generated.a")]

# What a compiler may call in freestanding code, with the names of the ARM run-time ABI; hal/tms570/start/memory_functions.cpp has them.
MEMORY_FUNCTIONS = re.compile(r"(mem(cpy|move|set|cmp)|__aeabi_mem(cpy|move|set|clr)[48]?)")
# Stands in the virtual table of an abstract class; called only through a destroyed object.
ABSTRACT = {"__cxa_pure_virtual"}


def sizes(build, prefix):
    """Room -> bytes of code, of constants, of initialised and of zeroed data."""
    result = {}
    for room, archive in archives(build):
        row = {"text": 0, "rodata": 0, "data": 0, "bss": 0}
        text = subprocess.run([f"{prefix}size", "-A", str(archive)], check=True, capture_output=True, text=True).stdout
        for line in text.splitlines():
            match = re.match(r"^\.(text|rodata|data|bss)(?:\.\S*)?\s+(\d+)\s", line)
            if match:
                row[match.group(1)] += int(match.group(2))
        result[room] = row
    return result


def foreign_symbols(build, prefix, rooms=None):
    """Undefined symbols that no object of the rooms (core and channels) defines, with the rooms that want them."""
    wanted, defined = {}, set()
    for room, archive in archives(build, rooms):
        text = subprocess.run([f"{prefix}nm", str(archive)], check=True, capture_output=True, text=True).stdout
        for line in text.splitlines():
            fields = line.split()
            if len(fields) == 2 and fields[0] == "U":
                wanted.setdefault(fields[1], set()).add(room)
            elif len(fields) == 3:
                defined.add(fields[2])
    return {symbol: sorted(rooms) for symbol, rooms in sorted(wanted.items())
            if symbol not in defined and symbol not in ABSTRACT and not MEMORY_FUNCTIONS.fullmatch(symbol)}
