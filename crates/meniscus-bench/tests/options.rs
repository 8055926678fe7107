//! What is read from a command line, and what is made of samples.

use meniscus_bench::clock::median;
use meniscus_bench::options::{Options, particle_count};

#[test]
fn counts_have_their_letters() {
    assert_eq!(particle_count("10k"), Ok(10_000));
    assert_eq!(particle_count("2M"), Ok(2_000_000));
    assert_eq!(particle_count("1234"), Ok(1234));
    for wrong in ["", "k", "99", "1.5k", "-3k", "10K", "99999999999999999999M"] {
        assert!(particle_count(wrong).is_err(), "{wrong}");
    }
}

#[test]
fn threads_double_up_to_the_most() {
    assert_eq!(Options::full(1).threads, [1]);
    assert_eq!(Options::full(2).threads, [1, 2]);
    assert_eq!(Options::full(6).threads, [1, 2, 4, 6]);
}

#[test]
fn the_median_is_in_the_middle() {
    assert_eq!(median([3.0, 1.0, 2.0]), 2.0);
    assert_eq!(median([4.0, 1.0, 2.0, 3.0]), 2.5);
    assert!(median([]).is_nan());
}
