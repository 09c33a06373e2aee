//! Figures as wholes: nothing is hidden or cut off, the files are what they should be.

use super::compose::compose;
use super::drawing::{Drawing, Item};
use super::segment::Segment;
use super::*;

fn series(kind: SeriesKind, level: &str, source: &str, value: impl Fn(f64) -> f64) -> FigureSeries {
    let count = if kind == SeriesKind::Line { 40 } else { 6 };
    let point = |n: i32| {
        let x = 0.02 + 0.3 * f64::from(n) / f64::from(count - 1);
        let y = value(x);
        let y_ends = (kind == SeriesKind::Computed).then_some([0.93 * y, 1.1 * y]);
        let grade = if kind == SeriesKind::Computed && n > 3 { "doubtful" } else { "" };
        FigurePoint { at: [x, y], y_ends, grade: grade.into(), ..FigurePoint::default() }
    };
    FigureSeries { kind, level: level.into(), source: source.into(), points: (0..count).map(point).collect() }
}

/// Three closed forms and runs of the solver, and two measurements.
fn sample() -> Figure {
    let mut all = Vec::new();
    for (n, level) in ["φ = 30 deg", "φ = 35 deg", "φ = 40 deg"].into_iter().enumerate() {
        let strength = 4.0 + 2.0 * n as f64;
        all.push(series(SeriesKind::Line, level, "closed form", move |x| strength * x.powf(1.3)));
        all.push(series(SeriesKind::Computed, level, "solver", move |x| 1.04 * strength * x.powf(1.3)));
    }
    all.push(series(SeriesKind::Measured, "", "disc 1", |x| 5.0 * x.powf(1.4)));
    all.push(series(SeriesKind::Measured, "", "disc 2", |x| 6.5 * x.powf(1.2)));
    let axis = |label: &str, name: &str| FigureAxis {
        label: label.into(),
        name: name.into(),
        unit: "-".into(),
        ..FigureAxis::default()
    };
    Figure {
        name: "drag".into(),
        x: axis("dimensionless sinkage Z", "Z"),
        y: axis("dimensionless drag F̄_H", "F_H_bar"),
        series: all,
        ..Figure::default()
    }
}

/// Paths of a class.
fn paths<'a>(drawing: &'a Drawing, wanted: &'a str) -> impl Iterator<Item = &'a [Segment]> {
    drawing.items.iter().filter_map(move |item| match item {
        Item::Path { class, segments, .. } if *class == wanted => Some(segments.as_slice()),
        _ => None,
    })
}

/// Left, top, right and bottom of each text.
fn texts(drawing: &Drawing) -> Vec<(String, [f64; 4])> {
    let place = |item: &Item| {
        let Item::Text { text, at: [x, y], is_turned } = item else { return None };
        let [high, low] = text.heights();
        let place = if *is_turned {
            [x - high, y - text.width, x - low, *y]
        } else {
            [*x, y - high, x + text.width, y - low]
        };
        Some((text.words(), place))
    };
    drawing.items.iter().filter_map(place).collect()
}

fn ends(segments: &[Segment]) -> impl Iterator<Item = [f64; 2]> {
    segments.iter().filter_map(|segment| match segment {
        Segment::Move(to) | Segment::Line(to) | Segment::Bend(_, to) => Some(*to),
        Segment::Curve(points) => Some(points[2]),
        Segment::Close => None,
    })
}

/// What is wrong with where texts stand: beyond the page, on another text, on data.
fn misplaced(drawing: &Drawing) -> Vec<String> {
    let all = texts(drawing);
    let mut wrong = Vec::new();
    for (n, (words, [left, top, right, bottom])) in all.iter().enumerate() {
        if *left < 0.0 || *top < 0.0 || *right > drawing.size[0] || *bottom > drawing.size[1] {
            wrong.push(format!("`{words}` is cut off"));
        }
        for (other, [l, t, r, b]) in &all[..n] {
            if left < r && l < right && top < b && t < bottom {
                wrong.push(format!("`{words}` stands on `{other}`"));
            }
        }
        for class in ["curve", "mark", "error", "cross", "dot"] {
            for [x, y] in paths(drawing, class).flat_map(ends) {
                if (*left..=*right).contains(&x) && (*top..=*bottom).contains(&y) {
                    wrong.push(format!("`{words}` hides a {class}"));
                }
            }
        }
    }
    wrong
}

#[test]
fn nothing_is_hidden_or_cut_off() {
    for width in [90.0, 190.0, 60.0] {
        for legend in [LegendPlace::Automatic, LegendPlace::Outside] {
            let mut figure = Figure { legend, ..sample() };
            figure.style.width = width;
            assert_eq!(misplaced(&compose(&figure)), Vec::<String>::new(), "{width} {legend:?}");
        }
    }
}

#[test]
fn a_legend_without_room_inside_stands_above_the_axes() {
    let mut figure = sample();
    figure.y.range = Some([0.0, 3.0]);
    // Data everywhere.
    for n in 0..400 {
        let at = [0.32 * f64::from(n % 20) / 19.0, 3.0 * f64::from(n / 20) / 19.0];
        let point = FigurePoint { at, ..FigurePoint::default() };
        figure.series[0].points.push(point);
    }
    let drawing = compose(&figure);
    let top = paths(&drawing, "frame").flat_map(ends).map(|[_, y]| y).fold(f64::INFINITY, f64::min);
    let names = texts(&drawing);
    let (_, place) = names.iter().find(|(words, _)| words.contains("disc 1")).unwrap();
    assert!(place[3] < top, "{place:?} {top}");
}

#[test]
fn many_series_make_the_page_grow() {
    let mut figure = sample();
    for form in ["a form", "another form", "a third form", "a form with a long name of its own"] {
        for level in ["φ = 30 deg", "φ = 35 deg", "φ = 40 deg"] {
            let shift = figure.series.len() as f64;
            figure.series.push(series(SeriesKind::Line, level, form, move |x| 0.1 * shift + 0.0 * x));
        }
    }
    let drawing = compose(&figure);
    assert!(drawing.size[1] > 1.1 * 0.75 * drawing.size[0], "{:?}", drawing.size);
    assert_eq!(misplaced(&drawing), Vec::<String>::new());
}

#[test]
fn what_has_no_level_is_named_once() {
    let mut figure = sample();
    figure.series.retain(|one| one.kind == SeriesKind::Computed);
    figure.series.push(series(SeriesKind::Line, "", "running median", |x| x));
    let named = texts(&compose(&figure));
    assert_eq!(named.iter().filter(|(words, _)| words == "running median").count(), 1);
    assert!(!named.iter().any(|(words, _)| words == "solver"), "{named:?}");
}

#[test]
fn a_given_place_of_the_legend_is_kept() {
    let place = |word: &str| {
        let drawing = compose(&Figure { legend: LegendPlace::of_word(word), ..sample() });
        let found = texts(&drawing).into_iter().find(|(words, _)| words.contains("disc 1"));
        found.map(|(_, [left, top, ..])| [left / drawing.size[0], top / drawing.size[1]])
    };
    assert!(place("bottom right").unwrap()[0] > 0.5 && place("bottom right").unwrap()[1] > 0.5);
    assert!(place("top left").unwrap()[0] < 0.5 && place("top left").unwrap()[1] < 0.5);
    assert_eq!(place("none"), None);
    for word in LegendPlace::WORDS.iter().skip(1) {
        assert_ne!(LegendPlace::of_word(word), LegendPlace::Automatic, "{word}");
    }
}

#[test]
fn marks_are_hollow_where_a_run_is_doubtful() {
    let drawing = compose(&sample());
    let fills = drawing.items.iter().filter_map(|item| match item {
        Item::Path { class: "mark", fill, .. } => *fill,
        _ => None,
    });
    // Two of six of each level, and one in the legend.
    assert_eq!(fills.filter(|fill| *fill == [255; 3]).count(), 3 * 2 + 1);
    assert_eq!(paths(&drawing, "error").count(), 3 * 6);
    assert!(texts(&drawing).iter().any(|(words, _)| words == "solver, doubtful"));
}

#[test]
fn intervals_have_their_ends_on_the_scale_of_the_axis() {
    let point =
        FigurePoint { at: [1.0, 2.0], y_ends: Some([1.0, 4.0]), x_ends: Some([0.5, 1.5]), grade: "".into() };
    let mut figure = sample();
    figure.series = vec![FigureSeries {
        kind: SeriesKind::Computed,
        level: String::new(),
        source: "solver".into(),
        points: vec![point],
    }];
    figure.x.range = Some([0.0, 2.0]);
    figure.y.range = Some([0.0, 4.0]);
    let drawing = compose(&figure);
    let frame: Vec<[f64; 2]> = paths(&drawing, "frame").flat_map(ends).collect();
    let ([left, top], [right, bottom]) = (frame[0], frame[2]);
    let bars: Vec<Vec<[f64; 2]>> = paths(&drawing, "error").map(|bar| ends(bar).take(2).collect()).collect();
    let near = |a: f64, b: f64| (a - b).abs() < 1e-9;
    assert!(
        near(bars[0][0][0], left + 0.25 * (right - left))
            && near(bars[0][1][0], left + 0.75 * (right - left))
    );
    assert!(near(bars[1][0][1], bottom + 0.25 * (top - bottom)) && near(bars[1][1][1], top), "{bars:?}");
}

#[test]
fn the_files_are_whole_and_always_the_same() {
    let files = figure_files(&sample());
    assert_eq!(files, figure_files(&sample()));
    assert!(files.svg.starts_with("<svg ") && files.svg.ends_with("</svg>\n"));
    assert!(files.svg.contains("width=\"90mm\" height=\"67.5mm\""), "{}", &files.svg[..200]);
    // Letters are outlines; what they say can be read.
    assert!(!files.svg.contains("<text") && files.svg.contains("aria-label=\"Dimensionless drag FH\""));
    let open = files.svg.matches('<').count();
    assert_eq!(open, files.svg.matches("/>").count() + 2);
    assert!(files.pdf.starts_with(b"%PDF-1.") && files.pdf.ends_with(b"%%EOF"));
    let has = |text: &[u8]| files.pdf.windows(text.len()).any(|part| part == text);
    assert!(has(b"/FontFile2") && has(b"CLTRFG+FigureSans-Italic") && has(b"/ToUnicode"));
    assert!(files.csv.starts_with(
        "kind,level,source,Z [-],Z_low [-],Z_high [-],F_H_bar [-],F_H_bar_low [-],F_H_bar_high [-],grade\n"
    ));
    assert_eq!(files.csv.lines().count(), 1 + 3 * (40 + 6) + 2 * 6);
}

#[test]
fn odd_figures_have_pictures() {
    let odd: [Vec<[f64; 2]>; 5] = [
        vec![],
        vec![[f64::NAN, 1.0]; 3],
        vec![[0.0, 0.0]],
        vec![[-1.0, 1e300], [2.0, -1e300], [f64::INFINITY, 0.0]],
        vec![[1e-320, 1.0], [1.0, 1e-320]],
    ];
    for points in odd {
        for kind in [SeriesKind::Line, SeriesKind::Computed, SeriesKind::Dots, SeriesKind::Measured] {
            for logarithmic in [false, true] {
                let mut figure = sample();
                let point =
                    |at: &[f64; 2]| FigurePoint { at: *at, x_ends: Some(*at), ..FigurePoint::default() };
                figure.series[0].kind = kind;
                figure.series[0].points = points.iter().map(point).collect();
                figure.series.truncate(1);
                figure.x.logarithmic = logarithmic;
                figure.y.logarithmic = logarithmic;
                figure.style.width = 30.0;
                let files = figure_files(&figure);
                assert!(!files.svg.contains("NaN") && !files.svg.contains("inf"), "{}", files.svg);
            }
        }
    }
}
