//! What the keys of a GeoTIFF say of the units of its coordinates and heights (OGC GeoTIFF 1.1; codes of
//! EPSG).

use crate::data_file::{FileProblem, problem};
use tiff::decoder::Decoder;
use tiff::tags::Tag;

/// Kind of the coordinates, 1 projected, 2 degrees, 3 about the Earth's centre; place of a pixel, 2 in its
/// middle.
const MODEL: u16 = 1024;
const RASTER: u16 = 1025;
/// Codes of the coordinate system: of degrees, projected, vertical.
const GEOGRAPHIC: u16 = 2048;
const PROJECTED: u16 = 3072;
const VERTICAL: u16 = 4096;
/// Code of the unit of projected coordinates, and its length [m] where it is one of its own; code of the unit
/// of heights.
const PROJECTED_UNIT: u16 = 3076;
const PROJECTED_UNIT_SIZE: u16 = 3077;
const VERTICAL_UNIT: u16 = 4099;
/// The code that stands for one of its own.
const OWN: u16 = 32767;

/// Units of length of EPSG: code, name, length [m].
const UNITS: [(u16, &str, f64); 24] = [
    (1025, "millimetre", 0.001),
    (1033, "centimetre", 0.01),
    (9001, "metre", 1.0),
    (9002, "foot", 0.3048),
    (9003, "US survey foot", 1200.0 / 3937.0),
    (9005, "Clarke's foot", 0.304_797_265_4),
    (9014, "fathom", 1.8288),
    (9030, "nautical mile", 1852.0),
    (9031, "German legal metre", 1.000_013_596_5),
    (9033, "US survey chain", 79_200.0 / 3937.0),
    (9034, "US survey link", 792.0 / 3937.0),
    (9035, "US survey mile", 6_336_000.0 / 3937.0),
    (9036, "kilometre", 1000.0),
    (9037, "Clarke's yard", 0.914_391_796_2),
    (9040, "British yard (Sears 1922)", 0.914_398_414_616_028_7),
    (9041, "British foot (Sears 1922)", 0.304_799_471_538_676_2),
    (9070, "British foot (1865)", 0.304_800_833_333_333_5),
    (9080, "Indian foot", 0.304_799_510_248_146_9),
    (9084, "Indian yard", 0.914_398_530_744_440_8),
    (9093, "mile", 1609.344),
    (9094, "Gold Coast foot", 0.304_799_710_181_508_7),
    (9096, "yard", 0.9144),
    (9097, "chain", 20.1168),
    (9098, "link", 0.201_168),
];
/// Projected systems in metres: UTM on WGS 84, NAD83 and ETRS89, Mercator of the web, and national ones.
const IN_METRES: [(u16, u16); 16] = [
    (2056, 2056),   // Switzerland
    (2154, 2154),   // France
    (3006, 3006),   // Sweden
    (3035, 3035),   // Europe
    (3067, 3067),   // Finland
    (3857, 3857),   // the web
    (3034, 3034),   // Europe
    (5041, 5042),   // the poles
    (25828, 25838), // ETRS89 / UTM
    (26901, 26923), // NAD83 / UTM
    (27700, 27700), // Great Britain
    (28992, 28992), // the Netherlands
    (31466, 31469), // Germany
    (31370, 31370), // Belgium
    (32601, 32660), // WGS 84 / UTM north
    (32701, 32760), // WGS 84 / UTM south
];
/// Systems of the American states in feet, on NAD83: in those of the US survey, but for these in
/// international ones.
const IN_FEET: (u16, u16) = (2222, 2289);
const IN_INTERNATIONAL_FEET: [(u16, u16); 7] =
    [(2222, 2224), (2251, 2253), (2256, 2256), (2265, 2266), (2269, 2270), (2273, 2273), (2280, 2282)];
/// Vertical systems and the codes of their units.
const VERTICAL_SYSTEMS: [(u16, u16); 6] =
    [(5703, 9001), (6360, 9003), (8228, 9002), (5773, 9001), (3855, 9001), (5714, 9001)];

/// A unit of length that a file states.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct FileUnit {
    /// Name of the unit, and which key says so.
    pub(super) name: String,
    /// Length of the unit [m].
    pub(super) metres: f64,
}

/// What the keys of an image say.
#[derive(Debug)]
pub(super) struct GeoKeys {
    entries: Vec<[u16; 4]>,
    numbers: Vec<f64>,
    /// What GDAL notes of the band: XML.
    metadata: String,
}

impl GeoKeys {
    pub(super) fn of<R: std::io::Read + std::io::Seek>(image: &mut Decoder<R>) -> Self {
        let directory = image.get_tag_u16_vec(Tag::GeoKeyDirectoryTag).unwrap_or_default();
        let entries = directory.chunks_exact(4).skip(1).map(|entry| [entry[0], entry[1], entry[2], entry[3]]);
        Self {
            entries: entries.collect(),
            numbers: image.get_tag_f64_vec(Tag::GeoDoubleParamsTag).unwrap_or_default(),
            metadata: image.get_tag_ascii_string(Tag::Unknown(42112)).unwrap_or_default(),
        }
    }

    fn code(&self, key: u16) -> Option<u16> {
        self.entries.iter().find(|entry| entry[0] == key && entry[1] == 0).map(|entry| entry[3])
    }

    fn number(&self, key: u16) -> Option<f64> {
        let [_, tag, _, index] = self.entries.iter().find(|entry| entry[0] == key)?;
        (*tag == 34736).then(|| self.numbers.get(usize::from(*index)).copied())?
    }

    /// Whether the coordinates are those of the middle of a pixel, not of its corner.
    pub(super) fn places_are_middles(&self) -> bool {
        self.code(RASTER) == Some(2)
    }

    /// Refuses coordinates that are no lengths along the ground.
    pub(super) fn require_projected(&self) -> Result<(), FileProblem> {
        let is_geographic = self.code(GEOGRAPHIC).is_some() && self.code(PROJECTED).is_none();
        match self.code(MODEL) {
            Some(2) => problem("its coordinates are degrees", "project it to metres, as of UTM"),
            None if is_geographic && self.code(PROJECTED_UNIT).is_none() => {
                problem("its coordinates are degrees", "project it to metres, as of UTM")
            }
            Some(3) => {
                problem("its coordinates are about the Earth's centre", "project it to metres, as of UTM")
            }
            _ => Ok(()),
        }
    }

    /// The unit of the coordinates; metres where the file does not say, with a remark.
    pub(super) fn unit(&self) -> Result<(FileUnit, Option<String>), FileProblem> {
        const SAVE: &str = "save it with coordinates in metres (gdalwarp -t_srs, or Export in a GIS)";
        let stated = match self.code(PROJECTED_UNIT) {
            Some(OWN) => match self.number(PROJECTED_UNIT_SIZE) {
                Some(metres) if metres.is_finite() && metres > 0.0 => {
                    Some(FileUnit { name: format!("a unit of {metres} m (ProjLinearUnitSize)"), metres })
                }
                _ => {
                    return problem(
                        "its coordinates are in a unit of its own (ProjLinearUnits 32767) whose length it does not say",
                        SAVE,
                    );
                }
            },
            Some(code) => match known(code, "ProjLinearUnits") {
                Some(unit) => Some(unit),
                None => {
                    return problem(
                        format!("the unit of its coordinates (ProjLinearUnits {code}) is not a known length"),
                        SAVE,
                    );
                }
            },
            None => None,
        };
        let system = self.code(PROJECTED).filter(|system| *system != OWN);
        let of_system = system.and_then(unit_of_system);
        let metre = || FileUnit { name: "metre".to_owned(), metres: 1.0 };
        match (stated, of_system, system) {
            (Some(stated), Some(own), Some(system)) if (stated.metres / own.metres - 1.0).abs() > 1e-4 => {
                problem(
                    format!(
                        "its coordinates are in {}, but those of its system, EPSG:{system}, are in {}",
                        stated.name, own.name
                    ),
                    SAVE,
                )
            }
            (Some(stated), ..) => Ok((stated, None)),
            (None, Some(own), _) => Ok((own, None)),
            (None, None, system) => {
                let known = match system {
                    Some(system) => {
                        format!(", and that of its coordinate system, EPSG:{system}, is not known here")
                    }
                    None => String::new(),
                };
                let remark = format!(
                    "it does not state the unit of its coordinates (ProjLinearUnits){known}: they are taken as metres"
                );
                Ok((metre(), Some(remark)))
            }
        }
    }

    /// The unit of the heights, if the file states it.
    pub(super) fn vertical_unit(&self) -> Result<Option<FileUnit>, FileProblem> {
        if let Some(code) = self.code(VERTICAL_UNIT) {
            let unit = known(code, "VerticalUnits");
            return unit.map_or_else(
                || {
                    problem(
                        format!("the unit of its heights (VerticalUnits {code}) is not a known length"),
                        "save it with heights in metres",
                    )
                },
                |unit| Ok(Some(unit)),
            );
        }
        if let Some(word) = self.of_band("unittype").filter(|word| !word.is_empty()) {
            return match named(&word) {
                Some(metres) => Ok(Some(FileUnit { name: format!("{word} (UNITTYPE)"), metres })),
                None => problem(
                    format!("the unit of its heights (UNITTYPE `{word}`) is not a known length"),
                    "save it with heights in metres",
                ),
            };
        }
        let system =
            self.code(VERTICAL).and_then(|system| VERTICAL_SYSTEMS.iter().find(|(code, _)| *code == system));
        Ok(system.and_then(|(system, unit)| known(*unit, &format!("EPSG:{system}"))))
    }

    /// Factor and summand that make heights of the pixels' numbers, as GDAL notes them.
    pub(super) fn scaling(&self) -> Result<[f64; 2], FileProblem> {
        let number = |role: &str, usual: f64| match self.of_band(role) {
            None => Ok(usual),
            Some(text) => text.trim().parse().ok().filter(|x: &f64| x.is_finite()).map_or_else(
                || problem(format!("its {role} `{text}` is not a number"), "save the image again"),
                Ok,
            ),
        };
        Ok([number("scale", 1.0)?, number("offset", 0.0)?])
    }

    /// What GDAL notes of the first band under a role: `<Item name="UNITTYPE" sample="0"
    /// role="unittype">metre</Item>`.
    fn of_band(&self, role: &str) -> Option<String> {
        let is_it = |head: &str| {
            head.contains(&format!("role=\"{role}\""))
                && (!head.contains("sample=") || head.contains("sample=\"0\""))
        };
        let mut items = self.metadata.split("<Item").skip(1).filter_map(|item| item.split_once('>'));
        let (_, text) = items.find(|(head, _)| is_it(head))?;
        Some(text.split('<').next().unwrap_or_default().trim().to_owned())
    }
}

fn known(code: u16, key: &str) -> Option<FileUnit> {
    let (_, name, metres) = UNITS.iter().find(|(known, ..)| *known == code)?;
    Some(FileUnit { name: format!("the {name} ({key}, EPSG:{code})"), metres: *metres })
}

/// The length of a unit by its name [m].
fn named(word: &str) -> Option<f64> {
    let word = word.to_lowercase().replace(['_', '-'], " ");
    let metres = match word.trim_end_matches('s') {
        "m" | "metre" | "meter" => 1.0,
        "cm" | "centimetre" | "centimeter" => 0.01,
        "mm" | "millimetre" | "millimeter" => 0.001,
        "km" | "kilometre" | "kilometer" => 1000.0,
        "ft" | "foot" | "feet" | "international foot" | "international feet" => 0.3048,
        "us survey foot" | "us survey feet" | "us ft" | "foot us" | "ftu" | "ft us" | "survey foot" => {
            1200.0 / 3937.0
        }
        "in" | "inch" | "inche" => 0.0254,
        "yd" | "yard" => 0.9144,
        "fathom" => 1.8288,
        _ => return None,
    };
    Some(metres)
}

/// The unit of a projected system, where it is known.
fn unit_of_system(system: u16) -> Option<FileUnit> {
    let is_in = |(low, high): &(u16, u16)| (*low..=*high).contains(&system);
    let unit = if IN_METRES.iter().any(is_in) {
        9001
    } else if IN_INTERNATIONAL_FEET.iter().any(is_in) {
        9002
    } else if is_in(&IN_FEET) {
        9003
    } else {
        return None;
    };
    known(unit, &format!("that of EPSG:{system}"))
}
