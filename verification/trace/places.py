"""Where code names a requirement, and which function that is: the place that realises it, for the gate `realised` and the evidence pages."""
import pathlib
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "gates"))
from common import PRODUCT_FOLDERS, files, functions, read, without_comments  # noqa: E402
from generate_ids import UID  # noqa: E402

# Documents about the machinery: their code is in verification.
MACHINERY = ("conformance", "firmware", "target", "verification")
TEXT = (".md", ".dcf", ".eds", ".yaml", ".json")
CPP = (".cpp", ".hpp")


def below(path, folder):
    return path == folder or path.startswith(folder + "/")


def naming_lines(root, folders):
    """Id -> (file of code, line) of each place that names it."""
    found = {}
    for name in files(root, under=folders):
        # The generated headers of ids and the registry name every id; a test shows a requirement and does not realise it.
        if below(name, "verification/trace") or name.endswith((*TEXT, "_test.cpp")):
            continue
        for number, line in enumerate(read(root, name).splitlines(), start=1):
            for uid in re.findall(rf"\b{UID.pattern}\b", line):
                found.setdefault(uid, []).append((name, number))
    return found


def told_paths(requirement):
    """The files and folders of the field REALISED."""
    return [path.strip() for path in requirement.fields.get("REALISED", "").split(",") if path.strip()]


class Place:
    """One place that realises a requirement: a line, and the function around or below it (None: the file says it of no function)."""

    def __init__(self, path, line, function=None):
        self.path, self.line, self.function = path, line, function


class Functions:
    """The functions of each file, read once."""

    def __init__(self, root):
        self.root, self.texts, self.found = root, {}, {}

    def text(self, path):
        if path not in self.texts:
            self.texts[path] = read(self.root, path)
        return self.texts[path]

    def of(self, path):
        if path not in self.found:
            self.found[path] = sorted(functions(self.text(path)), key=lambda function: function.first_line) if path.endswith(CPP) else []
        return self.found[path]

    def around(self, path, line):
        return next((function for function in self.of(path) if function.first_line <= line <= function.last_line), None)

    def place(self, path, line):
        """What a comment at this line speaks of: the function around it, the one below it, or the one that is declared there; in a header
        with a source of the same name, else that source."""
        around = self.around(path, line)
        if around or not path.endswith(CPP):
            return Place(path, line, around)
        code = without_comments(self.text(path)).splitlines()
        first = line if code[line - 1].strip() else next((number for number in range(line + 1, len(code) + 1) if code[number - 1].strip()), line)
        below_it = self.around(path, first)
        if below_it:
            return Place(path, line, below_it)
        statement = re.split(r"[;{]", "\n".join(code[first - 1:first + 11]))[0]
        name = re.search(r"([~\w]+)\s*\(", statement)
        source = re.sub(r"\.hpp$", ".cpp", path)
        if source != path and (self.root / source).is_file():
            named = [function for function in self.of(source) if name and function.name.split("::")[-1] == name.group(1)]
            return Place(source, named[0].first_line, named[0]) if named else Place(source, 1)
        return Place(path, line)


def places_of(root, requirements, known_functions):
    """Id -> places in code that name it, those of the product first; the folders and files of REALISED are told by told_paths."""
    product, machinery = naming_lines(root, PRODUCT_FOLDERS), naming_lines(root, ("verification",))
    found = {}
    for uid, requirement in requirements.items():
        of_machinery = pathlib.PurePosixPath(requirement.path).stem in MACHINERY
        lines = product.get(uid, []) + (machinery.get(uid, []) if of_machinery else [])
        unique = {}
        for path, line in lines:
            place = known_functions.place(path, line)
            # A header that declares what a source defines: both.
            for one in [place] if place.path == path else [place, Place(path, line)]:
                unique.setdefault((one.path, one.function.first_line if one.function else one.line), one)
        found[uid] = list(unique.values())
    return found
