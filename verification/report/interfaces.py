"""The page of interfaces: which room uses which other one, through which headers, and what these offer; from what the rooms declare (DEPENDS) and what
their files include. Nothing is written by hand."""
import pathlib
import re
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "gates"))
from common import PRODUCT_FOLDERS, files, outline, read, without_comments  # noqa: E402

ROOM = re.compile(r"\bcounterpoint_room\(([^)]*)\)")
INCLUDE = re.compile(r'^\s*#include "([^"]+)"', re.MULTILINE)
ENUMERATION = re.compile(r"^enum class (\w+)", re.MULTILINE)
FREE = re.compile(r"^(?!using|return|typedef|static_assert|friend)[\[\]\w:<>,&* ]+[ &*](\w+)\([^;{}]*\)[^;{}()]*[;{]", re.MULTILINE)
# Examples show how to use the rooms and are none of the architecture.
FOLDERS = [folder for folder in PRODUCT_FOLDERS if folder != "examples"]


class Rooms:
    """Folder of each room -> rooms that it declares, as folders; a folder may hold several rooms."""

    def __init__(self, root):
        self.root, self.folders, declared = root, {}, {}
        for name in files(root, "CMakeLists.txt", under=FOLDERS):
            folder = name.rpartition("/")[0]
            for inside in ROOM.findall(re.sub(r"#[^\n]*", "", read(root, name))):
                words = inside.split()
                self.folders[words[0]] = folder
                declared.setdefault(folder, []).extend(words[words.index("DEPENDS") + 1:] if "DEPENDS" in words else [])
        self.declared = {folder: sorted({self.folders[word] for word in words if word in self.folders} - {folder}) for folder, words in declared.items()}

    def of(self, name):
        """The room of a file: the nearest folder around it that is one."""
        folder = name
        while "/" in folder:
            folder = folder.rpartition("/")[0]
            if folder in self.declared:
                return folder
        return ""

    def reached(self, room):
        """What a room declares, and what that declares."""
        found, open_ones = set(), [room]
        while open_ones:
            for other in self.declared[open_ones.pop()]:
                if other not in found:
                    found.add(other)
                    open_ones.append(other)
        return found


def offered(text):
    """Types of a header, and its functions that belong to none."""
    code = without_comments(text)
    found = [one for one in outline(text)[1] if one.name]
    names = {one.name for one in found}
    classes = {one.name for one in found if not names & set(one.scopes)}
    return sorted(classes | set(ENUMERATION.findall(code))) + sorted(set(FREE.findall(code)))


def uses(root, rooms):
    """(room, other room) -> headers of the other one that files of the first include."""
    found = {}
    for name in files(root, "*.cpp", "*.hpp", "*.in", under=FOLDERS):
        mine = rooms.of(name)
        for header in INCLUDE.findall(read(root, name)) if mine else []:
            theirs = rooms.of(header)
            if theirs and theirs != mine and (root / header).is_file():
                found.setdefault((mine, theirs), set()).add(header)
    return found


def page_of(root):
    """What the template needs, and the gaps."""
    rooms = Rooms(root)
    used = uses(root, rooms)
    gaps = [f"interfaces: {mine} includes {min(headers)} of {theirs}, which it does not declare" for (mine, theirs), headers in sorted(used.items())
            if theirs not in rooms.reached(mine)]
    headers = sorted({header for one in used.values() for header in one})
    offers = {header: offered(read(root, header)) for header in headers}
    rows = [{"room": room, "other": other, "headers": sorted(used.get((room, other), ())), "declared": other in rooms.declared[room]}
            for room in sorted(rooms.declared) for other in sorted({*rooms.declared[room], *(theirs for mine, theirs in used if mine == room)})]
    return {"rows": rows, "offers": offers, "rooms": sorted(rooms.declared), "users": users(used)}, gaps


def users(used):
    """Header -> rooms that include it."""
    found = {}
    for (mine, _), headers in used.items():
        for header in headers:
            found.setdefault(header, []).append(mine)
    return {header: sorted(rooms) for header, rooms in sorted(found.items())}
