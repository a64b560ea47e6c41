"""All mutants of a file in one text, each behind a question that is asked while it runs.

`a < b` becomes `((mutant == 7) ? (a <= b) : (mutant == 8) ? (a >= b) : (a < b))`. One library then holds a whole channel with all its mutants, and
nothing is compiled for each. What is decided while compiling cannot ask; the compiler refuses it there, and such a mutant is compiled
alone.
"""
import tree_sitter
import tree_sitter_cpp

from generate import DROPPED, REPLACED

LISTS = ("argument_list", "initializer_list")
# Never asked: decided while compiling.
DECIDED_EARLY = ("case_statement", "static_assert_declaration", "template_argument_list", "bitfield_clause", "noexcept")
DECLARED = """extern "C" unsigned counterpoint_mutant;
bool CounterpointWhileCompiling();
"""
WHILE_COMPILING_CALL = "CounterpointWhileCompiling"


def question(number):
    """No macro and no function: the compiler names the line where it cannot be asked."""
    return f"(__builtin_is_constant_evaluated() ? {WHILE_COMPILING_CALL}() : (counterpoint_mutant == {number}U))"


def ancestors(node):
    while node is not None:
        yield node
        node = node.parent


def up_to(node, kinds):
    return next((above for above in ancestors(node) if above.type in kinds), None)


def is_constant(node):
    """Whether the compiler needs its value; a constexpr function is found by what uses it."""
    for above in ancestors(node):
        if above.type == "case_statement":
            value = above.child_by_field_name("value")
            if value is not None and value.start_byte <= node.start_byte and node.end_byte <= value.end_byte:
                return True
        elif above.type in DECIDED_EARLY:
            return True
        elif above.type in ("declaration", "field_declaration"):
            if any(child.type in ("type_qualifier", "storage_class_specifier") and child.text == b"constexpr" for child in above.children):
                return True
        elif above.type == "if_statement" and any(child.type == "constexpr" for child in above.children):
            condition = above.child_by_field_name("condition")
            if condition.start_byte <= node.start_byte and node.end_byte <= condition.end_byte:
                return True
    return False


def host_of(root, mutant):
    """(node, whether it is a statement) that asks; None if nothing can."""
    node = root.descendant_for_byte_range(mutant.first, mutant.last)
    if mutant.kind == "statements":
        node = up_to(node, ("expression_statement",))
        return node and (node, True)
    if mutant.kind == "returns":
        node = up_to(node, ("return_statement",))
        return node and (node, True)
    if mutant.kind == "arguments":
        place = up_to(node if node.type not in LISTS or node.start_byte < mutant.first else node.parent, LISTS)
        return place and (place.parent, False) if place.parent.type in ("call_expression", "compound_literal_expression") else None
    if mutant.was in REPLACED or (mutant.was in DROPPED and mutant.text == ""):
        return node.parent, False
    return (node, False) if (node.start_byte, node.end_byte) == (mutant.first, mutant.last) else None


class Text:
    """One file with those of its mutants that can ask, each by its number."""

    def __init__(self, source, mutants, numbers):
        root = tree_sitter.Parser(tree_sitter.Language(tree_sitter_cpp.language())).parse(source).root_node
        self.source, self.numbers = source, numbers
        self.hosts, self.alone, self.function = {}, set(), {}
        for mutant in mutants:
            found = host_of(root, mutant)
            if found is None or is_constant(found[0]):
                self.alone.add(mutant.name)
                continue
            node, is_statement = found
            self.hosts.setdefault((node.start_byte, -node.end_byte, is_statement), []).append(mutant)
            body = up_to(node, ("function_definition",))
            self.function[mutant.name] = (body.start_byte, body.end_byte) if body else None

    def exclude(self, names, is_early):
        """What the compiler refused is compiled alone; what it wanted to know while compiling, with all of its function."""
        bodies = {self.function[name] for name in names if is_early} - {None}
        self.alone |= {name for name, body in self.function.items() if name in names or body in bodies}

    def written(self):
        """(text, line -> names of its mutants)."""
        self.parts, self.places = [], {}
        self.line = 1
        spans = sorted((first, -negative, is_statement, [mutant for mutant in mutants if mutant.name not in self.alone])
                       for (first, negative, is_statement), mutants in self.hosts.items())
        # The larger one first; of two alike the statement.
        spans = sorted((span for span in spans if span[3]), key=lambda span: (span[0], -span[1], not span[2]))
        self.write(0, len(self.source), spans)
        return "".join(self.parts), self.places

    def put(self, text, mutant=None):
        """What belongs to a mutant begins on a line of its own."""
        for step in range(text.count("\n") if mutant else 0):
            self.places.setdefault(self.line + step + 1, set()).add(mutant.name)
        self.parts.append(text)
        self.line += text.count("\n")

    def write(self, first, last, spans):
        at = first
        while spans:
            begin, end, is_statement, mutants = spans[0]
            inner = [span for span in spans[1:] if span[0] < end]
            spans = spans[1 + len(inner):]
            self.put(self.source[at:begin].decode())
            (self.write_statement if is_statement else self.write_expression)(begin, end, mutants, inner)
            at = end
        self.put(self.source[at:last].decode())

    def changed(self, begin, end, mutant):
        return (self.source[begin:mutant.first] + mutant.text.encode() + self.source[mutant.last:end]).decode()

    def write_expression(self, begin, end, mutants, inner):
        self.put("(")
        for mutant in mutants:
            self.put(f"\n{question(self.numbers[mutant.name])} ? ({self.changed(begin, end, mutant)}) :", mutant)
        self.put("\n(")
        self.write(begin, end, inner)
        self.put("))")

    def write_statement(self, begin, end, mutants, inner):
        self.put("{")
        for mutant in mutants:
            other = "" if mutant.kind == "statements" else self.changed(begin, end, mutant)
            self.put(f"\nif ({question(self.numbers[mutant.name])}) {{ {other} }} else", mutant)
        self.put("\n{ ")
        self.write(begin, end, inner)
        self.put(" }}")
