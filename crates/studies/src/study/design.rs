//! Which points a part of a study has, and what is evaluated there.

use super::keys::{DESIGNS, MODELS};
use serde::{Deserialize, Serialize};

/// Which points a part has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Design {
    /// Every combination of the levels of the factors.
    Grid,
    /// The first levels of all factors, the second ones, and so on.
    List,
    /// The case itself, and every level of every factor alone.
    OneAtATime,
    /// A Latin hypercube.
    LatinHypercube,
    /// A scrambled Sobol sequence.
    Sobol,
}

impl Design {
    /// The design of that name.
    #[must_use]
    pub fn of(word: &str) -> Self {
        let all = [Self::Grid, Self::List, Self::OneAtATime, Self::LatinHypercube, Self::Sobol];
        let named = DESIGNS.iter().zip(all).find(|(name, _)| **name == word);
        named.map_or(Self::Grid, |(_, design)| design)
    }

    /// Whether the points of the design fill the ranges of the factors instead of their levels.
    #[must_use]
    pub fn fills_space(self) -> bool {
        matches!(self, Self::LatinHypercube | Self::Sobol)
    }
}

/// What is evaluated at a point.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum ModelKind {
    /// The closed forms.
    ClosedForm,
    /// The solver.
    Solver,
}

impl ModelKind {
    /// The models of these names.
    #[must_use]
    pub fn all_of(words: &[String]) -> Vec<Self> {
        let all = MODELS.iter().zip([Self::ClosedForm, Self::Solver]);
        all.filter(|(name, _)| words.iter().any(|word| word == *name)).map(|(_, model)| model).collect()
    }
}
