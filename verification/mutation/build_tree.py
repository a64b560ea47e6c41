"""How mutants are built and run: what a configured build tree knows of its sources and programs."""
import hashlib
import os
import pathlib
import re
import shlex
import signal
import subprocess
import sys

MEMORY_LIMIT_BYTES = 2**31
# Of a program that waits instead of running. Others are limited by processor time: a busy machine makes them wait, and that is no
# verdict.
TIME_LIMIT_S = 1800
# What ends a program from outside: a system without memory, a batch system, a person. What it would have said is not known by that.
FROM_OUTSIDE = (-signal.SIGKILL, -signal.SIGTERM, -signal.SIGINT, -signal.SIGHUP)
MOST_TRIES = 3
# A mutant is compiled once: nobody asks for it again.
QUIET = dict(os.environ, CCACHE_DISABLE="1")


class BadInput(Exception):
    """Arguments, a list of mutants or a build tree that cannot be used."""


def is_batch(source):
    """Whether CMake made the source, of several tests that are compiled at once."""
    return str(source).endswith(".cxx")


class Build:
    """What the build tree knows: how a source is compiled and how a program (named by its place in the tree) is linked."""

    def __init__(self, folder, programs):
        self.folder = folder
        if not (folder / "build.ninja").exists():
            raise BadInput(f"{folder}: no build.ninja, expected a configured build tree")
        done = subprocess.run(["ninja", "-C", str(folder), "-j2", *programs], capture_output=True, text=True, check=False)
        if done.returncode != 0:
            raise BadInput(f"{folder}: the programs do not build:\n{done.stdout}{done.stderr}")
        self.compile = {}
        self.sources = {}  # Of each program.
        self.link = {}
        for program in programs:
            commands = subprocess.run(["ninja", "-C", str(folder), "-t", "commands", program], capture_output=True,
                                      text=True, check=True).stdout.splitlines()
            found = {pathlib.Path(source.group(1)).resolve(): source.string
                     for source in (re.search(r" -c (\S+\.(?:cpp|cxx))$", line) for line in commands) if source}
            self.sources[program] = set(found)
            self.compile.update(found)
            self.link[program] = next(line for line in reversed(commands) if f" -o {program} " in line)

    def compile_mutated(self, source, copy, work):
        """Compiles `copy` in place of `source`; headers below `work` come first. Returns object and text of the compiler."""
        words = shlex.split(self.compile[source])
        target = work / (hashlib.sha256(str(source).encode()).hexdigest()[:8] + "_" + copy.stem + ".o")
        words = [word for word in words if word != "-Werror"]
        words[words.index("-c") + 1] = str(copy)
        words[words.index("-o") + 1] = str(target)
        for option, value in (("-MT", str(target)), ("-MF", str(target) + ".d")):
            if option in words:
                words[words.index(option) + 1] = value
        # Without debug information, which holds the path of the copy: equal code is then an equal object.
        words[words.index("-c"):words.index("-c")] = ["-w", "-g0"]
        # Behind the compiler's name, which the launcher of channel B wants in its place.
        first_option = next(i for i, word in enumerate(words) if word.startswith("-"))
        words.insert(first_option, f"-I{work}")
        done = subprocess.run(words, cwd=self.folder, capture_output=True, text=True, check=False, env=QUIET)
        return (target if done.returncode == 0 else None), done.stderr

    def link_mutated(self, program, objects, work):
        """Links the program with these objects (by source): in place of its own, before the libraries that hold the others."""
        line = self.link[program].replace(": && ", "", 1).replace(" && :", "", 1)
        words = shlex.split(line)
        target = work / pathlib.PurePath(program).name
        words[words.index("-o") + 1] = str(target)
        for source in self.sources[program] & set(objects):
            own = re.search(r" -o (\S+)", self.compile[source]).group(1)
            place = words.index(own) if own in words else next(i for i, word in enumerate(words) if word.endswith(".o"))
            words[place:place + (own in words)] = [str(objects[source])]
        words.append("-Wl,-s")  # Nobody debugs it, and it is linked once.
        done = subprocess.run(words, cwd=self.folder, capture_output=True, text=True, check=False, env=QUIET)
        return (target if done.returncode == 0 else None), done.stderr


def ended(program, arguments, processor_limit_s):
    """The program when it has ended by itself, or by a limit: of these the first is a signal that nobody outside sends."""
    limits = [f"--as={MEMORY_LIMIT_BYTES}", f"--cpu={processor_limit_s}:{processor_limit_s + 5}"]
    for _ in range(MOST_TRIES):
        done = subprocess.run(["prlimit", *limits, str(program), *arguments], capture_output=True, text=True, errors="replace", check=False,
                              timeout=TIME_LIMIT_S)
        if done.returncode not in FROM_OUTSIDE:
            return done
    raise BadInput(f"{program}: it was ended {MOST_TRIES} times from outside (signal {-done.returncode}), expected that it may run until its end")


def run_program(program, arguments, processor_limit_s):
    """Returns (killed, what it said). A mutant that eats time or memory is stopped, which kills it as well; one that somebody else
    stops is tried again. [SRS_VER_174]"""
    try:
        done = ended(program, arguments, processor_limit_s)
    except subprocess.TimeoutExpired:
        return True, f"no end within {TIME_LIMIT_S} s"
    if done.returncode == 0:
        return False, ""
    said = re.search(r"killed: (.*)|\[  FAILED  \] (\S+)", done.stdout)
    return True, (next(group for group in said.groups() if group) if said else f"status {done.returncode}")


def progress(done, count):
    if sys.stderr.isatty():
        filled = 40 * done // count
        sys.stderr.write(f"\r[{'#' * filled}{' ' * (40 - filled)}] {done} of {count} mutants" + ("\n" if done == count else ""))
        sys.stderr.flush()
