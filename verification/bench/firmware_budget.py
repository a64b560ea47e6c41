"""Budgets of the firmware: bytes of an image with 4 SRDOs by room, its dearest cycle, the stack of each channel."""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "verification/target")]
import firmware_run  # noqa: E402
import image_check  # noqa: E402
import stack  # noqa: E402

IMAGES = "verification/target/firmware"
IMAGE = "own_device_be32"
TARGETS = ["own_device", IMAGE, "bench"]
WORST = firmware_run.SCENARIOS / "own_device_worst.txt"
CHANNELS = ("a", "b")
ROOM = re.compile(r"^(?:.*/)?lib(\w+)\.a\(|^(.*)\.(?:obj|o)$")
# A line of the linker's map: section of an object, address, length, object; the name stands alone if it is long.
PLACED = re.compile(r"^ (\.[\w.$-]+)?\s+0x([0-9a-f]+)\s+0x([0-9a-f]+) (\S+)$")
RAM_ORIGIN = 0x08000000
# Rooms whose growth matters: each stands in the image of a device with SRDOs.
ROOMS = ("channel_a", "channel_b", "safety_core_comparator", "safety_core_kernel", "hal_tms570")
# A map of a linker with what a room has of code, of constants and of RAM, what is thrown away, and what is not loaded.
FIXTURE = """Discarded input sections
 .text.gone     0x00000000       0x40 channel_a/libchannel_a.a(crc.cpp.obj)
Linker script and memory map
 .vectors       0x00000000       0x20 start_up.S.obj
 .text.one      0x00001000       0x10 channel_a/libchannel_a.a(crc.cpp.obj)
 .rodata.of_a_long_name
                0x00001010        0x8 channel_a/libchannel_a.a(crc.cpp.obj)
 .bss.two       0x08000100       0x04 channel_b/libchannel_b.a(channel.cpp.obj)
 .debug_info    0x00000000      0x100 channel_b/libchannel_b.a(channel.cpp.obj)
 .note          0x00000000       0x30 channel_b/libchannel_b.a(channel.cpp.obj)
"""
IN_FIXTURE = {"objects of the image": {"flash": 32, "ram": 0}, "channel_a": {"flash": 24, "ram": 0}, "channel_b": {"flash": 0, "ram": 4}}


# Entry points of an image, the linker's symbols around the stack that each runs on, and what start_up.S pushed before.
ENTRIES = [("FirmwareMain", "stack_main_bottom", "stack_main_top", 0), ("FirmwareInterrupt", "stack_exception_top", "stack_interrupt_top", 96),
           ("FirmwareFastInterrupt", "stack_interrupt_top", "stack_fast_top", 96), ("FirmwareException", "stack_exception_length", None, 0),
           ("counterpoint::firmware::RunNonSafety", "stack_non_safety_length", None, 0)]


class BadInput(Exception):
    """It could not be measured; the text says why."""


def room_of(name):
    match = ROOM.match(name)
    return (match.group(1) or "objects of the image") if match else "other"


def bytes_by_room(text):
    """Room -> bytes of code and constants, bytes of RAM, from the linker's map."""
    rooms = {}
    # Sections that the linker threw away come first in the map.
    text = text[text.index("Linker script and memory map"):]
    for line in text.splitlines():
        match = PLACED.match(line)
        if not match or int(match.group(3), 16) == 0 or (match.group(1) or "").startswith((".debug", ".comment", ".ARM")):
            continue
        address, length = int(match.group(2), 16), int(match.group(3), 16)
        if address == 0 and not (match.group(1) or "").startswith(".vectors"):
            continue  # Not loaded.
        row = rooms.setdefault(room_of(match.group(4)), {"flash": 0, "ram": 0})
        row["ram" if address >= RAM_ORIGIN else "flash"] += length
    return rooms


def are_rooms_told(rooms):
    """Whether each room has code, and a map of known bytes is read as it is. [SRS_FW_015]"""
    missing = [room for room in ROOMS if rooms.get(room, {"flash": 0})["flash"] == 0]
    for room in missing:
        print(f"bench.py: no code of room {room} in the image, expected some", file=sys.stderr)
    read = bytes_by_room(FIXTURE)
    if read != IN_FIXTURE:
        print(f"bench.py: rooms of the known map: {read}, expected {IN_FIXTURE}", file=sys.stderr)
    return not missing and read == IN_FIXTURE


def stack_of_channels(build):
    """Greatest depth of an entry of each channel, and every entry with its own."""
    image = build / "verification/target/bench/bench.elf"
    greatest, entries = {}, {}
    for channel in CHANNELS:
        rows, problems = stack.compute(image, build, ROOT / "verification/target/virtual_calls.txt", [f"counterpoint::channel_{channel}::Channel::"])
        if problems:
            raise BadInput(f"stack of channel {channel}: {problems[0]}")
        greatest[channel] = rows[0][1]
        entries.update({name: size for name, size, _ in rows})
    return greatest, entries


def stack_of_entries(image, symbols, build):
    """Entry point -> bytes that it needs at most, bytes that there are; more than there are cannot be used."""
    calls = ROOT / "verification/target/firmware/virtual_calls.txt"
    result = {}
    for entry, bottom, top, pushed in ENTRIES:
        rows, problems = stack.compute(image, build, calls, [entry])
        if problems:
            raise BadInput(f"stack of {entry}: {problems[0]}")
        room = symbols[top] - symbols[bottom] if top else symbols[bottom]
        depth = rows[0][1] + pushed
        if depth > room:
            raise BadInput(f"stack of {entry}: {depth} bytes, expected at most the {room} that the linker script gives it")
        result[entry] = (depth, room)
    return result


def measure(build):
    """What limits.json judges, and what is shown."""
    image = build / IMAGES / f"{IMAGE}.elf"
    symbols = image_check.Elf(image).symbols
    entry_points = stack_of_entries(image, symbols, build)
    status, output, cost = firmware_run.run_scenario(build / IMAGES / "own_device.bin", WORST)
    if status != 0 or cost is None:
        raise BadInput(f"{WORST.name} on the emulator: exit status {status}\n{output[-400:]}")
    stacks, entries = stack_of_channels(build)
    measured = {"fw_flash": symbols["memory_flash_end"], "fw_ram": symbols["memory_ram_end"] - RAM_ORIGIN, "fw_cycle": cost[0],
                "fw_stack_a": stacks["a"], "fw_stack_b": stacks["b"]}
    return measured, {"rooms": bytes_by_room(image.with_name(image.name + ".map").read_text(encoding="utf-8")), "stack": entries, "entry_points": entry_points}


def show(shown):
    print("image with 4 SRDOs, flash and RAM by room: " + ", ".join(
        f"{room} {row['flash']} + {row['ram']} B" for room, row in sorted(shown["rooms"].items(), key=lambda item: -item[1]["flash"])))
    print("stack of the image's entry points, needed of given: " + ", ".join(
        f"{name.split('::')[-1]} {needed} of {given} B" for name, (needed, given) in shown["entry_points"].items()))
    deepest = sorted(shown["stack"].items(), key=lambda item: -item[1])[:6]
    print("stack of the channels' entries: " + ", ".join(f"{name.replace('counterpoint::', '')} {size} B" for name, size in deepest))
