"""What the gates share: which files they look at, C++ without comments, and how a gate speaks.

A gate is verification/gates/<name>/gate.py ROOT DATA. ROOT is the tree to look at, DATA the folder of collected results
(build/evidence/data for the tree itself). It prints one finding a line, `file:line: what is wrong, what was expected`.
Exit status: 0 nothing found, 1 findings, 2 the gate could not look (then nothing is shown, which is no success either).
"""
import pathlib
import re
import subprocess
import sys

SAFETY_ROOMS = ("safety_core/contract", "safety_core/comparator", "safety_core/kernel", "safety_core/selftest", "safety_core/crosslink", "channel_a", "channel_b")
MISRA_ROOMS = ("safety_core", "channel_a", "channel_b", "hal")
# A case of GoogleTest: its suite, its name.
TEST_CASE = re.compile(r"\b(?:TYPED_)?TEST(?:_[FP])?\(\s*(\w+),\s*(\w+)\s*\)")
PRODUCT_FOLDERS = ("safety_core", "channel_a", "channel_b", "hal", "canopen", "runtime", "simulator", "examples", "tools", "version", "names")


class CannotLook(Exception):
    """The gate has nothing to look at; the text says what was expected where."""


def run_gate(gate):
    """Runs gate(root, data), which returns (findings, what was looked at), and ends the program."""
    if len(sys.argv) != 3:
        print(f"usage: {sys.argv[0]} ROOT DATA", file=sys.stderr)
        sys.exit(2)
    try:
        findings, looked_at = gate(pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve())
    except CannotLook as problem:
        print(f"cannot look: {problem}")
        sys.exit(2)
    for finding in findings:
        print(finding)
    print(f"{len(findings)} findings; looked at {looked_at}")
    sys.exit(1 if findings else 0)


def files(root, *patterns, under=None):
    """Files of the tree as paths below root, fixtures of gates left out: they are wrong on purpose.

    In a repository: what git tracks or would track. Elsewhere (fixtures): every file.
    """
    if (root / ".git").exists():
        output = subprocess.run(["git", "-c", "safe.directory=*", "-C", str(root), "ls-files", "-z", "--cached", "--others", "--exclude-standard"],
                                check=True, capture_output=True, text=True).stdout
        names = sorted(name for name in output.split("\0") if name)
    else:
        names = sorted(path.relative_to(root).as_posix() for path in root.rglob("*") if path.is_file())
    chosen = []
    for name in names:
        path = pathlib.PurePosixPath(name)
        if re.match(r"verification/gates/[^/]+/fixture/", name) or not (root / name).is_file():
            continue
        if patterns and not any(path.match(pattern) for pattern in patterns):
            continue
        if under and not any(name == folder or name.startswith(folder + "/") for folder in under):
            continue
        chosen.append(name)
    return chosen


def cpp_files(root, under):
    chosen = files(root, "*.cpp", "*.hpp", under=under)
    if not chosen:
        raise CannotLook(f"no C++ file below {', '.join(under)} in {root.name}")
    return chosen


def read(root, name):
    return (root / name).read_text(encoding="utf-8", errors="replace")


def table_rows(text):
    """(line, header, cells) of each row of each table of a document."""
    header = []
    for number, line in enumerate(text.splitlines(), start=1):
        cells = [cell.strip() for cell in re.split(r"(?<!\\)\|", line)[1:-1]]
        if not cells:
            header = []
        elif not header:
            header = cells
        elif not set(cells[0]) <= set("-: "):
            yield number, header, cells


TOKEN = re.compile(r"""
    (?P<comment>//[^\n]*|/\*.*?\*/)
  | (?P<raw>R"(?P<delimiter>[^()\s\\]{0,16})\(.*?\)(?P=delimiter)")
  | (?P<string>"(?:\\.|[^"\\\n])*")
  | (?P<character>(?<![0-9A-Fa-f])'(?:\\.|[^'\\\n])+')
""", re.VERBOSE | re.DOTALL)


def without_comments(text, keep_strings=False):
    """The same number of lines and columns, comments (and the insides of literals) blanked."""
    def blank(match):
        found = match.group(0)
        if match.lastgroup == "comment" or match.group("comment"):
            return re.sub(r"[^\n]", " ", found)
        if keep_strings:
            return found
        return found[0] + re.sub(r"[^\n]", " ", found[1:-1]) + found[-1]
    return TOKEN.sub(blank, text)


class Class:
    def __init__(self, name, line, scopes):
        self.name = name
        self.line = line
        self.scopes = scopes
        self.methods = 0  # Member functions, constructors and operators, defaulted and deleted ones left out.


class Function:
    def __init__(self, name, first_line, last_line, signature, scopes):
        self.name = name
        self.first_line = first_line
        self.last_line = last_line
        self.signature = signature
        self.scopes = scopes  # Names of the namespaces and classes around it, the outermost first; "" without a name.

    @property
    def length(self):
        return self.last_line - self.first_line + 1


BODY = re.compile(r"\)\s*(?:(?:const\b|noexcept\b(?:\s*\([^()]*\))?|override\b|final\b|&&?|->\s*[\w:<>,&*()\s]+)\s*)*"
                  r"(?::(?!:).*)?$", re.DOTALL)
SCOPE = re.compile(r"\b(?:namespace|class|struct|union|enum|extern)\b")
NAMED_SCOPE = re.compile(r"\b(namespace|class|struct|union)\s+(?:\[\[.*?\]\]\s*)?([\w:]+)")
NO_METHOD = re.compile(r"\b(?:friend|using|typedef|static_assert|alignas)\b|=\s*(?:default|delete)\s*$")


def is_method(declaration):
    """Whether a member's declaration is a function's: a name and a parenthesis once template arguments and initialisers are gone."""
    bare = re.sub(r"\[\[.*?\]\]", "", declaration, flags=re.DOTALL)
    while re.search(r"<[^<>]*>", bare):
        bare = re.sub(r"<[^<>]*>", "", bare)
    head = re.split(r"\{|(?<!operator)(?<![=!])=", bare)[0]
    return not NO_METHOD.search(bare) and bool(re.search(r"[~\w]+\s*\(|\boperator\b", head))


def functions(text):
    """Function definitions of a C++ text, lambdas counted with the function they stand in."""
    return outline(text)[0]


def outline(text):
    """Function definitions of a C++ text, lambdas counted with the function they stand in, and its classes."""
    code = re.sub(r"(?m)^[ \t]*#.*?(?<!\\)$", lambda m: " " * len(m.group(0)), without_comments(text))
    found = []
    classes = []
    stack = []          # of "scope" (with its class or its name), "body" (with its start) or "init"
    segment_start = 0   # where the declaration that may open a brace begins
    line_starts = [0] + [match.end() for match in re.finditer(r"\n", code)]

    def line_of(offset):
        low, high = 0, len(line_starts)
        while high - low > 1:
            middle = (low + high) // 2
            if line_starts[middle] <= offset:
                low = middle
            else:
                high = middle
        return low + 1

    def scope_names():
        scopes = [scope.name if isinstance(scope, Class) else scope for kind, scope, _ in stack if kind == "scope"]
        return [part for scope in scopes for part in scope.split("::")]

    for match in re.finditer(r"[{};]", code):
        offset, character = match.start(), match.group(0)
        inside_body = any(kind == "body" for kind, _, _ in stack)
        own = stack[-1][1] if stack and isinstance(stack[-1][1], Class) else None
        if character == "{":
            segment = code[segment_start:offset]
            segment = re.sub(r"\b(?:public|private|protected)\s*:(?!:)", lambda m: " " * len(m.group(0)), segment)
            stripped = segment.lstrip()
            begin = segment_start + len(segment) - len(stripped)
            flat = re.sub(r"\{[^{}]*\}", "()", stripped)
            if inside_body:
                stack.append(("inner", begin, flat))
            elif flat.endswith(("=", ",", "(")) or re.search(r"=\s*[\w:<>]*\s*$", flat):
                stack.append(("init", begin, flat))
                continue
            elif "(" in flat and BODY.search(flat) and not re.search(r":\s*(?:[\w:<>]+\([^()]*\)\s*,\s*)*[\w:<>]+\s*$", flat):
                stack.append(("body", begin, flat))
                if own is not None and is_method(flat):
                    own.methods += 1
            elif SCOPE.search(flat) and "(" not in re.sub(r"\balignas\s*\(.*?\)|\[\[.*?\]\]", "", flat):
                named = NAMED_SCOPE.search(flat)
                scope = named.group(2) if named else ""
                if named and named.group(1) != "namespace" and not re.search(r"\benum\b", flat):
                    scope = Class(scope, line_of(begin), scope_names())
                    classes.append(scope)
                stack.append(("scope", scope, flat))
            else:
                stack.append(("init", begin, flat))
                continue
            segment_start = offset + 1
        elif character == "}":
            if not stack:
                continue
            kind, begin, signature = stack.pop()
            if kind == "init":
                continue
            if kind == "body":
                name = re.search(r"([~\w:<>]+(?:\s*operator\s*[^\s(]+)?)\s*\(", signature)
                found.append(Function(name.group(1) if name else "?", line_of(begin), line_of(offset), signature.strip(), scope_names()))
            segment_start = offset + 1
        elif not any(kind == "init" for kind, _, _ in stack):
            if own is not None and is_method(re.sub(r"^\s*(?:public|private|protected)\s*:", "", code[segment_start:offset])):
                own.methods += 1
            segment_start = offset + 1
    return found, classes
