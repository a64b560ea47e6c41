#!/usr/bin/env python3
"""Links of the documents lead to files and headings of the tree. Addresses on the web are not looked at."""
import pathlib
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from common import CannotLook, files, read, run_gate  # noqa: E402

LINK = re.compile(r"\[[^\]\n]*\]\(<?([^)\s>]+)>?\)")
CODE = re.compile(r"^(```|~~~).*?^\1[^\n]*$|`[^`\n]*`", re.MULTILINE | re.DOTALL)
WEB = re.compile(r"[a-z][a-z0-9+.-]*:", re.IGNORECASE)


def without_code(text):
    """The same lines, code blanked: what it shows in brackets is no link."""
    return CODE.sub(lambda match: re.sub(r"[^\n]", " ", match.group(0)), text)


def anchors(text):
    """Names that hosts of repositories give to headings: small letters, blanks as hyphens, a number for the second of a name."""
    names, seen = set(), {}
    body = re.sub(r"^(```|~~~).*?^\1[^\n]*$", "", text, flags=re.MULTILINE | re.DOTALL)
    for heading in re.findall(r"^#{1,6} +(.*?) *#*$", body, re.MULTILINE):
        plain = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading).replace("`", "").lower()
        name = re.sub(r"[^\w\- ]", "", plain).replace(" ", "-")
        names.add(f"{name}-{seen[name]}" if name in seen else name)
        seen[name] = seen.get(name, 0) + 1
    return names | set(re.findall(r'<a (?:id|name)="([^"]+)"', text))


def check(root, name, target):
    """What is wrong with a link of a document, or nothing."""
    path, _, heading = target.partition("#")
    place = (root / name).parent / path if path else root / name
    if root not in place.resolve().parents and place.resolve() != root:
        return "expected a place in the tree"
    if not place.exists():
        return "expected a file or folder that is there"
    if heading and place.suffix == ".md" and heading not in anchors(place.read_text(encoding="utf-8")):
        return "expected a heading that is there"
    return None


def gate(root, _data):
    findings, count = [], 0
    names = files(root, "*.md")
    if not names:
        raise CannotLook(f"no *.md in {root.name}")
    for name in names:
        for number, line in enumerate(without_code(read(root, name)).splitlines(), start=1):
            for target in LINK.findall(line):
                if WEB.match(target):
                    continue
                count += 1
                wrong = check(root, name, target)
                if wrong:
                    findings.append(f"{name}:{number}: link to '{target}', {wrong}")
    return findings, f"{count} links in {len(names)} documents"


run_gate(gate)
