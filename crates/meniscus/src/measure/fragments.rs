//! Pieces that a body has broken into, and how far two bodies are mixed.

use crate::cells::Cells;
use crate::vector::Vector;

/// For each particle the piece that it belongs to. Two particles nearer than `reach` (m) are of
/// one piece; pieces are numbered from the largest, equal ones by their first particle.
///
/// A reach of 1.6 spacings joins what a lattice of any kind joins, and nothing across a gap.
pub fn fragments<const D: usize>(position: &[Vector<f64, D>], reach: f64) -> Vec<usize> {
    let mut cells = Cells::new(reach);
    let mut parent: Vec<usize> = (0..position.len()).collect();
    for (i, x) in position.iter().enumerate() {
        cells.near(x, |j, _| {
            let (a, b) = (root(&mut parent, i), root(&mut parent, j));
            parent[a.max(b)] = a.min(b);
        });
        cells.add(i, *x);
    }
    let roots: Vec<usize> = (0..position.len()).map(|i| root(&mut parent, i)).collect();
    let mut size = vec![0_usize; position.len()];
    roots.iter().for_each(|&r| size[r] += 1);
    let mut order: Vec<usize> = (0..position.len()).filter(|&r| size[r] > 0).collect();
    order.sort_by_key(|&r| (std::cmp::Reverse(size[r]), r));
    let mut number = vec![0; position.len()];
    for (n, &r) in order.iter().enumerate() {
        number[r] = n;
    }
    roots.into_iter().map(|r| number[r]).collect()
}

/// Pairs of a particle of one body and one of another that are nearer than `reach` (m). Along
/// a sharp interface there are so many to the area; more of them tell of mixing.
pub fn contacts<const D: usize>(
    one: &[Vector<f64, D>],
    other: &[Vector<f64, D>],
    reach: f64,
) -> usize {
    let mut cells = Cells::new(reach);
    for (i, x) in one.iter().enumerate() {
        cells.add(i, *x);
    }
    let mut count = 0;
    for x in other {
        cells.near(x, |_, _| count += 1);
    }
    count
}

fn root(parent: &mut [usize], mut i: usize) -> usize {
    while parent[i] != i {
        parent[i] = parent[parent[i]];
        i = parent[i];
    }
    i
}

#[cfg(test)]
mod tests {
    use super::{contacts, fragments};
    use crate::measure::samples::cut;
    use crate::vector::Vector;

    #[test]
    fn two_balls_with_a_gap_are_two_and_touching_ones_are_one() {
        let fill = |x: f64| {
            let centre = Vector([x, 0.0, 0.0]);
            cut(12.0, 0.3, 0.2, |x| (*x - centre).norm() < 4.0)
        };
        let (left, right, near) = (fill(-6.0), fill(6.5), fill(1.5));
        let apart = fragments(&[left.clone(), right].concat(), 1.6);
        assert_eq!(apart.iter().max(), Some(&1));
        assert!(apart[..left.len()].iter().all(|&n| n == apart[0]));
        let together = fragments(&[left, near].concat(), 1.6);
        assert_eq!(together.iter().max(), Some(&0));
    }

    #[test]
    fn contacts_grow_with_the_area_and_with_mixing() {
        let half = |side: f64| {
            cut(22.0, 0.0, 0.0, |x: &Vector<f64, 2>| {
                x[0] > 0.0 && x[0] < 20.0 && x[1] > side - 4.0 && x[1] < side
            })
        };
        let (below, above) = (half(0.0), half(4.0));
        // Straight over, and to the two diagonal neighbours but for those at the ends.
        assert_eq!(contacts(&below, &above, 1.6), 20 + 2 * 19);
        let (even, odd): (Vec<_>, Vec<_>) = below.iter().partition(|x| x[0].floor() % 2.0 == 0.0);
        // Each of the 19 seams between columns: straight over in four rows, across in three.
        assert_eq!(contacts(&even, &odd, 1.6), 19 * (4 + 2 * 3));
    }

    #[test]
    fn the_largest_comes_first() {
        let x = [0.0, 10.0, 11.0, 30.0].map(|x| Vector([x, 0.0]));
        assert_eq!(fragments(&x, 1.5), [1, 0, 0, 2]);
    }
}
