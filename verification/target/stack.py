#!/usr/bin/env python3
"""Greatest stack depth of functions of an image, by the compilers' own figures and the calls that are in the image.

    stack.py IMAGE.elf --figures BUILD_FOLDER --calls virtual_calls.txt --entry NAME_PREFIX [--entry ...]

Frames come from the .ci files (GCC, -fcallgraph-info=su) and .su files (Clang, -fstack-usage) under the build folder.
Calls come from the disassembly of the image: each branch that leaves its function. A call through a register is a virtual
call; the table says which interfaces a function may call so, and every function in the image that implements one of their
methods counts. Fails on recursion, on a frame whose size is not fixed, on a function without a figure, on a call through a
register that the table does not allow.
Exit status: 0 every depth is known, 1 one is not, 2 input that cannot be used.
"""
import argparse
import pathlib
import re
import subprocess
import sys

FUNCTION = re.compile(r"^([0-9a-f]+) <([^>]+)>:$")
CAST = re.compile(r"\((?:unsigned )?(?:char|short|int|long)\)(?=\d)")  # Of a template's argument; what comes before '(' is the name.
INSTRUCTION = re.compile(r"^\s*([0-9a-f]+):\t[0-9a-f ]+\t(\S+)(?:\t(.*))?$")
BRANCH = re.compile(r"^(?:b|bl|blx|b[a-z]{2}|bl[a-z]{2})(?:\.[nw])?$|^cbn?z$")
TARGET = re.compile(r"([0-9a-f]+) <[^>]+>")
CI_NODE = re.compile(r'node: \{ title: "([^"]+)" label: "[^"]*\\n(\d+) bytes \(([^)]*)\)')
SU_LINE = re.compile(r"^.*:(\S+)\t(\d+)\t(\S+)$")


class BadInput(Exception):
    """Input that cannot be used; the text names the place."""


def lines_of(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout.splitlines()


def demangled(names):
    text = subprocess.run(["c++filt"], input="\n".join(names), check=True, capture_output=True, text=True).stdout
    return dict(zip(names, CAST.sub("", text).splitlines()))


def read_frames(folder):
    """Symbol -> (bytes, kind) for every function of every object."""
    frames = {}
    for path in sorted(folder.rglob("*.ci")):
        for name, size, kind in CI_NODE.findall(path.read_text(encoding="utf-8")):
            # A function with internal linkage has its file before its name.
            frames[name.rsplit(":", 1)[-1]] = (int(size), kind)
    for path in sorted(folder.rglob("*.su")):
        for line in path.read_text(encoding="utf-8").splitlines():
            match = SU_LINE.match(line)
            # GCC writes signatures here, which have blanks; its figures are in the .ci files.
            if match and match.group(1).startswith("_Z"):
                frames.setdefault(match.group(1), (int(match.group(2)), match.group(3)))
    if not frames:
        raise BadInput(f"{folder}: no .ci or .su file, expected a build by cmake/toolchain-armeb.cmake")
    return frames


class Table:
    """Which function may call virtually which interface, and the frames of functions that no compiler wrote. Lines:
    function prefix -> Interface::Method, namespace::Class::Method, ...     function = bytes
    `-> -` stands for what runs on a stack of its own."""

    def __init__(self, path):
        self.rows = []
        self.frames = {}
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), start=1):
            text = line.split("#")[0].strip()
            if not text:
                continue
            assembly = re.fullmatch(r"(\w+) = (\d+)", text)
            if assembly:
                self.frames[assembly.group(1)] = int(assembly.group(2))
                continue
            caller, arrow, callees = text.partition("->")
            if not arrow or not callees.strip():
                raise BadInput(f"{path}:{number}: expected 'function -> Interface::Method, ...', found '{text}'")
            self.rows.append((caller.strip(), [callee.strip() for callee in callees.split(",")]))

    def callees(self, caller):
        found = None
        for prefix, callees in self.rows:
            if caller.startswith(prefix):
                found = (found or []) + callees
        return found


class Image:
    """Functions of a linked image, the calls between them, and the methods that stand in its virtual tables."""

    def __init__(self, path):
        self.symbols = {}
        self.sizes = {}
        for line in lines_of("arm-none-eabi-readelf", "-sW", str(path)):
            fields = line.split()
            if len(fields) == 8 and fields[3] == "FUNC" and fields[6] not in ("UND", "ABS"):
                address = int(fields[1], 16) & ~1
                self.symbols.setdefault(address, []).append(fields[7])
                self.sizes[address] = max(self.sizes.get(address, 0), int(fields[2]))
        self.names = demangled(sorted({name for names in self.symbols.values() for name in names}))
        self.starts = sorted(self.symbols)
        self.calls = {address: set() for address in self.symbols}
        self.indirect = {}
        self.table_entries = self.read_tables(path)
        self.read_code(path)

    def name(self, address):
        return self.names[self.symbols[address][0]]

    def containing(self, address):
        low, high = 0, len(self.starts)
        while high - low > 1:
            middle = (low + high) // 2
            low, high = (middle, high) if self.starts[middle] <= address else (low, middle)
        return self.starts[low]

    def read_tables(self, path):
        """Addresses of the functions that virtual tables point to."""
        entries = set()
        ranges = []
        for line in lines_of("arm-none-eabi-readelf", "-sW", str(path)):
            fields = line.split()
            if len(fields) == 8 and fields[3] == "OBJECT" and fields[7].startswith("_ZTV"):
                ranges.append((int(fields[1], 16), int(fields[2])))
        words = {}
        names = re.findall(r"\] (\.(?:rodata|data|text)\S*) ", "\n".join(lines_of("arm-none-eabi-readelf", "-SW", str(path))))
        for section in names:
            for line in lines_of("arm-none-eabi-objdump", "-s", "-j", section, str(path)) if ranges else []:
                match = re.match(r"^ ([0-9a-f]+) ((?:[0-9a-f]{8} ?){1,4})", line)
                if match:
                    for number, word in enumerate(match.group(2).split()):
                        words[int(match.group(1), 16) + 4 * number] = int(word, 16)
        for start, size in ranges:
            for place in range(start + 8, start + size, 4):
                if words.get(place, 0) & ~1 in self.symbols:
                    entries.add(words[place] & ~1)
        return entries

    def read_code(self, path):
        current = None
        for line in lines_of("arm-none-eabi-objdump", "-d", str(path)):
            head = FUNCTION.match(line)
            if head:
                address = int(head.group(1), 16)
                current = self.containing(address)
                continue
            match = INSTRUCTION.match(line)
            if not match or current is None:
                continue
            operation, operands = match.group(2), (match.group(3) or "").split("@")[0].strip()
            if re.match(r"^b(l)?x", operation) and re.fullmatch(r"r\d+|ip|fp|sl|sb", operands):
                self.indirect.setdefault(current, []).append(line.strip())
            elif re.match(r"^(ldr|mov|add)", operation) and re.match(r"pc, (?!\[sp\])", operands):
                self.indirect.setdefault(current, []).append(line.strip())
            elif BRANCH.match(operation):
                target = TARGET.search(operands)
                if target:
                    callee = self.containing(int(target.group(1), 16))
                    leaves = callee != current or operation.startswith("bl") and operation[:3] not in ("blt", "ble", "bls")
                    if leaves:
                        self.calls[current].add(callee)

    def implementers(self, pattern):
        """Functions in virtual tables whose method is that of the pattern Interface::Method; with a namespace in front it
        is that class alone."""
        method = pattern.rsplit("::", 1)[1]
        found = set()
        for address in self.table_entries:
            # Methods that are alike may stand at one address.
            names = [self.names[symbol].split("(")[0] for symbol in self.symbols[address]]
            if any(name.endswith("::" + pattern) if pattern.count("::") > 1 else name.rsplit("::", 1)[1] == method for name in names):
                found.add(address)
        return found


class Depths:
    """Depth by function, computed once; `problems` says what could not be resolved."""

    def __init__(self, image, frames, table):
        self.image, self.frames, self.table = image, frames, table
        self.known = {}
        self.open = []
        self.problems = []

    def frame(self, address):
        for symbol in self.image.symbols[address]:
            if symbol in self.frames:
                size, kind = self.frames[symbol]
                if kind != "static":
                    self.problems.append(f"{self.image.name(address)}: its frame is not of fixed size ({kind})")
                return size
            if symbol in self.table.frames:
                return self.table.frames[symbol]
        # GCC names a clone in its graph as the linker does; what is left has no compiler: the start-up code.
        self.problems.append(f"{self.image.name(address)}: no compiler gave a figure")
        return 0

    def callees(self, address):
        result = set(self.image.calls[address])
        sites = self.image.indirect.get(address, [])
        if sites:
            name = self.image.name(address)
            patterns = self.table.callees(name)
            if patterns is None:
                self.problems.append(f"{name}: call through a register that the table does not allow: {sites[0]}")
                patterns = []
            for pattern in (pattern for pattern in patterns if pattern != "-"):
                result |= self.image.implementers(pattern)
        return result

    def depth(self, address):
        """(bytes, path) from this function downwards."""
        if address in self.known:
            return self.known[address]
        if address in self.open:
            names = [self.image.name(place) for place in self.open[self.open.index(address):] + [address]]
            self.problems.append("recursion: " + " > ".join(names))
            return (0, [])
        self.open.append(address)
        best = (0, [])
        for callee in sorted(self.callees(address)):
            best = max(best, self.depth(callee), key=lambda item: item[0])
        self.open.pop()
        own = self.frame(address)
        self.known[address] = (own + best[0], [(self.image.name(address).split("(")[0], own)] + best[1])
        return self.known[address]


def compute(image_path, figures, calls, entries):
    """Rows (function, bytes, path) of every function that begins like an entry, deepest first, and what is unresolved."""
    image = Image(image_path)
    depths = Depths(image, read_frames(figures), Table(calls))
    rows = []
    for prefix in entries:
        found = [address for address in image.starts
                 if any(image.names[symbol].startswith(prefix) for symbol in image.symbols[address])]
        if not found:
            raise BadInput(f"{image_path}: no function begins with '{prefix}'")
        rows += [(image.name(address).split("(")[0], *depths.depth(address)) for address in found]
    rows.sort(key=lambda row: (-row[1], row[0]))
    return rows, sorted(set(depths.problems))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("image", type=pathlib.Path)
    parser.add_argument("--figures", type=pathlib.Path, required=True)
    parser.add_argument("--calls", type=pathlib.Path, required=True)
    parser.add_argument("--entry", action="append", required=True, help="start of the name of functions to measure")
    arguments = parser.parse_args()
    rows, problems = compute(arguments.image, arguments.figures, arguments.calls, arguments.entry)
    for name, size, _ in rows:
        print(f"{size:6d} B  {name}")
    print("deepest: " + " > ".join(f"{name} {own}" for name, own in rows[0][2]))
    for problem in problems:
        print(f"stack.py: {problem}", file=sys.stderr)
    return 1 if problems else 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except BadInput as problem:
        print(f"stack.py: {problem}", file=sys.stderr)
        sys.exit(2)
