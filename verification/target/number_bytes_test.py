#!/usr/bin/env python3
"""Whether numbers and their bytes are right on processors of either byte order: the cross compiler works out number_bytes.cpp for each, and
what remains is looked at. A byte that is expected otherwise, and code that takes the processor's own order, have to be refused.

Exit status: 0 all is as expected, 1 something is not.
"""
import pathlib
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
SOURCE = "safety_core/kernel/variable.cpp"
# As bytes lie in the processor, which is right on one of the two.
OWN_ORDER = ("    VariableValue rest = value;\n", "    VariableValue rest = value;\n    if (variable.length_bits == 64U)\n    {\n"
             "        __builtin_memcpy(variable.place, &rest.bits, 8U);\n        return;\n    }\n")


def is_right(folder, order, *options):
    """Whether no call of Wrong is left for a processor of this byte order."""
    objects = folder / f"{order}.o"
    subprocess.run(["arm-none-eabi-g++", "-std=c++17", f"-m{order}-endian", "-mcpu=cortex-r5", "-mthumb", "-O3", "-fno-exceptions", "-fno-rtti", "-w",
                    *options, f"-I{ROOT}", "-c", str(HERE / "number_bytes.cpp"), "-o", str(objects)], check=True)
    names = subprocess.run(["arm-none-eabi-nm", str(objects)], check=True, capture_output=True, text=True).stdout
    return " U Wrong" not in names and " T Check" in names


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        changed = folder / SOURCE
        changed.parent.mkdir(parents=True)
        text = (ROOT / SOURCE).read_text(encoding="utf-8")
        changed.write_text(text.replace(*OWN_ORDER), encoding="utf-8")
        own = [is_right(folder, order, f"-I{folder}") for order in ("little", "big")]
        results = [("little-endian", is_right(folder, "little")), ("big-endian", is_right(folder, "big")),
                   ("another byte is refused", not any(is_right(folder, order, "-DOTHER_BYTE=1U") for order in ("little", "big"))),
                   ("the processor's own order is refused where it is another one", OWN_ORDER[0] in text and own == [True, False])]
    for what, good in results:
        print(f"{'pass' if good else 'FAIL'}  {what}")
    return 0 if all(good for _, good in results) else 1


if __name__ == "__main__":
    sys.exit(main())
