//! A body at a time: its surface and, last, its reference point.

use super::timed::{Cells, Part, Quantity};
use crate::files::{Inside, OutputError};
use crate::history::BodySample;
use crate::vtk::VtkFile;
use case::tow::TowDirection;
use glam::{DQuat, DVec3};
use std::f64::consts::TAU;

/// A body as its field file has it.
pub(super) struct Placed {
    points: Vec<DVec3>,
    velocities: Vec<DVec3>,
    triangles: Vec<i64>,
    /// Reference point [m], its velocity [m/s], angular velocity [rad/s].
    at: [DVec3; 3],
    /// Rotation from the body's axes to those of space.
    rotation: DQuat,
}

/// The line of a history whose interval includes a time [s]; the last where none does.
pub(super) fn sample_at(samples: &[BodySample], time: f64) -> BodySample {
    let n = samples.partition_point(|sample| sample.time < time * (1.0 - 1e-9));
    samples.get(n).or(samples.last()).copied().unwrap_or_default()
}

impl Placed {
    pub(super) fn read(file: &Inside) -> Result<Self, OutputError> {
        let file = VtkFile::read(file)?;
        let [points, velocities] = ["Points", "velocity"].map(|name| file.numbers(name));
        let vectors = |numbers: Vec<f64>| numbers.chunks_exact(3).map(DVec3::from_slice).collect();
        let fact = |name| file.fact(name).map(DVec3::from_array);
        Ok(Self {
            points: vectors(points?),
            velocities: vectors(velocities?),
            triangles: file.numbers("connectivity")?.into_iter().map(|n| n as i64).collect(),
            at: [fact("reference_point")?, fact("velocity")?, fact("angular_velocity")?],
            rotation: DQuat::from_scaled_axis(fact("rotation")?),
        })
    }

    /// The part of a file, with displacements since the start, and the forces of a line of the history.
    pub(super) fn part(&self, start: &Self, sample: &BodySample, tow: TowDirection) -> Part {
        let ([place, velocity, spin], count) = (self.at, self.points.len());
        let alone = |last: DVec3| vec![DVec3::ZERO; count].into_iter().chain([last]).collect::<Vec<_>>();
        let moved = self.points.iter().zip(&start.points).map(|(now, then)| *now - *then);
        let [along, left] = tow.components();
        let force = DVec3::new(
            -sample.drag * along - sample.lateral * left,
            -sample.drag * left + sample.lateral * along,
            sample.vertical,
        );
        let moment = DVec3::new(sample.moment_x, sample.moment_y, sample.moment_z);
        let quantities = [
            ("U", moved.chain([place - start.at[0]]).collect()),
            ("UR", vec![self.turned(start, sample.rotation); count + 1]),
            ("V", self.velocities.iter().copied().chain([velocity]).collect()),
            ("VR", vec![spin; count + 1]),
            ("RF", alone(DVec3::ZERO - force)),
            ("RM", alone(DVec3::ZERO - moment)),
        ];
        let quantity = |(name, vectors): (&str, Vec<DVec3>)| Quantity {
            section: "PointData",
            name: name.to_owned(),
            components: 3,
            numbers: vectors.iter().flat_map(|v| v.as_vec3().to_array()).collect(),
        };
        let none = || Cells::of(1, Vec::new());
        let cells =
            vec![Cells::of(1, vec![count as i64]), none(), Cells::of(3, self.triangles.clone()), none()];
        let points = self.points.iter().chain([&place]).flat_map(|point| point.to_array()).collect();
        Part { points, cells, quantities: quantities.map(quantity).into() }
    }

    /// Rotation since the start as a vector [rad]; whole turns are those of the given one about the axle
    /// [rad].
    fn turned(&self, start: &Self, about_axle: f64) -> DVec3 {
        let change = self.rotation * start.rotation.inverse();
        let vector = if change.w < 0.0 { -change } else { change }.to_scaled_axis();
        let axle = start.rotation * DVec3::Y;
        let axis = vector.try_normalize().unwrap_or(axle);
        let share = axis.dot(axle);
        let turns =
            if share.abs() > 0.5 { ((about_axle - vector.dot(axle)) / (TAU * share)).round() } else { 0.0 };
        vector + turns * TAU * axis
    }
}
