"""The second family of controllers: both Cortex-R5F of a Zynq UltraScale+, little-endian, on the emulator's machine xlnx-zcu102."""
import re
import subprocess

import emulator
import objects
import target_build
import zynqmp_machine
import zynqmp_two_cpu

BUILD = target_build.ROOT / "build/zynqmp"
PROGRAMS = BUILD / "verification/target/zynqmp"
# All cases, and so many sequences as on the other little-endian processors; the big-endian one runs a hundred times as many besides.
ARGUMENT = "short"
RUNS = ("conformance_a", "conformance_b", "differential")
IMAGES = ["conformance", "third_voice", "zynqmp_start_0", "zynqmp_start_1", "zynqmp_start_tcm", *zynqmp_two_cpu.IMAGES]
HOLDS = ("variables with an initial value", "variables without one are zero", "constructors ran", "the floating-point unit computes",
         "the memory protection is on", "each party writes what is its own")
# Argument of the program -> cause of the exception (hal::ExceptionCause) and where the access was, by the linker's symbol.
EXCEPTIONS = {"u": (3, None), "s": (5, None), "v": (5, None), "x": (1, "region_core"), "c": (1, "region_channel_a"), "a": (1, "region_channel_b"),
              "b": (1, "region_core"), "f": (1, "code")}
TOLD = r"^outputs closed\nFAILURE: exception (\d+) accessed 0x([0-9a-f]{8}) at 0x([0-9a-f]{8})\n"
TCM = ((0x00000000, 0x00010000), (0x00020000, 0x00030000))


def build():
    target_build.build_preset("zynqmp", [*IMAGES, *target_build.CERTIFIED_TARGETS], BUILD)


def addresses(image):
    """Name -> address of the linker's symbols."""
    text = subprocess.run(["arm-none-eabi-nm", str(image)], capture_output=True, text=True, check=True).stdout
    return {name: int(address, 16) for address, name in re.findall(r"^([0-9a-f]{8}) \S (\w+)$", text, re.MULTILINE)}


def outcomes(text):
    return dict(re.findall(r"^run=(\S+) (.*)$", text, re.MULTILINE))


def same(ours, theirs):
    """Whether all runs ended, with cases, without a failure, and alike."""
    return all(ours.get(run) == theirs.get(run) and " failures=0 " in ours.get(run, "") and not ours[run].startswith("cases=0 ")
               for run in RUNS)


def check_conformance(report, host_program, big_endian_image):
    host = subprocess.run([host_program, ARGUMENT], capture_output=True, text=True, timeout=600, check=False)
    expected = outcomes(host.stdout)
    big_endian = outcomes(emulator.run_image(big_endian_image, ARGUMENT, count_instructions=False).output)
    image = BUILD / "verification/target/conformance/conformance.elf"
    texts, status = zynqmp_machine.run([image], ARGUMENT, instructions=False)
    found = outcomes(texts[0])
    told = "; ".join(f"{name} {found.get(name, 'did not end')}" for name in RUNS)
    report.add(status == 0 and same(found, expected) and same(found, big_endian),
               "all cases and sequences little-endian on the Zynq UltraScale+, as on the host and big-endian", told, "SRS_ZYN_001")
    wrong = [{**expected, "conformance_a": expected.get("conformance_a", "") + "0"},
             {name: text for name, text in expected.items() if name != "differential"}, {}]
    refused = sum(not same(other, expected) for other in wrong)
    report.add(refused == len(wrong) and same(expected, expected), "another hash or a run that did not end is refused",
               f"{refused} of {len(wrong)}", "SRS_ZYN_001")


def equal_sequences(ours, theirs):
    """Whether the third voice ended on both, with sequences, without a difference, and alike."""
    return ours is not None and ours == theirs and " failures=0 " in ours and not ours.startswith("cases=0 ")


def check_third_voice(report, host_program):
    host = subprocess.run([host_program], capture_output=True, text=True, timeout=600, check=False)
    expected = outcomes(host.stdout).get("third_voice")
    texts, status = zynqmp_machine.run([BUILD / "verification/target/third_voice/third_voice.elf"], instructions=False)
    found = outcomes(texts[0]).get("third_voice")
    report.add(status == 0 and equal_sequences(found, expected), "third voice beside kernel and channels on the Zynq UltraScale+, as on the host",
               found or "did not end", "SRS_ZYN_016")
    line = "cases=9 failures=0 hash=00c0ffee steps=5"
    wrong = [line.replace("ee", "ef"), line.replace("=9", "=8"), line.replace("failures=0", "failures=1"), line + "0", None]
    refused = sum(not equal_sequences(other, line) for other in wrong) + (not equal_sequences("cases=0 failures=0 ", "cases=0 failures=0 "))
    refused += not equal_sequences(wrong[2], wrong[2])
    report.add(refused == 7 and equal_sequences(line, line), "another hash or count, a difference, or no run of the third voice is refused",
               f"{refused} of 7", "SRS_ZYN_016")


def check_objects(report, compilers_of):
    for room, archive in objects.archives(BUILD):
        name = "clang version 19" if room == "channel_b" else "GCC:"
        found, members = compilers_of(archive, name)
        report.add(members > 0 and found == members, f"compiler of {room} for the Zynq UltraScale+",
                   f"{name.strip(':')} in {found} of {members} objects", "SRS_ZYN_002")
    foreign = objects.foreign_symbols(BUILD, "arm-none-eabi-")
    report.add(not foreign, "symbols that come from elsewhere for the Zynq UltraScale+", ", ".join(foreign) or "none", "SRS_ZYN_002")


def started(text):
    """Whether start-up left everything as it has to be."""
    return all(f"holds {what}\n" in text for what in HOLDS) and "FAILS" not in text


def exception_of(text, cause, accessed, code):
    """What is wrong with the exception that a program told at its end; None: nothing."""
    found = re.search(TOLD, text, re.MULTILINE)
    if not found:
        return "no exception, or one that did not close the outputs"
    if int(found.group(1)) != cause:
        return f"cause {found.group(1)}, expected {cause}"
    where = int(found.group(2), 16)
    if accessed is not None and not accessed[0] <= where < accessed[1]:
        return f"accessed {where:#x}, expected {accessed[0]:#x} to {accessed[1]:#x}"
    place = int(found.group(3), 16)
    if not code[0] <= place < code[1] and place != where:
        return f"at {place:#x}, expected one of {code[0]:#x} to {code[1]:#x}"
    return None


def accessed_by(symbols, name):
    """First and last address but one that the exception may name."""
    if name is None:
        return (0, 1)
    if name == "code":
        return (symbols["image_code_start"], symbols["memory_code_end"])
    length = symbols["region_core_length" if name == "region_core" else "region_channel_length"]
    return (symbols[name], symbols[name] + length)


def same_record(first, second, cause):
    """Whether what is told after the reset is the exception of before: cause, accessed address, place, and that it was the only one."""
    told = re.search(TOLD, first, re.MULTILINE)
    return told is not None and second.startswith(f"record cause={cause} count=1 accessed={told.group(2)} at={told.group(3)}\n")


def run_start(images, argument):
    """Problems of one run of the start program on as many processors as images: exception, then a reset, and the record. An argument
    with the number of a processor is for that one alone: the other one goes on, and has no record."""
    cause, name = EXCEPTIONS[argument[0]]
    problems = []
    with zynqmp_machine.Machine(images, argument) as machine:
        machine.start()
        for core in range(len(images)):
            machine.wait_for(core, "end=")
        machine.monitor("system_reset")
        for core, image in enumerate(images):
            text = machine.wait_for(core, "end=", times=2) or machine.text[core]
            symbols = addresses(image)
            if argument[1:] not in ("", str(core)):
                first, _, second = text.partition("end=0\n")
                undisturbed = started(first) and "outputs closed" not in text and second.startswith("record cause=0 count=0 ")
                problems += [] if undisturbed else [f"{image.name} '{argument}': disturbed by the other processor's exception"]
                continue
            first, _, second = text.partition("end=1\n")
            code = (symbols["image_code_start"], symbols["memory_code_end"])
            wrong = exception_of(first, cause, accessed_by(symbols, name), code)
            if not wrong and not (started(first) and same_record(first, second, cause)):
                wrong = "another record after the reset, or none"
            problems += [f"{image.name} '{argument}': {wrong}"] if wrong else []
    return problems


def check_start(report):
    both = [PROGRAMS / "zynqmp_start_0.elf", PROGRAMS / "zynqmp_start_1.elf"]
    texts, status = zynqmp_machine.run(both)
    report.add(status == 0 and all(started(text) and text.startswith("record cause=0 count=0 ") for text in texts),
               "what start-up leaves behind, both processors at once", f"{len(HOLDS)} of {len(HOLDS)} hold on each" if status == 0 else
               "; ".join(line for text in texts for line in text.splitlines() if line.startswith("FAIL")),
               "SRS_ZYN_003", "SRS_ZYN_006", "SRS_ZYN_007")
    problems = [problem for argument in EXCEPTIONS for problem in run_start(both, argument)]
    report.add(not problems, "each exception on both processors at once: cause, place, and the record after a reset",
               "; ".join(problems) or f"{len(EXCEPTIONS)} kinds on 2 processors", "SRS_ZYN_005", "SRS_ZYN_006", "SRS_ZYN_007", "SRS_ZYN_069")
    problems = [problem for core in "01" for argument in "uxc" for problem in run_start(both, argument + core)]
    report.add(not problems, "an exception of one processor: the other one goes on and has no record", "; ".join(problems) or "3 kinds on each of 2 processors",
               "SRS_ZYN_005")
    problems = run_start([PROGRAMS / "zynqmp_start_tcm.elf"], "c")
    report.add(not problems, "an image with the layout of a board starts and takes its exceptions at 0", "; ".join(problems) or "as the others",
               "SRS_ZYN_003", "SRS_ZYN_004", "SRS_ZYN_005")
    good = "outputs closed\nFAILURE: exception 1 accessed 0x00000040 at 0x00000020\n"
    wrong = [good.replace("exception 1", "exception 3"), good.replace("0x00000040", "0x00000080"), good.replace("0x00000020", "0x00000100"),
             good.replace("outputs closed\n", ""), ""]
    refused = sum(exception_of(text, 1, (0x40, 0x80), (0, 0x100)) is not None for text in wrong) + (not started("holds constructors ran\n"))
    kept = "record cause=1 count=1 accessed=00000040 at=00000020\n"
    others = [kept.replace("cause=1", "cause=3"), kept.replace("count=1", "count=2"), kept.replace("40", "44"), kept.replace("20", "24"), ""]
    refused += sum(not same_record(good, other, 1) for other in others)
    report.add(refused == 11 and exception_of(good, 1, (0x40, 0x80), (0, 0x100)) is None and same_record(good, kept, 1),
               "another cause, access, place or record, outputs that stay open, or a start that is not whole, is refused", f"{refused} of 11",
               "SRS_ZYN_003", "SRS_ZYN_005")


def layout_problems(sections, symbols):
    """What in an image does not lie where a board has memory."""
    problems = []
    for name, address, length in sections:
        if length and not any(first <= address and address + length <= end for first, end in TCM):
            problems.append(f"{name} at {address:#x}, {length} bytes, outside of both TCMs")
    if symbols.get("FirmwareVectors") != 0:
        problems.append(f"vectors at {symbols.get('FirmwareVectors')}, expected 0")
    for region, length in (("region_channel_a", "region_channel_length"), ("region_channel_b", "region_channel_length"),
                           ("region_core", "region_core_length"), ("region_non_safety", "region_non_safety_length")):
        size = symbols.get(length, 0)
        if size < 32 or size & (size - 1) or symbols.get(region, 1) % size:
            problems.append(f"{region} at {symbols.get(region, 0):#x}, {size} bytes, expected a power of two and a multiple of it")
    return problems


def sections_of(image):
    """Name, address and length of what is in memory."""
    text = subprocess.run(["arm-none-eabi-readelf", "-S", "-W", str(image)], capture_output=True, text=True, check=True).stdout
    rows = re.findall(r"\] (\S+)\s+\w+\s+([0-9a-f]{8}) [0-9a-f]{6} ([0-9a-f]{6}) [0-9a-f]{2} +([WAX]*A[WAX]*)", text)
    return [(name, int(address, 16), int(length, 16)) for name, address, length, _ in rows]


def check_layout(report):
    images = [PROGRAMS / "zynqmp_start_tcm.elf", *(PROGRAMS / f"two_cpu/zynqmp_two_cpu_{core}_tcm.elf" for core in (0, 1))]
    problems = [f"{image.name}: {problem}" for image in images for problem in layout_problems(sections_of(image), addresses(image))]
    report.add(not problems and all(len(sections_of(image)) >= 8 for image in images), "images for a board: vectors, TCMs, regions",
               "; ".join(problems) or f"{len(images)} images", "SRS_ZYN_004")
    symbols = addresses(images[0])
    wrong = [([("x", 0xFFF0, 0x20)], symbols), ([("x", 0x01000000, 4)], symbols), ([], {**symbols, "FirmwareVectors": 0x01000000}),
             ([], {**symbols, "region_core_length": 0x300}), ([], {**symbols, "region_channel_b": symbols["region_channel_b"] + 8})]
    refused = sum(bool(layout_problems(*other)) for other in wrong)
    emulated = layout_problems(sections_of(PROGRAMS / "zynqmp_start_0.elf"), addresses(PROGRAMS / "zynqmp_start_0.elf"))
    report.add(refused == len(wrong) and bool(emulated), "an image with one thing elsewhere, and the emulator's own, are refused",
               f"{refused} of {len(wrong)}, {len(emulated)} findings", "SRS_ZYN_004")


def check(report, host_folder, big_endian_image, compilers_of):
    check_conformance(report, host_folder / "conformance/conformance_host", big_endian_image)
    check_third_voice(report, host_folder / "third_voice/third_voice_host")
    check_objects(report, compilers_of)
    check_start(report)
    check_layout(report)
    zynqmp_two_cpu.check(report, PROGRAMS / "two_cpu")
