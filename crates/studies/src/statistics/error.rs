//! What keeps a statistic from being computed.

/// Why a design or a statistic is refused.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum StatisticsError {
    /// A design without points or factors, or with more factors than the sequence has dimensions.
    #[error("a design of {points} points in {factors} factors is not possible: {cure}")]
    Design {
        /// Number of points asked for.
        points: usize,
        /// Number of factors asked for.
        factors: usize,
        /// What to do about the design.
        cure: String,
    },
    /// Not enough points.
    #[error("{what} needs at least {least} points, there are {given}: add points to the design")]
    TooFewPoints {
        /// What was to be computed.
        what: &'static str,
        /// The least number of points.
        least: usize,
        /// The number of points given.
        given: usize,
    },
    /// Lists whose lengths do not agree.
    #[error("point {point} has {given} coordinates or values where {expected} are expected")]
    Shape {
        /// Number of the point, from 0.
        point: usize,
        /// Number of coordinates or values of the point.
        given: usize,
        /// Number of coordinates or values that is expected.
        expected: usize,
    },
    /// A number that is not finite.
    #[error("point {point} has a coordinate or a value that is not a finite number: leave it out")]
    NotFinite {
        /// Number of the point, from 0.
        point: usize,
    },
    /// All points are the same.
    #[error("all points have the same inputs: no factor varies")]
    EqualInputs,
    /// All values are the same.
    #[error("all values are equal: nothing depends on the factors")]
    EqualValues,
    /// A matrix that should be positive definite is not, whatever the hyperparameters.
    #[error(
        "the covariance matrix of the surrogate is not positive definite: the inputs or the values are degenerate"
    )]
    NotPositiveDefinite,
    /// Factors of which one follows from others.
    #[error("a factor follows linearly from others: their effects cannot be told apart")]
    DependentFactors,
    /// A surrogate that does not predict the points left out of it.
    #[error(
        "the surrogate does not predict: Q² = {predictivity:.2}, at least {least:.2} is needed; add points, or vary fewer factors"
    )]
    NotPredictive {
        /// Predictivity of the surrogate Q² [–].
        predictivity: f64,
        /// The least that is accepted [–].
        least: f64,
    },
    /// A function without a variance.
    #[error("the response does not vary over the factors: there is no variance to divide")]
    NoVariance,
}
