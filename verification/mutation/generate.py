"""Every mutant of a C++ source, in a fixed order and each with a name that stays while its line stays.

A mutant is one replacement in the text, chosen on the syntax tree of tree-sitter, so that comments, templates, attributes,
declarations and what is decided while compiling (static_assert, enumerators, sizes of arrays) are left alone.
"""
import dataclasses
import hashlib
import re

import tree_sitter
import tree_sitter_cpp

OPERATORS = {
    "relational": {"<": ("<=", ">="), "<=": ("<", ">"), ">": (">=", "<="), ">=": (">", "<"), "==": ("!=",), "!=": ("==",)},
    "arithmetic": {"+": ("-",), "-": ("+",), "*": ("/",), "/": ("*",), "%": ("/",), "+=": ("-=",), "-=": ("+=",),
                   "*=": ("/=",), "++": ("--",), "--": ("++",)},
    "bitwise": {"&": ("|", "^"), "|": ("&", "^"), "^": ("|", "&"), "<<": (">>",), ">>": ("<<",), "&=": ("|=", "^="),
                "|=": ("&=", "^="), "^=": ("|=", "&="), "<<=": (">>=",), ">>=": ("<<=",)},
    "conditions": {"&&": ("||",), "||": ("&&",)},
}
REPLACED = {operator: (kind, others) for kind, table in OPERATORS.items() for operator, others in table.items()}
DROPPED = {"!": "conditions", "~": "bitwise", "-": "arithmetic"}
KINDS = ("relational", "arithmetic", "bitwise", "constants", "conditions", "statements", "arguments", "returns")
# Decided while compiling, or no code at all.
LEFT_ALONE = {"comment", "preproc_include", "preproc_def", "static_assert_declaration", "enumerator_list", "template_argument_list",
              "template_parameter_list", "array_declarator", "attribute_declaration", "alias_declaration", "parameter_list"}
LITERAL = re.compile(r"(0[xX][0-9A-Fa-f']+|[0-9][0-9']*)([uUlL]*)$")


class NotRead(Exception):
    """A source that the parser does not understand: mutants of it would be guesses."""


@dataclasses.dataclass(frozen=True)
class Mutant:
    file: str
    kind: str
    first: int  # Bytes of the file that are replaced.
    last: int
    text: str  # What stands there instead.
    line: int
    was: str
    name: str

    @property
    def place(self):
        return f"{self.file}:{self.line}"

    @property
    def change(self):
        return f"{self.kind}: {short(self.was)} -> {short(self.text) or 'nothing'}"

    def applied(self, source):
        return source[:self.first] + self.text.encode() + source[self.last:]


def short(text):
    line = " ".join(text.split())
    return line if len(line) <= 60 else line[:57] + "..."


def neighbours_of(literal):
    """The literals one above and one below, in the same notation; nothing for what is no whole number."""
    found = LITERAL.match(literal)
    if not found:
        return ()
    digits = found.group(1).replace("'", "")
    value = int(digits, 0) if digits[:2].lower() == "0x" else int(digits, 10)
    form = (lambda n: f"0x{n:0{len(digits) - 2}X}") if digits[:2].lower() == "0x" else str
    others = [value + 1] if value == 0 else [value + 1, value - 1]
    return tuple(form(other) + found.group(2) for other in others if form(other).count("x") or other < 2**64)


def of_operator(node):
    operator = node.child_by_field_name("operator")
    kind, others = REPLACED.get(operator.type, ("", ()))
    for other in others:
        yield kind, operator, other


def of_unary(node):
    operator = node.child_by_field_name("operator")
    if operator.type in DROPPED:
        yield DROPPED[operator.type], operator, ""


def of_condition(node):
    condition = node.child_by_field_name("condition")
    if condition is None:
        return
    if condition.type == "condition_clause":
        condition = condition.child_by_field_name("value")
    for value in ("false",) if node.type in ("while_statement", "for_statement") else ("true", "false"):
        yield "conditions", condition, value


def of_arguments(node):
    """Each argument as nothing, and each two neighbours swapped."""
    function = node.child_by_field_name("function")
    if function is not None and function.type == "template_function":
        return  # A cast.
    given = (node.child_by_field_name("arguments") or node.child_by_field_name("value")).named_children
    given = [item for item in given if item.type != "comment"]
    for item in given:
        if item.text not in (b"0U", b"{}", b"false", b"nullptr"):
            yield "arguments", item, "{}"
    for left, right in zip(given, given[1:]):
        if left.text != right.text:
            between = node.text[left.end_byte - node.start_byte:right.start_byte - node.start_byte]
            yield "arguments", (left, right), (right.text + between + left.text).decode()


def of_return(node):
    value = next((child for child in node.named_children if child.type != "comment"), None)
    if value is not None and value.text not in (b"0U", b"{}", b"false", b"nullptr"):
        yield "returns", value, "{}"


def of_statement(node):
    if node.parent.type not in ("for_range_loop",) and node.named_children:
        yield "statements", node, ";"


def of_literal(node):
    text = node.text.decode()
    for other in {"true": ("false",), "false": ("true",)}.get(text) or neighbours_of(text):
        yield "constants", node, other


FINDERS = {
    "binary_expression": of_operator, "assignment_expression": of_operator, "update_expression": of_operator,
    "unary_expression": of_unary, "pointer_expression": of_unary,
    "if_statement": of_condition, "while_statement": of_condition, "for_statement": of_condition, "conditional_expression": of_condition,
    "call_expression": of_arguments, "compound_literal_expression": of_arguments,
    "return_statement": of_return, "expression_statement": of_statement,
    "number_literal": of_literal, "true": of_literal, "false": of_literal,
}


def changes(node):
    """(kind, first byte, last byte, new text) of a node and of all below it, in the order of the text."""
    if node.type in LEFT_ALONE:
        return
    for kind, place, text in FINDERS.get(node.type, lambda _: ())(node):
        first, last = place if isinstance(place, tuple) else (place, place)
        yield kind, first.start_byte, last.end_byte, text
    for child in node.children:
        yield from changes(child)


def name_of(file, kind, line, was, text, seen):
    """Does not depend on the number of the line: other lines may come and go."""
    told = "\0".join((file, kind, line.strip(), was, text))
    seen[told] = seen.get(told, 0) + 1
    return hashlib.sha256(f"{told}\0{seen[told]}".encode()).hexdigest()[:12]


def mutants_of(file, source):
    """All mutants of `source` (bytes), which is the text of `file`."""
    tree = tree_sitter.Parser(tree_sitter.Language(tree_sitter_cpp.language())).parse(source)
    if tree.root_node.has_error:
        raise NotRead(f"{file}: the parser does not understand this file, expected plain C++17")
    lines = source.decode().split("\n")
    seen = {}
    found = []
    for kind, first, last, text in changes(tree.root_node):
        row = source.count(b"\n", 0, first)
        was = source[first:last].decode()
        if was != text:
            found.append(Mutant(file, kind, first, last, text, row + 1, was, name_of(file, kind, lines[row], was, text, seen)))
    return found
