//! A run on a thread of its own, for callers that keep the loop over time to themselves: each call says what
//! is wished for, and hears what has become of it.

use crate::simulation::{Exchange, Steerer, Wish};
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, channel};
use std::thread::JoinHandle;
use std::time::Duration;

/// What a run says, once after each wish; after a wish that it refuses, and after heights or a state that
/// were wished for, it then says where it stands.
#[derive(Debug)]
pub enum Said<T> {
    /// It stands at an exchange.
    At(Exchange),
    /// The wish cannot be fulfilled; why.
    Refused(String),
    /// The heights of the ground that were wished for [m], `None` outside the grid.
    Ground(Vec<Option<f64>>),
    /// The state that was wished for.
    Saved(Vec<u8>),
    /// It has ended, in this way.
    Ended(T),
}

/// The thread of a run is gone without a word: it has panicked.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("the thread of the run is gone")]
pub struct Gone;

/// The way to a run that is on. Dropped, it stops the run.
#[derive(Debug)]
pub struct Session<T> {
    /// `None` from when it hangs up.
    says: Option<Sender<Wish>>,
    hears: Receiver<Said<T>>,
    worker: Option<JoinHandle<()>>,
}

impl<T: Send + 'static> Session<T> {
    /// Begins a run, which gets its steerer from here. The first it says is where it stands.
    pub fn begin(run: impl FnOnce(&mut dyn Steerer) -> T + Send + 'static) -> Self {
        let ((says, hears), (answers, listens)) = (channel(), channel());
        let worker = std::thread::spawn(move || {
            let mut steerer = HandedOn { says: answers, hears };
            let end = run(&mut steerer);
            steerer.say(Said::Ended(end));
        });
        Self { says: Some(says), hears: listens, worker: Some(worker) }
    }

    /// Says what is wished for. A run that has ended meanwhile says so when it is heard next.
    pub fn wish(&self, wish: Wish) {
        if let Some(says) = &self.says {
            drop(says.send(wish));
        }
    }

    /// What the run says next, or `None` if it says nothing for so long.
    ///
    /// # Errors
    /// [`Gone`].
    pub fn hear(&self, patience: Duration) -> Result<Option<Said<T>>, Gone> {
        match self.hears.recv_timeout(patience) {
            Ok(said) => Ok(Some(said)),
            Err(RecvTimeoutError::Timeout) => Ok(None),
            Err(RecvTimeoutError::Disconnected) => Err(Gone),
        }
    }

    /// What the run says next, however long it takes.
    ///
    /// # Errors
    /// [`Gone`].
    pub fn wait(&self) -> Result<Said<T>, Gone> {
        self.hears.recv().map_err(|_| Gone)
    }
}

impl<T> Drop for Session<T> {
    fn drop(&mut self) {
        self.says = None;
        // What it would say of a panic, it has said.
        self.worker.take().into_iter().for_each(|worker| drop(worker.join()));
    }
}

/// The steerer of the run: hands everything on to the caller, and asks it.
struct HandedOn<T> {
    says: Sender<Said<T>>,
    hears: Receiver<Wish>,
}

impl<T> HandedOn<T> {
    /// A caller that no longer listens stops the run.
    fn say(&self, said: Said<T>) {
        drop(self.says.send(said));
    }
}

impl<T> Steerer for HandedOn<T> {
    fn next(&mut self, exchange: Exchange) -> Wish {
        self.say(Said::At(exchange));
        self.hears.recv().unwrap_or(Wish::Stop)
    }

    fn refused(&mut self, why: String) {
        self.say(Said::Refused(why));
    }

    fn ground(&mut self, heights: Vec<Option<f64>>) {
        self.say(Said::Ground(heights));
    }

    fn saved(&mut self, state: Vec<u8>) {
        self.say(Said::Saved(state));
    }
}
