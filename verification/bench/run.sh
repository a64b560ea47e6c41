#!/usr/bin/env bash
# ./dev bench: builds what is measured, measures it, prints the table, fails when a limit is broken.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
exec python3 verification/bench/bench.py "$@"
