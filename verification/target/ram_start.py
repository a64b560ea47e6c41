"""Executes HardwareInitialiseRam of an image for silicon, instruction by instruction, against a model of the two pieces of
hardware that it drives: the memory test (PBIST) and the initialisation by the system module. No emulator has them.

Knows the few instructions of ARM state that the function is made of; any other ends the run.
"""
import re
import subprocess

SYSTEM, PBIST, ERROR_KEY = 0xFFFFFF00, 0xFFFFE400, 0xFFFFF538
CONTROL, INIT_CONTROL, ENABLE, STATUS = SYSTEM + 0x58, SYSTEM + 0x5C, SYSTEM + 0x60, SYSTEM + 0x68
LOGGER, ACTIVE, OVERRIDE, FAIL_0, FAIL_1 = (PBIST + offset for offset in (0x164, 0x180, 0x188, 0x190, 0x194))
ROM, ALGORITHM, GROUPS_LOW, GROUPS_HIGH = (PBIST + offset for offset in (0x1C0, 0x1C4, 0x1C8, 0x1CC))
TEST_LOOKS, INIT_LOOKS = 5000, 700
MOST_INSTRUCTIONS = 3_000_000
FAULTS = ("none", "defect", "defect on the second port", "test without end", "test that does not run", "initialisation without end")
LINE = re.compile(r"^\s*([0-9a-f]+):\t(\S+)(?:\t(.*))?$")
CONDITIONS = {"": lambda z, c: True, "eq": lambda z, c: z, "ne": lambda z, c: not z, "lo": lambda z, c: not c, "cc": lambda z, c: not c}


class Refused(Exception):
    """The function did what it must not; the text says what."""


class Hardware:
    """Memory test and initialisation of memories."""

    def __init__(self, fault):
        self.fault, self.values, self.looks, self.tested, self.initialised, self.error_forced = fault, {}, 0, None, False, False

    def is_testing(self):
        return self.values.get(LOGGER) == 0x14

    def write(self, address, value):
        if self.is_testing() and address not in (ACTIVE, CONTROL):
            raise Refused(f"a write to {address:#x} while the memory test runs")
        if address == STATUS:
            return
        if address == LOGGER:
            needed = {CONTROL: 0x10A, ENABLE: 1, ACTIVE: 3, ALGORITHM: 8, GROUPS_HIGH: 0, OVERRIDE: 0, ROM: 3}
            wrong = [f"{place:#x}" for place, right in needed.items() if self.values.get(place) != right]
            if wrong:
                raise Refused(f"the memory test begins without {', '.join(wrong)}")
            self.tested, self.looks = self.values.get(GROUPS_LOW), 0
        elif address == CONTROL and value == 0x105:
            self.values[LOGGER] = 0
        elif address == ENABLE and self.values.get(INIT_CONTROL) == 0xA:
            self.initialised, self.looks = value == 1, 0
        elif address == ERROR_KEY:
            self.error_forced = value == 0xA
        elif address not in (CONTROL, INIT_CONTROL, ENABLE, ACTIVE, ALGORITHM, GROUPS_LOW, GROUPS_HIGH, OVERRIDE, ROM):
            raise Refused(f"a write to {address:#x}")
        self.values[address] = value

    def read(self, address):
        self.looks += 1
        if address == STATUS and self.is_testing():
            end = 1 if self.fault == "test that does not run" else TEST_LOOKS
            return 1 if self.looks > end and self.fault != "test without end" else 0
        if address == STATUS:
            return 0x101 if self.initialised and self.looks > INIT_LOOKS and self.fault != "initialisation without end" else 1
        if address in (FAIL_0, FAIL_1):
            if self.values.get(ACTIVE) != 3:
                raise Refused("the result of the memory test is read with its clocks off")
            return 1 if self.fault == ("defect" if address == FAIL_0 else "defect on the second port") else 0
        raise Refused(f"a read of {address:#x}")


def instructions_of(path, name):
    """Address -> (operation, operands) of one function."""
    text = subprocess.run(["arm-none-eabi-objdump", "-d", "--no-show-raw-insn", f"--disassemble={name}", str(path)], check=True, capture_output=True, text=True).stdout
    code = {}
    for line in text.splitlines():
        match = LINE.match(line)
        if match:
            code[int(match.group(1), 16)] = (match.group(2), re.split(r"\s*[@;]", match.group(3) or "")[0])
    return code


class Processor:
    """Four registers, two conditions."""

    def __init__(self, code, word_at, hardware):
        self.code, self.word_at, self.hardware = code, word_at, hardware
        self.registers, self.zero, self.carry = {}, False, False

    def value(self, text):
        return int(text[1:], 0) & 0xFFFFFFFF if text.startswith("#") else self.registers[text]

    def address(self, text):
        match = re.match(r"\[(\w+)(?:, #(-?\d+))?\]$", text)
        if not match:
            raise Refused(f"an access to [{text}]")
        return (self.registers[match.group(1)] + int(match.group(2) or 0)) & 0xFFFFFFFF

    def compare(self, left, right):
        self.zero, self.carry = left == right, left >= right

    def skip(self, rounds):
        """Rounds of the loop that counts up to a constant: nothing else would change in them."""
        register, most = next((words[0], self.value(words[1])) for words in (operands.split(", ") for name, operands in self.code.values() if name == "cmp")
                              if words[1].startswith("#") and self.value(words[1]) > rounds)
        self.registers[register] += most - 2 * rounds

    def step(self, place):
        operation, operands = self.code[place]
        match = re.match(r"(movw|mvn|mov|ldr|str|ands|add|subs|cmp|bx|b)(eq|ne|lo|cc)?$", operation)
        if not match:
            raise Refused(f"instruction '{operation} {operands}'")
        name = match.group(1)
        if not CONDITIONS[match.group(2) or ""](self.zero, self.carry):
            return place + 4
        words = re.split(r",\s*(?![^\[]*\])", operands)
        if name == "bx":
            return None
        if name == "b":
            return int(words[0].split()[0], 16)
        if name == "cmp":
            self.compare(self.value(words[0]), self.value(words[1]))
        elif name == "ldr" and words[1].startswith("[pc"):
            self.registers[words[0]] = self.word_at(place + 8 + int(re.search(r"#(\d+)", words[1]).group(1)))
        elif name == "ldr":
            self.registers[words[0]] = self.hardware.read(self.address(words[1]))
        elif name == "str":
            self.hardware.write(self.address(words[1]), self.value(words[0]))
        else:
            self.compute(name, words)
        return place + 4

    def compute(self, name, words):
        left, right = (self.value(words[-2]) if len(words) == 3 else 0), self.value(words[-1])
        results = {"mov": right, "movw": right, "mvn": ~right, "add": left + right, "ands": left & right, "subs": left - right}
        result = results[name] & 0xFFFFFFFF
        if name in ("ands", "subs"):
            self.zero, self.carry = result == 0, name == "ands" and self.carry or name == "subs" and left >= right
        if words[0] not in ("r0", "r1", "r2", "r3"):
            raise Refused(f"register {words[0]} is used, the caller keeps the record of an exception in r4 to r8")
        self.registers[words[0]] = result


def run(elf, code, fault):
    """The result register and the hardware after the function came back."""
    hardware = Hardware(fault)
    processor = Processor(code, elf.word_at, hardware)
    place, count, is_skipped = min(code), 0, False
    while place is not None:
        place = processor.step(place)
        count += 1
        if hardware.looks == 2 * TEST_LOOKS and hardware.is_testing() and not is_skipped:
            processor.skip(2 * TEST_LOOKS)
            is_skipped = True
        if count > MOST_INSTRUCTIONS:
            raise Refused("it does not come back")
    return processor.registers["r0"], hardware


def check(elf, groups):
    """Of an image_check.Elf and the groups of memories that its controller tests. Rows (holds, check, found): every fault of the hardware ends in time, with nERROR low and no go."""
    code = instructions_of(elf.path, "HardwareInitialiseRam")
    for fault in FAULTS:
        if not groups and fault in FAULTS[1:5]:
            continue  # Without groups there is no test.
        try:
            answer, hardware = run(elf, code, fault)
            good = answer != 0 and not hardware.error_forced and hardware.initialised and hardware.values.get(CONTROL, 0x105) == 0x105 \
                and hardware.values.get(INIT_CONTROL) == 5
            refused = answer == 0 and hardware.error_forced
            holds = (hardware.tested or 0) == groups and (good if fault == "none" else refused)
            found = f"tested {hardware.tested or 0:#x}, answer {answer}, nERROR {'low' if hardware.error_forced else 'high'}"
        except (Refused, KeyError) as problem:
            holds, found = False, str(problem)
        yield holds, f"RAM before its first use, fault of the hardware: {fault}", found
