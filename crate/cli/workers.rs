//! Jobs on several threads, one result.

use std::collections::BTreeMap;
use std::num::NonZero;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::mpsc;
use std::thread;

use clap::Args;
use rangelab::Result;

use super::failure::Failure;
use super::progress::progress;

#[derive(Args)]
pub struct Threads {
    /// Number of threads [default: one for each processor]
    #[arg(long, value_name = "COUNT")]
    threads: Option<NonZero<usize>>,
}

impl Threads {
    pub fn count(&self) -> usize {
        self.threads.or(thread::available_parallelism().ok()).map_or(1, NonZero::get)
    }
}

/// Jobs 0 to `count - 1`, and what takes their results in this order.
pub struct Jobs<J, M> {
    pub count: usize,
    pub job: J,
    pub merge: M,
}

impl<T, J, M> Jobs<J, M>
where
    T: Send,
    J: Fn(usize) -> Result<T> + Sync,
    M: FnMut(T) -> Result<()>,
{
    /// Runs all jobs with a progress bar, and hands over their results in their order, so that a sum does not depend on how
    /// many threads there are. The first that failed, by index, is the error.
    pub fn run(self, origin: impl std::fmt::Display, threads: usize) -> std::result::Result<(), Failure> {
        let bar = progress(self.count);
        let ended = self.run_until(threads, &CANCELLED, |done| bar.set_position(done as u64));
        bar.finish_and_clear();
        let done = ended.map_err(|error| Failure::about(origin, &error))?;
        if done.joined < done.count {
            return Err(Failure::Cancelled { percent: 100 * done.joined / done.count });
        }
        Ok(())
    }

    fn run_until(
        mut self,
        threads: usize,
        cancelled: &AtomicBool,
        mut done: impl FnMut(usize),
    ) -> Result<Done> {
        on_interrupt();
        let next = AtomicUsize::new(0);
        let (sender, receiver) = mpsc::channel();
        let (count, job, merge) = (self.count, &self.job, &mut self.merge);
        thread::scope(|scope| {
            for _ in 0..threads.min(count) {
                let (sender, next) = (sender.clone(), &next);
                scope.spawn(move || {
                    let open = |i: &usize| *i < count && !cancelled.load(Ordering::Relaxed);
                    let indices = || Some(next.fetch_add(1, Ordering::Relaxed)).filter(open);
                    for index in std::iter::from_fn(indices) {
                        // Without a receiver another job has failed, and nobody waits for this one.
                        if sender.send((index, job(index))).is_err() {
                            return;
                        }
                    }
                });
            }
            drop(sender);
            let joined = join(merge, receiver, &mut done)?;
            Ok(Done { joined, count })
        })
    }
}

/// How far the jobs have come.
struct Done {
    joined: usize,
    count: usize,
}

/// Takes results in the order of their indices, whatever the order in which they come: every result before one that failed
/// has come by then.
fn join<T>(
    merge: &mut impl FnMut(T) -> Result<()>,
    results: mpsc::Receiver<(usize, Result<T>)>,
    done: &mut impl FnMut(usize),
) -> Result<usize> {
    let mut early = BTreeMap::new();
    let mut joined = 0;
    for (index, result) in results {
        early.insert(index, result);
        while let Some(result) = early.remove(&joined) {
            merge(result?)?;
            joined += 1;
            done(joined);
        }
    }
    Ok(joined)
}

/// Whether Ctrl-C was pressed.
static CANCELLED: AtomicBool = AtomicBool::new(false);

/// From here on Ctrl-C ends the jobs, not the program at once. Where that cannot be arranged it ends the program.
fn on_interrupt() {
    let _ = ctrlc::set_handler(|| CANCELLED.store(true, Ordering::Relaxed));
}
