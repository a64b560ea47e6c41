"""A device with two CPUs on the two emulated processors, and what a fault in one of them does to both outputs.

Both images have the drivers that ship; registers of pins and watchdog, which the emulator has not, are words of the image that do what
the documents say (zynqmp/hal/absent_registers.cpp). An output is open while its pin is high.

A fault is a change of memory or of a register behind the back of the program, or an endless loop, by an order that the runner lays into
the OCM: the processor carries it out in its 40th cycle, the same in each run. What became of the outputs is told by each processor at its
UART, by its own clock; of one that stands, its watchdog resets the controller, and with it the pins, so long after it was served last.
"""
import itertools
import pathlib
import re
import struct
import subprocess
import tempfile

import image_check
import zynqmp_machine

IMAGES = ["zynqmp_two_cpu_0", "zynqmp_two_cpu_1", "zynqmp_two_cpu_0_tcm", "zynqmp_two_cpu_1_tcm", "zynqmp_two_cpu_0_parallel",
          "zynqmp_two_cpu_1_parallel"]
SHIFT = 3                # 8 ns an instruction
ORDER = 0xFFFDE000       # Four words: role of the processor, address of a byte, its bits that flip (0: it stands), done.
ROLES = (0xA5, 0x5B)     # PeerRole
ORDER_CYCLE = 40         # Each processor sends one message a cycle, the first one has the number 1.
LINK_WRITES = 4          # In a SharedLink: the mailbox that it writes.
LINK_ELSEWHERE = 0x40    # Bit 14 of that address: still OCM, but nobody reads there.
SLOT_BYTES, SLOT_WORDS, FIRST_SLOT, SLOTS = 200, 8, 4, 4
LINKS = (0xFFFC0000, 0xFFFC1000)
NO_FAULT = 90            # BoardFault, DeviceFault
TIMERS, TIMER_CONTROL = (0xFF110000, 0xFF120000), 0x0C
# Places in the storage of the channel of each processor, a bit in each: some hold what matters, some what the next pair overwrites.
STORAGE = ((100, 4, 92), (128, 32, 16))


def symbols(image):
    """Name -> address, names as in C++."""
    text = subprocess.run(["arm-none-eabi-nm", "-C", str(image)], capture_output=True, text=True, check=True).stdout
    return {name: int(address, 16) for address, name in re.findall(r"^([0-9a-f]{8}) \S (.*)$", text, re.MULTILINE)}


def place(table, end):
    """The one symbol with this end of its name."""
    found = [address for name, address in table.items() if name.endswith(end) and not name.startswith("guard variable")]
    if len(found) != 1:
        raise zynqmp_machine.BadRun(f"{len(found)} symbols end with {end}, expected 1")
    return found[0]


# A fault -> address of a byte and its bits, from the symbols of the processor's image and its number.
def stand(table, core):
    return 0, 0


def cut(table, core):
    return place(table, "Link()::link") + LINK_WRITES + 1, LINK_ELSEWHERE


def spoil_message(table, core):
    """One bit of the message that this processor has just sent."""
    return LINKS[core] + FIRST_SLOT + SLOT_BYTES * (ORDER_CYCLE % SLOTS) + SLOT_WORDS + 30, 1


def in_storage(offset):
    return lambda table, core: (place(table, "two_cpu_storage") + offset, 1)


def turn_pin(table, core):
    """The pin of the output is no output any more."""
    return place(table, "absent_pin_directions"), 1


def stop_timer(table, core):
    """Bit 0 of the control of the timer that is counter A of this processor."""
    return TIMERS[core] + TIMER_CONTROL, 1


def fields(line):
    return {name: int(value) for name, value in re.findall(r"(\w+)=(\d+)", line)}


def line_of(text, word_before):
    return next((fields(line) for line in text.splitlines() if line.startswith(word_before)), {})


class Seen:
    """What one run showed: texts, clocks at the fault, and of a processor that stands when its watchdog was served last."""

    def __init__(self, texts, served=None, threads=1):
        self.texts, self.served, self.threads = texts, served or {}, threads
        self.limits = [line_of(text, "limits ") for text in texts]
        self.last = [line_of(text, "cpu ") for text in texts]
        self.clocks = [line_of(text, "order ").get("at", 0) for text in texts]

    def closed(self, core):
        """Microseconds from the fault to the closed output; None: it stays open."""
        after = [int(at) for at in re.findall(r"^closed at=(\d+)$", self.texts[core], re.MULTILINE) if int(at) >= self.clocks[core]]
        if after:
            return after[0] - self.clocks[core]
        if self.last[core] or core not in self.served:
            return None
        return max(0, self.served[core] + self.limits[core]["watchdog"] - self.clocks[core])

    def was_open(self, core):
        before = [line for line in self.texts[core].split("order at=")[0].splitlines() if re.match(r"(open|closed) at=", line)]
        return bool(before) and before[-1].startswith("open")


def run(folder, core=None, fault=None, parallel=False):
    """One run, with a fault in one processor if that is named. `parallel`: both at once, each in a thread of the host."""
    images = [folder / f"zynqmp_two_cpu_{number}{'_parallel' if parallel else ''}.elf" for number in (0, 1)]
    extra = ["-accel", "tcg,thread=multi"] if parallel else []
    tables = [symbols(image) for image in images]
    address, bits = fault(tables[core], core) if fault else (0, 0)
    with tempfile.TemporaryDirectory() as work:
        order = pathlib.Path(work) / "order"
        order.write_bytes(struct.pack("<4I", ROLES[core] if fault else 0, address, bits, 0))
        with zynqmp_machine.Machine(images, can=True, shift=SHIFT, files={order: ORDER}, extra=extra, instructions=not parallel) as machine:
            machine.start()
            threads = len({processor["thread-id"] for processor in machine.monitor("query-cpus-fast")[zynqmp_machine.FIRST_CORE:]})
            stands = core if fault and not bits else None
            for number in (0, 1):
                if number != stands:
                    machine.wait_for(number, "end=")
            served = {} if stands is None else {stands: struct.unpack("<I", machine.read(place(tables[stands], "two_cpu_served"), 4))[0]}
            return Seen(machine.text, served, threads)


def undisturbed(seen):
    """What is wrong with a run in which nothing may happen."""
    problems = []
    for core in (0, 1):
        last, other = seen.last[core], seen.last[1 - core]
        if not seen.was_open(core) or last.get("open") != 1 or seen.closed(core) is not None:
            problems.append(f"the output of processor {core} does not stay open")
        if last.get("received", 0) < 8 or last.get("sent", 0) < 8 or last.get("taken", 0) < 65 or \
                (last.get("losses"), last.get("board"), last.get("fault")) != (0, NO_FAULT, NO_FAULT):
            problems.append(f"processor {core}: {last}")
        own, foreign = (("own103", "own104"), ("own104", "own103"))[core]
        if last.get(own, 0) < 8 or last.get(foreign) != 0 or abs(other.get("peer" + own[3:], 0) - last.get(own, 0)) > 1:
            problems.append(f"frames of processor {core}: {last}")
    return problems


def not_closed(seen, *limits):
    """What is wrong with a run in which both outputs have to close, each within the greatest of these limits."""
    problems = []
    for core in (0, 1):
        limit, took = max(seen.limits[core].get(name, 0) for name in limits), seen.closed(core)
        if not seen.was_open(core):
            problems.append(f"the output of processor {core} was not open")
        elif took is None:
            problems.append(f"the output of processor {core} stays open")
        elif took > limit:
            problems.append(f"the output of processor {core} closes after {took} us, limit {limit} us")
    return problems


def told(seen):
    return " and ".join(f"{(seen.closed(core) or 0) / 1000:.1f}" for core in (0, 1)) + " ms"


# What both images have to be linked with, and where alone they may differ from the image of a board: registers that the emulator has not.
DRIVERS = [f"hal/zynqmp/libhal_zynqmp.a({name}.cpp.obj)" for name in ("board", "can_ports", "canps", "counters", "safety_pins", "system_watchdog")] + \
    ["hal/tms570/libhal_tms570.a(mpu.cpp.obj)"]
OTHERWISE = ("hal/zynqmp/silicon/libhal_zynqmp_silicon.a(", "hal/zynqmp/start/libhal_zynqmp_low_vectors.a(")


def drivers_of(image):
    """Objects of hal/ in the image but those that stand for missing hardware."""
    return {name for name in image_check.members_of(image) if name.startswith("hal/") and not name.startswith(OTHERWISE)}


def other_drivers(ours, shipped):
    """What is wrong with the drivers of an image, beside those of the image for a board."""
    return [f"without {name}" for name in DRIVERS if name not in ours] + \
        [f"{name} is in one image only" for name in sorted(ours ^ shipped)]


def check_drivers(report, folder):
    """By the linker's maps: an archive is compiled once, whoever is linked with it."""
    for core in (0, 1):
        shipped = drivers_of(folder / f"zynqmp_two_cpu_{core}_tcm.elf")
        for name, requirement in ((f"zynqmp_two_cpu_{core}", "SRS_ZYN_200"), (f"zynqmp_two_cpu_{core}_parallel", "SRS_ZYN_202")):
            ours = drivers_of(folder / f"{name}.elf")
            wrong = other_drivers(ours, shipped)
            report.add(not wrong, f"{name} is linked with the drivers of the image for a board", "; ".join(wrong[:3]) or f"{len(ours)} objects", requirement)
    told = [bool(other_drivers(shipped - {name}, shipped - {name})) for name in DRIVERS] + \
        [bool(other_drivers(shipped | {"hal/host/libhal_host.a(board.cpp.obj)"}, shipped))]
    report.add(all(told), "a driver that is missing, and one of another folder, are refused", f"{sum(told)} of {len(told)}", "SRS_ZYN_200", "SRS_ZYN_202")


def check_quiet(report, folder):
    seen = run(folder)
    problems = undisturbed(seen)
    report.add(not problems, "two CPUs on two emulated processors: both outputs open, 103h by one controller, 104h by the other",
               "; ".join(problems) or f"{seen.last[0]['own103']} pairs, {seen.last[0]['taken']} and {seen.last[1]['taken']} messages",
               "SRS_ZYN_007", "SRS_ZYN_013", "SRS_ZYN_200")
    for core in (0, 1):
        spoiled = run(folder, core, spoil_message)
        problems = undisturbed(spoiled)
        corrupt = spoiled.last[1 - core].get("corrupt")
        report.add(not problems and corrupt == 1, f"a bit of one message of processor {core} flips in the shared memory: nothing closes",
                   "; ".join(problems) or f"{corrupt} message refused", "SRS_ZYN_015")
    return seen


# What, its order, and what the board says of it (BoardFault). A counter A that stands is told by the processor that does not live by it.
DRIVER_FAULTS = (("a turned pin", turn_pin, 3), ("a timer that stands", stop_timer, 4))


def check_faults(report, folder):
    for core in (0, 1):
        for what, fault in (("stands", stand), ("no longer reaches the link", cut)):
            seen = run(folder, core, fault)
            problems = not_closed(seen, "link")
            report.add(not problems, f"processor {core} {what}: both outputs close within {seen.limits[1 - core].get('link', 0) / 1000:.1f} ms",
                       "; ".join(problems) or told(seen), "SRS_ZYN_014")
        what, fault, board = DRIVER_FAULTS[core]
        seen = run(folder, core, fault)
        problems = not_closed(seen, "link") + ([] if seen.last[core].get("board") == board else [f"board fault {seen.last[core].get('board')}"])
        report.add(not problems, f"{what} of processor {core}: its driver tells it, both outputs close within {seen.limits[1 - core].get('link', 0) / 1000:.1f} ms",
                   "; ".join(problems) or told(seen), "SRS_ZYN_201")
        closed, problems = [], []
        for offset in STORAGE[core]:
            seen = run(folder, core, in_storage(offset))
            late = not_closed(seen, "channel", "configuration")
            closed += [] if late else [told(seen)]
            # A bit that nobody reads any more disturbs nobody; one output alone or too late is a failure.
            problems += [f"byte {offset}: {'; '.join(late)}"] if late and undisturbed(seen) else []
        report.add(closed and not problems, f"a bit flips in the storage of processor {core}'s channel: both outputs close, or it disturbs nobody",
                   "; ".join(problems) or f"{len(closed)} of {len(STORAGE[core])} close: {', '.join(closed)}", "SRS_ZYN_014")


def in_turns(seen):
    """What is wrong with a run whose processors have no thread of their own each."""
    return [f"{seen.threads} thread of the host for both processors"] if seen.threads != 2 else []


def check_parallel(report, folder, quiet):
    """Both processors at once, each in a thread of the host; their time is what both programs do (zynqmp/hal/coupled_time.cpp)."""
    seen = run(folder, parallel=True)
    problems = undisturbed(seen) + in_turns(seen)
    report.add(not problems and bool(in_turns(quiet)), "two CPUs on two processors that run at once: both outputs open, 103h by one controller, 104h by the other",
               "; ".join(problems) or f"{seen.last[0]['own103']} pairs, {seen.last[0]['taken']} and {seen.last[1]['taken']} messages", "SRS_ZYN_202")
    for core, (what, fault) in itertools.product((0, 1), (("stands", stand), ("no longer reaches the link", cut))):
        seen = run(folder, core, fault, parallel=True)
        problems = not_closed(seen, "link") + in_turns(seen)
        report.add(not problems, f"both at once, processor {core} {what}: both outputs close within {seen.limits[1 - core].get('link', 0) / 1000:.1f} ms",
                   "; ".join(problems) or told(seen), "SRS_ZYN_202")


def check_judge(report, quiet):
    """The judge on runs that are made up of a good one."""
    start = "limits link=362500 channel=462500 configuration=462500 watchdog=37500\nopen at=400000\norder at=1500000\n"
    closed, late = (f"{start}closed at={at}\ncpu open=0\nend=0\n" for at in (1862500, 1862501))
    opened, never = f"{start}cpu open=1\nend=0\n", closed.replace("open at=400000\n", "")
    runs = [(opened, opened), (closed, opened), (opened, closed), (closed, late), (late, closed), (never, closed), (start, closed)]
    refused = sum(bool(not_closed(Seen(texts), "link")) for texts in runs)
    refused += bool(not_closed(Seen((start, closed), {0: 1862500}), "link"))
    refused += sum(bool(undisturbed(Seen(texts))) for texts in ((closed, closed), (quiet.texts[0], ""), (quiet.texts[0], quiet.texts[0])))
    good = not not_closed(Seen((closed, closed)), "link") and not not_closed(Seen((start, closed), {0: 1500000}), "link")
    report.add(refused == len(runs) + 4 and good, "an output that stays open, closes late or never was open is refused",
               f"{refused} of {len(runs) + 4}", "SRS_ZYN_013", "SRS_ZYN_014", "SRS_ZYN_015")


def check(report, folder):
    check_drivers(report, folder)
    quiet = check_quiet(report, folder)
    check_judge(report, quiet)
    check_faults(report, folder)
    check_parallel(report, folder, quiet)
