#!/usr/bin/env python3
"""Each requirement is named in the code that realises it, or its field REALISED names the files and folders that do. A requirement of the
document `channel` needs that for channel A and for channel B. An id in the code that no requirement has is a finding, and so is a list of
ids that is not written out (SRS_AREA_001, -002): who searches for the second one does not find it."""
import pathlib
import re
import sys

HERE = pathlib.Path(__file__).resolve()
sys.path.insert(0, str(HERE.parents[1]))
sys.path.insert(0, str(HERE.parents[2] / "trace"))
from common import PRODUCT_FOLDERS, files, read, run_gate  # noqa: E402
from generate_ids import BadInput, UID, read_requirements  # noqa: E402
from places import MACHINERY, TEXT, below, naming_lines, told_paths  # noqa: E402

CHANNELS = ("channel_a", "channel_b")
SHORTENED = re.compile(rf"{UID.pattern}(?:, ?-|-|\.\.)[0-9]+")


def naming(root, folders):
    """Id -> files of code that name it."""
    return {uid: {name for name, _ in lines} for uid, lines in naming_lines(root, folders).items()}


def shortened(root):
    """Lists of ids in the code that are not written out."""
    for name in files(root, under=(*PRODUCT_FOLDERS, "verification", "tests")):
        if name.endswith(TEXT) or below(name, "verification/gates"):
            continue
        for match in SHORTENED.finditer(read(root, name)):
            yield f"{name}: {match.group(0)}, expected each id written out"


def told(root, requirement):
    """The paths of REALISED, and what is wrong with them."""
    paths = told_paths(requirement)
    wrong = [path for path in paths if not (root / path).exists() or not any(below(path, folder) for folder in (*PRODUCT_FOLDERS, "verification"))]
    return paths, [f"REALISED names '{path}', expected a file or folder of the product or of verification" for path in wrong]


def gate(root, _data):
    try:
        requirements = read_requirements(root)
    except BadInput as problem:
        return [str(problem)], "files that cannot be read"
    product, machinery = naming(root, PRODUCT_FOLDERS), naming(root, ("verification",))
    findings = list(shortened(root))
    for uid, requirement in requirements.items():
        where = f"{requirement.path}:{requirement.line}: {uid}"
        document = pathlib.PurePosixPath(requirement.path).stem
        paths, wrong = told(root, requirement)
        findings += [f"{where}: {problem}" for problem in wrong]
        named = product.get(uid, set()) | (machinery.get(uid, set()) if document in MACHINERY else set())
        for room in CHANNELS if document == "channel" else [""]:
            if not any(not room or below(path, room) for path in [*named, *paths]):
                findings.append(f"{where}: named by no code{' of ' + room if room else ''}, expected its id there or the place in REALISED")
    for uid, names in sorted((product | machinery).items()):
        if uid not in requirements and uid.split("_")[1] != "AREA":
            findings.append(f"{sorted(names)[0]}: names {uid}, which is no requirement")
    return findings, f"{len(requirements)} requirements, {sum('REALISED' in requirement.fields for requirement in requirements.values())} with REALISED"


run_gate(gate)
