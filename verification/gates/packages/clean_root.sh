#!/usr/bin/env bash
# clean_root.sh FOLDER: a Debian 12 with a C++ compiler, CMake, make, Ninja, pkg-config and Python, and nothing else; from where this machine has
# its packages. What is there already and was made of the same list stays.
set -euo pipefail
folder=$1
packages=g++-12,make,ninja-build,cmake,pkg-config,python3,python3-venv
if [ "$(cat "$folder/etc/counterpoint_clean_root" 2>/dev/null)" = "$packages" ]; then
    echo "$folder: is there"
    exit 0
fi
rm -rf "$folder"
mkdir -p "$(dirname "$folder")"
mirror=$(apt-get indextargets --format '$(CODENAME) $(SITE)' "Created-By: Packages" "Origin: Debian" | sed -n 's/^bookworm //p' | head -n 1)
[ -n "$mirror" ] || { echo "clean_root.sh: apt knows no source of bookworm, expected one in /etc/apt" >&2; exit 2; }
mmdebstrap --variant=apt --include="$packages" bookworm "$folder" "$mirror"
echo "$packages" >"$folder/etc/counterpoint_clean_root"
