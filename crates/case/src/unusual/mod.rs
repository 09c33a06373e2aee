//! What no soil, body or tow has: values outside what is usual for their keys, soil that is too soft or too
//! stiff for its weight, and motions that can hardly be meant. Such a case can be run; `check` says it, and
//! the run is graded doubtful.

mod load;
mod motion;
mod stiffness;
mod values;

use super::resolved::Case;

/// Everything that is unusual about a case, each a sentence; empty for a case without any.
#[must_use]
pub fn unusual(case: &Case) -> Vec<String> {
    let mut doubts = Vec::new();
    // Without gravity a case is a test of the method, or of metal.
    if case.gravity > 0.0 {
        values::values(case, &mut doubts);
        stiffness::stiffness(case, &mut doubts);
        load::loads(case, &mut doubts);
        motion::motions(case, &mut doubts);
    }
    doubts
}
