//! A step allocates nothing once its columns and lists have grown.

mod common;

use std::alloc::{GlobalAlloc, Layout, System};
use std::sync::atomic::{AtomicU64, Ordering};

use common::free_drop;
use meniscus::Simulation;
use meniscus::rates::{Dimension, Space};

struct Counting;

static ALLOCATIONS: AtomicU64 = AtomicU64::new(0);

// SAFETY: every call is passed on unchanged to the system's allocator.
#[allow(unsafe_code)]
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        ALLOCATIONS.fetch_add(1, Ordering::Relaxed);
        unsafe { System.alloc(layout) }
    }
    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        unsafe { System.dealloc(pointer, layout) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

fn steps_after_warm_up<const D: usize>(spacing: f64)
where
    Space: Dimension<D>,
{
    let mut simulation = Simulation::new(free_drop::<D>(spacing, 0.1)).expect("a sound setup");
    let mut step = |n: usize| {
        for _ in 0..n {
            simulation.step().expect("the flow is calm");
        }
        simulation.pairs().builds()
    };
    let builds_before = step(200);
    let before = ALLOCATIONS.load(Ordering::Relaxed);
    // Steps between two new lists: none. New lists may still grow a little.
    let mut free_of_any = 0;
    let mut last = (builds_before, before);
    for _ in 0..100 {
        let builds = step(1);
        let now = ALLOCATIONS.load(Ordering::Relaxed);
        if builds == last.0 {
            assert_eq!(now, last.1, "a step without new lists allocated");
            free_of_any += 1;
        }
        last = (builds, now);
    }
    assert!(
        free_of_any > 50,
        "only {free_of_any} steps without new lists"
    );
    let grown = ALLOCATIONS.load(Ordering::Relaxed) - before;
    let builds = last.0 - builds_before;
    assert!(
        grown <= builds * 4,
        "{grown} allocations in {builds} new lists"
    );
}

/// One test in this file: the counter is the whole process's.
#[test]
fn a_step_allocates_nothing_after_warm_up() {
    for threads in [1, 2] {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
        pool.expect("a thread pool").install(|| {
            steps_after_warm_up::<2>(0.06);
            steps_after_warm_up::<3>(0.14);
        });
    }
}
