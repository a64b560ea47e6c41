#!/usr/bin/env python3
"""Checks an image for silicon against what a TMS570 needs, since no emulator runs it.

    image_check.py IMAGE_be32.elf [IMAGE.elf]

ELF flags and order, vectors, placement of sections, regions of the MPU, reset sequence, what interrupts keep, the version,
nothing of a foreign library. With the second image, of the emulator: both are linked from the same objects of the rooms.
Exit status: 0 all holds, 1 something does not, 2 input that cannot be used.
"""
import pathlib
import re
import struct
import subprocess
import sys

import ram_start

BE32_FLAGS = 0x05000400  # EABI 5, hard float; BE8 would be 0x00800000 more.
EM_ARM, ET_EXEC, PT_LOAD = 40, 2, 1
SHF_ALLOC, SHT_NOBITS = 2, 8
VECTORS = ("Reset", "UndefinedInstruction", "SupervisorCall", "PrefetchAbort", "DataAbort", "Reserved", "Interrupt", "FastInterrupt")
RAM_ORIGIN = 0x08000000
ROOT = pathlib.Path(__file__).resolve().parents[2]
ECC_BYTES = 8
VARIANTS = ("LS20x", "LS12x", "LS31x", "LC43x")
ROOM_CODE = {"channel_a": ("counterpoint::channel_a::",), "channel_b": ("counterpoint::channel_b::",),
             "core": ("counterpoint::Kernel::", "counterpoint::Production::", "counterpoint::Reporting::", "counterpoint::Comparator::", "counterpoint::ConfigurationGuard::", "counterpoint::hal::OutputGate::")}
REGIONS = {"region_channel_a": "region_channel_length", "region_channel_b": "region_channel_length", "region_core": "region_core_length",
           "region_non_safety": "region_non_safety_length"}
# Registers that a mode has of its own, as the disassembler names them; the mode after reset (19) has the common ones as well.
COMMON = ("r0", "r1", "r2", "r3", "r4", "r5", "r6", "r7", "r8", "r9", "sl", "fp", "ip")
BANKED = {17: ("r8", "r9", "sl", "fp", "ip", "sp", "lr"), 18: ("sp", "lr"), 19: ("sp", "lr"), 23: ("sp", "lr"), 27: ("sp", "lr"), 31: ("sp", "lr")}
SYSTEM_CONTROL, COPROCESSORS, AUXILIARY, MONITOR = "cr1, cr0, {0}", "cr1, cr0, {2}", "cr1, cr0, {1}", "cr9, cr12, {0}"


def changed(what, register, field, bits):
    """Steps of a system register that is read, gets more bits, and is written."""
    place = re.escape(field)
    return [(f"{what}, read", rf"mrc 15, 0, {register}, {place}$"), (f"{what}, bits {bits:#x}", rf"orr {register}, {register}, #{bits}$"),
            (f"{what}, written", rf"mcr 15, 0, {register}, {place}$")]


def registers_of_modes():
    steps = [(f"register {name} set", rf"mov {name}, #0$") for name in COMMON]
    for mode, names in BANKED.items():
        steps.append((f"registers of mode {mode}", rf"cps #{mode}$"))
        if mode != 31:  # System mode has no saved status.
            steps.append((f"saved status of mode {mode}", r"msr SPSR_fsxc, r1$"))
        steps += [(f"{name} of mode {mode}", rf"mov {name}, #0$") for name in names]
    return steps


def stack_of(mode, register="mov sp, r4$"):
    return [(f"stack of mode {mode}", rf"cps #{mode}$"), (f"stack pointer of mode {mode}", register)]


# Steps of the reset sequence, each by the first instruction that shows it; in this order.
STEPS = [("big-endian data", r"setend be$"), *changed("exceptions big-endian", "r0", SYSTEM_CONTROL, 0x02000000), *registers_of_modes(),
         *changed("floating point allowed", "r1", COPROCESSORS, 0x00F00000), ("floating point enabled", r"mov r1, #1073741824$"), ("floating point on", r"vmsr fpexc, r1$"),
         ("floating point status", r"vmsr fpscr, r0$"), *[(f"floating point register {number}", rf"vmov d{number}, r0, r0$") for number in range(16)],
         *changed("export of events", "r0", MONITOR, 0x10), *changed("flash correction", "r0", AUXILIARY, 0x02000000),
         ("record of an exception kept", r"ldm r3, \{r4, r5, r6, r7, r8\}$"), ("RAM by hardware", r"bl [0-9a-f]+ <HardwareInitialiseRam>$"),
         ("its result looked at", r"cmp r0, #0$"), ("no end in time", r"beq [0-9a-f]+ <Stopped>$"), ("record of an exception back", r"stm r3, \{r4, r5, r6, r7, r8\}$"),
         *changed("RAM correction", "r0", AUXILIARY, 0x0C000000), *stack_of(23), *stack_of(27), *stack_of(19), *stack_of(18), *stack_of(17),
         *stack_of(31, r"ldr sp, "), ("zeroed data", r"strcc r2, \[r0\], #4$"), ("painted stack", r"strcc r2, \[r0\], #4$"),
         ("initialised data", r"strcc r3, \[r1\], #4$"), ("constructors", r"blx r0$"), ("asynchronous aborts", r"cpsie a$"), ("the program", r"blx r0$"),
         ("end", r"b [0-9a-f]+ <Stopped>$")]
START_FUNCTIONS = ("Reset", "InitialiseRegisters", "InitialiseMemory", "InitialiseProgram")
MEMORY_ACCESS = re.compile(r"^(ldr|str|ldm|stm|push|pop|ldrd|strd)")


class BadInput(Exception):
    """Input that cannot be used; the text names it."""


def lines_of(*command):
    return subprocess.run([str(word) for word in command], check=True, capture_output=True, text=True).stdout.splitlines()


def check_order(content):
    """Of the bytes of the file; nothing else can be read of one in another order."""
    yield content[:6] == b"\x7fELF\x01\x02", "ELF order", "32 bit, big-endian" if content[:6] == b"\x7fELF\x01\x02" else content[:6].hex()


class Elf:
    """Header, sections and symbols of a 32-bit big-endian ELF file."""

    def __init__(self, path):
        self.path = path
        self.bytes = path.read_bytes()
        if not all(holds for holds, _, _ in check_order(self.bytes)):
            raise BadInput(f"{path}: not a 32-bit big-endian ELF file")
        fields = struct.unpack_from(">HHIIIIIHHHHHH", self.bytes, 16)
        self.type, self.machine, self.entry, self.flags = fields[0], fields[1], fields[3], fields[6]
        self.program_headers = [struct.unpack_from(">IIIIIIII", self.bytes, fields[4] + number * fields[8]) for number in range(fields[9])]
        headers = [struct.unpack_from(">IIIIIIIIII", self.bytes, fields[5] + number * fields[10]) for number in range(fields[11])]
        names = headers[fields[12]][4]
        self.sections = {}
        for header in headers:
            name = self.bytes[names + header[0]:self.bytes.index(b"\0", names + header[0])].decode()
            self.sections[name] = {"type": header[1], "flags": header[2], "address": header[3], "offset": header[4], "size": header[5]}
        self.symbols, self.functions = {}, []
        for line in lines_of("arm-none-eabi-nm", "-C", "-S", path):
            match = re.match(r"^([0-9a-f]{8}) (?:([0-9a-f]{8}) )?(\w) (.*)$", line)
            if match:
                self.symbols[match.group(4)] = int(match.group(1), 16)
                if match.group(3) in "tTwW" and match.group(2):
                    self.functions.append((match.group(4), int(match.group(1), 16) & ~1, int(match.group(2), 16)))

    def word_at(self, address):
        """A word of what is loaded into flash."""
        _, offset, start, _, size, *_ = next(header for header in self.program_headers if header[0] == PT_LOAD and header[2] <= address < header[2] + header[4])
        return struct.unpack_from(">I", self.bytes, offset + address - start)[0]

    def text_at(self, address):
        """What is loaded into flash from there to the first zero."""
        _, offset, start, *_ = next(header for header in self.program_headers if header[0] == PT_LOAD and header[2] <= address < header[2] + header[4])
        place = offset + address - start
        return self.bytes[place:self.bytes.index(b"\0", place)].decode("ascii", "replace")

    def code(self):
        """Function -> its instructions with operands, blanks as one; in the order of addresses."""
        functions, current = {}, None
        for line in lines_of("arm-none-eabi-objdump", "-d", "--no-show-raw-insn", self.path):
            head = re.match(r"^[0-9a-f]+ <([^>]+)>:$", line)
            if head:
                current = functions.setdefault(head.group(1), [])
            elif re.match(r"^\s*[0-9a-f]+:\t", line) and current is not None:
                current.append(" ".join(re.split(r"[@;]", line.split("\t", 1)[1])[0].split()))
        return functions


def check_header(elf):
    yield elf.machine == EM_ARM and elf.type == ET_EXEC and elf.flags == BE32_FLAGS, "ELF flags", f"{elf.flags:#010x}, expected {BE32_FLAGS:#010x}"
    yield elf.entry == elf.symbols.get("Reset") and elf.entry % 4 == 0, "entry is Reset in ARM state", f"{elf.entry:#x}"


def check_vectors(elf):
    section = elf.sections.get(".vectors", {"address": None, "size": 0, "offset": 0})
    yield section["address"] == 0 and section["size"] == 32, "vectors at 0", f"{section['size']} bytes at {section['address']}"
    wrong = []
    for number, name in enumerate(VECTORS):
        word = struct.unpack_from(">I", elf.bytes, section["offset"] + 4 * number)[0]
        distance = ((word & 0x00FFFFFF) ^ 0x00800000) - 0x00800000
        target = 4 * number + 8 + 4 * distance
        if word >> 24 != 0xEA or target != elf.symbols.get(name):
            wrong.append(f"{name} {word:08x}")
    yield not wrong, "eight vectors lead to their handlers, instructions big-endian", ", ".join(wrong) or "8 of 8"


def check_placement(elf):
    flash, ram = elf.symbols["flash_length"], elf.symbols["ram_length"]
    wrong, spans = [], []
    for name, section in elf.sections.items():
        if not section["flags"] & SHF_ALLOC or section["size"] == 0:
            continue
        start, end = section["address"], section["address"] + section["size"]
        in_flash, in_ram = end <= flash, RAM_ORIGIN <= start and end <= RAM_ORIGIN + ram
        spans.append((start, end, name))
        if not (in_flash and section["type"] != SHT_NOBITS) and not (in_ram and (section["type"] == SHT_NOBITS or name == ".data")):
            wrong.append(name)
    spans.sort()
    wrong += [f"{left[2]} and {right[2]} overlap" for left, right in zip(spans, spans[1:]) if left[1] > right[0]]
    loads = [header for header in elf.program_headers if header[0] == PT_LOAD and header[4]]
    wrong += [f"load address {header[3]:#x}" for header in loads if header[3] + header[4] > flash]
    yield len(spans) >= 12 and not wrong, "every section in flash or RAM, what is loaded in flash", ", ".join(wrong) or f"{len(spans)} sections"
    # The flash has one ECC for 8 bytes: two pieces that share them cannot be programmed apart.
    split = [f"{header[3]:#x}" for header in loads if header[3] % ECC_BYTES]
    yield bool(loads) and not split, "what is programmed begins at a word of the flash's ECC", ", ".join(split) or f"{len(loads)} pieces"
    for room, prefixes in ROOM_CODE.items():
        start, end = elf.symbols[f"flash_{room}_start"], elf.symbols[f"flash_{room}_end"]
        own = [function for function in elf.functions if function[0].startswith(prefixes)]
        outside = [name for name, address, size in own if not start <= address < address + size <= end]
        yield len(own) >= 10 and not outside, f"code of {room} in its section", ", ".join(outside[:3]) or f"{len(own)} functions"


def check_regions(elf):
    wrong, spans = [], []
    for name, length_name in REGIONS.items():
        start, length = elf.symbols[name], elf.symbols[length_name]
        if length & (length - 1) or length < 32 or start % length:
            wrong.append(f"{name} {length:#x} at {start:#x}")
        spans.append((start, start + length, name))
    spans.sort()
    wrong += [f"{left[2]} and {right[2]} overlap" for left, right in zip(spans, spans[1:]) if left[1] > right[0]]
    for name in ("stack_main_bottom", "stack_exception_top", "stack_interrupt_top", "memory_data_start"):
        wrong += [f"{name} in {span[2]}" for span in spans if span[0] < elf.symbols[name] <= span[1] - 1]
    yield not wrong, "regions of the MPU are powers of two, aligned, and of one party each", ", ".join(wrong) or f"{len(spans)} regions"
    top = elf.symbols["stack_non_safety_top"]
    inside = any(name == "region_non_safety" and start < top <= end for start, end, name in spans)
    yield inside, "stack of non-safety code in its region", f"{top:#x}"
    record = elf.sections[".noinit"]["address"]
    kept = not elf.symbols["memory_zero_start"] <= record < elf.symbols["memory_zero_end"] and record >= elf.symbols["memory_data_end"]
    yield kept, "the exception record is not cleared by start-up", f"{record:#x}"


def check_reset(code):
    """Of Elf.code()."""
    missing = [name for name in (*START_FUNCTIONS, "HardwareInitialiseRam") if name not in code]
    if missing:
        yield False, "reset sequence", f"no function {', '.join(missing)}"
        return
    sequence = [instruction for name in START_FUNCTIONS for instruction in code[name]]
    place, lost = 0, None
    for step, pattern in STEPS:
        found = next((number for number in range(place, len(sequence)) if re.match(pattern, sequence[number])), None)
        if found is None:
            lost = step
            break
        place = found + 1
    yield lost is None, "reset sequence in the order of the silicon", f"{len(STEPS)} steps" if lost is None else f"'{lost}' is missing or too early"
    call = next((number for number, text in enumerate(sequence) if "<HardwareInitialiseRam>" in text), len(sequence))
    early = [text for text in sequence[:call] if MEMORY_ACCESS.match(text) and text != "ldm r3, {r4, r5, r6, r7, r8}"]
    yield call < len(sequence) and not early, "no access to memory before the RAM is initialised but to the record of an exception", ", ".join(early) or f"{call} instructions"
    main = code.get("FirmwareMain", [])
    told = [number for number, text in enumerate(main) if "LastException" in text]
    yield bool(told), "the program reads the record of an exception back", f"instruction {told[0]} of {len(main)}" if told else "no call of LastException"
    for name, save in (("Interrupt", "vpush {d0-d7}"), ("FastInterrupt", "vpush {d0-d7}"), ("RunUnprivileged", "vpush {d8-d15}")):
        body = code.get(name, [])
        saved = save in body and any(text.startswith("vmrs") for text in body) and any(text.startswith("push {r") for text in body)
        yield saved, f"{name} keeps the registers of what it interrupts or calls", f"{len(body)} instructions"


def members_of(path):
    """Archive members and objects in the image, from the linker's map."""
    return set(re.findall(r"^ \S+\s+0x[0-9a-f]+\s+0x[0-9a-f]+ (\S+)$", path.with_name(path.name + ".map").read_text(), re.MULTILINE))


def check_origin(ours, theirs):
    """Of members_of() two images; the second may be missing."""
    foreign = sorted(name for name in ours if name.startswith("/") or "lib/gcc" in name)
    yield len(ours) > 20 and not foreign, "no object of a foreign library", ", ".join(foreign[:3]) or f"{len(ours)} objects"
    if theirs:
        # The emulated board plays what the hardware of the port is: neither counts here.
        rooms = re.compile(r"(channel_a|channel_b|safety_core|examples)/.*\.a\(")
        mine, its = {name for name in ours if re.match(rooms, name)}, {name for name in theirs if re.match(rooms, name)}
        lost = sorted(its - mine)
        yield len(mine & its) > 20 and not lost, "linked from the objects that ran on the emulator", ", ".join(lost[:3]) or f"{len(mine & its)} objects"


def check_version(elf):
    """The text of version/version.cpp.in, with the version of the project."""
    project = re.search(r"project\(Counterpoint VERSION (\S+)", (ROOT / "CMakeLists.txt").read_text(encoding="utf-8")).group(1)
    address = elf.symbols.get("CounterpointVersion")
    text = "no symbol CounterpointVersion" if address is None else elf.text_at(address)
    yield re.fullmatch(rf"counterpoint {re.escape(project)} \(commit \w+, objects [0-9a-f]{{16}}\)", text) is not None, "version of the project", text


def variant_differences(root):
    """Where flash and RAM of hal/tms570/start/image.cmake are not those of hal/tms570/variant.hpp."""
    cmake = (root / "hal/tms570/start/image.cmake").read_text(encoding="utf-8")
    header = (root / "hal/tms570/chip/variant.hpp").read_text(encoding="utf-8")
    different = []
    for name in VARIANTS:
        lengths = re.search(rf"COUNTERPOINT_MEMORY_{name} 0x(\w+) 0x(\w+) ", cmake)
        table = re.search(rf"Variant k{name.capitalize()}\{{(.*?)\n\}};", header, re.DOTALL)
        if not lengths or not table or not all(f"0x{value}U" in table.group(1) for value in lengths.groups()):
            different.append(name)
    return different


def check(path, other=None):
    """Rows (holds, check, found)."""
    elf = Elf(path)
    needed = ["flash_length", "ram_length", "memory_zero_start", "stack_main_bottom", *REGIONS, *REGIONS.values()]
    missing = [name for name in needed if name not in elf.symbols]
    if missing:
        raise BadInput(f"{path}: no symbol {missing[0]}, expected an image linked by hal/tms570/start/tms570.ld")
    rows = []
    for part in (check_order(elf.bytes), check_header(elf), check_vectors(elf), check_placement(elf), check_regions(elf), check_reset(elf.code()), check_version(elf),
                 ram_start.check(elf, elf.symbols.get("pbist_ram_groups", 0)), check_origin(members_of(path), members_of(other) if other else None)):
        rows += part
    return rows


def main():
    if len(sys.argv) not in (2, 3):
        raise BadInput("expected IMAGE_be32.elf [IMAGE.elf]")
    paths = [pathlib.Path(word) for word in sys.argv[1:]]
    rows = check(*paths)
    for holds, text, found in rows:
        print(f"{'ok  ' if holds else 'FAIL'}  {text}: {found}")
    return 0 if all(row[0] for row in rows) else 1


if __name__ == "__main__":
    try:
        sys.exit(main())
    except (BadInput, OSError, subprocess.SubprocessError) as problem:
        print(f"image_check.py: {problem}", file=sys.stderr)
        sys.exit(2)
