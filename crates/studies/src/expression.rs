//! Formulas of keys that follow from others: numbers with units, names, `+ - * / ^`, brackets and a few
//! functions.

use coulter::case::quantity::{self, Dimension, describe};

/// A number in SI units with what it measures.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dimensional {
    /// The number, in SI units.
    pub value: f64,
    /// Dimension of the number.
    pub dimension: Dimension,
}

impl Dimensional {
    /// A number without a unit.
    #[must_use]
    pub fn plain(value: f64) -> Self {
        Self { value, dimension: Dimension([0; 4]) }
    }

    fn is_plain(self) -> bool {
        self.dimension == Dimension([0; 4])
    }
}

/// A formula.
#[derive(Clone, Debug, PartialEq)]
pub enum Expression {
    /// A number.
    Number(f64),
    /// A factor, a key of the case or a unit.
    Name(String),
    /// The negative of another.
    Negative(Box<Expression>),
    /// Two, joined by `+ - * / ^`.
    Joined(Box<Expression>, char, Box<Expression>),
    /// A function of another.
    Function(&'static str, Box<Expression>),
    /// The smallest (`min`) or the largest (`max`) of several.
    Extreme(&'static str, Vec<Expression>),
}

/// The functions.
pub const FUNCTIONS: [&str; 6] = ["sqrt", "sin", "cos", "tan", "exp", "ln"];
/// The functions of several quantities.
pub const EXTREMES: [&str; 2] = ["min", "max"];
/// Deepest nesting.
const DEEPEST: usize = 64;
/// Most letters.
const LONGEST: usize = 1000;

/// Reads a formula.
///
/// # Errors
/// What is wrong with it.
pub fn parse(text: &str) -> Result<Expression, String> {
    let letters: Vec<char> = text.chars().collect();
    if letters.len() > LONGEST {
        return Err(format!("it has more than {LONGEST} letters"));
    }
    let mut parser = Parser { letters: &letters, at: 0, depth: 0 };
    let read = parser.sum()?;
    match parser.peek() {
        None => Ok(read),
        Some(letter) => Err(format!("`{letter}` at letter {} is not expected there", parser.at + 1)),
    }
}

struct Parser<'a> {
    letters: &'a [char],
    at: usize,
    depth: usize,
}

fn starts_name(letter: char) -> bool {
    letter.is_alphabetic() || letter == '_' || letter == '°'
}

impl Parser<'_> {
    /// The next letter that is not a space.
    fn peek(&mut self) -> Option<char> {
        while self.letters.get(self.at).is_some_and(|letter| letter.is_whitespace()) {
            self.at += 1;
        }
        self.letters.get(self.at).copied()
    }

    fn take(&mut self, allowed: &str) -> Option<char> {
        let letter = self.peek().filter(|letter| allowed.contains(*letter))?;
        self.at += 1;
        Some(letter)
    }

    fn sum(&mut self) -> Result<Expression, String> {
        let mut left = self.product()?;
        while let Some(sign) = self.take("+-−") {
            let right = self.product()?;
            let sign = if sign == '−' { '-' } else { sign };
            left = Expression::Joined(Box::new(left), sign, Box::new(right));
        }
        Ok(left)
    }

    fn product(&mut self) -> Result<Expression, String> {
        let mut left = self.signed()?;
        loop {
            // A number and a unit stand side by side: `30 deg`.
            let sign = match self.take("*·/") {
                Some('·') => '*',
                Some(sign) => sign,
                None if self.peek().is_some_and(starts_name) => '*',
                None => return Ok(left),
            };
            let right = self.signed()?;
            left = Expression::Joined(Box::new(left), sign, Box::new(right));
        }
    }

    fn signed(&mut self) -> Result<Expression, String> {
        self.depth += 1;
        if self.depth > DEEPEST {
            return Err(format!("it is nested more than {DEEPEST} times"));
        }
        let read = if self.take("-−").is_some() {
            Expression::Negative(Box::new(self.signed()?))
        } else {
            let base = self.operand()?;
            if self.take("^").is_some() {
                Expression::Joined(Box::new(base), '^', Box::new(self.signed()?))
            } else {
                base
            }
        };
        self.depth -= 1;
        Ok(read)
    }

    fn operand(&mut self) -> Result<Expression, String> {
        match self.peek() {
            Some('(') => {
                self.at += 1;
                let inner = self.sum()?;
                self.take(")").ok_or_else(|| format!("a bracket is not closed at letter {}", self.at + 1))?;
                Ok(inner)
            }
            Some(letter) if letter.is_ascii_digit() || letter == '.' => self.number(),
            Some(letter) if starts_name(letter) => self.name(),
            Some(letter) => Err(format!("`{letter}` at letter {} is not expected there", self.at + 1)),
            None => Err("it ends where a number or a name is expected".to_owned()),
        }
    }

    fn number(&mut self) -> Result<Expression, String> {
        let rest: String = self.letters[self.at..].iter().collect();
        let (number, _) = quantity::split_number(&rest);
        self.at += number.chars().count();
        number
            .replace('_', "")
            .parse()
            .map(Expression::Number)
            .map_err(|_| format!("`{number}` is not a number"))
    }

    fn name(&mut self) -> Result<Expression, String> {
        let from = self.at;
        let continues =
            |letter: &char| starts_name(*letter) || letter.is_ascii_digit() || "._".contains(*letter);
        while self.letters.get(self.at).is_some_and(continues) {
            self.at += 1;
        }
        let name: String = self.letters[from..self.at].iter().collect();
        if let Some(extreme) = EXTREMES.iter().find(|extreme| **extreme == name) {
            self.take("(").ok_or_else(|| format!("`{name}` needs a bracket: {name}(…, …)"))?;
            let mut inner = vec![self.sum()?];
            while self.take(",").is_some() {
                inner.push(self.sum()?);
            }
            self.take(")").ok_or_else(|| format!("the bracket of `{name}` is not closed"))?;
            return Ok(Expression::Extreme(extreme, inner));
        }
        let Some(function) = FUNCTIONS.iter().find(|function| **function == name) else {
            return Ok(Expression::Name(name));
        };
        self.take("(").ok_or_else(|| format!("`{name}` needs a bracket: {name}(…)"))?;
        let inner = self.sum()?;
        self.take(")").ok_or_else(|| format!("the bracket of `{name}` is not closed"))?;
        Ok(Expression::Function(function, Box::new(inner)))
    }
}

impl Expression {
    /// Value of the expression; `known` gives that of a factor or a key.
    ///
    /// # Errors
    /// Which name is unknown, or which quantities do not go together.
    pub fn value(&self, known: &dyn Fn(&str) -> Option<Dimensional>) -> Result<Dimensional, String> {
        let found = match self {
            Self::Number(number) => Dimensional::plain(*number),
            Self::Name(name) => named(name, known)?,
            Self::Negative(inner) => {
                let inner = inner.value(known)?;
                Dimensional { value: -inner.value, ..inner }
            }
            Self::Joined(left, sign, right) => joined(left.value(known)?, *sign, right.value(known)?)?,
            Self::Function(name, inner) => function(name, inner.value(known)?)?,
            Self::Extreme(name, inner) => {
                let all = inner.iter().map(|one| one.value(known)).collect::<Result<Vec<_>, _>>()?;
                extreme(name, &all)?
            }
        };
        if found.value.is_finite() { Ok(found) } else { Err("it is not a finite number".to_owned()) }
    }

    /// The names in the expression.
    #[must_use]
    pub fn names(&self) -> Vec<&str> {
        match self {
            Self::Number(_) => Vec::new(),
            Self::Name(name) => vec![name],
            Self::Negative(inner) | Self::Function(_, inner) => inner.names(),
            Self::Joined(left, _, right) => [left.names(), right.names()].concat(),
            Self::Extreme(_, inner) => inner.iter().flat_map(Self::names).collect(),
        }
    }
}

/// The quantity of a name: a factor or a key, otherwise a unit or π.
fn named(name: &str, known: &dyn Fn(&str) -> Option<Dimensional>) -> Result<Dimensional, String> {
    if let Some(quantity) = known(name) {
        return Ok(quantity);
    }
    if matches!(name, "pi" | "π") {
        return Ok(Dimensional::plain(std::f64::consts::PI));
    }
    let unit = quantity::parse_any(&format!("1 {name}"));
    unit.map(|(value, dimension)| Dimensional { value, dimension }).map_err(|_| {
        format!("`{name}` is neither a factor nor a key of the case that holds a number, nor a unit")
    })
}

fn joined(left: Dimensional, sign: char, right: Dimensional) -> Result<Dimensional, String> {
    let Dimension(a) = left.dimension;
    let Dimension(b) = right.dimension;
    let each = |join: fn(i32, i32) -> i32| Dimension(std::array::from_fn(|n| join(a[n], b[n])));
    Ok(match sign {
        '*' => Dimensional { value: left.value * right.value, dimension: each(i32::saturating_add) },
        '/' => Dimensional { value: left.value / right.value, dimension: each(i32::saturating_sub) },
        '^' => power(left, right)?,
        _ if left.dimension != right.dimension => {
            let (a, b) = (describe(left.dimension), describe(right.dimension));
            return Err(format!("{a} and {b} cannot be added or subtracted"));
        }
        '-' => Dimensional { value: left.value - right.value, ..left },
        _ => Dimensional { value: left.value + right.value, ..left },
    })
}

fn extreme(name: &str, all: &[Dimensional]) -> Result<Dimensional, String> {
    let first = *all.first().ok_or("it is empty")?;
    all.iter().try_fold(first, |best, one| {
        if one.dimension != best.dimension {
            let (a, b) = (describe(best.dimension), describe(one.dimension));
            return Err(format!("{a} and {b} cannot be compared"));
        }
        let value = if name == "min" { best.value.min(one.value) } else { best.value.max(one.value) };
        Ok(Dimensional { value, ..best })
    })
}

fn power(base: Dimensional, exponent: Dimensional) -> Result<Dimensional, String> {
    if !exponent.is_plain() {
        return Err("an exponent has no unit".to_owned());
    }
    let value = base.value.powf(exponent.value);
    let Dimension(exponents) = base.dimension;
    let raised = exponents.map(|e| f64::from(e) * exponent.value);
    if raised.iter().any(|e| e.fract() != 0.0 || e.abs() > 20.0) {
        return Err(format!("{} has no power {}", describe(base.dimension), exponent.value));
    }
    Ok(Dimensional { value, dimension: Dimension(raised.map(|e| e as i32)) })
}

fn function(name: &str, of: Dimensional) -> Result<Dimensional, String> {
    if name == "sqrt" {
        return power(of, Dimensional::plain(0.5));
    }
    let is_angle = of.dimension == Dimension([0, 0, 0, 1]);
    let takes_it = is_angle && matches!(name, "sin" | "cos" | "tan");
    if !(of.is_plain() || takes_it) {
        return Err(format!("{name}({}) has no meaning", describe(of.dimension)));
    }
    Ok(Dimensional::plain(match name {
        "sin" => of.value.sin(),
        "cos" => of.value.cos(),
        "tan" => of.value.tan(),
        "exp" => of.value.exp(),
        _ => of.value.ln(),
    }))
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn value(text: &str) -> Result<Dimensional, String> {
        let known = |name: &str| match name {
            "t_bar" => Some(Dimensional::plain(0.25)),
            "body.disc.diameter" => Some(Dimensional { value: 0.2, dimension: quantity::LENGTH.dimension }),
            "soil.unit_weight" => {
                Some(Dimensional { value: 16e3, dimension: quantity::UNIT_WEIGHT.dimension })
            }
            "phi" => Some(Dimensional { value: 0.6, dimension: quantity::ANGLE.dimension }),
            _ => None,
        };
        parse(text)?.value(&known)
    }

    #[test]
    fn formulas_have_values_and_units() {
        for (text, expected, measure) in [
            ("t_bar * body.disc.diameter", 0.05, quantity::LENGTH),
            ("3.5 * soil.unit_weight * t_bar * body.disc.diameter^3", 3.5 * 32.0, quantity::FORCE),
            ("30 deg + phi", 30_f64.to_radians() + 0.6, quantity::ANGLE),
            ("-(2 mm − 5 mm)", 0.003, quantity::LENGTH),
            ("16 kN/m^3", 16e3, quantity::UNIT_WEIGHT),
            ("sqrt(body.disc.diameter^2)", 0.2, quantity::LENGTH),
            ("tan(phi) * 1 m", 0.6_f64.tan(), quantity::LENGTH),
            ("2 m / 2^-1", 4.0, quantity::LENGTH),
            ("min(3 mm, body.disc.diameter, 1 m)", 0.003, quantity::LENGTH),
            ("max(3 mm, body.disc.diameter)", 0.2, quantity::LENGTH),
        ] {
            let found = value(text).unwrap();
            assert!((found.value - expected).abs() < 1e-12 * expected.abs().max(1.0), "{text}: {found:?}");
            assert_eq!(found.dimension, measure.dimension, "{text}");
        }
    }

    #[test]
    fn what_is_wrong_is_said() {
        for (text, words) in [
            ("t_bar * ", "it ends where"),
            ("t_bar + phi", "cannot be added"),
            ("thickness", "`thickness` is neither a factor"),
            ("(1 + 2", "not closed"),
            ("1 + $", "`$` at letter 5"),
            ("sqrt(1 m)", "a length has no power 0.5"),
            ("ln(1 m)", "has no meaning"),
            ("1 / 0", "not a finite number"),
            ("2 ^ (1 m)", "an exponent has no unit"),
            ("min(1 m, 1 s)", "a length and a time cannot be compared"),
            ("sqrt 2", "needs a bracket"),
            ("1 2", "`2` at letter 3"),
        ] {
            let message = value(text).unwrap_err();
            assert!(message.contains(words), "{text}: {message}");
        }
        assert!(value(&"(".repeat(900)).unwrap_err().contains("nested"));
        assert!(value(&"(".repeat(10_000)).unwrap_err().contains("letters"));
    }

    proptest! {
        #[test]
        fn never_panics(text in "[-+*/^() 0-9a-z._·°]{0,24}") {
            let _ = value(&text);
        }
    }
}
