//! Which bodies are walls.

/// Per body: whether it is a wall. Bodies beyond are not.
#[derive(Clone, Copy, Debug)]
pub struct WallBodies<'a>(pub &'a [bool]);

impl WallBodies<'_> {
    /// Whether a body is a wall.
    #[inline]
    pub fn hold(self, body: u16) -> bool {
        self.0.get(usize::from(body)) == Some(&true)
    }
}
