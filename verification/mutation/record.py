"""The record of a whole run: each function of the safety rooms, by its text, with what became of its mutants.

A function whose text stands in the record has been judged; one that does not was changed since, or is new. What stands outside of
functions (constants, members with values) is one entry of its file.
"""
import collections
import dataclasses
import hashlib
import subprocess

import tree_sitter
import tree_sitter_cpp

OUTSIDE = "outside of functions"
VERDICTS = ("killed", "refused", "same", "equivalent", "survived", "not_judged")


@dataclasses.dataclass(frozen=True)
class Function:
    name: str
    first: int  # Bytes of the file.
    last: int
    key: str  # Name and digest of the text without comments and white space.


def plain_text(node, left_out=()):
    """The tokens below a node, one blank between two; without comments, and without what begins at a byte of `left_out`."""
    if node.type == "comment" or node.start_byte in left_out and node.type == "function_definition":
        return ""
    if not node.children:
        return node.text.decode() + " "
    return "".join(plain_text(child, left_out) for child in node.children)


def keyed(name, text):
    return f"{name} {hashlib.sha256(text.encode()).hexdigest()[:16]}"


def definitions(node):
    """Functions with a body, none inside of another."""
    if node.type == "function_definition":
        yield node
        return
    for child in node.children:
        yield from definitions(child)


def functions_of(source):
    """Every function of the text (bytes), the last entry what stands outside of them."""
    root = tree_sitter.Parser(tree_sitter.Language(tree_sitter_cpp.language())).parse(source).root_node
    found = []
    for node in definitions(root):
        declarator = node.child_by_field_name("declarator")
        name = " ".join(declarator.text.decode().split("(")[0].split()).lstrip("&* ") if declarator else "function"
        found.append(Function(name, node.start_byte, node.end_byte, keyed(name, plain_text(node))))
    outside = plain_text(root, {function.first for function in found})
    return [*found, Function(OUTSIDE, 0, len(source), keyed(OUTSIDE, outside))]


def keys_of(source, mutants):
    """Name of a mutant -> key of the function that it changes."""
    functions = functions_of(source)
    return {mutant.name: next(function.key for function in functions if function.first <= mutant.first < function.last) for mutant in mutants}


def made_by(root):
    """What made a run: commit and compilers. Raises OSError if git is not there."""
    def first_line(*words):
        return subprocess.run(words, cwd=root, capture_output=True, text=True, check=True).stdout.splitlines()[0]
    return {"commit": first_line("git", "rev-parse", "HEAD"), "date": first_line("git", "log", "-1", "--format=%cs"),
            "compilers": [first_line("c++", "--version"), first_line("clang++-19", "--version")]}


def record_of(subjects, reasons, made):
    """Of a run over everything. `reasons` has the mutants that no test can see; every other survivor is named, and what was not judged."""
    files, survivors, not_judged = {}, [], []
    for subject in subjects:
        counts, keys = collections.defaultdict(collections.Counter), keys_of(subject.source, subject.mutants)
        for name, key in keys.items():
            verdict = subject.verdicts.get(name, "not_judged")
            counts[key]["equivalent" if verdict == "survived" and name in reasons else verdict] += 1
        survivors += [{"name": mutant.name, "file": subject.file, "function": keys[mutant.name].rsplit(" ", 1)[0], "change": mutant.change}
                      for mutant in subject.mutants if subject.verdicts.get(mutant.name) == "survived" and mutant.name not in reasons]
        not_judged += [mutant.name for mutant in subject.mutants if mutant.name not in subject.verdicts]
        files[subject.file] = {key: {verdict: count for verdict in VERDICTS if (count := of_key[verdict])} for key, of_key in sorted(counts.items())}
    return {"made": made, "files": files, "survivors": survivors, "not_judged": not_judged}


def updated(record, fresh):
    """The record of a whole run with what a run over the functions that changed since has judged: `fresh`, of the same tree. What the record
    knows of a function whose text is still there stays; each commit that judged functions is named."""
    files, names = {}, set()
    for file, functions in fresh["files"].items():
        known = record["files"].get(file, {})
        files[file] = {key: known.get(key, counts) for key, counts in functions.items()}
        names |= {f"{file} {key}" for key in functions if key not in known}
    # Survivors of unchanged functions were not judged again: fresh names them as not judged.
    survivors = [entry for entry in record["survivors"] if entry["name"] in fresh["not_judged"]] + fresh["survivors"]
    not_judged = [name for name in fresh["not_judged"] if name in record["not_judged"]]
    earlier = [entry for entry in record["made"].get("since", []) if entry["commit"] != fresh["made"]["commit"]]
    since = [*earlier, {"commit": fresh["made"]["commit"], "date": fresh["made"]["date"], "functions": len(names)}]
    return {"made": {**record["made"], "since": since if names else record["made"].get("since", [])}, "files": files, "survivors": survivors, "not_judged": not_judged}


def changed_since(record, subjects):
    """(functions, mutants) whose text is not in the record: names of mutants by file, and "file: function" of each."""
    functions, mutants = [], {}
    for subject in subjects:
        known = record["files"].get(subject.file, {})
        keys = keys_of(subject.source, subject.mutants)
        mutants[subject.file] = [mutant for mutant in subject.mutants if keys[mutant.name] not in known]
        functions += [f"{subject.file}: {key.rsplit(' ', 1)[0]}" for key in sorted(set(keys.values())) if key not in known]
    return functions, mutants


def drawn_again(count, record, subjects, left_out, draw):
    """`count` mutants of the others, another draw for another text `draw`; not those that survive in the record or were not judged, which it names."""
    known = {*(survivor["name"] for survivor in record["survivors"]), *record["not_judged"]}
    others = [mutant for subject in subjects for mutant in subject.mutants if mutant not in left_out[subject.file] and mutant.name not in known]
    others.sort(key=lambda mutant: hashlib.sha256(f"{draw}\0{mutant.name}".encode()).digest())
    return others[:count]
