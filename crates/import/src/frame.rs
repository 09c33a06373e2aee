//! The axes of the case: x along the tow, z up, the plane of symmetry at y = 0.

/// From the axes of the deck to those of the case.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Frame {
    /// For each axis of the case, the axis of the deck along it, and whether in the same sense.
    pub(super) axes: [(usize, bool); 3],
    /// Position of the origin of the case along its own axes, in units of the deck.
    pub(super) origin: [f64; 3],
}

impl Frame {
    /// The four frames in which this axis of the deck points up, the one that turns least first.
    pub(super) fn upright(up: (usize, bool)) -> [Self; 4] {
        let first = (up.0 + 1) % 3;
        let second = (up.0 + 2) % 3;
        // A right-handed set: z up, x and y the axes that follow in the cycle, exchanged where up is turned.
        let (x, y) = if up.1 { (first, second) } else { (second, first) };
        let turn = |x: (usize, bool), y: (usize, bool)| Self { axes: [x, y, up], origin: [0.0; 3] };
        let mut frames = [
            turn((x, true), (y, true)),
            turn((y, true), (x, false)),
            turn((x, false), (y, false)),
            turn((y, false), (x, true)),
        ];
        // The frame that leaves most axes as they are comes first.
        let kept = |frame: &Self| {
            frame.axes.iter().enumerate().filter(|(n, (axis, same))| n == axis && *same).count() * 8
                + usize::from(frame.axes[0].1)
                + 4 * usize::from(frame.axes[0].0 == 0)
        };
        frames.sort_by_key(|frame| std::cmp::Reverse(kept(frame)));
        frames
    }

    /// A direction in axes of the case.
    pub(super) fn direction(&self, vector: [f64; 3]) -> [f64; 3] {
        self.axes.map(|(axis, same)| if same { vector[axis] } else { -vector[axis] })
    }

    /// A point in axes of the case, in units of the deck.
    pub(super) fn point(&self, point: [f64; 3]) -> [f64; 3] {
        let turned = self.direction(point);
        [0, 1, 2].map(|n| turned[n] - self.origin[n])
    }

    /// Whether it leaves the axes as they are.
    pub(super) fn is_plain(&self) -> bool {
        self.axes == [(0, true), (1, true), (2, true)]
    }

    /// In words: `x = x, y = −z, z = y`.
    pub(super) fn words(&self) -> String {
        let name = |n: usize| ["x", "y", "z"][n];
        let of = |n: usize| {
            let (axis, same) = self.axes[n];
            format!("{} along {}{}", name(n), if same { "" } else { "−" }, name(axis))
        };
        format!("{}, {}, {} of the deck", of(0), of(1), of(2))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn frames_are_right_handed_and_the_first_turns_least() {
        for axis in 0..3 {
            for same in [true, false] {
                for frame in Frame::upright((axis, same)) {
                    let [x, y, z] =
                        [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(|v| frame.direction(v));
                    let cross =
                        [x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]];
                    assert_eq!(cross, z, "{frame:?}");
                }
            }
        }
        assert!(Frame::upright((2, true))[0].is_plain());
        assert_eq!(Frame::upright((1, true))[0].axes, [(0, true), (2, false), (1, true)]);
    }
}
