#!/usr/bin/env python3
"""Writes a copy of a shipped source with one defect of defects.json in it.

    python3 verification/campaign/planted/plant.py NAME COPY

The form is that of verification/mutation/mutants.json: one exact replacement of text.
Exit status: 0 written; 1 the text no longer stands in the source as often as the defect says; 2 bad input.
"""
import json
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[2]


def main(arguments):
    if len(arguments) != 2:
        print("plant.py: expected NAME COPY", file=sys.stderr)
        return 2
    name, copy = arguments
    defects = {defect["name"]: defect for defect in json.loads((HERE / "defects.json").read_text(encoding="utf-8"))["mutants"]}
    if name not in defects:
        print(f"plant.py: no defect '{name}', expected one of {', '.join(defects)}", file=sys.stderr)
        return 2
    defect = defects[name]
    text = (ROOT / defect["file"]).read_text(encoding="utf-8")
    found = text.count(defect["find"])
    if found != defect["count"]:
        print(f"{defect['file']}: the text of defect {name} occurs {found} times, expected {defect['count']}", file=sys.stderr)
        return 1
    pathlib.Path(copy).write_text(text.replace(defect["find"], defect["replace"]), encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
