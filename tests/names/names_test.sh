#!/bin/sh
# names_test.sh PYTHON SOURCE_FOLDER NAMES_FOLDER: every public enumeration of the tree has its names, and one that cannot be read ends the
# build. [SRS_EASE_006]
python=$1
source=$2
names=$3
folder=$(mktemp -d) || exit 2
trap 'rm -rf "$folder"' EXIT
failures=0

# Counted another way than the names are made: by the lines at which a declaration begins.
cd "$source" || exit 2
for header in $(grep -rlE '^enum ' safety_core hal canopen runtime --include='*.hpp'); do
  for enumeration in $(sed -nE 's/^enum (class |struct )?([A-Za-z0-9_]+)[^;]*$/\2/p' "$header"); do
    if ! grep -q "NameOf(const $enumeration value)" "$names/names/$header" 2>/dev/null; then
      echo "$header: $enumeration has no NameOf"
      failures=$((failures + 1))
    fi
  done
done

# refuse TEXT: a header with this text is not read, and its line is told.
refuse() {
  mkdir -p "$folder/tree/hal"
  printf 'namespace a\n{\n%s\n}\n' "$1" >"$folder/tree/hal/x.hpp"
  if "$python" "$source/names/generate.py" "$folder/tree" "$folder/out" >"$folder/said" || ! grep -q '^hal/x.hpp:3: ' "$folder/said"; then
    echo "accepted: $1"
    failures=$((failures + 1))
  fi
}
refuse 'enum Plain { kOne };'
refuse 'enum class Empty : int {};'
refuse 'enum class Odd : int { kOne = 1, Two };'
refuse 'struct S { enum class Inner { kOne }; };'
refuse 'typedef enum { kOne } Old;'
# Near misses: a declaration, one of one line, one that is private.
printf 'namespace a::b\n{\nenum class Later : int;\nenum class One : int { kOne = 1, kTwoWords };\nclass C\n{\n  private:\n    enum class Own { kX };\n};\n}\n' >"$folder/tree/hal/x.hpp"
"$python" "$source/names/generate.py" "$folder/tree" "$folder/out" || failures=$((failures + 1))
grep -q 'return "two_words";' "$folder/out/names/hal/x.hpp" || failures=$((failures + 1))
[ "$(grep -c 'NameOf(const' "$folder/out/names/hal/x.hpp")" -eq 1 ] || failures=$((failures + 1))
[ "$failures" -eq 0 ]
