"""Loops of C++ as the gates see them: the head, its condition, what is moved, and by what the loop ends."""
import re

from common import SAFETY_ROOMS, functions, without_comments

# Where each loop is listed with its bound.
ROOMS = (*SAFETY_ROOMS, "hal/api")
HEAD = re.compile(r"\b(for|while)\s*\(")
NUMBER = re.compile(r"(0x[0-9A-Fa-f]+|\d+)[Uu]?(?:LL)?")
CONSTANT = re.compile(r"\bconstexpr\s+[\w:]+(?:\s+|\s+[\w:]+\s+)(k[A-Z]\w*)\s*(?:\{|=\s*)(0x[0-9A-Fa-f]+|\d+)[Uu]?(?:LL)?\s*[};]")
# A condition that holds as long as there is something left -> (what must move in head or body, what bounds the turns). {0} is the name.
KINDS = [
    (r"(\w+)(?: \+ \w+)? <=? (.+)", r"(\+\+|--){0}\b|\b{0} \+= ", "{1}"),
    (r"low < high", r"\blow = .*\bhigh = |\bhigh = .*\blow = ", "halvings of what is searched"),
    (r"left != 0U", r"\bleft = .*\bhalf\b", "halvings of what is searched"),
    (r"(\w+) > (.+)", r"--{0}\b", "{first}"),
    (r"(\w+) != 0U", r"--{0}\b", "{first}"),
    (r"(\w+) != (.*\bend)", r"\+\+{0}\b", "elements up to {1}"),
    (r"(\w+) != 0U", r"\b{0} (?:&= {0} - 1U|<<= 1U|>>= 1U)", "bits of {0}"),
    (r"\((\w+) & \w+\) == 0U", r"\b{0} >>= ", "bits of {0}"),
    (r"(\w+)\.mask != 0U", r"\bTakeLowest\({0}\)", "bits of {0}"),
    (r"(\w+)\.Next\(\)", r"", "slots of the mask that {0} walks"),
    (r"(\w+)\.IsAtSlot\(\)", r"\b{0}\.GoOn\(\)", "slots of the mask that {0} walks"),
    (r"line != 0U", r"\bline << 1U", "bits of an address"),
]


def head_of(code, start, pair="()"):
    """The text between the parentheses that open at `start`."""
    depth = 0
    for place in range(start, len(code)):
        depth += {pair[0]: 1, pair[1]: -1}.get(code[place], 0)
        if depth == 0:
            return code[start + 1:place]
    return code[start + 1:]


def split(text, operator):
    """Parts of an expression that stand on its outermost level."""
    text = text.strip()
    while text.startswith("(") and head_of(text, 0) == text[1:-1]:
        text = text[1:-1].strip()
    parts, depth, start = [], 0, 0
    for place, letter in enumerate(text):
        depth += {"(": 1, ")": -1}.get(letter, 0)
        if depth == 0 and text.startswith(operator, place):
            parts.append(text[start:place])
            start = place + len(operator)
    return parts + [text[start:]]


def flat(text):
    return " ".join(text.split())


class Loop:
    def __init__(self, code, match):
        self.before = code[:match.end()]
        self.line = code.count("\n", 0, match.start()) + 1
        self.keyword = match.group(1)
        inside = head_of(code, match.end() - 1)
        self.head = flat(inside)
        behind = code[match.end() + len(inside) + 1:]
        start = len(behind) - len(behind.lstrip())
        body = head_of(behind, start, "{}") if behind[start:start + 1] == "{" else behind[:behind.find(";")]
        self.parts = [flat(part) for part in inside.split(";")] if self.keyword == "for" else [self.head]
        self.moved = flat((self.parts[2] if len(self.parts) == 3 else "") + " ; " + body)

    @property
    def bound(self):
        """What its turns are at most, in the words of the code; "" when its head does not show that it ends."""
        if self.keyword == "for" and len(self.parts) == 1:
            ranged = re.fullmatch(r".*?[^:]:([^:].*)", self.head)
            return f"elements of {ranged.group(1).strip()}" if ranged else ""
        condition = self.parts[1] if len(self.parts) == 3 else self.head
        if len(split(condition, "||")) > 1:
            return ""
        return next((bound for part in split(condition, "&&") if (bound := self.bound_of(split(part, "&&")[0].strip()))), "")

    def bound_of(self, part):
        for condition, moved, bound in KINDS:
            match = re.fullmatch(condition, part)
            names = [re.escape(name) for name in match.groups()] if match else []
            if match and not self.moves_end(match) and self.is_walk_where_told(bound, match) and re.search(moved.format(*names) if names else moved, self.moved):
                first = re.search(r"= (.+)|\{(.+)\}", self.parts[0]) if len(self.parts) == 3 else None
                return bound.format(*(split(name, "&&")[0] for name in match.groups()), first=(first.group(1) or first.group(2)) if first else "its first value")
        return ""


    def is_walk_where_told(self, bound, match):
        """A walk over slots is one by its type."""
        head = self.before + self.head
        return "mask that" not in bound or re.search(rf"\bSlotWalk\s+{match.group(1)}\b", head) is not None

    def moves_end(self, match):
        """Whether the end of a counter is assigned in the loop itself."""
        end = match.group(2) if match.re.groups > 1 else ""
        return re.fullmatch(r"\w+", end) is not None and re.search(rf"(\+\+|--){end}\b|\b{end} [-+*]?= ", self.moved) is not None


def loops_of(text):
    """The loops of a file, in their order; what does a do loop is a `while` of its own."""
    code = without_comments(text)
    return [Loop(code, match) for match in HEAD.finditer(code)]


def function_at(text, line):
    """The name of the function around a line."""
    around = [function for function in functions(text) if function.first_line <= line <= function.last_line]
    return around[-1].name if around else ""


def constants(texts):
    """Name -> value of each constant that is a number, and the same number wherever there is one of this name."""
    found = {}
    for text in texts:
        for name, value in CONSTANT.findall(text):
            found.setdefault(name, set()).add(int(value, 0))
    return {name: values.pop() for name, values in found.items() if len(values) == 1}


def number_of(bound, known):
    """A bound as a number, where it is one constant or literal; the slots of a mask are kMaxSrdoCount."""
    if "mask that" in bound:
        return known.get("kMaxSrdoCount")
    literal = NUMBER.fullmatch(bound)
    return int(literal.group(1), 0) if literal else known.get(bound.rsplit("::", 1)[-1])
