//! Floating-point operations of a pair formula, counted by running it.
//!
//! [`Recorded`] is a [`Real`] that calculates nothing: each operation becomes
//! a node of a graph, equal nodes the same one. What is counted for one pair
//! are the nodes that the sums need and that change from neighbour to
//! neighbour, as a compiler would leave them: what nobody reads is not
//! worked out, what depends on the particle alone is worked out once.

use std::cell::RefCell;
use std::collections::HashMap;
use std::ops::{Add, Div, Mul, Neg, Sub};

use meniscus::kernel::SmoothingKernel;
use meniscus::term::{Pair, Record};
use meniscus::{PairTerm, Real, Vector};

/// Operations of one pair.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Operations {
    /// Additions, subtractions, multiplications, divisions and roots: one flop each.
    pub flops: u32,
    /// Signs, minima, maxima, comparisons and selections, which no flop rate counts.
    pub others: u32,
}

/// A number of which only the way it came about is known.
#[derive(Clone, Copy, Debug)]
pub struct Recorded(usize);

#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
enum Node {
    Literal(u64),
    /// The same for all neighbours.
    Own(usize),
    /// Another for each neighbour.
    Other(usize),
    Flop(&'static str, usize, usize),
    Unrated(&'static str, usize, usize, usize),
}

#[derive(Default)]
struct Graph {
    nodes: Vec<Node>,
    index: HashMap<Node, usize>,
}

thread_local! {
    static GRAPH: RefCell<Graph> = RefCell::default();
}

fn node(node: Node) -> usize {
    GRAPH.with_borrow_mut(|graph| {
        let next = graph.nodes.len();
        let index = *graph.index.entry(node).or_insert(next);
        if index == next {
            graph.nodes.push(node);
        }
        index
    })
}

fn flop(name: &'static str, a: Recorded, b: Recorded) -> Recorded {
    Recorded(node(Node::Flop(name, a.0, b.0)))
}

macro_rules! operator {
    ($Trait:ident, $method:ident, $name:literal) => {
        impl $Trait for Recorded {
            type Output = Self;
            fn $method(self, other: Self) -> Self {
                flop($name, self, other)
            }
        }
        impl $Trait<f64> for Recorded {
            type Output = Self;
            fn $method(self, other: f64) -> Self {
                flop($name, self, self.literal(other))
            }
        }
    };
}

operator!(Add, add, "+");
operator!(Sub, sub, "-");
operator!(Mul, mul, "*");
operator!(Div, div, "/");

impl Neg for Recorded {
    type Output = Self;
    fn neg(self) -> Self {
        Recorded(node(Node::Unrated("neg", self.0, self.0, self.0)))
    }
}

impl Real for Recorded {
    type Mask = Recorded;

    fn literal(self, value: f64) -> Self {
        Recorded(node(Node::Literal(value.to_bits())))
    }
    fn sqrt(self) -> Self {
        flop("sqrt", self, self)
    }
    fn floor(self) -> Self {
        Recorded(node(Node::Unrated("floor", self.0, self.0, self.0)))
    }
    fn min(self, other: Self) -> Self {
        Recorded(node(Node::Unrated("min", self.0, other.0, other.0)))
    }
    fn max(self, other: Self) -> Self {
        Recorded(node(Node::Unrated("max", self.0, other.0, other.0)))
    }
    fn mul_add(self, factor: Self, addend: Self) -> Self {
        // Two operations, in one or two instructions.
        self * factor + addend
    }
    fn tiny(self) -> Self {
        self.literal(f64::MIN_POSITIVE)
    }
    fn less(self, other: Self) -> Recorded {
        Recorded(node(Node::Unrated("less", self.0, other.0, other.0)))
    }
    fn select(mask: Recorded, yes: Self, no: Self) -> Self {
        Recorded(node(Node::Unrated("select", mask.0, yes.0, no.0)))
    }
}

/// Operations of one pair of `term` with the kernel `K`, its distance included.
pub fn of_pair<K: SmoothingKernel, T: PairTerm<D>, const D: usize>(term: &T) -> Operations {
    GRAPH.take();
    let mut count = 0;
    let mut next = |kind: fn(usize) -> Node| {
        count += 1;
        Recorded(node(kind(count)))
    };
    let position = Vector::<Recorded, D>::read(&mut || next(Node::Own));
    let own = T::Record::<Recorded>::read(&mut || next(Node::Own));
    // A sum is not the same for all neighbours.
    let mut sum = T::Sum::<Recorded>::read(&mut || next(Node::Other));
    let other_position = Vector::<Recorded, D>::read(&mut || next(Node::Other));
    let other = T::Record::<Recorded>::read(&mut || next(Node::Other));
    let [inverse_h_squared, value_factor, slope_factor] = [(); 3].map(|()| next(Node::Own));

    let offset = position - other_position;
    let distance_squared = offset.norm_squared();
    let square = distance_squared * inverse_h_squared;
    let (shape, slope) = match K::FROM_SQUARE {
        true => (
            K::shape_from_square(square),
            K::slope_over_q_from_square(square),
        ),
        false => (K::shape(square.sqrt()), K::slope_over_q(square.sqrt())),
    };
    let slope_over_distance = slope * slope_factor;
    let pair = Pair {
        offset,
        distance_squared,
        w: shape * value_factor,
        grad_w: offset * slope_over_distance,
        slope_over_distance,
    };
    term.pair(&own, &other, &pair, &mut sum);
    let mut results = Vec::new();
    sum.write(&mut |result| results.push(result.0));
    GRAPH.with_borrow(|graph| operations(&graph.nodes, &results))
}

fn operations(nodes: &[Node], results: &[usize]) -> Operations {
    // Operands stand before what is made of them.
    let mut varies = vec![false; nodes.len()];
    let mut needed = vec![false; nodes.len()];
    let operands = |node: Node| match node {
        Node::Literal(_) | Node::Own(_) | Node::Other(_) => vec![],
        Node::Flop(_, a, b) => vec![a, b],
        Node::Unrated(_, a, b, c) => vec![a, b, c],
    };
    for (k, &node) in nodes.iter().enumerate() {
        varies[k] = matches!(node, Node::Other(_)) || operands(node).iter().any(|&o| varies[o]);
    }
    results.iter().for_each(|&result| needed[result] = true);
    let mut count = Operations::default();
    for (k, &node) in nodes.iter().enumerate().rev() {
        if needed[k] && varies[k] {
            operands(node).iter().for_each(|&o| needed[o] = true);
            match node {
                Node::Flop(..) => count.flops += 1,
                Node::Unrated(..) => count.others += 1,
                _ => {}
            }
        }
    }
    count
}
