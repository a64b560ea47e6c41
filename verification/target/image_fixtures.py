"""Fixtures of image_check.py: an image for silicon that is right, changed in one thing at a time. Each must be refused, by the
check that looks for it."""
import copy
import re

import image_check

VECTOR_BYTES = 4
NOTHING = "nop"


def with_bytes(elf, offset, content):
    changed = copy.copy(elf)
    changed.bytes = elf.bytes[:offset] + content + elf.bytes[offset + len(content):]
    return changed


def with_symbol(elf, name, value):
    changed = copy.copy(elf)
    changed.symbols = dict(elf.symbols, **{name: value})
    return changed


def with_section(elf, name, **fields):
    changed = copy.copy(elf)
    changed.sections = dict(elf.sections, **{name: dict(elf.sections[name], **fields)})
    return changed


def with_load(elf, number, place, value):
    changed = copy.copy(elf)
    headers = [list(header) for header in elf.program_headers]
    headers[number][place] = value
    changed.program_headers = [tuple(header) for header in headers]
    return changed


def changed_field(elf, **fields):
    changed = copy.copy(elf)
    for name, value in fields.items():
        setattr(changed, name, value)
    return changed


def moved_function(elf, prefix, address):
    changed = copy.copy(elf)
    number = next(number for number, function in enumerate(elf.functions) if function[0].startswith(prefix))
    functions = list(elf.functions)
    functions[number] = (functions[number][0], address, functions[number][2])
    changed.functions = functions
    return changed


def header_fixtures(elf):
    little = elf.bytes[:5] + b"\x01" + elf.bytes[6:]
    yield "an ELF file in the order of the emulator's host", little, image_check.check_order, "ELF order"
    yield "flags of the emulator (BE8)", changed_field(elf, flags=elf.flags | 0x00800000), image_check.check_header, "ELF flags"
    yield "soft-float flags", changed_field(elf, flags=elf.flags & ~0x400), image_check.check_header, "ELF flags"
    yield "an entry in Thumb state", changed_field(elf, entry=elf.entry | 1), image_check.check_header, "entry is Reset"
    yield "another entry", changed_field(elf, entry=elf.entry + 4), image_check.check_header, "entry is Reset"


def vector_fixtures(elf):
    check, row = image_check.check_vectors, "eight vectors"
    start = elf.sections[".vectors"]["offset"]
    words = [elf.bytes[start + VECTOR_BYTES * number:start + VECTOR_BYTES * (number + 1)] for number in range(8)]
    for number, name in enumerate(image_check.VECTORS):
        yield f"bytes of vector {name} in the order of the emulator", with_bytes(elf, start + VECTOR_BYTES * number, words[number][::-1]), check, row
        # A branch is relative: the same word in the next place leads elsewhere.
        yield f"vector {name} as its neighbour", with_bytes(elf, start + VECTOR_BYTES * number, words[(number + 1) % 8]), check, row
    yield "vectors behind address 0", with_section(elf, ".vectors", address=0x20), check, "vectors at 0"
    yield "seven vectors", with_section(elf, ".vectors", size=28), check, "vectors at 0"


def placement_fixtures(elf):
    check, row = image_check.check_placement, "every section"
    load = next(number for number, header in enumerate(elf.program_headers) if header[0] == image_check.PT_LOAD and header[4])
    for name in (name for name, section in elf.sections.items() if section["flags"] & image_check.SHF_ALLOC and section["size"]):
        yield f"{name} in neither flash nor RAM", with_section(elf, name, address=0x20000000), check, row
    yield "code behind the flash", with_section(elf, ".text", address=elf.symbols["flash_length"]), check, row
    yield "memory of channel B behind the RAM", with_section(elf, ".channel_b", address=image_check.RAM_ORIGIN + elf.symbols["ram_length"]), check, row
    yield "stack over the memory of the core", with_section(elf, ".stack", address=elf.sections[".core"]["address"]), check, row
    yield "constants in RAM", with_section(elf, ".text", address=image_check.RAM_ORIGIN + 0x20000), check, row
    yield "a piece loaded into RAM", with_load(elf, load, 3, image_check.RAM_ORIGIN), check, row
    yield "a piece in the middle of an ECC word", with_load(elf, load, 3, 0x1004), check, "word of the flash's ECC"
    for room, prefixes in image_check.ROOM_CODE.items():
        yield f"a function of {room} elsewhere", moved_function(elf, prefixes, elf.sections[".text"]["address"]), check, f"code of {room} "


def region_fixtures(elf):
    check, row = image_check.check_regions, "regions of the MPU"
    for name, length_name in image_check.REGIONS.items():
        yield f"{name} not aligned", with_symbol(elf, name, elf.symbols[name] + 0x20), check, row
        yield f"{length_name} of {name} no power of two", with_symbol(elf, length_name, elf.symbols[length_name] + 0x20), check, row
    yield "the regions of both channels in one place", with_symbol(elf, "region_channel_b", elf.symbols["region_channel_a"]), check, row
    yield "the main stack in the region of channel A", with_symbol(elf, "stack_main_bottom", elf.symbols["region_channel_a"] + 0x40), check, row
    yield "the stack of non-safety code outside", with_symbol(elf, "stack_non_safety_top", elf.symbols["stack_main_top"]), check, "stack of non-safety"
    yield "the record of an exception in what is zeroed", with_section(elf, ".noinit", address=elf.symbols["memory_zero_start"]), check, "exception record"


def without(code, function, number):
    """The code with one instruction that does nothing in place of the own one."""
    lines = list(code[function])
    lines[number] = NOTHING
    return dict(code, **{function: lines})


def reset_fixtures(elf):
    """Every instruction that shows a step, left out; steps in another order; RAM used too early."""
    check, row = image_check.check_reset, "reset sequence"
    code = elf.code()
    place = 0
    sequence = [(name, number, text) for name in image_check.START_FUNCTIONS for number, text in enumerate(code[name])]
    for step, pattern in image_check.STEPS:
        place = next(number for number in range(place, len(sequence)) if re.match(pattern, sequence[number][2]))
        function, number, text = sequence[place]
        place += 1
        yield f"without '{text}' ({step})", without(code, function, number), check, row
    memory = list(code["InitialiseMemory"])
    call = next(number for number, text in enumerate(memory) if "<HardwareInitialiseRam>" in text)
    correction = memory.index("orr r0, r0, #201326592")
    early = memory[:call] + memory[correction - 1:correction + 4] + memory[call:correction - 1] + memory[correction + 4:]
    yield "RAM correction before the RAM is initialised", dict(code, InitialiseMemory=early), check, row
    yield "a push before the RAM is initialised", dict(code, InitialiseMemory=["push {r4, lr}"] + memory), check, "no access to memory"
    yield "nobody reads the record of an exception", dict(code, FirmwareMain=[text for text in code["FirmwareMain"] if "LastException" not in text]), check, "record of an exception back"
    for name in ("Interrupt", "FastInterrupt"):
        yield f"{name} without the registers of the floating-point unit", dict(code, **{name: [text for text in code[name] if not text.startswith("vpush")]}), check, f"{name} keeps"


def version_fixtures(elf):
    check, row = image_check.check_version, "version of the project"
    place = elf.bytes.index(b"counterpoint ") + len("counterpoint ")
    symbols = {name: value for name, value in elf.symbols.items() if name != "CounterpointVersion"}
    yield "another version", with_bytes(elf, place, b"9"), check, row
    yield "no version", changed_field(elf, symbols=symbols), check, row


def origin_fixtures(members):
    yield "an object of the compiler's library", members | {"/usr/lib/gcc/arm-none-eabi/libgcc.a(_udivsi3.o)"}, lambda ours: image_check.check_origin(ours, members), "foreign library"
    yield "an object of channel A that did not run", members | set(), lambda ours: image_check.check_origin(ours - {min(name for name in members if "channel_a" in name)}, members), "ran on the emulator"


def check(path):
    """How many changed images there are, and those that were not refused by the check that should."""
    elf = image_check.Elf(path)
    missed, count = [], 0
    fixtures = [*header_fixtures(elf), *vector_fixtures(elf), *placement_fixtures(elf), *region_fixtures(elf), *reset_fixtures(elf), *version_fixtures(elf),
                *origin_fixtures(image_check.members_of(path))]
    for what, changed, look, row in fixtures:
        count += 1
        if all(holds for holds, text, _ in look(changed) if row in text):
            missed.append(what)
    return count, missed
