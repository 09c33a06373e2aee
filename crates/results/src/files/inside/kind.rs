//! What an entry of a folder can be.

use std::io;

/// What an entry of a folder is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EntryKind {
    /// An ordinary file.
    File {
        /// Number of names of the file (hard links).
        names: u64,
    },
    /// A folder.
    Folder,
    /// A symbolic link.
    Link,
    /// A pipe, a device, a socket.
    Special,
}

/// The entry, unless it must not be used whatever is expected.
pub(super) fn refused(kind: EntryKind) -> io::Result<EntryKind> {
    match kind {
        EntryKind::File { .. } | EntryKind::Folder => Ok(kind),
        EntryKind::Link | EntryKind::Special => Err(forbidden(kind, "it", "an ordinary file or folder")),
    }
}

/// Says what an entry is instead of what is expected, and what to do.
pub(super) fn forbidden(kind: EntryKind, what: &str, expected: &str) -> io::Error {
    let (is, cure) = match kind {
        EntryKind::File { .. } => ("a file", "remove it"),
        EntryKind::Folder => ("a folder", "remove it"),
        EntryKind::Link => {
            ("a link, which is not followed", "put what it leads to in its place, or remove it")
        }
        EntryKind::Special => ("a pipe or a device", "remove it"),
    };
    io::Error::other(format!("{what} is {is}; {expected} belongs here: {cure}, or choose another folder"))
}
