#!/usr/bin/env bash
# Builds the wheel and tests it in a clean virtual environment: types, tests, notebooks, and the first ten lines of docs/how-to/python.md.
#
#   scripts/python/build_and_test.sh [--keep DIR]
#
# Needs Python 3.10 or newer and the package index. The wheel is built in the usual target folder, so that libraries which are built
# there are not built again. --keep leaves the wheel in DIR.
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/../.."
python="${PYTHON:-python3}"
keep=""
if [ "${1:-}" = "--keep" ]; then
    keep="$(realpath -m "${2:?--keep needs a folder}")"
fi
scratch="$(mktemp -d)"
trap 'rm -rf "$scratch"' EXIT

part() {
    echo "python: == $1 ($SECONDS s)"
}

part "wheel"
"$python" -m venv "$scratch/build"
"$scratch/build/bin/pip" install --quiet "maturin>=1.9,<2"
(cd crates/python && "$scratch/build/bin/maturin" build --release --locked --out "$scratch/wheels")
if [ -n "$keep" ]; then
    mkdir -p "$keep"
    cp "$scratch"/wheels/*.whl "$keep"
fi
# The program that the wheel's numbers are compared with.
cargo build --release --locked -p coulter-cli
export COULTER_PROGRAM="${CARGO_TARGET_DIR:-$PWD/target}/release/coulter"

# From here on as a user has it: nothing but the wheel and what it asks for.
part "first plot"
"$python" -m venv "$scratch/user"
wheel="$(ls "$scratch"/wheels/*.whl)"
# From `pip install` to a plot, in the ten lines of the documentation.
mkdir "$scratch/first"
sed -n '/^```python/,/^```/p' docs/how-to/python.md | sed '1d; /^```/,$d' >"$scratch/first/first.py"
lines="$(grep -c . "$scratch/first/first.py")"
[ "$lines" -le 10 ] || { echo "python: the first example of docs/how-to/python.md has $lines lines" >&2; exit 1; }
began="$EPOCHREALTIME"
"$scratch/user/bin/pip" install --quiet "$wheel[matplotlib]"
(cd "$scratch/first" && MPLBACKEND=agg "$scratch/user/bin/python" first.py)
[ -s "$scratch/first/tow.png" ] || { echo "python: the first example left no plot" >&2; exit 1; }
awk -v began="$began" -v ended="$EPOCHREALTIME" -v lines="$lines" 'BEGIN { printf "python: from pip install to a plot: %.1f s, %d lines\n", ended - began, lines }'

part "packages of the tests"
"$scratch/user/bin/pip" install --quiet mypy pytest nbclient nbformat ipykernel pandas xarray pyvista fmpy mujoco

part "types"
(cd crates/python && "$scratch/user/bin/mypy" --config-file pyproject.toml --python-executable "$scratch/user/bin/python")

part "tests and notebooks"
# The package that is installed is tested, not the sources beside the tests.
(cd crates/python && "$scratch/user/bin/python" -m pytest -q -p no:cacheprovider --durations=8)
part "end"
