#!/usr/bin/env bash
# Writes the tables and the plot of docs/benchmark_beads.md anew: rewrite_page.sh BUILD_FOLDER [PANEL or other options of bead_table.py ...]
set -euo pipefail
build=$(realpath "$1")
shift
python=${PYTHON:-/usr/bin/python3}
here=$(cd "$(dirname "$0")" && pwd)
docs=$here/../../docs
program=$build/apps/beadmesh/beadmesh

[[ $# -gt 0 ]] || set -- single basic rotated

"$python" "$here/bead_table.py" "$program" --page "$docs/benchmark_beads.md" "$@"
"$python" "$here/modal_check.py" "$program" --page "$docs/benchmark_beads.md" --plot "$docs/pictures/modal_check.svg"
