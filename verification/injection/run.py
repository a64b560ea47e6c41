#!/usr/bin/env python3
"""Faults in the code of the target (./dev inject): skipped instructions, inverted decisions, bits of registers and RAM."""
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
IMAGE = ROOT / "build/target/verification/target/injection/injected"
# Harness and start-up: not what ships in a cycle.
NOT_FAULTED = re.compile(r"injection|Injection|TargetMain|counterpoint6target|^Target|Firmware|^Reset|Initialise|^Stopped|Exception|Abort|Call|"
                         r"^Interrupt|FastInterrupt|HardwareInit|StandardOutput|Request|SwappedE|AddressOf|LengthOf|__cxa|_GLOBAL__|^Reserved|^Run")
MEMORY = ("faulted_kernel", "faulted_channel_a", "faulted_channel_b", "faulted_storage_a", "faulted_storage_b", "faulted_pins")
REGISTER = re.compile(r"\b(r\d+|sl|fp|ip|sp|lr|a\d|v\d)\b")
NUMBERS = {**{f"r{n}": n for n in range(13)}, "sl": 10, "fp": 11, "ip": 12, "sp": 13, "lr": 14}
ALL_READ = ("str", "cmp", "cmn", "tst", "teq", "push", "stm", "bx", "blx", "cbz", "cbnz", "vst", "vpush", "tb", "movt", "bfi")
INSTRUCTION = re.compile(r"^\s*([0-9a-f]+):\t[0-9a-f ]+\t(\S+)\s*([^;@]*)")


def expand(operands):
    """{r4-r7} as {r4, r5, r6, r7}."""
    return re.sub(r"\br(\d+)-r(\d+)\b", lambda m: ", ".join(f"r{n}" for n in range(int(m[1]), int(m[2]) + 1)), operands)


def registers_read(name, operands):
    operands = expand(operands)
    if not name.startswith(ALL_READ) and "," in operands:
        first, rest = operands.split(",", 1)
        operands = rest if "[" not in first else operands
        if name.startswith(("add", "sub", "and", "orr", "eor", "mul", "lsl", "lsr", "asr", "bic", "orn")) and operands.count(",") == 0:
            operands += ", " + first
    mask = 0
    for register in REGISTER.findall(operands):
        mask |= 1 << NUMBERS[register] if register in NUMBERS else 0
    return mask


def describe(elf, to):
    """What the injector has to know of the image."""
    lines = []
    table = subprocess.run(["arm-none-eabi-readelf", "-sW", elf], capture_output=True, text=True, check=True).stdout
    for row in table.splitlines():
        fields = row.split()
        if len(fields) != 8 or not fields[0].endswith(":") or fields[0] == "Num:":
            continue
        address, size, kind, name = int(fields[1], 16), int(fields[2], 0), fields[3], fields[7]
        if not name.startswith("$"):
            lines.append(f"symbol {name} {address}")
        if kind == "FUNC" and address & 1 and not NOT_FAULTED.search(name):
            lines.append(f"code {address & ~1} {(address & ~1) + size}")
        if name in MEMORY:
            lines.append(f"memory {address} {address + size}")
    text = subprocess.run(["arm-none-eabi-objdump", "-d", elf], capture_output=True, text=True, check=True).stdout
    for row in text.splitlines():
        found = INSTRUCTION.match(row)
        if found:
            mask = registers_read(found[2], found[3])
            if mask:
                lines.append(f"reads {int(found[1], 16)} {mask}")
    to.write_text("\n".join(lines) + "\n", encoding="utf-8")


if __name__ == "__main__":
    describe(IMAGE.with_suffix(".elf"), IMAGE.with_suffix(".txt"))
