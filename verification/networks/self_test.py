"""Shows that the rules can be broken: one healthy run, and what the oracle says of it after one thing was changed."""
import copy
import json

import devices
import frames as wire
import judge
import scenario
from draw import MANAGER, Plan, SECOND, Slave
from frames import Frame

RELAY, PLAIN = 33, 5


def healthy_plan(profile="cia302"):
    slaves = [Slave(PLAIN, "io", 500, False, {}, "io", 500), Slave(RELAY, "relay", 330, True, {}, "relay", 330)]
    plan = Plan(0, profile, 500000, 1, {"node": MANAGER, "profile": profile, "heartbeat": "50 ms"}, slaves, [])
    plan.duration_us = 2 * SECOND
    return plan


class Case:
    """A copy of the healthy run that one fixture may change."""

    def __init__(self, plan, frames, document):
        self.plan = copy.deepcopy(plan)
        self.frames = list(frames)
        self.document = copy.deepcopy(document)

    def place_of_start(self):
        return next(place for place, frame in enumerate(self.frames) if frame.is_nmt and frame.data == bytes((1, RELAY)))

    def answers(self, index, sub):
        """Places of the answers to a reading of that object of the relay."""
        head = bytes((index & 0xFF, index >> 8, sub))
        return [place for place, frame in enumerate(self.frames)
                if frame.identifier == wire.ANSWER + RELAY and frame.data[1:4] == head]

    def add(self, t_us, identifier, data):
        self.frames.append(Frame(t_us, identifier, bytes(data)))
        self.frames.sort(key=lambda frame: frame.t_us)


def start_of_all(case):
    case.add(1 * SECOND, wire.NMT, (1, 0))


def unread_mapping(case):
    for place in reversed(case.answers(0x1381, 2)):
        del case.frames[place]


def unread_signature(case):
    for place in reversed(case.answers(0x13FF, 1)):
        del case.frames[place]


def other_value(case):
    place = case.answers(0x1301, 2)[-1]
    frame = case.frames[place]
    case.frames[place] = Frame(frame.t_us, frame.identifier, frame.data[:4] + bytes((77, 0, 0, 0)))


def validity_not_last(case):
    del case.frames[case.answers(0x13FE, 0)[-1]]


def boot_up_behind_it(case):
    first, last = case.answers(0x1301, 1)[-1], case.place_of_start()
    case.add((case.frames[first].t_us + case.frames[last].t_us) // 2, wire.ERROR_CONTROL + RELAY, (0,))


def stop_behind_it(case):
    case.add(case.frames[case.answers(0x13FF, 0)[-1]].t_us + 1, wire.NMT, (2, RELAY))
    case.plan.events.append({"at_us": 0, "do": "send", "identifier": 0, "data": bytes((2, RELAY))})


def stored_before(case):
    case.plan.events.append({"at_us": 20, "do": "store", "node": RELAY, "key": (0x1301, 2), "value": 77})
    case.frames = [frame for frame in case.frames if frame.data[:1] not in (b"\x81", b"\x82") or frame.identifier != 0]


def other_serial(case):
    case.plan.slaves[1].device_serial = 331


def other_serial_written(case):
    case.plan.slaves[1].device_serial = 331
    case.frames = [frame for frame in case.frames if not frame.is_nmt or frame.data != bytes((1, RELAY))]
    case.add(SECOND, wire.REQUEST + RELAY, (0x2F, 0xFE, 0x13, 0, 0, 0, 0, 0))


def exchanged_unheard(case):
    case.plan.events += [{"at_us": 1000000, "do": "bus_off", "until_us": 1100000},
                         {"at_us": 1050000, "do": "replace", "node": RELAY, "serial": 331}]
    case.add(1051000, wire.ERROR_CONTROL + RELAY, (0,))
    readings = [frame for frame in case.frames if frame.identifier in (wire.ANSWER + RELAY, wire.REQUEST + RELAY)]
    for frame in readings:
        case.add(frame.t_us + 1200000, frame.identifier, frame.data)
    case.add(readings[-1].t_us + 1201000, wire.NMT, (1, RELAY))


def runs_altered(case):
    case.plan.duration_us = 12 * SECOND
    case.plan.events += [{"at_us": 1100000, "do": "send", "identifier": 0, "data": bytes((0x80, RELAY))},
                         {"at_us": 1150000, "do": "store", "node": RELAY, "key": (0x1301, 2), "value": 77},
                         {"at_us": 1200000, "do": "send", "identifier": 0, "data": bytes((1, RELAY))}]
    case.add(1100100, wire.NMT, (0x80, RELAY))
    case.add(1200100, wire.NMT, (1, RELAY))
    case.frames = [frame for frame in case.frames if frame.t_us < 1100200 or frame.identifier != wire.ERROR_CONTROL + RELAY]
    for number in range(2000, 12000, 100):
        case.add(number * 1000 + 7, wire.ERROR_CONTROL + RELAY, (5,))


def does_not_run(case):
    verdict = next(verdict for verdict in case.document["expectations"] if f"node {PLAIN} " in verdict["wanted"])
    verdict["seen"] = "pre-operational"


def left_booting(case):
    case.document["managers"][0]["events"].append({"t_us": 1900000, "node": PLAIN, "event": "status", "letter": "none",
                                                   "code": 0, "step": "vendor-ID"})


def held(case, *orders):
    """Orders to the relay that were taken, in the middle of its start-up."""
    t_us = case.frames[case.answers(0x1301, 1)[-1]].t_us
    case.document["managers"][0]["events"] += [{"t_us": t_us + place, "event": "order", "order": order, "answer": "taken"}
                                               for place, order in enumerate(orders)]


def held_by_stop(case):
    held(case, f"stop {RELAY}")


def held_by_preop_of_all(case):
    held(case, "preop all")


def held_by_1f82(case):
    held(case, f"start {RELAY}", f"set 0x1F82:{RELAY:02X} 4")


def held_and_freed(case):
    held(case, f"stop {RELAY}", f"boot {RELAY}")


FIXTURES = ((start_of_all, "1 start of all"), (unread_mapping, "2 verified"), (unread_signature, "2 verified"),
            (other_value, "2 verified"), (validity_not_last, "2 verified"), (boot_up_behind_it, "2 verified"),
            (stop_behind_it, "2 verified"), (stored_before, "2 verified"), (other_serial, "3 identity"),
            (other_serial_written, "3 identity"), (exchanged_unheard, "3 identity, exchanged unheard"),
            (runs_altered, "4 stopped"), (does_not_run, "5 runs"), (left_booting, "5 booting"),
            (held_by_stop, "7 held"), (held_by_preop_of_all, "7 held"), (held_by_1f82, "7 held"), (held_and_freed, None))


def tell(name, expected, rules):
    is_held = rules == expected
    print(f"{'pass' if is_held else 'FAIL'}  {name}: {', '.join(sorted(rules)) or 'no rule is broken'}"
          + ("" if is_held else f", expected {', '.join(sorted(expected)) or 'no broken rule'}"))
    return is_held


def program_fixtures(program, catalogue, plan, folder):
    """A scenario that the product refuses, and a second run with other bytes."""
    refused = copy.deepcopy(plan)
    refused.events.append({"at_us": 3 * SECOND, "do": "pull", "node": PLAIN})
    good = tell("refused", {"6 program"}, {violation.rule for violation in
                                           judge.run_network(program, catalogue, refused, folder, False).violations})
    outcome = judge.Outcome(plan)
    judge.compare(outcome, (b"a", b"b"), (b"a", b"c"))
    return tell("other_bytes", {"6 same bytes"}, {violation.rule for violation in outcome.violations}) and good


def run(program, folder):
    """All fixtures; the exit status."""
    catalogue = devices.Catalogue(program, folder)
    plan = healthy_plan()
    status, words, files = judge.simulate(program, scenario.write(plan, catalogue, folder), folder)
    if status != 0 or files is None:
        print(f"FAIL  the healthy network: exit status {status}: {words}")
        return 1
    frames, document = wire.frames_of(files[0].decode("ascii"), "frames.log"), json.loads(files[1])
    good = tell("healthy", set(), {violation.rule for violation in judge.judge(plan, catalogue, frames, document).violations})
    for change, rule in FIXTURES:
        case = Case(plan, frames, document)
        change(case)
        outcome = judge.judge(case.plan, catalogue, case.frames, case.document)
        good = tell(change.__name__, {rule} - {None}, {violation.rule for violation in outcome.violations}) and good
    return 0 if program_fixtures(program, catalogue, plan, folder) and good else 1
