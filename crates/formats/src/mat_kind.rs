//! Tells by its first bytes which of the formats of MATLAB and Octave a file has.

/// The number of bytes that tell the format.
pub(crate) const START: usize = 128;

/// The first bytes of HDF5 files.
const HDF5: &[u8] = b"\x89HDF\r\n\x1a\n";

/// MATLAB's formats.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum MatKind {
    /// Version 4.
    V4,
    /// Version 5, which `save -v6` and `save -v7` write.
    V5,
    /// Version 7.3, which is HDF5 behind a text.
    V73,
    /// HDF5 as it is.
    Hdf5,
}

/// The format of a file that starts like this.
pub(crate) fn kind_of(start: &[u8]) -> Option<MatKind> {
    if start.starts_with(HDF5) {
        return Some(MatKind::Hdf5);
    }
    if start.starts_with(b"MATLAB 7.3 MAT-file") {
        return Some(MatKind::V73);
    }
    if start.starts_with(b"MATLAB 5.0 MAT-file") {
        return Some(MatKind::V5);
    }
    // Other programs may write another text in front of version and byte order.
    match start.get(124..START) {
        Some(b"\x00\x01IM" | b"\x01\x00MI") => Some(MatKind::V5),
        Some(b"\x00\x02IM" | b"\x02\x00MI") => Some(MatKind::V73),
        _ => is_v4(start).then_some(MatKind::V4),
    }
}

/// Returns whether a file that starts like this is what Octave's `save -text` writes.
pub(crate) fn is_octave(start: &[u8]) -> bool {
    let mut lines = start.split(|&byte| byte == b'\n');
    let first = lines.next().unwrap_or_default();
    let says = |line: &[u8], words: &str| {
        let text = line.strip_prefix(b"# ").or_else(|| line.strip_prefix(b"% "));
        text.is_some_and(|text| text.starts_with(words.as_bytes()))
    };
    says(first, "Created by Octave")
        || says(first, "name: ") && says(lines.next().unwrap_or_default(), "type: ")
}

/// Returns whether this is the header of a variable of version 4: type, rows, columns, whether complex, length of the name, and
/// the name with a zero behind it.
fn is_v4(start: &[u8]) -> bool {
    let Some((head, name)) = start.split_at_checked(20) else { return false };
    [u32::from_le_bytes, u32::from_be_bytes].iter().any(|number| {
        let mut words = head.as_chunks().0.iter().map(|&word| number(word));
        let mut word = || words.next().unwrap_or(u32::MAX);
        let (kind, rows, columns, complex, length) = (word(), word(), word(), word(), word());
        let is_kind = kind < 5000 && kind / 100 % 10 == 0 && kind / 10 % 10 <= 5 && kind % 10 <= 2;
        let name = usize::try_from(length).ok().and_then(|length| name.get(..length));
        let is_name = name.and_then(|name| name.split_last()).is_some_and(|(end, name)| {
            *end == 0 && !name.is_empty() && name.iter().all(|byte| byte.is_ascii_graphic())
        });
        is_kind && rows < 1 << 31 && columns < 1 << 31 && complex <= 1 && is_name
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn formats_are_told_by_their_first_bytes() {
        let mut header = [b' '; 128];
        header[..6].copy_from_slice(b"Scilab");
        for (end, kind) in [
            (b"\x00\x01IM", Some(MatKind::V5)),
            (b"\x01\x00MI", Some(MatKind::V5)),
            (b"\x00\x02IM", Some(MatKind::V73)),
            (b"\x00\x03IM", None),
        ] {
            header[124..].copy_from_slice(end);
            assert_eq!(kind_of(&header), kind);
        }
        let v4 = |kind: u32, name: &[u8]| {
            let words = [kind, 3, 1, 0, name.len() as u32];
            let big = [words.map(u32::to_be_bytes).concat(), name.to_vec()].concat();
            let little = [words.map(u32::to_le_bytes).concat(), name.to_vec()].concat();
            [kind_of(&big), kind_of(&little)]
        };
        assert_eq!(v4(1000, b"x\0"), [Some(MatKind::V4); 2]);
        assert_eq!(v4(0, b"x\0"), [Some(MatKind::V4); 2]);
        assert_eq!([v4(1000, b"x"), v4(1000, b"\0"), v4(7, b"x\0")].concat(), [None; 6]);
        assert_eq!(kind_of(b"x,y\n1,2\n"), None);
    }
}
