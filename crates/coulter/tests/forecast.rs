//! The forecast of a case: what is recommended, and its interval, over a scan of cases.
#![allow(clippy::unwrap_used)] // clippy does not recognise test helpers

use coulter::case;
use coulter::forecast::{Effort, intervals, outlook};

const DISC: &str = include_str!("../../../cases/light_disc.toml");

/// The interval of every model contains the value shown, whatever the friction angle, the load, the axle and
/// the dilation.
#[test]
fn intervals_contain_the_value_shown() {
    let loads: [&[&str]; 3] = [
        &["body.disc.weight=15 N"],
        &["body.disc.weight=150 N"],
        &["body.disc.heave=\"fixed\"", "body.disc.sinkage=50 mm"],
    ];
    for angle in [26, 32, 33, 41] {
        for (n, load) in loads.into_iter().enumerate() {
            let axle = [
                "body.disc.spin=\"locked\"",
                "body.disc.spin=\"free\"",
                "body.disc.spin={ speed = \"2 rad/s\" }",
            ];
            let dilation = if angle % 2 == 0 { 0 } else { angle };
            let soil = [
                format!("soil.friction_angle={angle} deg"),
                format!("soil.dilation_angle={dilation} deg"),
                axle[(n + angle) % 3].to_owned(),
            ];
            let sets: Vec<String> = load.iter().map(|set| (*set).to_owned()).chain(soil).collect();
            let case = case::parse(DISC, "light_disc", &sets).unwrap();
            let outlook = outlook(&case).unwrap();
            let found = intervals(&outlook, Vec::new(), Effort::Quick);
            for model in outlook.forecast.models.iter().filter(|m| m.applicable) {
                let shown = model.prediction.unwrap();
                let values = [
                    ("drag_N", Some(shown.drag)),
                    ("vertical_N", Some(shown.vertical)),
                    ("sinkage_m", shown.sinkage),
                ];
                for (quantity, value) in values {
                    let Some(interval) = found.of(model.name, quantity) else { continue };
                    let value = value.unwrap();
                    assert!(interval.low <= value && value <= interval.high, "{sets:?}: {interval:?}");
                    assert!(interval.low < interval.high, "{sets:?}: {interval:?}");
                }
            }
            // The recommended model has one, unless the disc digs in.
            if let Some(best) = outlook.recommended() {
                assert!(found.of(best.name, "drag_N").is_some(), "{sets:?}");
            }
        }
    }
}
