//! Ground under water: submerged weights of soil and bodies, the drag of the water, what is refused, and the
//! forecast with suction.
use super::{SAND, fastest, read};
use coulter::case::Case;
use coulter::forecast::outlook;
use coulter::simulation::Simulation;
use glam::DVec3;

const WATER: &str = "[water]\nlevel = \"2 m\"\npermeability = \"1 cm/s\"\n";
const BLOCK: &str =
    "[body.block]\nshape = \"block\"\nsize = [\"40 mm\", \"40 mm\", \"40 mm\"]\nfriction = 0.3\n";
const DISC: &str = "[body.disc]\nshape = \"disc\"\ndiameter = \"0.2 m\"\nthickness = \"50 mm\"\nfriction = 0.3\nweight = \"100 N\"\n\
                    forward = { speed = \"0.2 m/s\", ramp = \"10 ms\" }\nheave = \"free\"\nspin = \"free\"\n";

fn text(water: &str, soil: &str, body: &str) -> String {
    format!(
        "format = 2\n{water}[soil]\nyoung_modulus = \"3 MPa\"\n{soil}\n\
         [domain]\nx = [\"-0.5 m\", \"0.5 m\"]\ny = [\"-0.2 m\", \"0.2 m\"]\nz = [\"-0.2 m\", \"0.5 m\"]\n[grid]\ncell = \"20 mm\"\nfine_z = [\"-0.1 m\", \"0.4 m\"]\n{body}\n\
         [run]\nduration = \"0.1 s\"\n"
    )
}

fn case(water: &str, soil: &str, body: &str) -> Case {
    read(&text(water, soil, body)).unwrap()
}

#[test]
fn soil_weighs_what_its_grains_weigh_in_water() {
    let lower = format!(
        "\n[layer.gravel]\ntop = \"0.1 m\"\nyoung_modulus = \"3 MPa\"\n{}",
        SAND.replace("0.5", "0.9")
    );
    let sand = case(WATER, &format!("{SAND}{lower}"), "");
    let expected = sand.soil.density * 9.81 * (1.0 - 1000.0 / 2650.0);
    assert!((sand.soil.unit_weight / expected - 1.0).abs() < 1e-12);
    let simulation = super::run(&sand);
    assert!(fastest(&simulation) < 1e-9, "{} m/s", fastest(&simulation));
    // Mean vertical stress in the lowest cell.
    let (grid, soil) = (&simulation.model.grid, &simulation.state.soil);
    let lowest = -soil.stress[2][grid.index(10, 10, 0)];
    let half_a_cell = 0.5 * (grid.faces[2][1] - grid.faces[2][0]);
    let below = sand.layers[0].soil.unit_weight * (0.1 - half_a_cell);
    let found = sand.soil.unit_weight * 0.1 + below;
    assert!((lowest / found - 1.0).abs() < 1e-9, "{lowest} Pa, not {found}");
    // Given as such, the submerged unit weight makes the dry density.
    let clay =
        "law = \"tresca\"\nshear_strength = \"2 kPa\"\npoisson_ratio = 0.49\nunit_weight = \"6 kN/m^3\"";
    let density = case(WATER, clay, "").soil.density;
    assert!((density - 6000.0 / (9.81 * (1.0 - 1000.0 / 2650.0))).abs() < 1e-9);
}

/// How far a body falls, and its speed, at each step [m, m/s].
fn fall(case: &Case) -> Vec<[f64; 3]> {
    let mut simulation: Simulation = Simulation::new(case);
    let mut all = Vec::new();
    while !simulation.is_done() {
        simulation.advance().unwrap();
        let body = &simulation.state.mechanism.bodies[0];
        all.push([simulation.state.time, body.pose.position.z, body.rates()[2]]);
    }
    all
}

#[test]
fn a_body_falls_under_its_submerged_weight_against_the_drag_of_the_water() {
    let body = format!(
        "{BLOCK}mass = \"0.128 kg\"\nelevation = \"0.3 m\"\nheave = {{ load = \"0 N\", ramp = \"0 s\" }}"
    );
    let falling = case(&format!("{WATER}drag_coefficient = 2\n"), SAND, &body);
    // Twice as heavy as water: g' = g/2. Drag ½ρC_dA = 1.6 kg/m.
    let (mass, weight, drag) = (0.128, 0.064 * 9.81, 1.6_f64);
    assert!((falling.weight(&falling.bodies[0]) / weight - 1.0).abs() < 1e-12);
    let terminal = (weight / drag).sqrt();
    let time_scale = mass * terminal / weight;
    for [time, _, speed] in fall(&falling) {
        let expected = -terminal * (time / time_scale).tanh();
        assert!((speed - expected).abs() < 2e-3 * terminal, "at {time} s {speed} m/s, not {expected}");
    }
    let simulation = super::run(&falling);
    let energy = simulation.history.energy.last().unwrap();
    assert!(energy.unexplained().abs() < 1e-6, "{} J", energy.unexplained());
    let free = case(&format!("{WATER}drag_coefficient = 0\n"), SAND, &body);
    let [time, z, _] = *fall(&free).last().unwrap();
    assert!(((0.3 - z) / (0.25 * 9.81 * time * time) - 1.0).abs() < 1e-2);
}

#[test]
fn weights_are_given_in_air_or_in_water_and_the_drag_is_a_column() {
    let heavy = |weight: &str| {
        format!(
            "{BLOCK}{weight}\nelevation = \"0.2 m\"\nheave = \"free\"\nforward = {{ speed = \"1 m/s\", ramp = \"10 ms\" }}"
        )
    };
    let water = format!("{WATER}density = \"1025 kg/m^3\"\naccept_drained = true\n");
    let in_air = case(&water, SAND, &heavy("weight = \"2 N\""));
    let displaced = 1025.0 * 9.81 * 0.04_f64.powi(3);
    let in_water = case(&water, SAND, &heavy(&format!("submerged_weight = \"{} N\"", 2.0 - displaced)));
    assert!((in_water.bodies[0].mass / in_air.bodies[0].mass - 1.0).abs() < 1e-12);
    let sample = *super::run(&in_air).history.bodies[0].last().unwrap();
    // Vertical speed adds to the drag: ½ρC_dA |v| v_x
    let expected = 0.5 * 1025.0 * 0.0016 * sample.speed.hypot(sample.heave_speed) * sample.speed;
    assert!(
        (sample.water_drag / expected - 1.0).abs() < 1e-9 && sample.drag == 0.0,
        "{} N",
        sample.water_drag
    );
    // The parts of a welded body displace water each for itself, about the common centre.
    let part = "[body.part]\nshape = \"block\"\nsize = [\"40 mm\", \"40 mm\", \"40 mm\"]\nfriction = 0.3\nwelded_to = \"block\"\nx = \"0.1 m\"\nelevation = \"0.2 m\"\nweight = \"2 N\"\n";
    let both = case(&water, SAND, &format!("{}\n{part}", heavy("weight = \"2 N\"")));
    let fluid = both.fluid(&both.bodies[0]);
    assert!((fluid.displaced * 9.81 / (2.0 * displaced) - 1.0).abs() < 1e-12);
    assert!((fluid.centre - DVec3::new(0.05, 0.0, 0.0)).length() < 1e-12);
}

#[test]
fn what_is_not_submerged_or_does_not_drain_is_refused() {
    let dry = "law = \"mohr-coulomb\"\nfriction_angle = \"35 deg\"\n";
    let (mohr, heavy) =
        (format!("{dry}unit_weight = \"9 kN/m^3\""), format!("{dry}unit_weight = \"16 kN/m^3\""));
    let light = format!("{BLOCK}weight = \"0.5 N\"\nheave = \"free\"");
    let twice = format!("{BLOCK}weight = \"2 N\"\nsubmerged_weight = \"1 N\"\nheave = \"free\"");
    let fine = WATER.replace("1 cm/s", "1e-5 m/s");
    let shallow = WATER.replace("2 m", "10 mm");
    let pressed = format!("{WATER}pore_pressure = true\n");
    let clay = "law = \"tresca\"\nshear_strength = \"2 kPa\"\nunit_weight = \"6 kN/m^3\"";
    let penalty = format!("{BLOCK}[numerics]\ncontact = \"penalty\"\n");
    for (water, soil, body, message) in [
        ("[water]\npermeability = \"1 mm/s\"\n", SAND, "", "`water.level` is missing"),
        ("[water]\naccept_drained = true\n", SAND, "", "without water there is nothing to drain"),
        ("[water]\nlevel = \"2 m\"\n", SAND, "", "the permeability of the soil is not given"),
        (WATER, &format!("{SAND}bolton_q = 4"), "", "the volume strain of the soil as it fails is not given"),
        (WATER, &mohr, "", "the volume strain of the soil as it fails is not given"),
        (&format!("{WATER}volume_strain = 0.05\n"), &heavy, "", "is that of a soil with"),
        (&format!("{WATER}grain_density = \"900 kg/m^3\"\n"), SAND, "", "are not heavier than the water"),
        (&shallow, SAND, BLOCK, "`block` reaches up to 0.04 m, above the water at 0.01 m"),
        (&WATER.replace("2 m", "-1 m"), SAND, "", "the ground reaches up to 0 m"),
        (WATER, SAND, &light, "`block` floats: it weighs 0.5 N"),
        (WATER, SAND, &twice, "both say what the body weighs"),
        ("", SAND, &format!("{BLOCK}submerged_weight = \"1 N\"\nheave = \"free\""), "without water"),
        (&fine, SAND, DISC, "the soil does not drain: drainage number"),
        (&format!("{WATER}volume_strain = 2\n"), SAND, "", "water.volume_strain = 2 is out of range"),
        (&pressed, clay, "", "the law is that of soil from which no water can flow"),
        (&pressed, SAND, &penalty, "the penalty method knows no pore pressure"),
        (&format!("{pressed}accept_drained = true\n"), SAND, DISC, "the soil is taken for drained, and its"),
        (
            "[water]\nlevel = \"2 m\"\npore_pressure = true\n",
            SAND,
            "",
            "from which its pore pressure follows",
        ),
        (&format!("{WATER}pore_pressure = \"yes\"\n"), SAND, "", "pore_pressure"),
    ] {
        let refused = read(&text(water, soil, body)).unwrap_err();
        assert!(refused.contains(message), "{message}: {refused}");
    }
    assert!(read(&text(&format!("{fine}accept_drained = true\n"), SAND, DISC)).is_ok());
}

#[test]
fn fine_sand_under_water_runs_with_its_pore_pressure_and_without_a_drainage_check() {
    let fine = format!("{}pore_pressure = true\n", WATER.replace("1 cm/s", "1e-4 m/s"));
    let case = case(&fine, SAND, &DISC.replace("weight = \"100 N\"", "weight = \"300 N\""));
    let mut simulation: Simulation = Simulation::new(&case);
    while !simulation.is_done() {
        simulation.advance().unwrap();
    }
    let end = simulation.history.bodies[0].last().unwrap();
    assert!(end.pore_vertical != 0.0 && end.pore_vertical.abs() < 300.0, "{} N", end.pore_vertical);
    let energy = simulation.history.energy.last().unwrap();
    assert!(energy.seepage > 0.0 && energy.closure().abs() < 0.05, "{energy:?}");
    assert!(case.drainage_number() > Some(5.0));
    assert_eq!(coulter::trust::Setting::of(&case).drainage_per_speed, None);
}

#[test]
fn a_forecast_has_suction_where_the_water_cannot_follow_and_none_for_soil_that_may_liquefy() {
    let fine = format!("{}accept_drained = true\n", WATER.replace("1 cm/s", "1e-4 m/s"));
    let found = outlook(&case(&fine, SAND, DISC)).unwrap();
    let water = found.under_water.unwrap();
    let depth = |forecast: &analytic::Forecast| {
        let best = forecast.models.iter().find(|model| Some(model.model) == forecast.recommended);
        best.unwrap().prediction.unwrap().sinkage.unwrap()
    };
    let [less, usual, more] = water.suction.unwrap().map(|suction| depth(&suction.forecast));
    assert!(more < usual && usual < less && less < depth(&found.forecast), "{less} {usual} {more} m");
    let area = 0.2 * 0.05;
    assert!((water.drag / (0.5 * 1000.0 * area * 0.04) - 1.0).abs() < 0.01, "{} N", water.drag);
    let loose = case(&fine, &SAND.replace("0.5", "0.0"), DISC);
    assert!(outlook(&loose).unwrap_err().contains("it may liquefy"));
    assert!(outlook(&case("", SAND, DISC)).unwrap().under_water.is_none());
}

const BLADE: &str = "[body.blade]\nshape = \"blade\"\nwidth = \"0.2 m\"\nheight = \"0.16 m\"\nthickness = \"30 mm\"\npitch = \"-45 deg\"\n\
                     friction = 0.4\nsinkage = \"50 mm\"\nforward = { speed = \"0.15 m/s\" }\n";
const WEDGE: &str = "[body.wedge]\nshape = \"wedge\"\nlength = \"0.12 m\"\nwidth = \"0.2 m\"\nheight = \"0.12 m\"\nfriction = 0.4\n\
                     sinkage = \"50 mm\"\nforward = { speed = \"0.15 m/s\" }\n";

fn forecast_under_water(extra: &str, body: &str) -> Result<coulter::forecast::UnderWater, String> {
    let fine = format!("{}accept_drained = true\n{extra}", WATER.replace("1 cm/s", "1e-4 m/s"));
    let read = read(&text(&fine, SAND, body))?;
    Ok(outlook(&read)?.under_water.unwrap())
}

#[test]
fn a_blade_or_a_wedge_cuts_saturated_sand_and_a_disc_does_not() {
    let blade = forecast_under_water("", BLADE).unwrap().blade.unwrap();
    let [less, usual, more] = blade.cuts.unwrap().map(|cut| cut.force.drag);
    assert!(0.0 < less && less < usual && usual < more && more < 3.0 * usual, "{less} {usual} {more} N");
    // The thick blade reaches below its front by 30 mm sin 45°.
    assert!((blade.depth / (0.05 - 0.03 * 0.5_f64.sqrt()) - 1.0).abs() < 1e-9, "{} m", blade.depth);
    // As high over its base as long: its face is that of the blade.
    let height = 0.16 * 0.5_f64.sqrt();
    let same =
        WEDGE.replace("50 mm", &format!("{} m", blade.depth)).replace("0.12 m", &format!("{height} m"));
    let wedge = forecast_under_water("", &same).unwrap().blade.unwrap();
    assert!((wedge.angle - blade.angle).abs() < 1e-9 && (wedge.depth / blade.depth - 1.0).abs() < 1e-6);
    let of_wedge = wedge.cuts.unwrap()[1].force.drag;
    assert!((of_wedge / usual - 1.0).abs() < 1e-6, "{of_wedge} N, not {usual} N");
    let upright = forecast_under_water("", &BLADE.replace("-45 deg", "0 deg")).unwrap().blade.unwrap();
    assert!(upright.cuts.unwrap_err().contains("the valid range is 15° to 60°"));
    assert!(forecast_under_water("", DISC).unwrap().blade.is_none());
}

#[test]
fn a_plough_has_a_tow_force_where_its_coefficients_are_given() {
    let keys = "[forecast]\nplough_weight_coefficient = [0.3, 0.5]\nplough_slow_coefficient = [5, 15]\n\
                plough_rate_coefficient = [\"50 kN*s/m^3\", \"200 kN*s/m^3\"]\n";
    let body = format!("{BLADE}weight = \"100 N\"\n");
    let found = forecast_under_water(keys, &body).unwrap().plough.unwrap();
    let weight = 100.0 - 9810.0 * 0.2 * 0.16 * 0.03;
    let unit_weight = case(WATER, SAND, "").soil.unit_weight;
    for (force, [by_weight, slow, rate]) in found.forces.iter().zip([[0.3, 5.0, 5e4], [0.5, 15.0, 2e5]]) {
        let depth = 0.05_f64;
        let expected = by_weight * weight + slow * unit_weight * depth.powi(3) + rate * 0.15 * depth * depth;
        assert!((force.total() / expected - 1.0).abs() < 1e-6, "{} N, not {expected}", force.total());
    }
    let refused = |keys: &str, body: &str| forecast_under_water(keys, body).unwrap_err();
    let two = keys.replace("plough_slow_coefficient = [5, 15]\n", "");
    assert!(refused(&two, &body).contains("needs all three coefficients"));
    assert!(refused(&keys.replace("[5, 15]", "[15, 5]"), &body).contains("starts above its end"));
    assert!(refused(&keys.replace("[5, 15]", "[5, 10, 15]"), &body).contains("expected 2 numbers"));
    assert!(refused(keys, DISC).contains("fix its heave"));
    let dry = outlook(&read(&text(keys, SAND, &body)).unwrap()).unwrap_err();
    assert!(dry.contains("add [water]"), "{dry}");
}
