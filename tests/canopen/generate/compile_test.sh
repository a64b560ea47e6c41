#!/bin/sh
# compile_test.sh SOURCE_FOLDER GENERATED_FOLDER COUNT: all generated dictionaries by all compilers of SRS_GEN_004.
source=$1
folder=$2
count=$3
object=$(mktemp) || exit 2
trap 'rm -f "$object"' EXIT
warnings="-Wall -Wextra -Wpedantic -Wconversion -Wsign-conversion -Wold-style-cast -Wshadow -Werror"
target="-mcpu=cortex-r4f -mbig-endian -mfpu=vfpv3-d16 -mfloat-abi=hard -mthumb -ffreestanding -fno-exceptions -fno-rtti"
failures=0
compiled=0

# compile COMPILER FLAGS...: every dictionary (the build of the tests has made objects of them, too); a compiler that is not installed is named and left out.
compile() {
  if ! command -v "$1" >/dev/null; then
    echo "$1 is not installed: left out"
    return
  fi
  for dictionary in "$folder"/*/object_dictionary.cpp; do
    if "$@" -std=c++17 $warnings -I"$source" -c "$dictionary" -o "$object"; then
      compiled=$((compiled + 1))
    else
      echo "$1 does not compile $dictionary"
      failures=$((failures + 1))
    fi
  done
}

compile g++-12 -fsyntax-only
compile clang++-19 -fsyntax-only
compile arm-none-eabi-g++ -Os $target
echo "$compiled compilations of $count dictionaries"
[ "$failures" -eq 0 ] && [ "$compiled" -ge "$count" ]
