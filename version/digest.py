#!/usr/bin/env python3
"""The digest of the objects of core and channels in a build folder.

    digest.py BUILD TEMPLATE FILE     writes FILE: TEMPLATE with the first digits of the digest for @COUNTERPOINT_OBJECTS@

`counterpoint --version` and the firmware images tell these digits, evidence and release the whole digest: what was measured is what
is there. The same commit, compilers and options give the same digest in any folder. [SRS_VER_140]
"""
import hashlib
import pathlib
import subprocess
import sys
import tempfile

# Room, archive in the build folder. The digest goes over the objects in this order.
CERTIFIED = [("safety_core/comparator", "safety_core/comparator/libsafety_core_comparator.a"),
             ("safety_core/kernel", "safety_core/kernel/libsafety_core_kernel.a"),
             ("safety_core/selftest", "safety_core/selftest/libsafety_core_selftest.a"),
             ("safety_core/crosslink", "safety_core/crosslink/libsafety_core_crosslink.a"),
             ("hal/api", "hal/api/libhal_api.a"),
             ("channel_a", "channel_a/libchannel_a.a"),
             ("channel_b", "channel_b/libchannel_b.a")]
TOLD_DIGITS = 16


class BadInput(Exception):
    """Input that cannot be used; the text names it."""


def archives(build, rooms=None):
    for room, path in rooms or CERTIFIED:
        archive = pathlib.Path(build) / path
        if not archive.is_file():
            raise BadInput(f"{archive}: not there, expected after the build")
        yield room, archive


def members(archive, tool="ar"):
    """Name and bytes of each object, in the order of the names."""
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([tool, "x", str(archive.resolve())], cwd=folder, check=True)
        return [(path.name, path.read_bytes()) for path in sorted(pathlib.Path(folder).iterdir())]


def digest(build):
    """SHA-256 over room, name and bytes of every object."""
    total = hashlib.sha256()
    count = 0
    for room, archive in archives(build):
        for name, content in members(archive):
            total.update(f"{room}/{name}:{hashlib.sha256(content).hexdigest()}\n".encode())
            count += 1
    return total.hexdigest(), count


def told(value):
    """The digits of a digest that programs tell."""
    return value[:TOLD_DIGITS]


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    template = pathlib.Path(sys.argv[2]).read_text(encoding="utf-8")
    pathlib.Path(sys.argv[3]).write_text(template.replace("@COUNTERPOINT_OBJECTS@", told(digest(sys.argv[1])[0])), encoding="utf-8")
