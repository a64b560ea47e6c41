#!/usr/bin/env python3
"""Whether the stack of an entry point is computed as it is, and what nobody can compute fails: small images of a few functions each.

Exit status: 0 all is as expected, 1 something is not.
"""
import pathlib
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve()
sys.path.insert(0, str(HERE.parent))
import stack  # noqa: E402

COMPILER = ("arm-none-eabi-gcc", "-mcpu=cortex-r5", "-mthumb", "-O1", "-fno-inline", "-fno-exceptions", "-fno-asynchronous-unwind-tables", "-fno-unwind-tables", "-fcallgraph-info=su", "-nostdlib", "-Wl,-eEntry")
# What a frame holds is written and read where the compiler does not see it.
HEAD = "extern \"C\" {\nvolatile int place;\n__attribute__((noinline)) void Use(volatile int* it) { place = *it; }\n"
LEAF = "__attribute__((noinline)) void Leaf() { volatile int room[100]; room[0] = 1; Use(&room[0]); }\n"
RIGHT = LEAF + "void Entry() { volatile int room[20]; room[0] = 2; Use(&room[0]); Leaf(); place = 3; }\n"
RECURSIVE = "void Entry();\n__attribute__((noinline)) void Back() { if (place) { Entry(); place = 1; } }\nvoid Entry() { Back(); place = 2; }\n"
DYNAMIC = "void Entry() { volatile int* room = (volatile int*)__builtin_alloca(place); room[0] = 1; Use(room); }\n"
INDIRECT = LEAF + "void (*volatile there)();\nvoid Entry() { there(); place = 1; }\n"
TABLE = "Other:: -> Interface::Method\n"


def computed(folder, name, source, table=TABLE):
    """Depth of Entry, and what could not be resolved."""
    place = folder / name
    place.mkdir()
    (place / "image.cpp").write_text(HEAD + source + "}\n", encoding="utf-8")
    (place / "calls.txt").write_text(table, encoding="utf-8")
    subprocess.run([*COMPILER, "-o", place / "image.elf", place / "image.cpp"], check=True, cwd=place)
    rows, problems = stack.compute(place / "image.elf", place, place / "calls.txt", ["Entry"])
    return rows[0][1], problems


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        right, none = computed(folder, "right", RIGHT)
        entries = [("right", 480 <= right <= 544 and none == []),  # 100 and 20 words, and what is pushed.
                   ("recursion", any(text.startswith("recursion: Entry") for text in computed(folder, "recursive", RECURSIVE)[1])),
                   ("a dynamic frame", any("not of fixed size (dynamic" in text for text in computed(folder, "dynamic", DYNAMIC)[1])),
                   ("a call through a register that no line lists", any("call through a register" in text for text in computed(folder, "indirect", INDIRECT)[1])),
                   ("the same one, listed", computed(folder, "listed", INDIRECT, "Entry -> -\n")[1] == [])]
    for what, good in entries:
        print(f"{'pass' if good else 'FAIL'}  {what}")
    return 0 if all(good for _, good in entries) else 1


if __name__ == "__main__":
    sys.exit(main())
