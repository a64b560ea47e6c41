#!/usr/bin/env bash
# ./dev firmware: builds the images, runs them big-endian on the emulated processor, compares with the host.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
exec python3 verification/target/run_target.py "$@"
