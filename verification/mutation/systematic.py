#!/usr/bin/env python3
"""Breaks the safety rooms in every small way and shows which of these mutants no test kills.

    ./dev mutants --all                            every room (about 80 minutes on 2 cores the first time, then what changed)
    ./dev mutants --room crosslink                 one room: comparator, kernel, crosslink, selftest, channel_a, channel_b
    ./dev mutants --file safety_core/comparator/slot_mask.hpp
    ./dev mutants --room kernel --sample 50        the same 50 of the room each time
    ./dev mutants --room kernel --list             names, places and changes; builds and runs nothing
    ./dev mutants --all --record                   and writes record.json, which the evidence shows
    ./dev mutants --all --record --kept            the record of what a run has judged so far; it names the rest
    ./dev mutants --changed --again 24             functions that changed since the record, and 24 drawn from the others
    ./dev mutants --changed --record               and puts all of the changed functions into the record, with the commit that judged them;
                                                   judges again what survives there or was not judged
    ./dev mutants --self-test                      shows that a test suite which checks nothing lets mutants survive

A mutant is one change of one operator, constant, condition, statement, argument or returned value (generate.py). Its object is
compiled as the product's is, linked before the room's library into the programs that judge the room, and run with a limit.

    killed       a program failed, or did not end in time
    refused      it does not compile, or not with the room's static_assert
    same code    the compiler makes the same object of it: nothing to see for any test
    equivalent   it survives and equivalent.json says why no test can see it
    SURVIVED     no test sees it: write one, or give the reason

Verdicts are kept in build/mutants/results.json, with --all the score in build/mutants/score.json. A file is run again when it, a
header that it includes or its command line has changed; survivors also when a program that judges has. After Ctrl-C the next run
goes on where this one was.
Exit status: 0 nothing survives without a reason; 1 something does, or a reason no longer fits; 2 bad input.
"""
import argparse
import concurrent.futures
import functools
import hashlib
import json
import pathlib
import re
import resource
import sys
import tempfile
import threading
import time

from build_tree import BadInput, Build, is_batch, progress, run_program
from generate import KINDS, NotRead, mutants_of
from record import changed_since, drawn_again, made_by, record_of, updated

ROOT = pathlib.Path(__file__).resolve().parents[2]
HERE = "verification/mutation"
PROBE = f"{HERE}/counterpoint_mutation_probe"
BRIEF = ("--gtest_brief=1", "--gtest_fail_fast")
CORE_TESTS = ("tests/safety_core/safety_core_tests", BRIEF)
CONFORMANCE, DIFFERENTIAL = (PROBE, ()), (PROBE, ("differential",))
THIRD_VOICE = ("verification/third_voice/counterpoint_third_voice", ("--sequences", "1000"))


def judges_of_channel(room):
    """Every test program of the channel, so that a new one is not left out; CONFORMANCE stands for its conformance test."""
    names = sorted(path.name.removesuffix("_test.cpp") for path in (ROOT / "tests" / room).glob("*_test.cpp"))
    programs = {name: (f"tests/{room}/{room}_{name}_test", BRIEF) for name in names if name != "conformance"}
    slow = programs.pop("flipped_storage")
    return (DIFFERENTIAL, *programs.values(), CONFORMANCE, slow, THIRD_VOICE)


# Folder of a room, and the programs that judge it with their arguments, the fastest first.
ROOMS = {
    "comparator": ("safety_core/comparator", ((f"{HERE}/counterpoint_comparator_probe", BRIEF), CORE_TESTS)),
    "kernel": ("safety_core/kernel", (CORE_TESTS, ("tests/safety_core/selftest/selftest_tests", BRIEF))),
    "crosslink": ("safety_core/crosslink", (("tests/safety_core/crosslink/crosslink_tests", BRIEF),)),
    "selftest": ("safety_core/selftest", (("tests/safety_core/selftest/selftest_tests", BRIEF),)),
    "channel_a": ("channel_a", judges_of_channel("channel_a")),
    "channel_b": ("channel_b", judges_of_channel("channel_b")),
}
FIXTURE = f"{HERE}/fixture/systematic"
FIXTURES = {"seeing": (FIXTURE, ((f"{HERE}/counterpoint_mutation_seeing", ()),)),
            "blind": (FIXTURE, ((f"{HERE}/counterpoint_mutation_blind", ()),))}
RECORD = ROOT / HERE / "record.json"
TESTS = ("tests/", "verification/")
LEAST_LIMIT_S = 5
KEPT_EVERY = 20


def room_of(file, rooms):
    room = next((name for name, (folder, _) in rooms.items() if file.startswith(folder + "/")), None)
    if room is None or not (ROOT / file).is_file():
        raise BadInput(f"{file}: no such file of a safety room, expected one below {', '.join(folder for folder, _ in rooms.values())}")
    return room


def chosen_files(options, rooms):
    """(room, file) in order."""
    if options.file:
        return sorted({(room_of(file, rooms), file) for file in options.file})
    return [(room, path.relative_to(ROOT).as_posix()) for room in (options.room or rooms)
            for path in sorted((ROOT / rooms[room][0]).glob("*.?pp"))]


@functools.lru_cache(maxsize=None)
def included_directly(file):
    return re.findall(r'^#include "([^"]+)"', (ROOT / file).read_text(encoding="utf-8"), re.MULTILINE)


@functools.lru_cache(maxsize=None)
def included_by(file):
    """The file and all files of the tree that it includes."""
    found, open_files = [], [file]
    while open_files:
        name = open_files.pop()
        if name not in found and (ROOT / name).is_file():
            found.append(name)
            open_files += included_directly(name)
    return found


def digest_of(parts):
    digest = hashlib.sha256()
    for part in parts:
        digest.update(part if isinstance(part, bytes) else part.encode())
        digest.update(b"\0")
    return digest.hexdigest()


class Subject:
    """One file with its mutants, the sources that see it, and what is known about it."""

    def __init__(self, room, file, rooms):
        self.room, self.file = room, file
        self.judges = rooms[room][1]
        self.source = (ROOT / file).read_bytes()
        self.mutants = mutants_of(file, self.source)
        self.compiled = [file] if file.endswith(".cpp") else []
        self.batches = []  # Of tests that see a header: compiled for what survives without them, since each takes long.
        self.verdicts = {}

    def prepare(self, build, programs, kept):
        """Finds who sees a header: product sources, and tests that include it themselves. Takes over the verdicts that still hold."""
        for source in sorted({source for program, _ in self.judges for source in build.sources[program]} if not self.compiled else ()):
            name = source.relative_to(ROOT).as_posix()
            if is_batch(source):
                if any(self.file in included_directly(test) for test in included_directly(name)):
                    self.batches.append(name)
            elif self.file in (included_directly(name) if name.startswith(TESTS) else included_by(name)):
                self.compiled.append(name)
        seen = sorted({name for source in self.compiled + self.batches for name in included_by(source)})
        commands = [build.compile[ROOT / name] for name in self.compiled + self.batches]
        self.key = digest_of([(ROOT / name).read_bytes() for name in seen] + commands)
        self.judged_by = digest_of(programs[program] for program, _ in self.judges)
        if kept.get("source") == self.key:
            same_judges = kept.get("judges") == self.judged_by
            names = {mutant.name for mutant in self.mutants}
            self.verdicts = {name: verdict for name, verdict in kept["verdicts"].items()
                             if name in names and (same_judges or verdict != "survived")}

    def kept(self):
        return {"source": self.key, "judges": self.judged_by, "verdicts": self.verdicts}


class Runner:
    def __init__(self, build, limits):
        self.build = build
        self.limits = limits  # Of each judge, in seconds of processor time.
        self.untouched = {}   # Source -> bytes of its object without a mutant.
        self.lock = threading.Lock()

    def unchanged(self, source):
        """The object of a source without a mutant, compiled once."""
        with self.lock:
            if source not in self.untouched:
                with tempfile.TemporaryDirectory(prefix="mutant-") as folder:
                    item, text = self.build.compile_mutated(source, source, pathlib.Path(folder))
                    if item is None:
                        raise BadInput(f"{source.relative_to(ROOT)}: does not compile unchanged:\n{text}")
                    self.untouched[source] = item.read_bytes()
            return self.untouched[source]

    def compiled(self, subject, sources, text, work, program, objects):
        """Adds to `objects` (source -> object) those of one program that see the file; False if one does not compile."""
        changed = work / subject.file
        changed.parent.mkdir(parents=True, exist_ok=True)
        changed.write_bytes(text)
        for source in (ROOT / name for name in sources):
            if source in self.build.sources[program] and source not in objects:
                copy = changed if source == ROOT / subject.file else source
                objects[source], _ = self.build.compile_mutated(source, copy, work)
                if objects[source] is None:
                    return False
        return True

    def judge(self, subject, mutant):
        """What survives without the batches of tests that see the header is judged with them as well."""
        verdict = self.judged_with(subject, subject.compiled, mutant)
        if subject.batches and verdict in ("survived", "same"):
            verdict = self.judged_with(subject, subject.compiled + subject.batches, mutant)
        return verdict

    def judged_with(self, subject, sources, mutant):
        """From program to program: what the first one kills is not compiled for the others."""
        with tempfile.TemporaryDirectory(prefix="mutant-") as folder:
            work, objects, linked, seen = pathlib.Path(folder), {}, {}, False
            for program, arguments in subject.judges:
                if not self.compiled(subject, sources, mutant.applied(subject.source), work, program, objects):
                    return "refused"
                changed = {source: item for source, item in objects.items() if item.read_bytes() != self.unchanged(source)}
                if not self.build.sources[program] & set(changed):
                    continue
                seen = True
                if program not in linked:
                    linked[program], text = self.build.link_mutated(program, changed, work)
                    if linked[program] is None:
                        raise BadInput(f"{mutant.place}: {mutant.name}: {program} does not link:\n{text}")
                if run_program(linked[program], arguments, self.limits[program, arguments])[0]:
                    return "killed"
            return "survived" if seen else "same"


def examine_judges(build, subjects):
    """What the real sources do not pass, linked as a mutant is, cannot judge one. Returns the limits and the digests of the programs."""
    limits, programs = {}, {}
    for judge in sorted({judge for subject in subjects for judge in subject.judges}):
        program, arguments = judge
        with tempfile.TemporaryDirectory(prefix="mutant-") as folder:
            linked, text = build.link_mutated(program, {}, pathlib.Path(folder))
            if linked is None:
                raise BadInput(f"{program}: does not link as its mutants do:\n{text}")
            before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
            killed, said = run_program(linked, arguments, 600)
        if killed:
            raise BadInput(f"{program} {' '.join(arguments)}: the sources themselves fail ({said}), expected a pass")
        limits[judge] = LEAST_LIMIT_S + int(10.0 * (resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before))
        programs[program] = digest_of([(build.folder / program).read_bytes()])
    return limits, programs


def read_json(path, default):
    try:
        return json.loads(path.read_text(encoding="utf-8"))
    except FileNotFoundError:
        return default
    except ValueError as error:
        raise BadInput(f"{path}: {error}, expected JSON") from error


def write_json(path, value):
    path.parent.mkdir(parents=True, exist_ok=True)
    fresh = path.with_suffix(".new")
    fresh.write_text(json.dumps(value, indent=1, sort_keys=True) + "\n", encoding="utf-8")
    fresh.replace(path)


def run(runner, subjects, wanted, keep, jobs):
    """Judges what has no verdict yet; `keep` is called now and then, and at the end, whatever ends it."""
    to_do = [(subject, mutant) for subject in subjects for mutant in wanted[subject.file] if mutant.name not in subject.verdicts]
    pool = concurrent.futures.ThreadPoolExecutor(max_workers=jobs)
    try:
        futures = {pool.submit(runner.judge, subject, mutant): (subject, mutant) for subject, mutant in to_do}
        for done, future in enumerate(concurrent.futures.as_completed(futures), start=1):
            subject, mutant = futures[future]
            subject.verdicts[mutant.name] = future.result()
            progress(done, len(to_do))
            if done % KEPT_EVERY == 0:
                keep()
    finally:
        pool.shutdown(wait=True, cancel_futures=True)
        keep()
    return len(to_do)


def read_reasons(path):
    """Name of a mutant -> why no test can see it."""
    reasons = {}
    for entry in read_json(path, {"equivalent": []})["equivalent"]:
        if not all(entry.get(field) for field in ("name", "file", "change", "reason")):
            raise BadInput(f"{path}: {entry}: expected name, file, change and reason")
        reasons[entry["name"]] = entry
    return reasons


def row_of(label, verdicts):
    counts = {verdict: verdicts.count(verdict) for verdict in ("killed", "refused", "same", "equivalent", "survived")}
    judged = counts["killed"] + counts["survived"]
    score = f"{100.0 * counts['killed'] / judged:.1f} %" if judged else "-"
    return [label, len(verdicts), *counts.values(), score]


def show(subjects, wanted, reasons):
    """Prints survivors and the score; returns (rows, survivors, stale reasons)."""
    survivors, stale, rows, everything = [], [], [], []
    for subject in subjects:
        names = {mutant.name for mutant in subject.mutants}
        stale += [f"{subject.file}: {name}: no such mutant any more" for name, entry in reasons.items()
                  if entry["file"] == subject.file and name not in names]
        verdicts = []
        for mutant in wanted[subject.file]:
            verdict = subject.verdicts[mutant.name]
            if mutant.name in reasons and verdict == "survived":
                verdict = "equivalent"
            elif mutant.name in reasons:
                stale.append(f"{mutant.place}: {mutant.name}: {verdict}, though said to be equivalent")
            if verdict == "survived":
                survivors.append(mutant)
            verdicts.append((mutant.kind, verdict))
        everything += verdicts
        if verdicts:
            rows.append(row_of(subject.file, [verdict for _, verdict in verdicts]))
    for mutant in survivors:
        print(f"SURVIVED  {mutant.name}  {mutant.place}: {mutant.change}")
    for line in stale:
        print(f"STALE     {line}")
    rows += [row_of(kind, [verdict for of_kind, verdict in everything if of_kind == kind]) for kind in KINDS]
    rows.append(row_of("all", [verdict for _, verdict in everything]))
    head = ["", "mutants", "killed", "refused", "same code", "equivalent", "survived", "score"]
    for row in [head, *rows]:
        print(f"{row[0]:<50}" + "".join(f"{cell:>11}" for cell in row[1:]))
    return rows, survivors, stale


def chosen(subjects, count, only):
    """File -> mutants to run. The names are hashes: the first of them in order are as good as drawn, and the same each time."""
    names = [mutant.name for subject in subjects for mutant in subject.mutants]
    drawn = set(sorted(names)[:count]) & set(only or names)
    for name in set(only or ()) - drawn:
        raise BadInput(f"{name}: no such mutant here, expected a name that --list prints")
    return {subject.file: [mutant for mutant in subject.mutants if mutant.name in drawn] for subject in subjects}


def draw_of(build):
    """Changes with every test that judges."""
    sources = sorted({source for of_program in build.sources.values() for source in of_program})
    return digest_of(source.read_bytes() for source in sources)


def chosen_by_record(options, subjects, build):
    """File -> mutants of functions that the record does not have, and some of the others."""
    record = read_json(options.recorded, None)
    if record is None:
        raise BadInput(f"{options.recorded}: no such file, expected the record of a whole run (./dev mutants --all --record)")
    functions, changed = changed_since(record, subjects)
    for function in functions:
        print(f"CHANGED   {function}")
    again = drawn_again(options.again, record, subjects, changed, draw_of(build))
    count = sum(map(len, changed.values()))
    drawn = sorted((mutant.name for of_file in changed.values() for mutant in of_file))[:options.sample]
    print(f"{len(functions)} functions changed since the record of {record['made']['commit'][:8]} with {count} mutants, {len(drawn)} of them run; "
          f"{len(again)} drawn from the others")
    open_names = {*(survivor["name"] for survivor in record["survivors"]), *record["not_judged"]} if options.record else set()
    wanted = {*drawn, *open_names, *(mutant.name for mutant in again)}
    return {subject.file: [mutant for mutant in subject.mutants if mutant.name in wanted] for subject in subjects}


def judged(options, rooms, results_path):
    """Generates, runs and shows. Returns (survivors, stale reasons)."""
    subjects = [Subject(room, file, rooms) for room, file in chosen_files(options, rooms)]
    subjects = [subject for subject in subjects if subject.mutants]
    wanted = chosen(subjects, options.sample, options.only) if not options.changed else {}
    if options.list:
        for mutant in (mutant for subject in subjects for mutant in wanted[subject.file]):
            print(f"{mutant.name}  {mutant.place}: {mutant.change}")
        print(f"{sum(map(len, wanted.values()))} mutants")
        return [], []
    started = time.monotonic()
    build = Build(options.build.resolve(), sorted({program for subject in subjects for program, _ in subject.judges}))
    limits, programs = examine_judges(build, subjects)
    if options.changed:
        wanted = chosen_by_record(options, subjects, build)
    results = {} if options.anew else read_json(results_path, {})
    for subject in subjects:
        subject.prepare(build, programs, results.get(subject.file, {}))
        for name in options.only or ():
            subject.verdicts.pop(name, None)
    def keep():
        write_json(results_path, {**results, **{subject.file: subject.kept() for subject in subjects}})
    if options.kept:
        wanted = {subject.file: [mutant for mutant in wanted[subject.file] if mutant.name in subject.verdicts] for subject in subjects}
    count = run(Runner(build, limits), subjects, wanted, keep, options.jobs)
    reasons = read_reasons(ROOT / HERE / "equivalent.json")
    rows, survivors, stale = show(subjects, wanted, reasons)
    passes = not survivors and not stale
    print(f"{rows[-1][1]} mutants, {count} of them run now in {time.monotonic() - started:.0f} s; killed {rows[-1][2]}, survived "
          f"{len(survivors)}, stale reasons {len(stale)}, score {rows[-1][-1]}: {'pass' if passes else 'FAIL'}")
    if options.json:
        fields = ("name", "mutants", "killed", "refused", "same_code", "equivalent", "survived", "score")
        write_json(options.json, {"rows": [dict(zip(fields, row)) for row in rows], "pass": passes,
                                  "survivors": [f"{mutant.name} {mutant.place}: {mutant.change}" for mutant in survivors]})
    if options.record:
        fresh = record_of(subjects, reasons, made_by(ROOT))
        write_json(options.recorded, updated(read_json(options.recorded, None), fresh) if options.changed else fresh)
    return survivors, stale


def self_test(options):
    """A suite that checks lets nothing survive; one that calls everything and checks nothing lets something, which the record names."""
    good = True
    options.file = options.room = options.sample = options.only = options.json = None
    for suite, record, is_updated in (("seeing", None, False), ("blind", None, False), ("blind", "other", False), ("blind", "same", False),
                                      ("blind", "other", True), ("blind", "same", True)):
        with tempfile.TemporaryDirectory(prefix="mutants-") as folder:
            options.changed, options.record, options.again = record is not None, record is None or is_updated, 0
            options.recorded = pathlib.Path(folder) / "record.json"
            if record:
                write_json(options.recorded, fixture_record(record))
            survivors, _ = judged(options, {suite: FIXTURES[suite]}, pathlib.Path(folder) / "results.json")
            written = read_json(options.recorded, {})
        named = len(written["survivors"])
        expected = suite == "blind" and record != "same"
        # An update names who judged what has changed, and keeps the rest as it is.
        of = [entry["functions"] for entry in written["made"].get("since", [])]
        held = bool(survivors) == expected and (named == len(survivors) or record and not is_updated) and bool(of) == (is_updated and record == "other")
        held = held and written["made"]["commit"] == ("0" * 40 if record else written["made"]["commit"]) and not written["not_judged"]
        # Mutants of the header's function are seen in the batch of the suite alone.
        in_batch = sum(counts.get("killed", 0) for counts in written["files"][f"{FIXTURE}/subject.hpp"].values()) if suite == "seeing" else 6
        held = held and in_batch == 6
        print(f"{'pass' if held else 'FAIL'}  fixture {suite}{f', record of the {record} function' if record else ''}{', updated' if is_updated else ''}: "
              f"{len(survivors)} mutants survive, expected {'some' if expected else 'none'}; the record names {named}")
        good = good and held
    return 0 if good else 1


def fixture_record(of):
    """The record of the fixture as it is, or as if its function had changed since."""
    subjects = [Subject("blind", f"{FIXTURE}/{name}", {"blind": FIXTURES["blind"]}) for name in ("subject.cpp", "subject.hpp")]
    for subject in subjects:
        subject.verdicts = {mutant.name: "killed" for mutant in subject.mutants}
    record = record_of(subjects, {}, {"commit": "0" * 40})
    if of == "other":
        record["files"] = {file: {key + "0": counts for key, counts in functions.items()} for file, functions in record["files"].items()}
    return record


def parsed(arguments):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter, prog="./dev mutants")
    parser.add_argument("--all", action="store_true", help="every room")
    parser.add_argument("--room", action="append", choices=sorted(ROOMS), help="this room; may be given again")
    parser.add_argument("--file", action="append", help="this file of a room, as a path in the tree; may be given again")
    parser.add_argument("--sample", type=int, metavar="N", help="only N of the mutants, the same ones each time")
    parser.add_argument("--only", action="append", metavar="NAME", help="only the mutant of this name, judged anew; may be given again")
    parser.add_argument("--list", action="store_true", help="print the mutants, build and run nothing")
    parser.add_argument("--changed", action="store_true", help="functions whose text the record does not have; with --sample at most so many mutants")
    parser.add_argument("--again", type=int, default=0, metavar="N", help="with --changed: N mutants of the others too, another draw after each change of a test")
    parser.add_argument("--record", action="store_true", help="with --all: write the record that --changed and the evidence read; with --changed: bring it up to date")
    parser.add_argument("--kept", action="store_true", help="with --all --record: run nothing more; the record names what was not judged yet")
    parser.add_argument("--recorded", type=pathlib.Path, default=RECORD, help="the record that --changed reads and --record writes")
    parser.add_argument("--anew", action="store_true", help="forget all kept verdicts")
    parser.add_argument("--jobs", type=int, default=2, help="mutants at the same time (default 2)")
    parser.add_argument("--json", type=pathlib.Path, help="write score and survivors to this file (--all: build/mutants/score.json)")
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build/product", help="configured build tree (default build/product)")
    parser.add_argument("--self-test", action="store_true", help="show that the run fails where it must")
    options = parser.parse_args(arguments)
    if not (options.all or options.room or options.file or options.self_test or options.changed):
        parser.error("nothing to do, expected --all, --changed, --room, --file or --self-test")
    if options.record and (not (options.all or options.changed) or options.sample or options.only or options.room or options.file):
        parser.error("--record: expected --all or --changed and no choice of mutants")
    if options.kept and not (options.record and options.all):
        parser.error("--kept: expected --all --record beside it")
    if options.changed and (options.only or options.list):
        parser.error("--changed: chooses the mutants itself, expected neither --only nor --list")
    if options.all and not (options.json or options.sample or options.only or options.changed):
        options.json = ROOT / "build/mutants/score.json"
    return options


def main(arguments):
    options = parsed(arguments)
    try:
        if options.self_test:
            return self_test(options)
        survivors, stale = judged(options, ROOMS, ROOT / "build/mutants/results.json")
    except (BadInput, NotRead) as error:
        print(error, file=sys.stderr)
        return 2
    except KeyboardInterrupt:
        print("\nstopped; what was judged is kept, the same command goes on", file=sys.stderr)
        return 1
    return 1 if survivors or stale else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
