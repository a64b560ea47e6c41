"""A device with two CPUs on the two emulated processors, and what a fault in one of them does to both outputs.

A fault is a change of memory by the debugger port, at an instruction (TwoCpuPoint, once in the 60th cycle): the same in each run. What
became of the outputs is told by each processor at its UART, by its own clock; of one that stands, its output closes by the rule of the
gate, so long after the last Drive as the gate keeps open.
"""
import re
import struct

import zynqmp_debugger
import zynqmp_machine

IMAGES = ["zynqmp_two_cpu_0", "zynqmp_two_cpu_1", "zynqmp_two_cpu_0_tcm", "zynqmp_two_cpu_1_tcm"]
SHIFT = 5                # 32 ns an instruction
BRANCH_TO_ITSELF = b"\xfe\xe7"
LINK_WRITES = 4          # In a SharedLink: the mailbox that it writes.
LINK_ELSEWHERE = 0x40    # Bit 14 of that address: still OCM, but nobody reads there.
SLOT_BYTES, SLOT_WORDS, FIRST_SLOT, SLOTS = 200, 8, 4, 4
LINKS = (0xFFFC0000, 0xFFFC1000)
# Places in the storage of the channel of each processor, a bit in each: some hold what matters, some what the next pair overwrites.
STORAGE = ((100, 4, 92), (64, 32, 16))


def place(symbols, end):
    """The one symbol with this end of its name."""
    found = [row for name, row in symbols.items() if name.endswith(end)]
    if len(found) != 1:
        raise zynqmp_machine.BadRun(f"{len(found)} symbols end with {end}, expected 1")
    return found[0]


def flip(debugger, address, bit=1):
    debugger.write(address, bytes([debugger.read(address, 1)[0] ^ bit]))


def word(debugger, address):
    return struct.unpack("<I", debugger.read(address, 4))[0]


def stand(debugger, core, symbols):
    debugger.write(symbols[core]["TwoCpuPoint"][0] & ~1, BRANCH_TO_ITSELF)


def cut(debugger, core, symbols):
    flip(debugger, place(symbols[core], "Link()::link")[0] + LINK_WRITES + 1, LINK_ELSEWHERE)


def spoil_message(debugger, core, symbols):
    """One bit of the message that this processor has just sent."""
    newest = word(debugger, LINKS[core])
    flip(debugger, LINKS[core] + FIRST_SLOT + SLOT_BYTES * (newest % SLOTS) + SLOT_WORDS + 30)


def in_storage(offset):
    return lambda debugger, core, symbols: flip(debugger, place(symbols[core], "two_cpu_storage")[0] + offset)


def nothing(debugger, core, symbols):
    pass


def fields(line):
    return {name: int(value) for name, value in re.findall(r"(\w+)=(\d+)", line)}


def line_of(text, word_before):
    return next((fields(line) for line in text.splitlines() if line.startswith(word_before)), {})


class Seen:
    """What one run showed: texts, clocks at the fault, and of a processor that stands when its output was driven last."""

    def __init__(self, texts, clocks, driven):
        self.texts, self.clocks, self.driven = texts, clocks, driven
        self.limits = [line_of(text, "limits ") for text in texts]
        self.last = [line_of(text, "cpu ") for text in texts]

    def closed(self, core):
        """Microseconds from the fault to the closed output; None: it stays open."""
        after = [int(at) for at in re.findall(r"^closed at=(\d+)$", self.texts[core], re.MULTILINE) if int(at) >= self.clocks[core]]
        if after:
            return after[0] - self.clocks[core]
        if self.last[core] or core not in self.driven:
            return None
        return max(0, self.driven[core] + self.limits[core]["gate"] - self.clocks[core])

    def was_open(self, core):
        before = [line for line in self.texts[core].splitlines() if re.match(r"(open|closed) at=", line) and
                  fields(line)["at"] < self.clocks[core]]
        return bool(before) and before[-1].startswith("open")


def run(folder, core, change, stands=False):
    """One run with a fault in the memory of this processor."""
    images = [folder / f"zynqmp_two_cpu_{number}.elf" for number in (0, 1)]
    symbols = [zynqmp_debugger.symbols(image) for image in images]
    with zynqmp_machine.Machine(images, can=True, shift=SHIFT, gdb=True) as machine:
        machine.start(run=False)
        debugger = zynqmp_debugger.Debugger(machine)
        debugger.run_to(symbols[core]["TwoCpuPoint"][0])
        clocks = [word(debugger, row["two_cpu_now"][0]) for row in symbols]
        change(debugger, core, symbols)
        debugger.go()
        driven = {}
        for number in (0, 1):
            if not (stands and number == core):
                machine.wait_for(number, "end=")
        if stands:
            driven[core] = struct.unpack("<I", machine.read(symbols[core]["two_cpu_driven"][0], 4))[0]
        return Seen(machine.text, clocks, driven)


def undisturbed(seen):
    """What is wrong with a run in which nothing may happen."""
    problems = []
    for core in (0, 1):
        last, other = seen.last[core], seen.last[1 - core]
        if not seen.was_open(core) or last.get("open") != 1 or seen.closed(core) is not None:
            problems.append(f"the output of processor {core} does not stay open")
        if last.get("received", 0) < 15 or last.get("sent", 0) < 15 or last.get("taken", 0) < 100:
            problems.append(f"processor {core}: {last}")
        own, foreign = (("own103", "own104"), ("own104", "own103"))[core]
        if last.get(own, 0) < 15 or last.get(foreign) != 0 or abs(other.get("peer" + own[3:], 0) - last.get(own, 0)) > 1:
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


def check_quiet(report, folder):
    seen = run(folder, 0, nothing)
    problems = undisturbed(seen)
    report.add(not problems, "two CPUs on two emulated processors: both outputs open, 103h by one controller, 104h by the other",
               "; ".join(problems) or f"{seen.last[0]['own103']} pairs, {seen.last[0]['taken']} and {seen.last[1]['taken']} messages",
               "SRS_ZYN_007", "SRS_ZYN_013")
    for core in (0, 1):
        spoiled = run(folder, core, spoil_message)
        problems = undisturbed(spoiled)
        corrupt = spoiled.last[1 - core].get("corrupt")
        report.add(not problems and corrupt == 1, f"a bit of one message of processor {core} flips in the shared memory: nothing closes",
                   "; ".join(problems) or f"{corrupt} message refused", "SRS_ZYN_015")
    return seen


def check_faults(report, folder):
    for core in (0, 1):
        for what, change, stands in (("stands", stand, True), ("no longer reaches the link", cut, False)):
            seen = run(folder, core, change, stands)
            problems = not_closed(seen, "link")
            report.add(not problems, f"processor {core} {what}: both outputs close within {seen.limits[1 - core].get('link', 0) / 1000:.1f} ms",
                       "; ".join(problems) or told(seen), "SRS_ZYN_014")
        closed, problems = [], []
        for offset in STORAGE[core]:
            seen = run(folder, core, in_storage(offset))
            late = not_closed(seen, "channel", "configuration")
            closed += [] if late else [told(seen)]
            # A bit that nobody reads any more disturbs nobody; one output alone or too late is a failure.
            problems += [f"byte {offset}: {'; '.join(late)}"] if late and undisturbed(seen) else []
        report.add(closed and not problems, f"a bit flips in the storage of processor {core}'s channel: both outputs close, or it disturbs nobody",
                   "; ".join(problems) or f"{len(closed)} of {len(STORAGE[core])} close: {', '.join(closed)}", "SRS_ZYN_014")


def check_judge(report, quiet):
    """The judge on runs that are made up of a good one."""
    closed = [text.split("open at=")[0] + f"open at=5\nclosed at={clock + 1000}\ncpu open=0\nend=0\n"
              for text, clock in zip(quiet.texts, quiet.clocks)]
    late = [text.replace(f"closed at={clock + 1000}", f"closed at={clock + 900000}") for text, clock in zip(closed, quiet.clocks)]
    never = closed[0].replace("open at=5\n", "")
    runs = [quiet.texts, [closed[0], quiet.texts[1]], [quiet.texts[0], closed[1]], [closed[0], late[1]], [late[0], closed[1]],
            [never, closed[1]]]
    refused = sum(bool(not_closed(Seen(texts, quiet.clocks, {}), "link")) for texts in runs)
    refused += bool(undisturbed(Seen(closed, quiet.clocks, {}))) + bool(undisturbed(Seen([quiet.texts[0], ""], quiet.clocks, {})))
    good = not not_closed(Seen(closed, quiet.clocks, {}), "link")
    report.add(refused == len(runs) + 2 and good, "an output that stays open, closes late or never was open is refused", f"{refused} of {len(runs) + 2}",
               "SRS_ZYN_013", "SRS_ZYN_014", "SRS_ZYN_015")


def check(report, folder):
    quiet = check_quiet(report, folder)
    check_judge(report, quiet)
    check_faults(report, folder)
