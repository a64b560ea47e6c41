"""Fixtures: one channel that takes bytes in the order of the processor, in one place of each kind: data received, data to send,
configuration and its signature. The host cannot see it; the target must."""
import pathlib
import re
import shlex
import subprocess
import tempfile

import emulator

ROOT = pathlib.Path(__file__).resolve().parents[2]
# Room, what, file, what stands there, and what takes the order of the processor instead.
FIXTURES = [
    ("channel_a", "received data", "channel_a/channel.cpp", "        pair.data = PayloadOf(record.held);", "        __builtin_memcpy(&pair.data, &record.held, 8U);"),
    ("channel_a", "safe value", "channel_a/channel.cpp", "    record.safe = BytesOf(setup.safe_value);", "    __builtin_memcpy(&record.safe, &setup.safe_value, 8U);"),
    ("channel_a", "signature", "channel_a/signature.cpp", "        crc.AddBytes(mapping.entries[position], kFourBytes); // MISRA D-002",
     "        std::uint8_t order[4]; __builtin_memcpy(order, &mapping.entries[position], 4U); for (const std::uint8_t byte : order) { crc.AddByte(byte); }"),
    ("channel_b", "received data", "channel_b/consumer.cpp", "    x_pairs.pending[slot] = data;",
     "    __builtin_memcpy(&x_pairs.pending[slot], &frame.data[0U], 8U);"),
    ("channel_b", "data to send", "channel_b/producer.cpp", "    Unpack(data, {&frame.data[0U]}, kMaxPayloadBits);",
     "    __builtin_memcpy(&frame.data[0U], &data, 8U);"),
    ("channel_b", "signature", "channel_b/checksum.cpp", "void Crc16::AddWord(std::uint32_t word) noexcept\n{\n    for (std::uint32_t at = 0U; at < 32U; at += 8U)\n    {\n        AddByte(word >> at);\n",
     "void Crc16::AddWord(std::uint32_t word) noexcept\n{\n    std::uint8_t order[4]; __builtin_memcpy(order, &word, 4U);\n    for (const std::uint8_t byte : order)\n    {\n        AddByte(byte);\n"),
]
SUITES = {"target": "verification/target/conformance/conformance.elf", "host": "verification/target/conformance/conformance_host"}


class BadInput(Exception):
    """A fixture that cannot be built; the text says why."""


def commands_of(build, program):
    done = subprocess.run(["ninja", "-C", str(build), "-t", "commands", program], capture_output=True, text=True, check=True)
    return done.stdout.splitlines()


def words_of(line):
    """The command alone: what CMake puts around a link (`: &&`, the copy to .bin) is left out."""
    return shlex.split(re.sub(r"^: && ", "", line).split(" && ")[0])


def execute(words, build):
    done = subprocess.run(words, cwd=build, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise BadInput(f"{' '.join(words[:2])} ...: {(done.stderr + done.stdout).strip()[-400:]}")


def build_changed(build, program, fixture, work):
    """The program with the changed file in place of the room's own."""
    _, _, name, find, replace = fixture
    text = (ROOT / name).read_text(encoding="utf-8")
    if text.count(find) != 1:
        raise BadInput(f"{name}: '{find.strip()}' occurs {text.count(find)} times, expected once")
    changed = work / pathlib.Path(name).name
    changed.write_text(text.replace(find, replace), encoding="utf-8")
    commands = commands_of(build, program)
    compile_line = next(line for line in commands if line.endswith(f" -c {ROOT / name}"))
    words = [word for word in words_of(compile_line) if word != "-Werror"]
    words[words.index("-c") + 1] = str(changed)
    item = work / "changed.o"
    words[words.index("-o") + 1] = str(item)
    words[words.index("-MF") + 1] = str(work / "changed.d")
    execute(words, build)
    link = words_of(next(line for line in reversed(commands) if f" -o {program} " in line))
    result = work / pathlib.Path(program).name
    link[link.index("-o") + 1] = str(result)
    link = [f"-Wl,-Map={result}.map" if "-Map=" in word and word.startswith("-Wl,-Map=") else word for word in link]
    first = next(number for number, word in enumerate(link) if re.search(r"\.(o|obj)$", word))
    link[first:first] = [str(item)]
    execute(link, build)
    return result


def run_target(program):
    binary = program.with_suffix(".bin")
    subprocess.run(["arm-none-eabi-objcopy", "-O", "binary", str(program), str(binary)], check=True)
    return emulator.run_image(binary, "short", count_instructions=False)


def outcome_of(fixture, target, host):
    """Whether the host passes and the target fails, and what was seen."""
    room = fixture[0]
    with tempfile.TemporaryDirectory(prefix="byte-order-") as folder:
        work = pathlib.Path(folder)
        on_host = build_changed(host, SUITES["host"], fixture, work)
        done = subprocess.run([on_host, "short"], capture_output=True, text=True, timeout=1800, check=False)
        run = run_target(build_changed(target, SUITES["target"], fixture, work))
    line = re.search(rf"run=conform\w+{room[-2:]} cases=\d+ failures=(\d+)", run.output)
    caught = run.status not in (0, None) and line is not None and int(line.group(1)) > 0
    return done.returncode == 0 and caught, f"{line.group(1) if line else 'no'} failures of its cases"


def check(report, target, host):
    for fixture in FIXTURES:
        try:
            holds, text = outcome_of(fixture, target, host)
        except BadInput as problem:
            holds, text = False, str(problem)
        report.add(holds, f"{fixture[1]} of {fixture[0]} in the order of the processor: the host passes, the target fails", text, "SRS_FW_011")
