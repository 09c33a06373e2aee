//! Measured curves as instruments write them, in each command that takes them; columns named on the command
//! line; no common point is an error.

use crate::field_01_calibrate_first_row_zero::PLATE;
use crate::support::{Answer, Desk};
use serde_json::Value;

const FORCES: &str = "sinkage [mm],force [N]\n4,21\n8,46\n12,75\n";

fn compared(file: &[u8], more: &[&str]) -> (Desk, Answer) {
    let desk = Desk::with(&[("plate.toml", PLATE)]);
    desk.write("m.csv", file);
    let answer = desk.coulter(&[&["compare", "plate.toml", "m.csv", "--json"], more].concat());
    (desk, answer)
}

/// The document of a comparison, and its remarks.
fn document(file: &[u8], more: &[&str]) -> (Value, Vec<String>) {
    let (_, answer) = compared(file, more);
    assert_eq!(answer.code, 0, "{}", answer.error);
    let document: Value = serde_json::from_str(&answer.out).unwrap();
    let remarks =
        document["remarks"].as_array().unwrap().iter().map(|r| r.as_str().unwrap().to_owned()).collect();
    (document, remarks)
}

fn bias(document: &Value) -> f64 {
    document["compared"][0]["differences"]["bias"].as_f64().unwrap()
}

#[test]
fn every_dialect_is_the_same_comparison() {
    let (plain, remarks) = document(FORCES.as_bytes(), &[]);
    assert!(remarks.is_empty(), "{remarks:?}");
    let expected = bias(&plain);
    let latin = b"sinkage [mm];force [N];h\xf6he [V]\n4;21;1\n8;46;1\n12;75;1\n".to_vec();
    for (file, words) in [
        (FORCES.replace('[', "(").replace(']', ")").into_bytes(), &[][..]),
        (FORCES.replace(',', "\t").into_bytes(), &[]),
        (FORCES.replace(',', ";").replace('\n', ";\r\n").into_bytes(), &[]),
        (FORCES.replace(',', "  ").into_bytes(), &[]),
        (b"sinkage,force\n[mm],[N]\n\"4\",\"21\"\n8,46\n12,75\n".to_vec(), &[]),
        (b"sinkage_mm;force_N\n4,0;21,0\n8,0;46,0\n12,0;75,0\n".to_vec(), &["decimal commas"]),
        (
            b"sinkage [mm],force [N],comment\n4,21,start\n8,46,\n12,75,creak\n".to_vec(),
            &["\"comment\" left out: text"],
        ),
        (b"depth [mm],force [N]\n-4,21\n-8,46\n-12,75\n".to_vec(), &["counts upwards"]),
        (b"z [mm],load [N]\n-4,-21\n-8,-46\n-12,-75\n".to_vec(), &["counts upwards", "its sign was turned"]),
        (
            b"elevation [mm],force [N]\n-4,-21\n-8,-46\n-12,-75\n".to_vec(),
            &["counts upwards", "its sign was turned"],
        ),
        (latin, &["Windows-1252", "\"höhe [V]\" left out"]),
    ] {
        let (found, remarks) = document(&file, &[]);
        assert!((bias(&found) - expected).abs() < 1e-9 * expected.abs(), "{file:?}: {}", bias(&found));
        assert_eq!(remarks.len(), words.len(), "{remarks:?}");
        for word in words {
            assert_eq!(
                remarks.iter().filter(|remark| remark.contains(word)).count(),
                1,
                "{word}: {remarks:?}"
            );
        }
    }
}

#[test]
fn units_and_names_of_instruments() {
    let pressed = |file: &str| bias(&document(file.as_bytes(), &[]).0);
    let newtons = pressed("depth [mm],force [N]\n4,9.80665\n8,19.6133\n");
    let same = |file: &str| assert!((pressed(file) - newtons).abs() < 1e-6 * newtons.abs(), "{file}");
    same("depth [mm],force [kgf]\n4,1\n8,2\n");
    same("depth [in],force [lbf]\n0.157480315,2.20462262\n0.31496063,4.40924524\n");
    let kilopascals = pressed("depth [mm],pressure [kPa]\n4,6.894757293\n8,13.789514586\n");
    for file in [
        "depth [mm],qc [psi],fs [kPa],comment\n4,1,3,a\n8,2,4,b\n",
        "depth [mm],cone_resistance [kN/m²]\n4,6.894757293\n8,13.789514586\n",
        "depth [mm],q_c [N/mm²]\n4,0.006894757293\n8,0.013789514586\n",
        "depth [mm],pressure [ksf]\n4,0.144\n8,0.288\n",
    ] {
        assert!((pressed(file) - kilopascals).abs() < 1e-6 * kilopascals.abs(), "{file}");
    }
}

#[test]
fn what_leads_nowhere_is_refused_with_a_way_out() {
    for (file, words) in [
        ("depth [mm],force [kg]\n4,21\n8,46\n", &["a mass where a force belongs", "kgf"][..]),
        ("depth [mm],force [kgff]\n4,21\n8,46\n", &["did you mean `kgf`?"]),
        (
            "depth [mm],foo [N]\n4,21\n8,46\n",
            &["unknown column \"foo [N]\"", "aliases. Or say what a column is with --column"],
        ),
        ("depth [mm],froce [N]\n4,21\n8,46\n", &["unknown column", "did you mean `force`? Or say"]),
        ("elevation [mm],force [N]\n104,21\n100,46\n", &["where the surface lies is not known", "=-sinkage"]),
    ] {
        let (_, answer) = compared(file.as_bytes(), &[]);
        assert_eq!(answer.code, 2, "{file}: {}", answer.out);
        answer.says(words);
    }
}

#[test]
fn no_common_point_is_an_error_that_says_both_ranges() {
    let desk = Desk::with(&[
        ("a.csv", FORCES),
        ("b.csv", "sinkage [m],force [N]\n4,21\n8,46\n12,75\n"),
        ("c.csv", "sinkage [mm],force [N]\n2,10\n9,50\n"),
    ]);
    let words = ["nothing to compare", "0.004 to 0.012 m", "4 to 12 m"];
    desk.expect(2, &["compare", "a.csv", "b.csv"]).says(&words);
    // Beside another that has some it is a remark, once.
    let answer = desk.expect(0, &["compare", "a.csv", "b.csv", "c.csv"]);
    assert_eq!(answer.text().matches("no point of b.csv").count(), 1, "{}", answer.out);
}

#[test]
fn columns_are_named_in_every_command() {
    const LOG: &str = "way [mm],Fz [N],loadcell [V],note\n4,21,1,a\n8,46,2,b\n12,75,3,c\n";
    let named = ["--column", "way [mm]=sinkage", "--column", "Fz=vertical", "--column", "note=-"];
    let (plain, _) = document(FORCES.as_bytes(), &[]);
    let (found, remarks) = document(LOG.as_bytes(), &named);
    assert_eq!(bias(&found), bias(&plain));
    assert!(remarks.len() == 1 && remarks[0].contains("\"loadcell [V]\" left out"), "{remarks:?}");
    let desk = Desk::with(&[("plate.toml", PLATE), ("log.csv", LOG)]);
    let calibrate = [
        "calibrate",
        "plate.toml",
        "log.csv",
        "--parameter",
        "soil.friction_angle=28..42 deg",
        "--samples",
        "100",
        "-o",
        "k",
    ];
    let answer = desk.expect(0, &[&calibrate[..], &named].concat());
    answer.says(&["note: log.csv: column \"loadcell [V]\" left out"]);
    assert!(desk.read("k/calibration.html").contains("loadcell [V]"));
    desk.expect(2, &[&calibrate[..], &named, &["--column", "qc=pressure"]].concat())
        .says(&["no measured file has such a column", "\"way [mm]\""]);
    desk.expect(2, &["compare", "plate.toml", "log.csv", "--column", "way=deep"])
        .says(&["`deep` is not a quantity"]);
    desk.expect(2, &["report", "nowhere", "--column", "way=sinkage"]).says(&["--with"]);
}
