#!/usr/bin/env python3
"""The two channels are not written alike: few runs of tokens that both have, and no number of five digits but those of the standard and the contract.

Names are blanked, numbers count by their value, operators and keywords stay. A run is 15 tokens, three of them operators, that stands in
both channels; at most 0.8 % of the tokens of either may lie in such runs (unrelated rooms share 0.3 to 0.8 %). A number is one that
is written with five digits or more without leading zeros, whatever its base; numbers of the contract are shared on purpose.
"""
import pathlib
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from common import CannotLook, cpp_files, read, run_gate, without_comments  # noqa: E402

RUN = 15
OPERATORS_IN_RUN = 3
MOST_SHARED = 0.008
CHANNELS = ("channel_a", "channel_b")
CONTRACT = ("safety_core/contract",)
# CRC-32 as IEEE 802.3 has it, both ways round, and the start of a register of 32 bits.
OF_STANDARDS = {0x04C11DB7, 0xEDB88320, 0xFFFFFFFF}

KEYWORDS = set("""alignas auto bool break case class const constexpr continue default delete do else enum explicit false final for friend if inline
    mutable namespace new noexcept nullptr operator override private protected public return sizeof static static_assert static_cast
    reinterpret_cast struct switch template this true typename union using virtual void while""".split())
OPERATORS = set("+ - * / % ^ & | ~ << >> < > <= >= == != += -= *= /= %= ^= &= |= <<= >>=".split())
LITERAL = re.compile(r"(?:0[xX][0-9A-Fa-f']+|0[bB][01']+|\d[\d']*)[uUlLzZ]*")
TOKEN = re.compile(r"\s+|(?P<number>" + LITERAL.pattern + r")|(?P<word>[A-Za-z_]\w*(?:::~?[A-Za-z_]\w*)*)"
                   r"|(?P<sign><<=|>>=|->\*?|\+\+|--|&&|\|\||[-+*/%&|^<>=!]=|<<|>>|::|.)", re.DOTALL)


def value_of(literal):
    digits = literal.rstrip("uUlLzZ").replace("'", "")
    return int(digits, 0) if digits[:1] != "0" or digits[1:2].lower() in ("x", "b") else int(digits, 8)


def is_long(literal):
    digits = literal.rstrip("uUlLzZ").replace("'", "").lower()
    return len(digits[2:].lstrip("0") if digits.startswith("0x") else str(value_of(literal))) >= 5


def tokens(text):
    """(token, line) without comments, directives and names."""
    code = re.sub(r"(?m)^[ \t]*#(?:[^\n]*\\\n)*[^\n]*", lambda found: "\n" * found.group(0).count("\n"), without_comments(text))
    line = 1
    for found in TOKEN.finditer(code):
        if found.group("number"):
            yield str(value_of(found.group("number"))), line
        elif found.group("word"):
            yield found.group("word") if found.group("word") in KEYWORDS else "name", line
        elif found.group("sign"):
            yield found.group("sign"), line
        line += found.group(0).count("\n")


def numbers(text):
    """Value -> line of each number of five digits."""
    code = without_comments(text)
    return {value_of(found.group(0)): code.count("\n", 0, found.start()) + 1
            for found in re.finditer(r"(?<![\w.])" + LITERAL.pattern + r"(?![\w.])", code) if is_long(found.group(0))}


def runs(listing):
    """Run -> the places (file, first token) where it stands."""
    found = {}
    for name, sequence in listing.items():
        for first in range(len(sequence) - RUN + 1):
            run = tuple(token for token, _ in sequence[first:first + RUN])
            if sum(token in OPERATORS for token in run) >= OPERATORS_IN_RUN:
                found.setdefault(run, []).append((name, first))
    return found


def covered(own, other):
    """Tokens of `own` that lie in runs of both, as (file, token)."""
    return {(name, first + step) for run, places in own.items() if run in other for name, first in places for step in range(RUN)}


def stretches(hit, listing):
    """The covered tokens as `file:line` of each stretch's beginning."""
    return [f"{name}:{listing[name][place][1]}" for name, place in sorted(hit) if (name, place - 1) not in hit]


def gate(root, _data):
    listings, constants = [], []
    for channel in CHANNELS:
        names = cpp_files(root, (channel,))
        listings.append({name: list(tokens(read(root, name))) for name in names})
        constants.append({value: (name, line) for name in names for value, line in numbers(read(root, name)).items()})
    contract = set()
    if (root / CONTRACT[0]).exists():
        contract = {value for name in cpp_files(root, CONTRACT) for value in numbers(read(root, name))}
    findings = []
    for value in sorted((constants[0].keys() & constants[1].keys()) - contract - OF_STANDARDS):
        places = [f"{name}:{line}" for name, line in (constants[0][value], constants[1][value])]
        findings.append(f"{places[0]}: the number {value:X}h stands in {places[1]} as well, expected no number of five digits in both channels")
    all_runs = [runs(listing) for listing in listings]
    shown = []
    for own, other in ((0, 1), (1, 0)):
        total = sum(len(sequence) for sequence in listings[own].values())
        if total == 0:
            raise CannotLook(f"no token in {CHANNELS[own]}")
        hit = covered(all_runs[own], all_runs[other])
        share = len(hit) / total
        shown.append(f"{100 * share:.2f} % of {total} tokens of {CHANNELS[own]} in runs of both")
        if share > MOST_SHARED:
            places = stretches(hit, listings[own])
            findings.append(f"{places[0]}: {100 * share:.2f} % of the tokens of {CHANNELS[own]} lie in runs that {CHANNELS[1 - own]} has, expected at most "
                            f"{100 * MOST_SHARED:.1f} %: {', '.join(places[:30])}{' ...' if len(places) > 30 else ''}")
    return findings, ", ".join(shown)


run_gate(gate)
