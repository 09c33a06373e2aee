#!/usr/bin/env bash
# Builds a release into dist/ and tries what it has built:
#
#   coulter-VERSION-x86_64-unknown-linux-musl     the command as one static program, stripped
#   coulter_VERSION_amd64.deb                     the same as a Debian package, with manual pages, completions and example cases
#   coulter-VERSION-*.whl                         the Python package
#   libcoulter_fmu.so                             what `coulter export-fmu` puts into FMUs; the Debian package has it, too
#   Containerfile                                 podman build -t coulter dist
#   licences/                                     licences of everything that is linked into them
#   man/, completions/                            manual pages; completions for five shells
#   SHA256SUMS                                    of all of these
#
#   scripts/release/build.sh             from committed files alone
#   scripts/release/build.sh --check     what CI can afford: the static program alone, from the files as they are, without timing it
#
# Needs Rust from rustup, a C compiler and Python 3; on the first call also the package index, for maturin and cargo-about. Installs
# musl-tools where that is missing and may be installed.
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/../.."
target=x86_64-unknown-linux-musl
python="${PYTHON:-python3}"
dist="$PWD/dist"
built="${CARGO_TARGET_DIR:-$PWD/target}"
tools="$built/release-tools"
scratch="$(mktemp -d)"
check=""
case "${1:-}" in
    "") ;;
    --check) check=yes; dist="$scratch/dist" ;;
    *) echo "release: unknown argument $1; there is --check" >&2; exit 2 ;;
esac
# Files that go into the wheel from outside its folder; they are made here and are gone afterwards.
in_wheel=(crates/python/LICENSES-THIRD-PARTY.txt crates/python/LICENSES-RUST-LIBRARY.html)
trap 'rm -rf "$scratch"; rm -f "${in_wheel[@]}"' EXIT

part() {
    echo "release: == $1 ($SECONDS s)"
}

fail() {
    echo "release: $1" >&2
    exit 1
}

from_committed_files() {
    [ -z "$(git status --porcelain)" ] || fail "there are changes that are not committed: $(git status --porcelain | head -n 3)"
}

# The target of Rust, and a C compiler for it (the compression library is in C).
static_target() {
    rustup target list --installed | grep -qx "$target" || rustup target add "$target"
    command -v musl-gcc >/dev/null && return
    local as_root=""
    [ "$(id -u)" -eq 0 ] || as_root="sudo -n"
    $as_root apt-get install -y musl-tools >/dev/null 2>&1 ||
        { $as_root apt-get update && $as_root apt-get install -y musl-tools; } >/dev/null || fail "musl-gcc is missing; install musl-tools"
}

# Sets `program`. Paths of this machine would be in the messages of panics.
static_program() {
    local flags="--remap-path-prefix=$PWD=coulter --remap-path-prefix=${CARGO_HOME:-$HOME/.cargo}=cargo"
    CC_x86_64_unknown_linux_musl=musl-gcc CARGO_TARGET_X86_64_UNKNOWN_LINUX_MUSL_RUSTFLAGS="$flags" \
        cargo build --release --locked --target "$target" -p coulter-cli
    program="$dist/coulter-$version-$target"
    cp "$built/$target/release/coulter" "$program"
}

# FMUs are loaded by programs with the usual C library.
fmu_library() {
    cargo build --release --locked -p coulter-fmu
    cp "$built/release/libcoulter_fmu.so" "$dist/"
    "$program" export-fmu cases/light_disc.toml --library "$dist/libcoulter_fmu.so" -o "$scratch/light_disc.fmu" >/dev/null ||
        fail "$program cannot export an FMU"
}

# Licences of all crates in program and wheel, of what these bring along in C, of Rust's library and of the font in the pictures.
licences() {
    local about="$tools/bin/cargo-about" crates rust zstd
    if [ ! -x "$about" ]; then
        cargo install cargo-about --version 0.9.3 --locked --features cli --root "$tools"
    fi
    mkdir "$dist/licences"
    crates="$dist/licences/THIRD-PARTY.txt"
    # Offline: texts come from the packages alone, so that the same files give the same list.
    cargo fetch --locked
    "$about" generate --workspace --locked --offline --fail -c scripts/release/about.toml scripts/release/about.hbs -o "$crates"
    zstd="$(cargo metadata --locked --format-version 1 |
        "$python" -c 'import json, os, sys
print(*(os.path.dirname(p["manifest_path"]) for p in json.load(sys.stdin)["packages"] if p["name"] == "zstd-sys"))')"
    append "Zstandard, in C (zstd-sys)" "$zstd/zstd/LICENSE" >>"$crates"
    append "DejaVu Sans, the font in the pictures" crates/report/assets/DejaVuSans-LICENSE.txt >>"$crates"
    append "musl, the C library in the static program" /usr/share/doc/musl/copyright >>"$crates"
    rust="$(rustc --print sysroot)/share/doc/rust/COPYRIGHT-library.html"
    cp "$rust" "$dist/licences/RUST-LIBRARY.html"
    cp LICENSE-MIT LICENSE-APACHE "$dist/licences/"
    cp "$crates" "${in_wheel[0]}"
    cp "$rust" "${in_wheel[1]}"
    grep -q "Apache License" "$crates" && grep -q "Permission is hereby granted" "$crates" || fail "licence texts are missing in $crates"
}

append() {
    printf '\n%s\n%s\n\n' "================================================================================" "$1"
    cat "$2"
}

wheel() {
    "$python" -m venv "$scratch/maturin"
    "$scratch/maturin/bin/pip" install --quiet "maturin>=1.9,<2"
    (cd crates/python && "$scratch/maturin/bin/maturin" build --release --locked --out "$dist")
    local found name
    found="$("$python" -m zipfile -l "$dist"/*.whl)"
    for name in LICENSE-MIT LICENSE-APACHE "$(basename "${in_wheel[0]}")" "$(basename "${in_wheel[1]}")"; do
        grep -q "licenses/$name" <<<"$found" || fail "the wheel has no $name"
    done
    "$python" -m venv "$scratch/user"
    "$scratch/user/bin/pip" install --quiet "$dist"/*.whl
    [ "$("$scratch/user/bin/coulter" --version)" = "coulter $version" ] || fail "the wheel's command does not answer"
}

# Manual pages and completions, by the program itself.
pages_and_completions() {
    local shell
    mkdir "$dist/completions" "$dist/man"
    "$program" man "$dist/man" >/dev/null
    for shell in bash zsh fish powershell elvish; do
        "$program" completions "$shell" >"$dist/completions/coulter.$shell"
        [ -s "$dist/completions/coulter.$shell" ] || fail "no completions for $shell"
    done
    [ -s "$dist/man/coulter.1" ] || fail "no manual page"
}

# The static program with manual pages, completions and cases where Debian looks for them; it needs no other package.
debian_package() {
    local root="$scratch/deb" shared="$scratch/deb/usr/share" package="$dist/coulter_${version}_amd64.deb"
    install -Dm755 "$program" "$root/usr/bin/coulter"
    install -Dm644 -t "$root/usr/lib/coulter" "$dist/libcoulter_fmu.so"
    install -Dm644 -t "$shared/man/man1" "$dist"/man/*.1
    gzip -9n "$shared"/man/man1/*
    install -Dm644 "$dist/completions/coulter.bash" "$shared/bash-completion/completions/coulter"
    install -Dm644 "$dist/completions/coulter.zsh" "$shared/zsh/vendor-completions/_coulter"
    install -Dm644 "$dist/completions/coulter.fish" "$shared/fish/vendor_completions.d/coulter.fish"
    install -Dm644 -t "$shared/doc/coulter/examples" cases/*.toml cases/*.json cases/*.stl
    cat LICENSE-MIT LICENSE-APACHE $([ -n "$check" ] || echo "$dist/licences/THIRD-PARTY.txt") >"$shared/doc/coulter/copyright"
    mkdir "$root/DEBIAN"
    cat >"$root/DEBIAN/control" <<CONTROL
Package: coulter
Version: $version
Architecture: amd64
Maintainer: The Coulter developers <coulter@invalid>
Installed-Size: $(du -sk "$root/usr" | cut -f1)
Section: science
Priority: optional
Description: Rigid bodies moving through soil
 Explicit coupled Eulerian-Lagrangian solver and closed-form models of discs,
 wheels, blades, pipes and footings in sand and clay: sinkage, forces, ruts.
CONTROL
    dpkg-deb --root-owner-group --build "$root" "$package" >/dev/null
    dpkg-deb -x "$package" "$scratch/installed"
    [ "$("$scratch/installed/usr/bin/coulter" --version)" = "coulter $version" ] || fail "the program of $package does not answer"
}

# The program is static, names no folder of this machine, and gives the numbers of the ordinary one.
try_program() {
    file "$program" | grep -Eq "static(ally|-pie) linked" || fail "not static: $(file "$program")"
    ldd "$program" 2>&1 | grep -Eq "statically linked|not a dynamic executable" || fail "not static: $(ldd "$program")"
    ! grep -aqF -e "$PWD/" -e "${CARGO_HOME:-$HOME/.cargo}/" "$program" || fail "$program names folders of this machine"
    [ "$("$program" --version)" = "coulter $version" ] || fail "$program does not answer"
    cargo build --release --locked -p coulter-cli
    ordinary="$built/release/coulter"
    local each
    for each in program ordinary; do
        "${!each}" run cases/passive_wall.toml -o "$scratch/$each" >/dev/null 2>&1 || fail "the short run of ${!each} ended with $?"
    done
    "$python" scripts/release/compare_runs.py "$scratch/program" "$scratch/ordinary"
}

# The C library of the static program has another allocator, and elementary functions that differ in the last bit: a towed disc, in which
# small differences grow, shows by how much.
speed() {
    local each n
    for each in program ordinary; do
        "${!each}" run cases/light_disc.toml -o "$scratch/disc_$each" --set grid.cell="12 mm" --set run.tow_distance="0.02 m" >/dev/null 2>&1 ||
            fail "the towed disc of ${!each} ended with $?"
    done
    "$python" scripts/release/compare_runs.py "$scratch/disc_program" "$scratch/disc_ordinary" --steady
    for n in 1 2 3; do
        for each in program ordinary; do
            "${!each}" bench --json --warm-up 200 --steps 600 >"$scratch/$each.$n.json"
        done
    done
    "$python" scripts/speed/compare.py static "$scratch"/program.*.json -- ordinary "$scratch"/ordinary.*.json
}

sums() {
    (cd "$dist" && find . -type f ! -name SHA256SUMS -printf '%P\0' | sort -z | xargs -0 sha256sum >SHA256SUMS && sha256sum --quiet -c SHA256SUMS)
}

version="$(cargo metadata --no-deps --locked --format-version 1 |
    "$python" -c 'import json, sys; print(next(p["version"] for p in json.load(sys.stdin)["packages"] if p["name"] == "coulter-cli"))')"
[ -n "$check" ] || from_committed_files
rm -rf "$dist"
mkdir -p "$dist"

part "static program, version $version"
static_target
static_program
part "library of FMUs"
fmu_library
if [ -z "$check" ]; then
    part "licences"
    licences
    part "wheel"
    wheel
fi
part "manual pages and completions"
pages_and_completions
if command -v dpkg-deb >/dev/null; then
    part "Debian package"
    debian_package
fi
cp scripts/release/Containerfile "$dist"
part "trial"
try_program
if [ -z "$check" ]; then
    part "speed"
    speed
fi
part "sums"
sums
(cd "$dist" && find . -type f -printf '%10s  %P\n' | sort -k 2)
part "end"
