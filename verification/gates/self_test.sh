#!/usr/bin/env bash
# Every gate on its fixtures (it must refuse them), then on the tree with the data of the last ./dev verify, if there is any.
# self_test.sh [GATE...]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
python=python3
[ ! -x .venv/bin/python ] || python=.venv/bin/python
what=(--fixtures)
[ ! -d build/evidence/data ] || what=(--tree build/evidence/data)
exec "$python" verification/gates/run.py "${what[@]}" "$@"
