//! Searches on several threads.

use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc;
use std::thread;

use rangelab::Result;
use rangelab::model::scenario::Scenario;
use rangelab::place::{Improvement, improve};

/// Makes the searches 0 to `count - 1` and gives them back in their order; `done` hears of each that ends.
pub fn run(
    scenario: &Scenario,
    count: usize,
    threads: usize,
    mut done: impl FnMut(),
) -> Result<Vec<Improvement>> {
    let next = AtomicUsize::new(0);
    let (sender, receiver) = mpsc::channel();
    let mut found: Vec<_> = thread::scope(|scope| {
        for _ in 0..threads.min(count) {
            let (sender, next) = (sender.clone(), &next);
            scope.spawn(move || {
                let indices = || Some(next.fetch_add(1, Ordering::Relaxed)).filter(|&i| i < count);
                for index in std::iter::from_fn(indices) {
                    sender
                        .send((index, improve(scenario, index as u64)))
                        .expect("the receiver waits for all");
                }
            });
        }
        drop(sender);
        receiver.into_iter().inspect(|_| done()).collect()
    });
    found.sort_by_key(|(index, _)| *index);
    found.into_iter().map(|(_, search)| search).collect()
}
