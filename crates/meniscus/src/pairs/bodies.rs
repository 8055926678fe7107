//! Which particles hang together: those within reach of each other, and all that they reach.

use std::collections::HashMap;

use crate::domain::Domain;
use crate::vector::Vector;

/// For each point a number, the same for all that chains of points nearer than `reach` (m)
/// connect, and how many there are.
///
/// Points are gathered in cells so small that all in one are connected. Two cells are joined as
/// soon as one pair is near enough, and not looked at if they are joined already.
pub(crate) fn connected<const D: usize>(
    points: &[Vector<f64, D>],
    reach: f64,
    domain: &Domain<D>,
) -> (Vec<u32>, usize) {
    let longest = reach / (D as f64).sqrt();
    let mut side = [longest; D];
    // Along a periodic axis a whole number of cells.
    let mut cells_around = [i64::MAX; D];
    for d in 0..D {
        if let Some((low, high)) = domain.periodic[d] {
            let count = ((high - low) / longest).ceil().max(1.0);
            side[d] = (high - low) / count;
            cells_around[d] = count as i64;
        }
    }
    let cell_of = |x: &Vector<f64, D>| -> [i64; D] {
        std::array::from_fn(|d| {
            let low = domain.periodic[d].map_or(0.0, |(low, _)| low);
            let cell = ((x[d] - low) / side[d]).floor() as i64;
            if cells_around[d] == i64::MAX {
                cell
            } else {
                cell.rem_euclid(cells_around[d])
            }
        })
    };
    let mut number: HashMap<[i64; D], u32> = HashMap::new();
    let mut cells: Vec<([i64; D], Vec<u32>)> = Vec::new();
    let mut home = Vec::with_capacity(points.len());
    for (i, x) in points.iter().enumerate() {
        let cell = cell_of(x);
        let n = *number.entry(cell).or_insert_with(|| {
            cells.push((cell, Vec::new()));
            cells.len() as u32 - 1
        });
        cells[n as usize].1.push(i as u32);
        home.push(n);
    }
    let mut parent: Vec<u32> = (0..cells.len() as u32).collect();
    let range: [i64; D] = side.map(|side| (reach / side).ceil() as i64);
    let is_near = |a: u32, b: u32| {
        let mut offset = points[a as usize] - points[b as usize];
        for d in 0..D {
            if let Some((low, high)) = domain.periodic[d] {
                offset[d] -= (offset[d] / (high - low)).round() * (high - low);
            }
        }
        offset.norm_squared() < reach * reach
    };
    let around: usize = range.iter().map(|&r| 2 * r as usize + 1).product();
    for (n, (cell, rows)) in cells.iter().enumerate() {
        // Half of the cells around: the others look back.
        for k in 0..around / 2 {
            let mut rest = k as i64;
            let there: [i64; D] = std::array::from_fn(|d| {
                let width = 2 * range[d] + 1;
                let at = cell[d] + rest % width - range[d];
                rest /= width;
                if cells_around[d] == i64::MAX {
                    at
                } else {
                    at.rem_euclid(cells_around[d])
                }
            });
            let Some(&other) = number.get(&there) else {
                continue;
            };
            let (a, b) = (root(&mut parent, n as u32), root(&mut parent, other));
            let others = &cells[other as usize].1;
            let joined = a == b || rows.iter().any(|&i| others.iter().any(|&j| is_near(i, j)));
            if joined {
                parent[a.max(b) as usize] = a.min(b);
            }
        }
    }
    let mut count = 0;
    let mut label = vec![u32::MAX; cells.len()];
    for n in 0..cells.len() as u32 {
        let top = root(&mut parent, n) as usize;
        if label[top] == u32::MAX {
            label[top] = count;
            count += 1;
        }
        label[n as usize] = label[top];
    }
    let of_point = home.iter().map(|&n| label[n as usize]).collect();
    (of_point, count as usize)
}

fn root(parent: &mut [u32], mut n: u32) -> u32 {
    while parent[n as usize] != n {
        parent[n as usize] = parent[parent[n as usize] as usize];
        n = parent[n as usize];
    }
    n
}

#[cfg(test)]
mod tests {
    use super::connected;
    use crate::domain::Domain;
    use crate::vector::Vector;

    #[test]
    fn a_gap_parts_two_bodies_and_a_bridge_joins_them() {
        let mut points: Vec<Vector<f64, 2>> = Vec::new();
        for k in 0..200 {
            let side = f64::from(k % 2);
            points.push(Vector([
                f64::from(k / 20) + 12.01 * side,
                f64::from(k / 2 % 10),
            ]));
        }
        // 9 and 12.01 are 3.01 apart.
        let open = Domain::default();
        let (of, count) = connected(&points, 3.0, &open);
        assert_eq!(count, 2);
        assert!((0..200).all(|k| of[k] == (k % 2) as u32));
        points.push(Vector([10.5, 4.0]));
        assert_eq!(connected(&points, 3.0, &open).1, 1);
        points.pop();
        // From 21.01 on to 24 = 0.
        let around = Domain {
            periodic: [Some((0.0, 24.0)), None],
        };
        assert_eq!(connected(&points, 3.0, &around).1, 1);
    }

    #[test]
    fn it_agrees_with_all_pairs() {
        const REACH: f64 = 1.0;
        // Strewn without order: some lie alone, some in chains.
        let points: Vec<Vector<f64, 3>> = (0..300)
            .map(|k| {
                let at =
                    |c: f64| 10.0 * (43_758.545 * (f64::from(k) * c + c).sin()).rem_euclid(1.0);
                Vector([at(12.9898), at(78.233), at(37.719)])
            })
            .collect();
        let (of, count) = connected(&points, REACH, &Domain::default());
        // A few of them are neighbours: neither all one, nor all alone.
        assert!((10..290).contains(&count), "{count}");
        for i in 0..300 {
            for j in 0..i {
                if (points[i] - points[j]).norm() < REACH {
                    assert_eq!(of[i], of[j]);
                }
            }
        }
        // As many bodies as a flood finds.
        let mut seen = vec![false; 300];
        let mut floods = 0;
        for start in 0..300 {
            let mut stack = vec![start];
            floods += usize::from(!seen[start]);
            while let Some(i) = stack.pop() {
                if !std::mem::replace(&mut seen[i], true) {
                    stack.extend((0..300).filter(|&j| (points[i] - points[j]).norm() < REACH));
                }
            }
        }
        assert_eq!(floods, count);
    }
}
