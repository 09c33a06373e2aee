//! From lines to keyword blocks: comments, continued lines, included files.

use crate::block::{Block, Parameter, Place, Row, Source, Wrong};

/// Most files of a deck.
const MOST_FILES: usize = 200;
/// Deepest inclusion.
const DEEPEST: usize = 10;
/// Most bytes of all files together.
const MOST_BYTES: usize = 256 << 20;

/// The blocks of a deck, with what was wrong with them.
#[derive(Debug, Default)]
pub(super) struct Scanned {
    pub(super) sources: Vec<Source>,
    pub(super) blocks: Vec<Block>,
    /// Number of a block and what is wrong with it.
    pub(super) wrong: Vec<(usize, Wrong)>,
}

struct Scanner<'a, F> {
    found: Scanned,
    /// The block to which lines of data belong.
    open: Option<usize>,
    bytes: usize,
    include: &'a F,
}

/// Splits a deck into blocks.
pub(super) fn scan<F: Fn(&str) -> Result<String, String>>(text: &str, name: &str, include: &F) -> Scanned {
    let mut scanner = Scanner { found: Scanned::default(), open: None, bytes: 0, include };
    if let Err(message) = scanner.file(text.to_owned(), name.to_owned(), 0) {
        let block = Block {
            keyword: "DECK".into(),
            parameters: vec![],
            rows: vec![],
            place: Place { file: 0, line: 1 },
        };
        scanner.found.blocks.push(block);
        scanner.found.sources.push(Source { name: name.to_owned(), text: String::new() });
        scanner.found.wrong.push((0, message.into()));
    }
    scanner.found
}

impl<F: Fn(&str) -> Result<String, String>> Scanner<'_, F> {
    fn file(&mut self, text: String, name: String, depth: usize) -> Result<(), String> {
        self.bytes = self.bytes.saturating_add(text.len());
        if self.bytes > MOST_BYTES || self.found.sources.len() >= MOST_FILES || depth > DEEPEST {
            return Err(format!(
                "a deck has at most {MOST_FILES} files, {MOST_BYTES} bytes and {DEEPEST} levels of inclusion"
            ));
        }
        let file = self.found.sources.len();
        self.found.sources.push(Source { name, text: String::new() });
        let mut lines = text.lines().enumerate().peekable();
        while let Some((number, line)) = lines.next() {
            let place = Place { file, line: number + 1 };
            let line = line.trim();
            if line.is_empty() || line.starts_with("**") {
                continue;
            }
            let Some(keyword) = line.strip_prefix('*') else {
                self.data(place, line);
                continue;
            };
            let mut whole = keyword.trim().to_owned();
            // A line that ends in a comma goes on in the next.
            while whole.ends_with(',') {
                match lines.next_if(|(_, next)| !next.trim_start().starts_with('*')) {
                    Some((_, next)) => whole.push_str(next.trim()),
                    None => break,
                }
            }
            self.keyword(place, &whole, depth);
        }
        self.found.sources[file].text = text;
        Ok(())
    }

    fn data(&mut self, place: Place, line: &str) {
        match self.open {
            Some(open) => self.found.blocks[open].rows.push(Row { place, text: line.to_owned() }),
            None => {
                let number =
                    self.push(Block { keyword: "(DATA)".into(), parameters: vec![], rows: vec![], place });
                self.found.wrong.push((number, "data before the first keyword".into()));
            }
        }
    }

    fn push(&mut self, block: Block) -> usize {
        self.found.blocks.push(block);
        self.found.blocks.len() - 1
    }

    fn keyword(&mut self, place: Place, text: &str, depth: usize) {
        let block = block(place, text);
        let is_include = block.keyword == "INCLUDE";
        let input = block.value("INPUT").map(str::to_owned);
        let number = self.push(block);
        if !is_include {
            self.open = Some(number);
        }
        match input {
            Some(name) => {
                // The text of an included file belongs to the block above it until the next keyword.
                let read = (self.include)(&name).and_then(|text| self.file(text, name.clone(), depth + 1));
                if let Err(message) = read {
                    self.found.wrong.push((number, format!("{name:?}: {message}").into()));
                }
            }
            None if is_include => self.found.wrong.push((number, "INPUT= is missing".into())),
            None => {}
        }
    }
}

/// A block without data, from its line without the asterisk.
fn block(place: Place, text: &str) -> Block {
    let mut parts = split(text).into_iter();
    let keyword = in_capitals(&parts.next().unwrap_or_default());
    let parameters = parts.filter(|part| !part.trim().is_empty()).map(|part| match part.split_once('=') {
        Some((name, value)) => {
            let value = value.trim().trim_matches(['"', '\'']).to_owned();
            Parameter::new(in_capitals(name), Some(value))
        }
        None => Parameter::new(in_capitals(&part), None),
    });
    Block { keyword, parameters: parameters.collect(), rows: vec![], place }
}

/// The parts of a line between commas that stand in no quotes.
fn split(text: &str) -> Vec<String> {
    let mut parts = vec![String::new()];
    let mut is_quoted = false;
    for letter in text.chars() {
        is_quoted ^= letter == '"';
        match parts.last_mut() {
            Some(last) if letter != ',' || is_quoted => last.push(letter),
            _ => parts.push(String::new()),
        }
    }
    parts
}

/// In capitals, with single blanks.
fn in_capitals(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ").to_uppercase()
}
