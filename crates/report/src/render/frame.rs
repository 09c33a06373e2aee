//! One picture: light, colours, title, scale and time.

use super::camera::Camera;
use super::mesh::{HeightColours, Mesh, base, placed, shaded};
use super::options::{Colouring, RenderOptions, Viewpoint};
use super::raster::{Fragment, Raster};
use super::shadow::ShadowMap;
use crate::pictures::{Anchor, Canvas, SUPERSAMPLING, Tone};
use crate::view::{RecordedBody, Recording};
use glam::DVec3;
use input::readable::digits;

/// Light of the sky on a level face, and of the sun on a face towards it.
const SKY: f64 = 0.54;
const SUN: f64 = 0.64;
/// What is around a body that is followed, over its extent.
const SURROUNDINGS: f64 = 2.2;

/// A recording, and how it is to be shown.
pub(super) struct Renderer<'a> {
    pub(super) recording: &'a Recording,
    /// Displacement of the first body at the recorded times [m]; empty without one.
    pub(super) displacements: &'a [f64],
    pub(super) title: &'a str,
    pub(super) options: &'a RenderOptions,
    viewpoint: Viewpoint,
    /// Camera of the last recorded time where it follows a body.
    camera: Camera,
    /// Where the block of soil ends below [m].
    base: f64,
    colours: HeightColours,
}

impl<'a> Renderer<'a> {
    pub(super) fn new(
        (recording, displacements): (&'a Recording, &'a [f64]),
        title: &'a str,
        options: &'a RenderOptions,
    ) -> Self {
        // A strip of plane strain is seen from its side.
        let usual = if recording.places[1].len() == 2 { Viewpoint::SIDE } else { Viewpoint::OBLIQUE };
        let viewpoint = options.viewpoint.unwrap_or(usual);
        let base = base(recording);
        let followed = recording.bodies.first().filter(|_| viewpoint.follow);
        // Framed once for all times, a followed body where it is at the end: the picture must not breathe.
        let shown = followed.map_or_else(|| everything(recording, base), surroundings);
        let camera = Camera::framing(&viewpoint, &shown, options.size);
        let colours = HeightColours::of(recording);
        Self { recording, displacements, title, options, viewpoint, camera, base, colours }
    }

    /// The picture of a recorded time.
    pub(super) fn picture(&self, frame: usize) -> Canvas {
        let [width, height] = self.options.size;
        let heights = (self.options.colouring == Colouring::Height).then_some(&self.colours);
        let mesh = Mesh::of((self.recording, self.base), frame, heights);
        let camera = self.camera(frame);
        let vertices: Vec<[f64; 3]> = mesh
            .vertices
            .iter()
            .map(|vertex| camera.project(vertex.place).map(|v| SUPERSAMPLING as f64 * v))
            .collect();
        let mut raster = Raster::new([SUPERSAMPLING * width, SUPERSAMPLING * height]);
        raster.draw(&vertices, &mesh.triangles);
        let sun = self.sun();
        let shadow = ShadowMap::of(&mesh, sun);
        let mut canvas = Canvas::new(width, height);
        canvas.paint([0.0, 0.0, width as f64, height as f64], |x, y| {
            let pixel = [x, y].map(|v| (SUPERSAMPLING as f64 * v) as usize);
            let seen = raster.seen(pixel, &vertices, &mesh.triangles)?;
            Some(colour(&mesh, &vertices, seen, (&shadow, sun)))
        });
        if self.options.labelled {
            self.label(&mut canvas, frame);
        }
        canvas
    }

    /// Direction of the sun: from above, from behind and from the right of the viewer.
    fn sun(&self) -> DVec3 {
        let (s, c) = self.viewpoint.azimuth.sin_cos();
        let (ahead, right) = (DVec3::new(c, s, 0.0), DVec3::new(s, -c, 0.0));
        (0.58 * right - 0.36 * ahead + 0.73 * DVec3::Z).normalize()
    }

    fn camera(&self, frame: usize) -> Camera {
        let Some(body) = self.recording.bodies.first().filter(|_| self.viewpoint.follow) else {
            return self.camera;
        };
        let middle = |pose: &[f64; 12]| placed(pose).1;
        let moved = middle(&body.poses[frame]) - middle(&body.poses[body.poses.len() - 1]);
        self.camera.moved(moved.with_z(0.0))
    }

    /// Title, scale of heights, time and displacement.
    fn label(&self, canvas: &mut Canvas, frame: usize) {
        let [width, height] = self.options.size.map(|n| n as f64);
        let unit = (width / 1280.0).max(0.55);
        canvas.text(self.title, [24.0 * unit, 30.0 * unit], 24.0 * unit, Anchor::Left);
        let mut when = format!("t = {:.2} s", self.recording.times[frame]);
        if let Some(u) = self.displacements.get(frame).filter(|u| u.abs() > 5e-4) {
            when += &format!(",  u = {u:.3} m").replace('-', "−");
        }
        canvas.text(&when, [24.0 * unit, height - 24.0 * unit], 19.0 * unit, Anchor::Left);
        if self.options.colouring == Colouring::Plain {
            return;
        }
        let (right, top, wide) = (width - 30.0 * unit, 48.0 * unit, 230.0 * unit);
        let (low, high) = (self.colours.low(), self.colours.most);
        let bar = [right - wide, top, right, top + 11.0 * unit];
        canvas.paint(bar, |x, _| Some(self.colours.tone(low + (high - low) * (x - bar[0]) / wide)));
        canvas.text("height of the surface [mm]", [right, 30.0 * unit], 17.0 * unit, Anchor::Right);
        for value in [low, 0.5 * (low + high), high] {
            let x = bar[0] + wide * (value - low) / (high - low);
            canvas.text(&digits(1e3 * value), [x, top + 24.0 * unit], 16.0 * unit, Anchor::Centre);
        }
    }
}

/// Points around a body where it is at the end.
fn surroundings(body: &RecordedBody) -> Vec<DVec3> {
    let (rotation, middle) = placed(&body.poses[body.poses.len() - 1]);
    body.points.iter().map(|p| middle + rotation * *p * (1.0 + SURROUNDINGS)).collect()
}

/// Points around all that is to be seen at any time.
fn everything(recording: &Recording, base: f64) -> Vec<DVec3> {
    let ends = recording.places.each_ref().map(|axis| [axis[0], axis[axis.len() - 1]]);
    let heights = recording.heights.iter().flatten().copied().filter(|z| z.is_finite());
    let levels = [base, heights.fold(recording.level, f64::max)];
    let mut points: Vec<DVec3> = Vec::new();
    for x in ends[0] {
        for y in ends[1] {
            points.extend(levels.map(|z| DVec3::new(x, y, z)));
        }
    }
    for body in &recording.bodies {
        for (rotation, middle) in body.poses.iter().map(placed) {
            points.extend(body.points.iter().step_by(7).map(|p| middle + rotation * *p));
        }
    }
    points
}

/// The colour of what a pixel shows.
fn colour(mesh: &Mesh, vertices: &[[f64; 3]], seen: Fragment, (shadow, sun): (&ShadowMap, DVec3)) -> Tone {
    let triangle = mesh.triangles[seen.triangle];
    // From the picture to space: what is nearer counts more.
    let weights: [f64; 3] = std::array::from_fn(|n| seen.weights[n].max(0.0) * vertices[triangle[n]][2]);
    let sum: f64 = weights.iter().sum();
    let at = triangle.map(|n| mesh.vertices[n]);
    let blend = |of: &dyn Fn(usize) -> DVec3| (0..3).map(|n| weights[n] / sum * of(n)).sum::<DVec3>();
    let place = blend(&|n| at[n].place);
    let normal = blend(&|n| at[n].normal.normalize_or_zero()).normalize_or_zero();
    let facing = normal.dot(sun).max(0.0);
    let reached = if facing > 0.0 { shadow.light(place, normal) } else { 0.0 };
    let light = SKY * (0.8 + 0.2 * normal.z) + SUN * facing * reached;
    [0, 1].map(|ground| {
        let mixed = blend(&|n| DVec3::from_array(at[n].tone[ground].map(f64::from)));
        shaded(mixed.to_array().map(|channel| channel.round() as u8), light)
    })
}
