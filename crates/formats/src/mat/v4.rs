//! Variables of version 4, one after the other: a header of five words, the name, the numbers column by column.
//!
//! Source: The MathWorks, *MAT-File Format* (level 4).

use std::io::{self, Read};

use super::elements::{ByteOrder, Damage};
use super::numbers::{Numbers, ask_for, extend};
use super::search::Search;
use super::variable::{Content, LONGEST_NAME, Variable};

/// The words in front of the name: the type, rows, columns, whether complex, the length of the name.
const WORDS: usize = 5;

/// The types of stored numbers, by the tens of the type: their bytes, and the element type of version 5 that
/// is the same.
const STORED: [(u64, u32); 6] = [(8, 9), (4, 7), (4, 5), (2, 3), (2, 4), (1, 2)];

/// Reads the next variable; `false` at the end of the file.
pub(super) fn next(search: &mut Search, file: &mut dyn Read) -> Result<bool, Damage> {
    let mut head = Vec::new();
    file.take(4 * WORDS as u64).read_to_end(&mut head)?;
    if head.is_empty() {
        return Ok(false);
    }
    let words = head.as_chunks::<4>().0;
    let [kind, ..] = words else { return Err(Damage::Io(io::ErrorKind::UnexpectedEof.into())) };
    // Types are below 5000, which no number is with its bytes turned around but zero.
    let order = if u32::from_le_bytes(*kind) < 5000 { ByteOrder::Little } else { ByteOrder::Big };
    let number = |word: &[u8; 4]| match order {
        ByteOrder::Little => u32::from_le_bytes(*word),
        ByteOrder::Big => u32::from_be_bytes(*word),
    };
    let numbers: Vec<u32> = words.iter().map(number).collect();
    let &[kind, rows, columns, complex, length] = numbers.as_slice() else {
        return Err(Damage::Io(io::ErrorKind::UnexpectedEof.into()));
    };
    if (kind / 1000 > 1) || kind / 100 % 10 != 0 {
        return Err(Damage::format(format!("its type is {kind}, of another machine's numbers")));
    }
    if rows > i32::MAX as u32 || columns > i32::MAX as u32 {
        return Err(Damage::format("a dimension is negative"));
    }
    let stored = usize::try_from(kind / 10 % 10).ok().and_then(|kind| STORED.get(kind));
    let &(size, element) = stored.ok_or_else(|| Damage::format(format!("its type is {kind}")))?;
    let length = u64::from(length);
    if length > LONGEST_NAME {
        return Err(Damage::format(format!("the name of a variable claims to have {length} bytes")));
    }
    let mut name = Vec::new();
    if file.take(length).read_to_end(&mut name)? as u64 != length {
        return Err(Damage::Io(io::ErrorKind::UnexpectedEof.into()));
    }
    let name = String::from_utf8_lossy(&name).trim_end_matches('\0').to_owned();
    let content = match (kind % 10, complex) {
        (1, _) => Content::Other("text".to_owned()),
        (2, _) => Content::Other("sparse".to_owned()),
        (_, 1) => Content::Other("complex".to_owned()),
        _ if rows == 0 || columns == 0 => Content::Other("empty".to_owned()),
        _ => Content::Numbers { rows: rows.into(), columns: columns.into() },
    };
    // Both are below 2³¹, so that only the number of bytes may be too large.
    let count = u64::from(rows) * u64::from(columns);
    let bytes = count.saturating_mul(size << complex.min(1));
    let mut body = file.take(bytes);
    let variable = Variable { name, content };
    search.add(variable, head.len() as u64 + length + bytes, |count, memory| {
        ask_for(count, size_of::<f64>(), memory)?;
        let mut doubles = Vec::new();
        let mut buffer = vec![0; 1 << 16];
        loop {
            let part = buffer.len().min(usize::try_from(body.limit()).unwrap_or(usize::MAX));
            let Some(part) = buffer.get_mut(..part).filter(|part| !part.is_empty()) else { break };
            body.read_exact(part)?;
            extend(&mut doubles, element, part, order);
        }
        Ok(Numbers::Doubles(doubles))
    })?;
    io::copy(&mut body, &mut io::sink())?;
    if body.limit() > 0 {
        return Err(Damage::Io(io::ErrorKind::UnexpectedEof.into()));
    }
    Ok(true)
}
