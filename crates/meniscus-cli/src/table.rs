//! Plain tables for the terminal.

/// Rows under a header, columns aligned: the first to the left, the rest to the right.
pub fn table(header: &[&str], rows: &[Vec<String>]) -> String {
    let width = |column: usize| {
        rows.iter()
            .map(|row| row.get(column).map_or(0, |cell| cell.chars().count()))
            .chain([header[column].chars().count()])
            .max()
            .unwrap_or(0)
    };
    let widths: Vec<usize> = (0..header.len()).map(width).collect();
    let line = |cells: &mut dyn Iterator<Item = &str>| {
        let padded: Vec<String> = cells
            .zip(&widths)
            .enumerate()
            .map(|(column, (cell, &width))| {
                let space = " ".repeat(width.saturating_sub(cell.chars().count()));
                if column == 0 {
                    format!("{cell}{space}")
                } else {
                    format!("{space}{cell}")
                }
            })
            .collect();
        padded.join("  ").trim_end().to_owned()
    };
    let rule = "-".repeat(widths.iter().sum::<usize>() + 2 * widths.len().saturating_sub(1));
    let mut lines = vec![line(&mut header.iter().copied()), rule];
    lines.extend(
        rows.iter()
            .map(|row| line(&mut row.iter().map(String::as_str))),
    );
    lines.join("\n")
}

/// A difference with its sign; what rounds to zero has none, what is no number is a dash.
pub fn signed(value: f64, decimals: usize) -> String {
    if !value.is_finite() {
        return "–".into();
    }
    let digits = format!("{:.decimals$}", value.abs());
    let sign = match digits.bytes().all(|digit| b"0.".contains(&digit)) {
        true => "",
        false if value < 0.0 => "−",
        false => "+",
    };
    format!("{sign}{digits}")
}

/// The text with a capital letter first.
pub fn capital(text: &str) -> String {
    let mut letters = text.chars();
    let first = letters.next().map(|c| c.to_uppercase().to_string());
    first.unwrap_or_default() + letters.as_str()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_are_aligned_by_letters_not_bytes() {
        let rows = [
            vec!["µ".to_owned(), "1 ± 2".to_owned()],
            vec!["long name".to_owned(), "3".to_owned()],
        ];
        let text = table(&["name", "value"], &rows);
        let expected = "name       value\n----------------\nµ          1 ± 2\nlong name      3";
        assert_eq!(text, expected);
    }

    #[test]
    fn a_difference_of_nothing_has_no_sign() {
        assert_eq!(signed(-1e-9, 3), "0.000");
        assert_eq!(signed(-0.0, 1), "0.0");
        assert_eq!(signed(-0.0126, 3), "−0.013");
        assert_eq!(signed(2.449, 1), "+2.4");
        assert_eq!(signed(f64::NAN, 1), "–");
        assert_eq!(signed(f64::INFINITY, 1), "–");
    }
}
