#!/bin/sh
# The four unknowns of validation/D6_wheel from its plate, by the solver through a surrogate: the measured points, scatter and priors of
# its second rule, and what is fixed there. Compare with the set in cases/cmu_plate.toml, which scripts/d6/fit_plate.py found.
#
# The first 26 of 36 runs are at the points of d6_design.csv, a Latin hypercube over two standard deviations of the priors.
#
# usage: calibrate_d6.sh COULTER OUT [more options]
set -eu
here=$(cd "$(dirname "$0")" && pwd)
coulter=$1
out=$2
shift 2
exec "$coulter" calibrate "$here/../../cases/cmu_plate.toml" "$here/cmu_plate.csv" \
    --parameter "soil.critical_friction_angle=33 ± 3 deg" \
    --parameter "e_max=1.03 ± 0.05" \
    --parameter "soil.reference_strain=0.002 */ 3" \
    --parameter "soil.compression_modulus=32 MPa */ 3" \
    --link "soil.minimum_density=2650/(1 + e_max) [kg/m^3]" \
    --link "soil.maximum_density=2650/(1 + 0.63*e_max) [kg/m^3]" \
    --design "$here/d6_design.csv" --noise 10% --model solver --budget 36 --threads 1 -o "$out" "$@"
