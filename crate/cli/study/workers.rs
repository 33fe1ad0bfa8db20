//! Trials on several threads, one result.

use std::collections::BTreeMap;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc;
use std::thread;

use rangelab::Result;
use rangelab::study::block::Block;
use rangelab::study::monte_carlo::MonteCarlo;

/// Runs all blocks of a study on `threads` threads and joins them in their order, so that the sum does not depend on
/// how many threads there are. `done` hears of each block that is joined.
pub fn run(study: &MonteCarlo<'_>, threads: usize, mut done: impl FnMut(usize)) -> Result<Block> {
    let next = AtomicUsize::new(0);
    let (sender, receiver) = mpsc::channel();
    thread::scope(|scope| {
        for _ in 0..threads.min(study.blocks()) {
            let (sender, next) = (sender.clone(), &next);
            scope.spawn(move || {
                let indices = || Some(next.fetch_add(1, Ordering::Relaxed)).filter(|&i| i < study.blocks());
                for index in std::iter::from_fn(indices) {
                    let block = study.block(index);
                    // Without a receiver another block has failed, and nobody waits for this one.
                    if sender.send((index, block)).is_err() {
                        return;
                    }
                }
            });
        }
        drop(sender);
        join(study.start(), receiver, &mut done)
    })
}

/// Joins blocks in the order of their indices, whatever the order in which they come. The first that failed, by index, is
/// the error: every block before it has come by then.
fn join(
    mut total: Block,
    blocks: mpsc::Receiver<(usize, Result<Block>)>,
    done: &mut impl FnMut(usize),
) -> Result<Block> {
    let mut early = BTreeMap::new();
    let mut joined = 0;
    for (index, block) in blocks {
        early.insert(index, block);
        while let Some(block) = early.remove(&joined) {
            total.merge(&block?)?;
            joined += 1;
            done(joined);
        }
    }
    Ok(total)
}
