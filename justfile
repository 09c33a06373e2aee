# What a developer does every day; `just` lists it. Each recipe is one line that can be typed without just.

_list:
    @just --list --unsorted

# Format, spelling, links, lints, documentation of the library
check:
    .ci/run lint

# The tests, of one crate (`just test solver`) or of all
test crate="":
    cargo test --release --locked --no-fail-fast {{ if crate == "" { "--workspace" } else if crate == "coulter" { "-p coulter" } else { "-p coulter-" + crate } }}

# 31 short runs of every kind give the same bits as before
fingerprints:
    cargo test --release --locked -p coulter --test fingerprints

# Rewrites what follows from the tables of keys, columns, limits and commands
update:
    COULTER_UPDATE=1 cargo test --release --locked -p coulter-case -p coulter-results -p coulter-studies -p coulter
    COULTER_UPDATE=1 cargo test --release --locked -p coulter-cli --test commands

# The verification suite, the quick part of it unless ids are given
verify *ids:
    cargo run --release -- verify {{ if ids == "" { "--fast --strict" } else { ids } }}

# The book, into target/book; `just book --pdf` prints it too
book *options:
    scripts/book/build {{ options }}

# What each source file is for
map *crates:
    @python3 scripts/book/map.py {{ crates }}

# Feeds a reader with garbage: case, study, table, mesh, heights, checkpoint, results, deck; `just fuzz` names them
fuzz target="" *options:
    scripts/fuzz {{ target }} {{ options }}

# Changes the physics line by line and asks whether a test fails
mutants part *options:
    scripts/mutants {{ part }} {{ options }}

# As fast as another commit? Both are built and bench in turns
guard commit:
    scripts/speed/guard {{ commit }}

# Everything that must pass before a merge
ci *parts:
    .ci/run {{ parts }}

# What users install, into dist/: static program, Debian package, wheel
release *options:
    scripts/release/build.sh {{ options }}
