#!/usr/bin/env python3
"""Writes for each header of the product that has public enumerations a header of the same path below names/, with two functions
an enumeration, in its namespace:

    NameOf(value)     the enumerator's name in lower case: SrdoCause::kNotInverse is "not_inverse"; "unknown" for a value that none has
    MeaningOf(value)  the comment behind the enumerator, one line; empty where there is none

    generate.py ROOT OUTPUT     ROOT: the tree; OUTPUT: the folder of names/

No room of the kernel sees these headers, so that none of the texts can come into a firmware that does not ask for them. Exit status: 0
written, 1 an enumeration that this program cannot read (file:line is printed), which therefore would have no name. [SRS_EASE_006]
"""
import pathlib
import re
import sys

FOLDERS = ("safety_core", "hal", "canopen", "runtime")
HEAD = "// Made by names/generate.py of the enumerations in {path}. SPDX-License-Identifier: Apache-2.0\n"
ANY = re.compile(r"\benum\b(?=\s+\w|\s*\{)")
CLASS = re.compile(r"^(?:template <.*> *)?(?:class|struct) \w+", re.MULTILINE)
DECLARED = re.compile(r"enum (?:class|struct) \w+(?: : [\w:]+)?;")
WHOLE = re.compile(r"enum class (\w+)(?: : [\w:]+)?\s*\{(.*?)\};", re.DOTALL)
COMMENT = r"//[^\n]*"
PIECE = re.compile(rf"\s*(?:(?P<comment>{COMMENT})|(?P<name>k\w+)(?:\s*=\s*[^,/]+)?\s*(?:,|$|(?={COMMENT})))\s*")
NAMESPACE = re.compile(r"^namespace ([\w:]+)", re.MULTILINE)
ACCESS = re.compile(r"^\s*(public|protected|private):", re.MULTILINE)


class Unreadable(Exception):
    """An enumeration of a form that is not known; the text names its place."""


def lower_case(name):
    """kNotInverse: not_inverse."""
    return re.sub(r"(?<!^)(?=[A-Z])", "_", name[1:]).lower()


def enumerators(body, place):
    """(name, meaning) of each."""
    found, at = [], 0
    while at < len(body.rstrip()):
        piece = PIECE.match(body, at)
        if piece is None:
            raise Unreadable(f"{place}: enumerator '{body[at:].strip().splitlines()[0]}', expected kName, or kName = VALUE")
        at = piece.end()
        if piece["name"]:
            found.append([piece["name"], ""])
        elif found and piece["comment"].startswith("///<"):
            found[-1][1] = f"{found[-1][1]} {piece['comment'][4:].strip()}".strip()
    if not found:
        raise Unreadable(f"{place}: an enumeration without an enumerator that can be read")
    return found


def is_private(text, start):
    """Whether an enumeration stands in a class, behind `private:` or `protected:`."""
    is_first_of_line = not text[text.rfind("\n", 0, start) + 1:start].strip()
    outer = [match.start() for match in CLASS.finditer(text, 0, start)]
    words = ACCESS.findall(text, outer[-1], start) if outer else []
    return is_first_of_line and bool(words) and words[-1] != "public" and text[start - 1] == " "


def read(path, text):
    """(namespace, enumeration, its enumerators) of each public one."""
    for match in ANY.finditer(text):
        start = match.start()
        line = text[text.rfind("\n", 0, start) + 1:start]
        place = f"{path}:{text.count(chr(10), 0, start) + 1}"
        if "//" in line or DECLARED.match(text, start) or is_private(text, start):
            continue
        whole = WHOLE.match(text, start)
        namespaces = NAMESPACE.findall(text, 0, start)
        if whole is None or line or not namespaces:
            raise Unreadable(f"{place}: '{text[start:].splitlines()[0]}', expected 'enum class NAME' in a namespace, outside of a class")
        yield namespaces[-1], whole[1], enumerators(whole[2], place)


def switch(function, name, rows, otherwise):
    lines = [f"[[nodiscard]] constexpr const char* {function}(const {name} value) noexcept", "{", "    switch (value)", "    {"]
    for enumerator, text in rows:
        quoted = text.replace("\\", "\\\\").replace('"', '\\"')
        lines += [f"    case {name}::{enumerator}:", f'        return "{quoted}";']
    return "\n".join([*lines, "    }", f'    return "{otherwise}";', "}"])


def header(path, found):
    guard = "NAMES_" + re.sub(r"\W", "_", path).upper()
    parts = [HEAD.format(path=path) + f"#ifndef {guard}\n#define {guard}\n\n#include \"{path}\"\n"]
    for namespace, name, rows in found:
        names = [(enumerator, lower_case(enumerator)) for enumerator, _ in rows]
        parts.append(f"namespace {namespace}\n{{\n{switch('NameOf', name, names, 'unknown')}\n"
                     f"{switch('MeaningOf', name, rows, '')}\n}} // namespace {namespace}\n")
    return "\n".join(parts) + f"\n#endif // {guard}\n"


def write(path, text):
    """Only what changed, so that nothing else is compiled again."""
    path.parent.mkdir(parents=True, exist_ok=True)
    if not path.is_file() or path.read_text(encoding="utf-8") != text:
        path.write_text(text, encoding="utf-8")


def main():
    root, output = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    written = set()
    try:
        for path in sorted(file for folder in FOLDERS for file in (root / folder).rglob("*.hpp")):
            name = path.relative_to(root).as_posix()
            found = list(read(name, path.read_text(encoding="utf-8")))
            if found:
                write(output / "names" / name, header(name, found))
                written.add(output / "names" / name)
    except Unreadable as problem:
        print(problem)
        return 1
    for old in set((output / "names").rglob("*.hpp")) - written:
        old.unlink()
    return 0


if __name__ == "__main__":
    sys.exit(main())
