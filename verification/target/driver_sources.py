"""Whether the tests of the drivers run the sources that are in the image: by what both builds compile and link."""
import hashlib
import pathlib
import re
import shlex
import subprocess

ROOT = pathlib.Path(__file__).resolve().parents[2]
ARCHIVE = "hal/tms570/libhal_tms570.a"
PROGRAMS = ("tests/hal/tms570/hal_tms570_tests", "tests/integration/tms570/tms570_device_test")
# What the linker may put beside the drivers into a program that tests them.
MODELS = "verification/models/tms570/"
FEWEST = 20


def commands_of(build, target):
    text = subprocess.run(["ninja", "-C", str(build), "-t", "commands", target], check=True, capture_output=True, text=True).stdout
    return [shlex.split(line.split(" && ")[1] if line.startswith(": && ") else line) for line in text.splitlines()]


def compiled(build):
    """Source -> what its compiler is told beside warnings, optimisation and paths: definitions and files put before it."""
    result = {}
    for words in commands_of(build, ARCHIVE):
        if "-c" in words:
            source = pathlib.Path(words[words.index("-c") + 1]).relative_to(ROOT).as_posix()
            if source.startswith("hal/tms570/"):
                result[source] = [word for word in words if re.match(r"-D|-U|-include|-imacros", word)]
    return result


def linked_drivers(link_map):
    """Drivers in an image, from the linker's map."""
    members = re.findall(r"libhal_tms570\.a\(([\w.]+\.cpp)\.obj\)$", link_map.read_text(encoding="utf-8"), re.MULTILINE)
    # An archive knows no folders; no two drivers have one name.
    places = {path.name: path.relative_to(ROOT).as_posix() for path in (ROOT / "hal/tms570").rglob("*.cpp")
              if path.parent.name not in ("silicon", "start")}
    return {places.get(name, name) for name in members}


def tested(build, program):
    """The archives and objects of a test's link that may define a driver, and whether it compiles one by itself."""
    commands = commands_of(build, program)
    link = commands[-1]
    own = [words[words.index("-c") + 1] for words in commands if "-c" in words and "-o" in words
           and f"{pathlib.Path(program).name}.dir" in words[words.index("-o") + 1]]
    return [word for word in link if word.endswith(".a")], [pathlib.Path(path).relative_to(ROOT).as_posix() for path in own]


def differences(image, ours, theirs, links):
    """What is not the same. `image`: drivers in the image; sources of both builds; (archives, own sources) of each test."""
    wrong = []
    if len(image) < FEWEST:
        wrong.append(f"{len(image)} drivers in the image")
    wrong += [f"{name} is in the image, the host does not compile it" for name in sorted(image - theirs.keys())]
    wrong += [f"{name} is compiled for one of both only" for name in sorted(ours.keys() ^ theirs.keys())]
    wrong += [f"{name} is told {' '.join(ours[name] + theirs[name])}" for name in sorted(ours.keys() & theirs.keys()) if ours[name] or theirs[name]]
    for archives, own in links:
        if ARCHIVE not in archives:
            wrong.append(f"a test is linked without {ARCHIVE}")
        wrong += [f"a test compiles {name}" for name in own if name.startswith("hal/tms570/")]
        wrong += [f"a test is linked with {name}" for name in archives if "tms570" in name and name != ARCHIVE and not name.startswith(MODELS)]
    return wrong


def fixtures(image, ours, theirs, links):
    """The same with one thing wrong each: every one of them must be told."""
    first = min(image)
    yield image, ours, {name: told for name, told in theirs.items() if name != first}, links
    yield image, ours, dict(theirs, **{first: ["-DTEST=1"]}), links
    yield image, dict(ours, **{"hal/tms570/other.cpp": []}), theirs, links
    yield {first}, ours, theirs, links
    yield image, ours, theirs, [(["hal/tms570/libother_tms570.a"], links[0][1])]
    yield image, ours, theirs, [(links[0][0], [*links[0][1], first])]


def check(report, target, product, images):
    """One row for each image, and one for the fixtures."""
    ours, theirs = compiled(target), compiled(product)
    links = [tested(product, program) for program in PROGRAMS]
    for image in images:
        drivers = linked_drivers(image.with_name(image.name + ".map"))
        wrong = differences(drivers, ours, theirs, links)
        digest = hashlib.sha256("".join(hashlib.sha256((ROOT / name).read_bytes()).hexdigest() for name in sorted(drivers)).encode()).hexdigest()
        report.add(not wrong, f"drivers of {image.stem} are the sources that the tests of the drivers run",
                   "; ".join(wrong[:3]) or f"{len(drivers)} sources, SHA-256 {digest}", "SRS_FW_020")
    told = [len(differences(*fixture)) > 0 for fixture in fixtures(linked_drivers(images[0].with_name(images[0].name + ".map")), ours, theirs, links)]
    report.add(all(told), "another list, another definition or another archive is told", f"{sum(told)} of {len(told)}", "SRS_FW_020")
