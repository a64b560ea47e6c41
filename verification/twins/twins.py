#!/usr/bin/env python3
"""Shows which mistakes channel A and channel B can make alike, and whether each is one that no design prevents.

    ./dev twins                     everything (about an hour on 2 cores the first time, then what changed)
    ./dev twins --sample 300        300 mutants of each channel, drawn by what the sources are
    ./dev twins --quick             100 sequences, without those that have to be compiled one by one (about 3 minutes)
    ./dev twins --file channel_a/slot.cpp --file channel_b/consumer.cpp
    ./dev twins --rules             the requirement mutants, each with its requirement
    ./dev twins --self-test         two alike signatures are refused, two different ones are not

Each systematic mutant of a channel (verification/mutation/generate.py) drives its channel alone through the same seeded sequences
of calls. What it shows becomes one number, its trace.

    not seen       the trace of the unmutated channel
    refused        it does not compile (static_assert is taken out, so that a proof while compiling hides nothing)
    stopped        it crashes or does not end
    shared         a mutant of A and one of B show the same wrong trace: no comparator can see that
    explained      a requirement mutant (a channel as it is, behind a wrapper that breaks one named requirement) shows it too:
                   both break the same requirement in the same way, which no design prevents
    known          known.json says what the common slip is; a gap that stands there openly, no excuse. An entry with "only_at": 100
                   counts where 100 sequences are all (--quick); more of them tell the two apart, and the whole run checks that they do
    UNEXPLAINED    anything else: the algorithms are alike there. Change the algorithm of one channel, or, if both only break one
                   requirement, write that requirement mutant (broken_rules.cpp).

Traces of 100 and of 3000 sequences, those that are shared also of 10 000 of another seed. Kept in build/twins/results.json by the
text of the channel. After Ctrl-C the next run goes on where this one was. The table: build/twins/table.json.
Exit status: 0 every shared trace is explained or known; 1 one is not, or a known one is no more; 2 bad input.
"""
import argparse
import concurrent.futures
import dataclasses
import functools
import hashlib
import json
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "mutation"))
from build_tree import BadInput, QUIET, progress  # noqa: E402
from generate import NotRead, mutants_of  # noqa: E402
from known import FIRST, ONLY_AT, covers, fits, names_of, read_known, record  # noqa: E402
from schemata import DECLARED, Text, WHILE_COMPILING_CALL  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parents[2]
HERE = "verification/twins"
PROGRAM = f"{HERE}/counterpoint_twins"
# Seed and number of sequences of each step. Who is alone with a trace, or stopped, does not take the next one.
STEPS = ((1, FIRST), (1, 3000), (2, 10000))
# Of processor time: about fifty times what a channel takes.
MILLISECONDS = (1000, 20000, 60000)
KEPT_EVERY = 10
BATCH = 40
REFUSED, STOPPED = "refused", "stopped"
RULES = "rules"
UNBROKEN = 0  # The plain channel as it is.
# What drives a channel.
DRIVEN_BY = ("safety_core/contract", "verification/differential", HERE)
# Unmutated, both channels show the same in all sequences but those where a mapping names an object of the wrong side.
MOST_LEFT_OUT = 0.05


def digest_of(*parts):
    digest = hashlib.sha256()
    for part in parts:
        digest.update(part if isinstance(part, bytes) else str(part).encode())
        digest.update(b"\0")
    return digest.hexdigest()[:24]


def meaning_of(path):
    """The text without comments and spaces."""
    return re.sub(r"//[^\n]*|/\*.*?\*/|\s+", "", path.read_text(encoding="utf-8"), flags=re.DOTALL)


def ran(words, folder):
    done = subprocess.run(words, cwd=folder, capture_output=True, text=True, errors="replace", check=False, env=QUIET)
    return done.returncode, done.stdout, done.stderr


@dataclasses.dataclass(frozen=True)
class Pair:
    """Two rooms with the same task, below `root`, and what is left of their sources to drive."""
    root: pathlib.Path
    subjects: pathlib.Path
    known: pathlib.Path
    unit: tuple = ()  # Options of the program for a unit that is no channel.


FIXTURES = {"alike": "two_signatures", "different": "near_miss_first_signatures"}
CHANNELS = Pair(ROOT, ROOT / HERE, ROOT / HERE / "known.json")


class Room:
    """The sources of one channel, their objects, and how a mutant becomes a library."""

    def __init__(self, side, pair, build):
        self.side, self.pair, self.build = side, pair, build
        self.name = f"channel_{side}"
        self.files = sorted(path.relative_to(pair.root).as_posix() for path in (pair.root / self.name).glob("*.?pp"))
        self.subject = pair.subjects / f"subject_{side}.cpp"
        self.sources = [pair.root / file for file in self.files if file.endswith(".cpp")] + [self.subject]
        self.mutants = {file: mutants_of(file, (pair.root / file).read_bytes()) for file in self.files}
        self.flags = self.read_flags()
        self.no_limit = ["-ferror-limit=0"] if "clang" in self.flags[0] else []
        self.objects = {}

    def read_flags(self):
        archive = f"{HERE}/libverification_twins_{self.side}.a"
        lines = ran(["ninja", "-C", str(self.build), "-t", "commands", archive], ROOT)[1].splitlines()
        line = next((line for line in lines if f"subject_{self.side}.cpp.o" in line and " -c " in line), None)
        if line is None:
            raise BadInput(f"{self.build}: no command for subject_{self.side}.cpp, expected a configured build tree")
        words = shlex.split(line)
        words = words[1:] if words[0].endswith("ccache") else words
        if words[0].endswith("compile_with"):
            words = [words[1], *words[3:]]
        words = words[:words.index("-MD")]
        return [word for word in words if word not in ("-Werror", "-O2")] + ["-w", "-g0", "-O1", "-fPIC", "-Dstatic_assert(...)="]

    @functools.lru_cache(maxsize=None)
    def included(self, path):
        found = {path.relative_to(self.pair.root).as_posix()} if path.is_relative_to(self.pair.root) else set()
        for name in re.findall(r'^#include "([^"]+)"', path.read_text(encoding="utf-8"), re.MULTILINE):
            if (self.pair.root / name).is_file():
                found |= self.included(self.pair.root / name)
        return found

    def compile(self, text_of, target, work, options=()):
        """Headers below `work` come first. Returns status and what the compiler said."""
        words = [self.flags[0], f"-I{work}", f"-I{self.pair.root}", f"-I{self.pair.subjects}", f"-I{ROOT}", *self.flags[1:], *options, "-c", str(text_of), "-o", str(target)]
        status, _, said = ran(words, self.build)
        return status, said

    def link(self, changed, target):
        objects = [str(changed.get(source, self.objects[source])) for source in self.sources]
        status, _, said = ran(["ld", "-shared", "-Bsymbolic", "-o", str(target), *objects], self.build)
        if status != 0:
            raise BadInput(f"{self.name}: does not link:\n{said}")

    def make(self, folder):
        """The unmutated objects and library."""
        folder.mkdir(parents=True, exist_ok=True)
        for number, source in enumerate(self.sources):
            self.objects[source] = folder / f"{number}.o"
            status, said = self.compile(source, self.objects[source], folder)
            if status != 0:
                raise BadInput(f"{source}: does not compile unchanged:\n{said}")
        self.content = {source: item.read_bytes() for source, item in self.objects.items()}
        self.library = folder / f"{self.name}.so"
        self.link({}, self.library)
        texts = [meaning_of(self.pair.root / name) for name in sorted(set().union(*map(self.included, self.sources)))]
        self.key = digest_of(*texts, " ".join(self.flags))

    def make_schemata(self, folder):
        """One library with all mutants that can be asked for while it runs; the others are in `alone`."""
        everything = [mutant for file in self.files for mutant in self.mutants[file]]
        self.numbers = {mutant.name: number for number, mutant in enumerate(everything, start=1)}
        texts = {file: Text((self.pair.root / file).read_bytes(), self.mutants[file], self.numbers) for file in self.files}
        (folder / self.name).mkdir(parents=True)
        (folder / "declared.hpp").write_text(DECLARED, encoding="utf-8")
        objects, rest = {}, list(enumerate(self.sources))
        while rest:
            places = {}
            for file, text in texts.items():
                written, places[str(folder / file)] = text.written()
                (folder / file).write_text(written, encoding="utf-8")
            refused, still = [], []
            for number, source in rest:
                objects[source] = folder / f"{number}.o"
                text_of = folder / source.relative_to(self.pair.root) if source != self.subject else source
                words = ["-include", str(folder / "declared.hpp"), "-Wno-narrowing", *self.no_limit]
                status, said = self.compile(text_of, objects[source], folder, words)
                if status != 0:
                    still.append((number, source))
                    refused.append(said)
            before = sum(len(text.alone) for text in texts.values())
            for path, line, what in re.findall(r"^(/\S+?):(\d+):\d+: (?:fatal )?(?:error|note): (.*)$", "\n".join(refused), re.MULTILINE):
                names = places.get(path, {}).get(int(line), set())
                is_early = WHILE_COMPILING_CALL in what
                if names:
                    texts[pathlib.Path(path).relative_to(folder).as_posix()].exclude(names, is_early)
            if still and before == sum(len(text.alone) for text in texts.values()):
                raise BadInput(f"{self.name}: its mutants do not compile together:\n{refused[0]}")
            rest = still
        self.alone = set().union(*(text.alone for text in texts.values()))
        self.all_mutants = folder / f"{self.name}_mutants.so"
        self.link(objects, self.all_mutants)

    def mutated(self, mutant, work):
        """The objects that differ from the unmutated ones, by source; None if it does not compile."""
        copy = work / mutant.file
        copy.parent.mkdir(parents=True, exist_ok=True)
        copy.write_bytes(mutant.applied((self.pair.root / mutant.file).read_bytes()))
        changed = {}
        for number, source in enumerate(self.sources):
            if mutant.file in self.included(source):
                target = work / f"{number}.o"
                if self.compile(copy if source == self.pair.root / mutant.file else source, target, work)[0] != 0:
                    return None
                if target.read_bytes() != self.content[source]:
                    changed[source] = target
        return changed


class Driver:
    def __init__(self, build, pair):
        self.program = str(build / PROGRAM)
        self.options = list(pair.unit)
        # Not the rules: they change nothing about what a mutant shows.
        texts = [meaning_of(path) for folder in DRIVEN_BY for path in sorted((ROOT / folder).glob("*.?pp")) if not path.name.startswith("broken")]
        self.key = digest_of(*texts, *pair.unit, STEPS)
        self.program_key = digest_of(pathlib.Path(self.program).read_bytes())
        self.left_out = []

    def words(self, room, library, step, rule):
        seed, count = STEPS[step]
        words = [self.program, *self.options, "--library", str(library), "--side", room.side, "--seed", str(seed), "--sequences", str(count),
                 "--milliseconds", str(MILLISECONDS[step])]
        words += ["--without", *self.left_out[seed]] if self.left_out[seed] else []
        return words + (["--rule", str(rule)] if rule is not None else [])

    def trace(self, room, library, step, rule=None):
        status, said, _ = ran(self.words(room, library, step, rule), ROOT)
        return said.split()[-1] if status == 0 else STOPPED

    def traces(self, room, numbers, step):
        """Of mutants that one library holds."""
        words = [*self.words(room, room.all_mutants, step, None), "--mutants", *map(str, numbers)]
        said = dict(line.split() for line in ran(words, ROOT)[1].splitlines())
        return [said[str(number)] for number in numbers]

    def compare_unmutated(self, rooms, steps):
        """Leaves out the sequences in which the unmutated channels do not show the same."""
        self.left_out = {1: [], 2: []}
        if self.options:
            return
        for step in range(len(steps))[-2:]:
            seed, count = STEPS[step]
            said = [ran([*self.words(room, room.library, step, None), "--each"], ROOT)[1].splitlines()[:-1] for room in rooms]
            differing = [one.split()[0] for one, other in zip(*said) if one != other]
            if len(said[0]) != count or len(said[1]) != count or len(differing) > MOST_LEFT_OUT * count:
                raise BadInput(f"seed {seed}: the unmutated channels differ in {len(differing)} of {count} sequences, expected at most "
                               f"{100 * MOST_LEFT_OUT:.0f} %")
            self.left_out[seed] = differing
        # What the first step shows depends on its own sequences only.
        self.key = digest_of(self.key, [number for number in self.left_out[STEPS[0][0]] if int(number) < FIRST])

    def rules(self):
        said = ran([self.program, *self.options, "--list-rules"], ROOT)[1]
        return [line.split("\t") for line in said.splitlines()]


class Results:
    """Traces of each mutant, by what the whole room is; of each rule, by what it is."""

    def __init__(self, path, anew):
        self.path = path
        try:
            self.traces = {} if anew or path is None else json.loads(path.read_text(encoding="utf-8"))
        except (FileNotFoundError, ValueError):
            self.traces = {}

    def keep(self, rooms):
        if self.path is None:
            return
        self.path.parent.mkdir(parents=True, exist_ok=True)
        fresh = self.path.with_suffix(".new")
        used = {room.key for room in rooms} | {RULES}
        fresh.write_text(json.dumps({key: dict(self.traces[key]) for key in used & set(self.traces)}, sort_keys=True), encoding="utf-8")
        fresh.replace(self.path)


class Measurement:
    def __init__(self, pair, build, results, jobs, steps):
        self.pair, self.results, self.jobs = pair, results, jobs
        self.steps = STEPS[:steps]
        self.driver = Driver(build, pair)
        self.folder = tempfile.TemporaryDirectory(prefix="twins-")
        self.rooms = [Room(side, pair, build) for side in "ab"]
        for room in self.rooms:
            room.make(pathlib.Path(self.folder.name) / room.name / "unmutated")
            room.make_schemata(pathlib.Path(self.folder.name) / room.name / "mutants")
        self.driver.compare_unmutated(self.rooms, self.steps)
        for room in self.rooms:
            room.key = digest_of(room.key, self.driver.key)
            self.forget_later(results.traces.setdefault(room.key, {}))
        self.base, others = ([self.driver.trace(room, room.library, step) for step in range(len(self.steps))] for room in self.rooms)
        if self.base != others or STOPPED in self.base:
            raise BadInput("the unmutated channels do not show the same, expected one trace")

    def forget_later(self, traces):
        """Steps behind the first one are of other sequences when others are left out."""
        later = [digest_of(self.driver.left_out)]
        if len(self.steps) > 1 and traces.get("") != later:
            for name in traces:
                traces[name] = traces[name][:1]
            traces[""] = later

    def take(self, room, name, step, trace):
        traces = self.results.traces[room.key].setdefault(name, [])
        if len(traces) == step:
            traces.append(trace)

    def drive_alone(self, room, mutant, step):
        with tempfile.TemporaryDirectory(prefix="twin-") as folder:
            work = pathlib.Path(folder)
            changed = room.mutated(mutant, work)
            if changed:
                library = work / "mutant.so"
                room.link(changed, library)
                self.take(room, mutant.name, step, self.driver.trace(room, library, step))
            else:
                self.take(room, mutant.name, step, REFUSED if changed is None else self.base[step])
        return 1

    def drive_together(self, room, mutants, step):
        for mutant, trace in zip(mutants, self.driver.traces(room, [room.numbers[mutant.name] for mutant in mutants], step)):
            self.take(room, mutant.name, step, trace)
        return len(mutants)

    def drive_all(self, wanted, step):
        """One more step of each, unless it is known from an earlier run."""
        rest = [(room, mutant) for room, mutant in wanted if len(self.traces_of(room, mutant)) <= step]
        pool, futures = concurrent.futures.ThreadPoolExecutor(max_workers=self.jobs), []
        try:
            for room in self.rooms:
                together = [mutant for each, mutant in rest if each is room and mutant.name not in room.alone]
                futures += [pool.submit(self.drive_together, room, together[first:first + BATCH], step) for first in range(0, len(together), BATCH)]
                futures += [pool.submit(self.drive_alone, room, mutant, step) for each, mutant in rest if each is room and mutant.name in room.alone]
            done = 0
            for number, future in enumerate(concurrent.futures.as_completed(futures), start=1):
                done += future.result()
                progress(done, len(rest))
                if number % KEPT_EVERY == 0:
                    self.results.keep(self.rooms)
        finally:
            pool.shutdown(wait=True, cancel_futures=True)
            self.results.keep(self.rooms)

    def traces_of(self, room, mutant):
        return self.results.traces[room.key].get(mutant.name, [])

    def groups(self, wanted, step):
        """Traces up to `step` -> room -> mutants, without those that stopped."""
        found = {}
        for room, mutant in wanted:
            traces = tuple(self.traces_of(room, mutant)[:step + 1])
            if len(traces) == step + 1 and not {REFUSED, STOPPED} & set(traces):
                found.setdefault(traces, {}).setdefault(room.side, []).append((room, mutant))
        return found

    def measure(self, wanted):
        """Step after step with those that still share a trace, or are not seen yet. Returns (shared groups, not seen, stopped, refused)."""
        rest = wanted
        for step in range(len(self.steps)):
            print(f"{len(rest)} mutants, {STEPS[step][1]} sequences of seed {STEPS[step][0]}", flush=True)
            self.drive_all(rest, step)
            groups = self.groups(rest, step)
            unseen = tuple(self.base[:step + 1])
            if step == min(1, len(self.steps) - 1):
                not_seen = sum(map(len, groups.get(unseen, {}).values()))
            goes_on = [traces for traces, sides in groups.items() if (len(sides) == 2 and traces != unseen) or (traces == unseen and step == 0)]
            rest = [item for traces in goes_on for members in groups[traces].values() for item in members]
        refused, stopped = (sum(verdict in self.traces_of(room, mutant) for room, mutant in wanted) for verdict in (REFUSED, STOPPED))
        shared = {traces: sides for traces, sides in groups.items() if len(sides) == 2 and traces != tuple(self.base)}
        return shared, not_seen, stopped, refused

    def explanations(self, shared):
        """Traces -> the requirement mutants that show them."""
        found = {}
        rules = self.driver.rules()
        pool = concurrent.futures.ThreadPoolExecutor(max_workers=self.jobs)
        rest = list(range(len(rules)))
        traces = {rule: () for rule in rest}
        room = self.rooms[0]
        if not self.driver.options and [self.rule_trace(room, UNBROKEN, rules[UNBROKEN], step) for step in range(len(self.steps))] != self.base:
            raise BadInput("the plain channel, nothing broken, does not show what the channels show, expected the same")
        for step in range(len(self.steps)):
            prefixes = {key[:step + 1] for key in shared}
            for rule, trace in zip(rest, pool.map(lambda rule: self.rule_trace(room, rule, rules[rule], step), rest)):
                traces[rule] += (trace,)
            self.first_of_rules = {trace[0] for trace in traces.values()}
            rest = [rule for rule in rest if traces[rule] in prefixes]
        for rule in rest:
            found.setdefault(traces[rule], []).append(rules[rule][1:])
        self.results.keep(self.rooms)
        return found

    def unexplained_at_first(self, wanted):
        """Names of the mutants of each side that share a trace of the first step which no requirement mutant shows; behind explanations()."""
        shared = [(trace, sides) for (trace,), sides in self.groups(wanted, 0).items() if len(sides) == 2 and trace != self.base[0]]
        return [{side: {mutant.name for _, mutant in sides[side]} for side in "ab"} for trace, sides in shared if trace not in self.first_of_rules]

    def rule_trace(self, room, rule, text, step):
        known = self.results.traces.setdefault(RULES, {}).setdefault(digest_of(self.driver.program_key, room.key, *text[1:]), [])
        if len(known) == step:
            known.append(self.driver.trace(room, room.library, step, rule))
        return known[step]


def lines_of(members):
    return [f"{mutant.place}: {mutant.change} [{mutant.name}]" for _, mutant in members]


def judged(measurement, shared, entries, wanted, is_all):
    """(rows of the table, unexplained, stale). Entries of the first step's sequences count where these are all; the whole run looks whether they
    are shared there still, and no longer at its end."""
    explanations = measurement.explanations(shared)
    is_first_all = len(measurement.steps) == 1
    counting = [entry for entry in entries if is_first_all or ONLY_AT not in entry]
    rows, unexplained, used, stale = [], [], [], []
    for traces, sides in sorted(shared.items(), key=lambda item: item[1]["a"][0][1].place):
        row = {"trace": traces[-1], "a": lines_of(sides["a"]), "b": lines_of(sides["b"]), "requirement": explanations.get(traces, [])}
        names = names_of(row)
        if not row["requirement"]:
            fitting = [entry for entry in counting if fits(entry, names)]
            used += fitting
            row["known"] = [entry["slip"] for entry in fitting] if covers(fitting, names) else []
            if not row["known"]:
                unexplained.append(row)
            if not is_first_all:
                lasting = [entry for entry in entries if ONLY_AT in entry and all(set(entry[side]) <= names[side] for side in "ab")]
                stale += [(entry, f"shared to the end, expected only at {FIRST} sequences") for entry in lasting]
        rows.append(row)
    if is_all:
        at_first = measurement.unexplained_at_first(wanted)
        gone = [entry for entry in entries if ONLY_AT in entry and not any(fits(entry, names) for names in at_first)]
        stale += [(entry, f"no unexplained shared trace at {FIRST} sequences any more") for entry in gone]
        stale += [(entry, "no unexplained shared trace any more") for entry in counting if entry not in used]
    return rows, unexplained, stale


def tell(measurement, wanted, found, rows, unexplained, stale):
    _, not_seen, stopped, refused = found
    for row in unexplained:
        print("UNEXPLAINED  the same wrong behaviour, and no requirement mutant has it, expected one:")
        for line in (*row["a"], *row["b"]):
            print(f"    {line}")
    for entry, why in stale:
        print(f"STALE        {entry['slip']}: {why}")
    explained = sum(bool(row["requirement"]) for row in rows)
    known = len(rows) - explained - len(unexplained)
    left_out = sum(map(len, measurement.driver.left_out.values()))
    print(f"{len(wanted)} mutants: {not_seen} not seen in {measurement.steps[:2][-1][1]} sequences, {stopped} stopped, {refused} refused; {left_out} sequences left out")
    print(f"{len(rows)} shared traces: {explained} explained by a requirement mutant, {known} known, {len(unexplained)} unexplained, "
          f"{len(stale)} stale: {'FAIL' if unexplained or stale else 'pass'}")


def chosen(measurement, options):
    """(room, mutant) to drive. The sample is drawn by what the sources are: another one after each change, the same each time."""
    wanted = []
    for room in measurement.rooms:
        files = [file for file in room.files if not options.file or file in options.file]
        mutants = [mutant for file in files for mutant in room.mutants[file]]
        if options.quick:
            mutants = [mutant for mutant in mutants if mutant.name not in room.alone]
        if options.sample:
            seed = digest_of(*[(room.pair.root / file).read_bytes() for each in measurement.rooms for file in each.files])
            mutants = sorted(mutants, key=lambda mutant: digest_of(seed, mutant.name))[:options.sample]
        wanted += [(room, mutant) for mutant in mutants]
    unknown = set(options.file or ()) - {file for room in measurement.rooms for file in room.files}
    if unknown:
        raise BadInput(f"{', '.join(sorted(unknown))}: no file of a channel, expected one of channel_a or channel_b")
    return wanted


def measured(pair, options, results_path, table_path):
    started = time.monotonic()
    measurement = Measurement(pair, options.build.resolve(), Results(results_path, options.anew), options.jobs, 1 if options.quick else len(STEPS))
    wanted = chosen(measurement, options)
    found = measurement.measure(wanted)
    is_all = not (options.file or options.sample or options.quick)
    rows, unexplained, stale = judged(measurement, found[0], read_known(pair.known), wanted, is_all)
    tell(measurement, wanted, found, rows, unexplained, stale)
    if options.record:
        record(pair.known, rows, measurement.unexplained_at_first(wanted))
        unexplained, stale = [], []
    print(f"{time.monotonic() - started:.0f} s")
    if table_path:
        table_path.parent.mkdir(parents=True, exist_ok=True)
        table_path.write_text(json.dumps(rows, indent=1) + "\n", encoding="utf-8")
    return unexplained, stale


def built(build):
    if not (build / "build.ninja").exists():
        raise BadInput(f"{build}: no build.ninja, expected a configured build tree")
    targets = [PROGRAM, *[f"{HERE}/libverification_twins_{side}.a" for side in "ab"]]
    status, said, errors = ran(["ninja", "-C", str(build), "-j2", *targets], ROOT)
    if status != 0:
        raise BadInput(f"{build}: the program does not build:\n{said}{errors}")


def told(good, what):
    print(f"{'pass' if good else 'FAIL'}  {what}")
    return good


def record_test(measurement, wanted, shared, unexplained):
    """What an entry of the record does, marked and unmarked, with a trace that is shared to the end."""
    names = [{side: sorted(found) for side, found in names_of(row).items()} for row in unexplained]
    lasting = [{**each, "slip": "fixture"} for each in names]
    marked = [{**each, ONLY_AT: FIRST} for each in lasting]
    nowhere = {"a": ["0"], "b": ["0"], "slip": "fixture", ONLY_AT: FIRST}
    whole = [judged(measurement, shared, entries, wanted, True)[1:] for entries in (lasting, marked, [*lasting, marked[0]], [*lasting, nowhere])]
    measurement.steps, measurement.base = STEPS[:1], measurement.base[:1]
    quick = judged(measurement, measurement.measure(wanted)[0], marked, wanted, False)[1:]
    return [told(whole[0] == ([], []), "an entry of what is shared to the end: the whole run accepts it"),
            told(len(whole[1][0]) == len(names), f"marked {ONLY_AT}, it does not count in the whole run"),
            told([why for _, why in whole[2][1]] == [f"shared to the end, expected only at {FIRST} sequences"],
                 f"marked {ONLY_AT} beside one that counts, it is stale in the whole run"),
            told([entry for entry, _ in whole[3][1]] == [nowhere], f"marked {ONLY_AT} and not shared there, it is stale in the whole run"),
            told(quick == ([], []), f"marked {ONLY_AT}, it counts in the quick run")]


def refusal_test():
    """A record of another number of sequences is bad input."""
    with tempfile.TemporaryDirectory(prefix="twins-") as folder:
        path = pathlib.Path(folder) / "known.json"
        path.write_text(json.dumps({"known": [{"a": ["0"], "b": ["0"], "slip": "fixture", ONLY_AT: 3000}]}), encoding="utf-8")
        try:
            read_known(path)
            said = ""
        except BadInput as error:
            said = str(error)
    return told(said.endswith(f"{ONLY_AT} 3000: expected {FIRST}, the sequences of --quick"), f"{ONLY_AT} 3000 is refused")


def self_test(options):
    """Of two signatures that were once alike a shared trace is unexplained; of the two before them none is. Entries of the record do what they say."""
    good = refusal_test()
    options.file = options.sample = None
    options.quick = options.record = False
    for case, tree in FIXTURES.items():
        pair = Pair(ROOT / "verification/gates/likeness/fixture" / tree / "tree", ROOT / HERE / "fixture" / case,
                    ROOT / HERE / "fixture" / case / "known.json", ("--unit",))
        measurement = Measurement(pair, options.build.resolve(), Results(None, options.anew), options.jobs, len(STEPS))
        wanted = chosen(measurement, options)
        found = measurement.measure(wanted)
        rows, unexplained, stale = judged(measurement, found[0], [], wanted, True)
        tell(measurement, wanted, found, rows, unexplained, stale)
        expected = "some" if case == "alike" else "none"
        good &= told(bool(unexplained) == (case == "alike"), f"fixture {case}: {len(unexplained)} shared traces are unexplained, expected {expected}")
        if case == "alike":
            good &= all(record_test(measurement, wanted, found[0], unexplained))
    return 0 if good else 1


def parsed(arguments):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter, prog="./dev twins")
    parser.add_argument("--file", action="append", help="mutants of this file alone, as a path in the tree; may be given again")
    parser.add_argument("--sample", type=int, metavar="N", help="N mutants of each channel, drawn by the content of the sources")
    parser.add_argument("--quick", action="store_true",
                        help=f"judge by the first {FIRST} sequences, and only mutants that share one library")
    parser.add_argument("--record", action="store_true", help="write what is unexplained into known.json, instead of failing")
    parser.add_argument("--anew", action="store_true", help="forget all kept traces")
    parser.add_argument("--jobs", type=int, default=2, help="mutants at the same time (default 2)")
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build/product", help="configured build tree (default build/product)")
    parser.add_argument("--rules", action="store_true", help="print the requirement mutants")
    parser.add_argument("--self-test", action="store_true", help="show that the run fails where it must")
    return parser.parse_args(arguments)


def main(arguments):
    options = parsed(arguments)
    try:
        if options.record and (options.quick or options.sample or options.file):
            raise BadInput("--record with --quick, --sample or --file: what these leave out would be lost, expected the whole run")
        built(options.build.resolve())
        if options.rules:
            print(ran([str(options.build.resolve() / PROGRAM), "--list-rules"], ROOT)[1], end="")
            return 0
        if options.self_test:
            return self_test(options)
        unexplained, stale = measured(CHANNELS, options, ROOT / "build/twins/results.json", ROOT / "build/twins/table.json")
    except (BadInput, NotRead) as error:
        print(error, file=sys.stderr)
        return 2
    except KeyboardInterrupt:
        print("\nstopped; what was driven is kept, the same command goes on", file=sys.stderr)
        return 1
    return 1 if unexplained or stale else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
