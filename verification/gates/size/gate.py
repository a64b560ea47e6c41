#!/usr/bin/env python3
"""Size by thought: no C++ file of product, verification or tests beyond 600 lines, no function beyond 60 (from its signature to its closing brace), no class beyond 30 methods, and a class's methods in one place. No Python function of verification beyond 70.

A class's methods are its member functions, constructors and operators, those of nested classes with it; what is defaulted or
deleted does not count. A method defined out of its class stands in the file beside its declaration (foo.cpp for foo.hpp, in the same
folder or in one that holds variants of a port) or in a file named after the class: the stem in CamelCase, alone or behind the names
of the folders around it (canopen/cia301/sdo/server.cpp: SdoServer). A nested class counts with its outer one; a class of one .cpp
stands where it is. exceptions.json names the classes that do not comply, each with a reason; one that complies must leave the list.
"""
import ast
import json
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from common import PRODUCT_FOLDERS, CannotLook, cpp_files, files, outline, read, run_gate  # noqa: E402

MAX_FILE_LINES = 600
MAX_FUNCTION_LINES = 60
MAX_METHODS = 30
MAX_PYTHON_LINES = 70
VERIFICATION = "verification"
TESTS = "tests"
EXCEPTIONS = "verification/gates/size/exceptions.json"


def camel_case(words):
    return "".join(part[:1].upper() + part[1:] for part in words.split("_"))


def is_named_after(name, cls):
    """Whether the file `name` may hold methods of `cls`: its stem, or folders and stem, tell the class."""
    parts = [camel_case(part) for part in pathlib.PurePosixPath(name).with_suffix("").parts]
    return any("".join(parts[first:]) == cls for first in range(len(parts)))


def outer_class(function, declared):
    """The outermost class of a function defined with a qualified name, as (its key, its name); (None, "") for others."""
    words = function.name.split("::")[:-1]
    for first in range(len(function.scopes), -1, -1):
        for count in range(1, len(words) + 1):
            key = "::".join(function.scopes[:first] + words[:count])
            if key in declared:
                return key, words[count - 1]
    return None, ""


def look(root, names):
    """Functions of each file, and of each outermost class its places (file, line) and methods."""
    functions, declared = {}, {}
    for name in names:
        functions[name], classes = outline(read(root, name))
        for cls in classes:
            keys = ["::".join(cls.scopes[:count]) for count in range(1, len(cls.scopes) + 1)]
            outer = next((key for key in keys if key in declared and name in [file for file, _ in declared[key]["places"]]), None)
            key = outer or "::".join(cls.scopes + [cls.name])
            entry = declared.setdefault(key, {"places": [], "methods": 0})
            entry["methods"] = entry["methods"] + cls.methods
            if outer is None:
                entry["places"].append((name, cls.line))
    return functions, declared


def class_findings(functions, declared):
    """Findings as (class, text)."""
    for key, entry in declared.items():
        name, line = entry["places"][0]
        if entry["methods"] > MAX_METHODS * len(entry["places"]):
            yield key, f"{name}:{line}: {key} has {entry['methods']} methods, expected at most {MAX_METHODS}"
    for name in functions:
        for function in functions[name]:
            key, cls = outer_class(function, declared)
            if key is None or is_named_after(name, cls):
                continue
            homes = [pathlib.PurePosixPath(file) for file, _ in declared[key]["places"]]
            here = pathlib.PurePosixPath(name)
            if not any(home.stem == here.stem and (home.parent == here.parent or home.parent in here.parents) for home in homes):
                yield key, f"{name}:{function.first_line}: {function.name} stands neither beside its declaration ({homes[0]}) nor in a file named after {cls}"


def python_findings(root, name):
    for node in ast.walk(ast.parse(read(root, name))):
        if isinstance(node, ast.FunctionDef) and node.end_lineno - node.lineno + 1 > MAX_PYTHON_LINES:
            yield f"{name}:{node.lineno}: {node.name} has {node.end_lineno - node.lineno + 1} lines, expected at most {MAX_PYTHON_LINES}"


def gate(root, _data):
    names = cpp_files(root, (*PRODUCT_FOLDERS, VERIFICATION, TESTS))
    functions, declared = look(root, names)
    exceptions = json.loads(read(root, EXCEPTIONS)) if (root / EXCEPTIONS).exists() else {}
    findings = []
    for name in names:
        lines = read(root, name).count("\n")
        if lines > MAX_FILE_LINES:
            findings.append(f"{name}:{lines}: the file has {lines} lines, expected at most {MAX_FILE_LINES}")
        for function in functions[name]:
            if function.length > MAX_FUNCTION_LINES:
                findings.append(f"{name}:{function.first_line}: {function.name} has {function.length} lines, "
                                f"expected at most {MAX_FUNCTION_LINES}")
    scripts = files(root, "*.py", under=(VERIFICATION,))
    findings += [text for name in scripts for text in python_findings(root, name)]
    excused = set()
    for key, text in class_findings(functions, declared):
        if key in exceptions:
            excused.add(key)
        else:
            findings.append(text)
    findings += [f"{EXCEPTIONS}:1: {key} complies or is gone, expected only classes that do not" for key in exceptions if key not in excused]
    count = sum(len(each) for each in functions.values())
    if count == 0:
        raise CannotLook("no function found in the files of product, verification and tests")
    return findings, f"{count} functions in {len(names)} files, {len(scripts)} scripts, {len(declared)} classes, {len(exceptions)} of them excused"


run_gate(gate)
