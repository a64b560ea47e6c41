"""What the injector has to know of the linked image: symbols, the code and the memory that are faulted, registers read."""
import re
import subprocess

# Driver of the steps, start-up and semihosting: not what ships in a cycle.
NOT_FAULTED = re.compile(r"injection|Injection|TargetMain|counterpoint6target|^Target|Firmware|^Reset|Initialise|^Stopped|Exception|Abort|Call|"
                         r"^Interrupt|FastInterrupt|HardwareInit|StandardOutput|Request|SwappedE|AddressOf|LengthOf|__cxa|_GLOBAL__|^Reserved|^Run")
MEMORY = ("faulted_kernel", "faulted_channel_a", "faulted_channel_b", "faulted_storage_a", "faulted_storage_b", "faulted_pins")
NUMBERS = {**{f"r{n}": n for n in range(13)}, "sl": 10, "fp": 11, "ip": 12, "sp": 13, "lr": 14}
REGISTER = re.compile(r"\b(r\d+|sl|fp|ip|sp|lr)\b")
# Instructions whose first operand is read.
ALL_READ = ("str", "cmp", "cmn", "tst", "teq", "push", "stm", "bx", "blx", "cbz", "cbnz", "vst", "vpush", "tb", "movt", "bfi")
ALSO_FIRST = ("add", "sub", "and", "orr", "eor", "mul", "lsl", "lsr", "asr", "bic", "orn")
INSTRUCTION = re.compile(r"^\s*([0-9a-f]+):\t[0-9a-f ]+\t(\S+)\s*([^;@]*)")


def registers_read(name, operands):
    """Bit n: register n."""
    operands = re.sub(r"\br(\d+)-r(\d+)\b", lambda m: ", ".join(f"r{n}" for n in range(int(m[1]), int(m[2]) + 1)), operands)
    if not name.startswith(ALL_READ) and "," in operands:
        first, rest = operands.split(",", 1)
        operands = rest if "[" not in first else operands
        if name.startswith(ALSO_FIRST) and "," not in operands:
            operands += ", " + first
    mask = 0
    for register in REGISTER.findall(operands):
        mask |= 1 << NUMBERS.get(register, 31)
    return mask & 0x7FFF


def describe(elf, to, part=None, code=""):
    """Writes the text that Program of program.hpp reads.

    part: the one whose RAM is faulted, NAME or NAME:BEGIN:END (bytes); code: what the names of faulted functions contain (a regular expression).
    """
    part, *edges = (part or "").split(":")
    lines = []
    table = subprocess.run(["arm-none-eabi-readelf", "-sW", elf], capture_output=True, text=True, check=True).stdout
    for row in table.splitlines():
        fields = row.split()
        if len(fields) != 8 or fields[0] == "Num:" or fields[7].startswith("$"):
            continue
        address, size, kind, name = int(fields[1], 16), int(fields[2], 0), fields[3], fields[7]
        lines.append(f"symbol {name} {address}")
        if kind == "FUNC" and address & 1 and not NOT_FAULTED.search(name) and re.search(code, name):
            lines.append(f"code {address & ~1} {(address & ~1) + size}")
        if name in ([part] if part else MEMORY):
            begin, end = map(int, edges or (0, size))
            lines.append(f"memory {address + begin} {address + end}")
    text = subprocess.run(["arm-none-eabi-objdump", "-d", elf], capture_output=True, text=True, check=True).stdout
    for found in filter(None, map(INSTRUCTION.match, text.splitlines())):
        mask = registers_read(found[2], found[3])
        if mask:
            lines.append(f"reads {int(found[1], 16)} {mask}")
    to.write_text("\n".join(lines) + "\n", encoding="utf-8")


def places(elf, addresses):
    """Address -> function and file:line, of the innermost inlined function."""
    if not addresses:
        return {}
    done = subprocess.run(["arm-none-eabi-addr2line", "-Cf", "-e", elf, *(f"{address:#x}" for address in addresses)],
                          capture_output=True, text=True, check=True).stdout.splitlines()
    result = {}
    for number, address in enumerate(addresses):
        function = done[2 * number].split("(anonymous namespace)::")[-1].split("(")[0].replace("counterpoint::", "")
        result[address] = (function, re.sub(r" \(discriminator.*", "", done[2 * number + 1]).removeprefix("./"))
    return result


def functions_not_called(description, elf, executed):
    """Names of the faulted functions of which no instruction is executed, and how many functions there are."""
    ranges = [tuple(map(int, line.split()[1:])) for line in description.read_text(encoding="utf-8").splitlines() if line.startswith("code ")]
    never = [begin for begin, end in ranges if not any(begin <= address < end for address in executed)]
    return sorted({function for function, _ in places(elf, never).values()}), len(ranges)


def parts_of_memory(elf):
    """(begin, end, name) of each part whose RAM is faulted."""
    table = subprocess.run(["arm-none-eabi-readelf", "-sW", elf], capture_output=True, text=True, check=True).stdout
    rows = [row.split() for row in table.splitlines() if row.split()[-1:] and row.split()[-1] in MEMORY]
    return [(int(row[1], 16), int(row[1], 16) + int(row[2], 0), row[7]) for row in rows]
