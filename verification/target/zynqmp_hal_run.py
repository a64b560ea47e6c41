"""The drivers of hal/zynqmp, and devices on them, on the emulator's own CAN controllers: each image tests itself and tells a verdict a
line; what crossed the bus the emulator's trace tells, apart from our drivers."""
import re
import tempfile

import target_build
import zynqmp_machine

BUILD = target_build.ROOT / "build/zynqmp"
PROGRAMS = BUILD / "verification/target/zynqmp/hal"
# Image -> verdicts that it has to tell, and what they show.
DRIVERS = ("zynqmp_drivers", 120, ("SRS_ZYN_041", "SRS_ZYN_044", "SRS_ZYN_045", "SRS_ZYN_046", "SRS_ZYN_047", "SRS_ZYN_048", "SRS_ZYN_049", "SRS_ZYN_050",
                                   "SRS_ZYN_052", "SRS_ZYN_054", "SRS_ZYN_055", "SRS_ZYN_056", "SRS_ZYN_060", "SRS_ZYN_062", "SRS_ZYN_066", "SRS_ZYN_067"))
DEVICES = {"sensor": 16, "actuator": 34, "standing_time": 10, "own_device": 19, "own_device_two_controllers": 19}
BOARD_IMAGES = ("sensor", "actuator", "own_device", "own_device_two_controllers")
DEVICE_IDS = ("SRS_ZYN_067", "SRS_ZYN_068", "SRS_ZYN_069", "SRS_ZYN_070")
IMAGES = [DRIVERS[0], *(f"zynqmp_emulated_{device}" for device in DEVICES), *(f"zynqmp_{device}" for device in BOARD_IMAGES)]
# Identifiers of the normal and inverse frames that a device sends, and how many pairs at least.
SENT = {"sensor": ((0x101, 0x102, 9),), "own_device": ((0x121, 0x122, 4), (0x123, 0x124, 4)),
        "own_device_two_controllers": ((0x121, 0x122, 4), (0x123, 0x124, 4))}
FRAME = re.compile(r"xlnx_can_tx_data .*ID: 0x([0-9a-f]+) DLC: 0x([0-9a-f]+) DATA: ((?:0x[0-9a-f]+ ?)+)")
IDENTIFIER_SHIFT = 21
WORD = 4


def build():
    target_build.build_preset("zynqmp", IMAGES, BUILD)


def judge(text, status, expected):
    """What is wrong with what an image told: nothing missing, nothing failed, the count of the image and ours."""
    found = re.search(r"^checks=(\d+) failures=(\d+)$", text, re.MULTILINE)
    holding = len(re.findall(r"^holds  \S.*$", text, re.MULTILINE))
    wrong = re.findall(r"^FAILS  (.*)$", text, re.MULTILINE)
    if found is None:
        wrong.append("no line checks=<n> failures=<n>")
    elif (int(found.group(1)), int(found.group(2)), holding) != (expected, 0, expected):
        wrong.append(f"{holding} of {found.group(1)} verdicts hold, expected {expected} of {expected}")
    if status != 0:
        wrong.append(f"end={status}, expected end=0")
    return wrong


def bytes_of(text, length):
    """Data of a frame. The emulator's frame has the bytes of each word the other way round than the documents: DESIGN.md."""
    data = [int(byte, 16) for byte in text.split()]
    return (data[WORD - 1::-1] + data[:WORD - 1:-1])[:length]


def pairs_on_bus(trace, normal, inverse):
    """(pairs whose inverse frame follows its normal one with each bit inverted, other frames of both identifiers)."""
    pairs, others, open_frame = 0, 0, None
    for identifier, length, data in FRAME.findall(trace):
        number, frame = int(identifier, 16) >> IDENTIFIER_SHIFT, bytes_of(data, int(length, 16))
        if number == normal:
            others += open_frame is not None
            open_frame = frame
        elif number == inverse:
            is_pair = open_frame is not None and frame == [byte ^ 0xFF for byte in open_frame]
            pairs, others, open_frame = pairs + is_pair, others + (not is_pair), None
    return pairs, others


def run_traced(image):
    with tempfile.NamedTemporaryFile("r", suffix=".trace") as trace:
        texts, status = zynqmp_machine.run([image], can=True, extra=["-trace", f"enable=xlnx_can_tx_data,file={trace.name}"])
        return texts[0], status, trace.read()


def check_judges(report):
    """A verdict that fails, one that is missing, a run that broke off, a frame that is not inverse: each is told."""
    good = "holds  a\nholds  b\nchecks=2 failures=0\nend=0\n"
    bad = [(good.replace("holds  b", "FAILS  b"), 0), (good.replace("holds  b\n", ""), 0), ("holds  a\n", None), (good.replace("checks=2", "checks=3"), 0), (good, 1)]
    told = sum(bool(judge(text, status, 2)) for text, status in bad)
    report.add(told == len(bad) and not judge(good, 0, 2), "a verdict that fails or is missing, and a run that broke off, are told", f"{told} of {len(bad)}",
               "SRS_ZYN_070")
    line = "xlnx_can_tx_data Frame: ID: 0x{:08x} DLC: 0x02 DATA: 0x00 0x00 0x{:02x} 0x01 0x00 0x00 0x00 0x00\n"
    first, second, wrong = line.format(0x101 << 21, 1), line.format(0x102 << 21, 0xFE).replace("0x01 ", "0xfe "), line.format(0x102 << 21, 0xFE)
    report.add([pairs_on_bus(text, 0x101, 0x102) for text in (first + second, first + wrong, second, first + first + second)]
               == [(1, 0), (0, 1), (0, 1), (1, 1)], "a pair of the trace that is not inverse or not whole is told", "4 traces", "SRS_ZYN_070")


def check(report):
    name, expected, ids = DRIVERS
    text, status, trace = run_traced(PROGRAMS / f"{name}.elf")
    wrong = judge(text, status, expected)
    report.add(not wrong, "drivers of the Zynq UltraScale+ on the emulator's controllers", "; ".join(wrong[:3]) or f"{expected} of {expected} verdicts hold", *ids)
    frames = len(FRAME.findall(trace))
    report.add(frames >= 200, "frames of the drivers that the emulator saw on its bus", f"{frames}", "SRS_ZYN_070")
    for device, expected in DEVICES.items():
        text, status, trace = run_traced(PROGRAMS / f"zynqmp_emulated_{device}.elf")
        wrong = judge(text, status, expected)
        for normal, inverse, least in SENT.get(device, ()):
            pairs, others = pairs_on_bus(trace, normal, inverse)
            wrong += [f"{normal:x}h/{inverse:x}h: {pairs} pairs and {others} other frames on the bus, expected {least} pairs or more and no other"] \
                if pairs < least or others else []
        report.add(not wrong, f"{device} on the emulated Zynq UltraScale+", "; ".join(wrong[:3]) or f"{expected} of {expected} verdicts hold", *DEVICE_IDS)
    check_judges(report)
