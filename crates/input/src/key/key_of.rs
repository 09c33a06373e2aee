//! Keys together with the places of their values: reading, checks of range and lists of numbers follow from
//! them.

use super::allowed_range::AllowedRange;
use super::declaration::{Key, Kind, key};
use super::default_value::DefaultValue;

use super::usual_range::UsualRange;
use crate::problem::Problems;
use crate::typed::Section;

/// A key of a section, and where its value lies in a `T`, which the section becomes.
pub struct KeyOf<T: 'static> {
    /// The key.
    pub key: Key,
    /// Where the value of the key lies.
    pub place: Place<T>,
}

/// Where the value of a key lies in a `T`.
pub enum Place<T: 'static> {
    /// A number that every `T` has. Where it has no default and is not required, it stays what the `T` began
    /// with.
    Number(fn(&mut T) -> &mut f64),
    /// A number that may be left out.
    Optional(fn(&mut T) -> &mut Option<f64>),
    /// A number of a part that not every `T` has; without the part it is neither read nor checked.
    Part(fn(&mut T) -> Option<&mut f64>),
    /// A number that may follow from other keys: it is checked where it exists, but whoever reads the section
    /// fills it in.
    Derived(fn(&mut T) -> Option<&mut f64>),
    /// A whole number, 0 or more.
    Count(fn(&mut T) -> &mut usize),
    /// Yes or no.
    Flag(fn(&mut T) -> &mut bool),
    /// One of the words of the key, and what it changes.
    Word(fn(&mut T, &str)),
    /// No place: whoever reads the section knows what the key changes.
    Elsewhere,
}

impl<T: 'static> KeyOf<T> {
    /// A key that must be given, unless it gets a default.
    pub const fn new(name: &'static str, kind: Kind, place: Place<T>) -> Self {
        Self { key: key(name, kind, DefaultValue::Required, ""), place }
    }

    const fn with(self, key: Key) -> Self {
        Self { key, ..self }
    }

    /// The key with what applies where it is left out.
    pub const fn default(self, default: DefaultValue) -> Self {
        let key = Key { default, ..self.key };
        self.with(key)
    }

    /// Derived from other keys where it is left out: how.
    pub const fn derived(self, how: &'static str) -> Self {
        self.default(DefaultValue::Derived(how))
    }

    /// Required where the soil law of this word applies.
    pub const fn required_for(self, law: &'static str) -> Self {
        self.default(DefaultValue::RequiredFor(law))
    }

    /// The key with the range of the numbers that it allows.
    pub const fn within(self, range: AllowedRange) -> Self {
        let key = self.key.within(range);
        self.with(key)
    }

    /// The key with the range of the numbers that are usual.
    pub const fn usually(self, usual: UsualRange) -> Self {
        let key = self.key.usually(usual);
        self.with(key)
    }

    /// The key with its meaning.
    pub const fn means(self, meaning: &'static str) -> Self {
        let key = Key { meaning, ..self.key };
        self.with(key)
    }

    /// Fills in what the section says, or the default; false if that is wrong or missing, which has been
    /// reported.
    fn fill(&self, whole: &mut T, section: &Section, problems: &mut Problems) -> bool {
        let name = self.key.name;
        let is_given = section.has(name);
        let fill = |place: &mut f64| match section.number(name) {
            Some(number) => {
                *place = number;
                true
            }
            None => !is_given && !self.key.default.is_required(),
        };
        if self.key.default.is_required() && !is_given {
            self.key.missing(section, problems);
        }
        match self.place {
            Place::Number(place) => fill(place(whole)),
            Place::Part(place) => place(whole).is_none_or(fill),
            Place::Optional(place) => {
                *place(whole) = section.number(name);
                !is_given || place(whole).is_some()
            }
            Place::Word(choose) => section.text(name).map(|word| choose(whole, &word)).is_some(),
            Place::Count(place) => section.number(name).map(|n| *place(whole) = n as usize).is_some(),
            Place::Flag(place) => section.flag(name).map(|flag| *place(whole) = flag).is_some(),
            Place::Derived(_) | Place::Elsewhere => true,
        }
    }

    fn value(&self, of: &mut T) -> Option<f64> {
        match self.place {
            Place::Number(place) => Some(*place(of)),
            Place::Optional(place) => *place(of),
            Place::Part(place) | Place::Derived(place) => place(of).copied(),
            Place::Count(place) => Some(*place(of) as f64),
            Place::Flag(_) | Place::Word(_) | Place::Elsewhere => None,
        }
    }
}

/// What a section says, in the order of the keys, put into a `T`; `None` if any of it is wrong or missing,
/// which has been reported.
pub fn read<T>(keys: &[KeyOf<T>], mut start: T, section: &Section, problems: &mut Problems) -> Option<T> {
    let mut is_right = true;
    for key in keys {
        is_right &= key.fill(&mut start, section, problems);
    }
    is_right.then_some(start)
}

/// The number of a key without which other keys of the section mean nothing; `None` if it is wrong or
/// missing, which is reported.
pub fn required<T>(keys: &[KeyOf<T>], name: &str, section: &Section, problems: &mut Problems) -> Option<f64> {
    if !section.has(name) {
        keys.iter().filter(|one| one.key.name == name).for_each(|one| one.key.missing(section, problems));
    }
    section.number(name)
}

/// Numbers, each with its key.
pub type Numbers = Vec<(&'static Key, f64)>;

/// The numbers of a `T`, each with its key.
pub fn numbers<T: Clone>(keys: &'static [KeyOf<T>], of: &T) -> Numbers {
    let mut of = of.clone();
    keys.iter().filter_map(|one| Some((&one.key, one.value(&mut of)?))).collect()
}

/// Reports the numbers of the section at a path that are out of the range of their key.
pub fn in_ranges(path: &str, numbers: &[(&Key, f64)], problems: &mut Problems) {
    for (key, number) in numbers {
        key.admits(&format!("{path}.{}", key.name), *number, problems);
    }
}

/// The keys without their places.
pub const fn declared<T, const N: usize>(keys: &[KeyOf<T>]) -> [Key; N] {
    let (mut all, mut n) = ([keys[0].key; N], 0);
    while n < N {
        all[n] = keys[n].key;
        n += 1;
    }
    all
}

/// The keys of several lists, one after the other.
pub const fn joined<const N: usize>(lists: &[&[Key]]) -> [Key; N] {
    let (mut all, mut n, mut list) = ([lists[0][0]; N], 0, 0);
    while list < lists.len() {
        let mut own = 0;
        while own < lists[list].len() {
            all[n] = lists[list][own];
            (n, own) = (n + 1, own + 1);
        }
        list += 1;
    }
    all
}

/// How many keys several lists have.
pub const fn count(lists: &[&[Key]]) -> usize {
    let (mut sum, mut list) = (0, 0);
    while list < lists.len() {
        sum += lists[list].len();
        list += 1;
    }
    sum
}
