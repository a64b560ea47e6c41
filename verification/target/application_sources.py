"""Whether the firmware examples are built from the sources of the applications that the host runs: by what both builds compile and link."""
import pathlib
import re

import driver_sources
import image_check

# Application -> its archive, the object in it, the programs of the host that run it.
APPLICATIONS = {"sensor": ("examples/sensor/libexamples_sensor.a", "sensor.cpp", ("examples/sensor/example_sensor", "verification/target/firmware/firmware_sensor_host")),
                "actuator": ("examples/actuator/libexamples_actuator.a", "actuator.cpp",
                             ("examples/actuator/example_actuator", "verification/target/firmware/firmware_actuator_host")),
                "own_device": ("examples/firmware/own_device/libfirmware_own_device.a", "own_application.cpp",
                               ("verification/target/firmware/firmware_own_device_host",))}


def compiled(build, archive):
    """Source -> definitions and files put before it, of all that goes into the archive from its folder."""
    result = {}
    for words in driver_sources.commands_of(build, archive):
        if "-c" in words:
            source = pathlib.Path(words[words.index("-c") + 1]).relative_to(driver_sources.ROOT).as_posix()
            if source.startswith(archive.rsplit("/", 1)[0]):
                result[source] = [word for word in words if re.match(r"-D|-U|-include|-imacros", word)]
    return result


def differences(device, members, ours, theirs, links):
    """What is not the same. `members`: objects of the image; sources of both builds; archives of each program of the host."""
    archive, name, _ = APPLICATIONS[device]
    folder = archive.rsplit("/", 1)[0]
    source = f"{folder}/{name}"
    wrong = [] if f"{archive}({name}.obj)" in members else [f"the image is linked without {name} of {archive}"]
    wrong += [f"{source} is not compiled for both"] if source not in ours or source not in theirs else []
    wrong += [f"{place} is compiled for one of both only" for place in sorted(ours.keys() ^ theirs.keys())]
    wrong += [f"{place} is told {' '.join(ours[place] + theirs[place])}" for place in sorted(ours.keys() & theirs.keys()) if ours[place] or theirs[place]]
    return wrong + [f"a program of the host is linked without {archive}" for archives in links if archive not in archives]


def fixtures(device, members, ours, theirs, links):
    """The same with one thing wrong each: every one of them must be told."""
    archive, name, _ = APPLICATIONS[device]
    source = f"{archive.rsplit('/', 1)[0]}/{name}"
    yield members - {f"{archive}({name}.obj)"}, ours, theirs, links
    yield members, {place: told for place, told in ours.items() if place != source}, theirs, links
    yield members, {place.replace(name, "other.cpp"): told for place, told in ours.items()}, theirs, links
    yield members, dict(ours, **{source: ["-DTARGET=1"]}), theirs, links
    yield members, ours, theirs, [[place for place in archives if place != archive] for archives in links]


def check(report, target, product, folder):
    """One row for each application and one for the fixtures. `folder`: the images."""
    told = []
    for device, (archive, _, programs) in APPLICATIONS.items():
        found = (image_check.members_of(folder / f"{device}_be32.elf"), compiled(target, archive), compiled(product, archive),
                 [driver_sources.commands_of(product, program)[-1] for program in programs])
        wrong = differences(device, *found)
        report.add(not wrong, f"the application of {device} is the source that the host runs", "; ".join(wrong[:3]) or ", ".join(sorted(found[1])), "SRS_FW_008")
        told += [bool(differences(device, *fixture)) for fixture in fixtures(device, *found)]
    report.add(all(told), "an application of another source, of another definition, or not linked is told", f"{sum(told)} of {len(told)}", "SRS_FW_008")
