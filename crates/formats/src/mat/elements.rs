//! Tagged elements: type, number of bytes, bytes.

use std::io::{self, Read, Take};

use crate::error::InputErrorKind;
use crate::mat_kind::START;

/// Element types that are not numbers.
pub(super) const MATRIX: u32 = 14;
pub(super) const COMPRESSED: u32 = 15;

/// Elements begin at multiples of so many bytes.
const ALIGNMENT: u64 = 8;

/// The order of the bytes of a number.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum ByteOrder {
    Little,
    Big,
}

/// The byte order that the end of the header of version 5 tells.
pub(super) fn byte_order(header: &[u8]) -> Option<ByteOrder> {
    match header.get(124..START)? {
        b"\x00\x01IM" => Some(ByteOrder::Little),
        b"\x01\x00MI" => Some(ByteOrder::Big),
        _ => None,
    }
}

/// The problem with the bytes of a file.
#[derive(Debug)]
pub(super) enum Damage {
    /// The bytes stop too soon, or cannot be read or inflated.
    Io(io::Error),
    /// The bytes contradict the format.
    Format(String),
    /// The bytes are sound, but ask for more than is allowed.
    Refused(InputErrorKind),
}

impl Damage {
    pub(super) fn format(reason: impl Into<String>) -> Self {
        Damage::Format(reason.into())
    }
}

impl From<io::Error> for Damage {
    fn from(error: io::Error) -> Self {
        Damage::Io(error)
    }
}

/// The text in front of an element.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Tag {
    /// The type of what follows.
    pub(super) kind: u32,
    /// The number of bytes of the element.
    pub(super) bytes: u64,
    /// The bytes that stand in the tag itself.
    packed: Option<[u8; 4]>,
}

/// Elements within a reader that ends where they end.
pub(super) struct Elements<R> {
    inner: R,
    order: ByteOrder,
    /// The number of bytes read so far.
    position: u64,
}

impl<R: Read> Elements<R> {
    pub(super) fn new(inner: R, order: ByteOrder) -> Self {
        Elements { inner, order, position: 0 }
    }

    pub(super) fn order(&self) -> ByteOrder {
        self.order
    }

    /// The next tag; `None` at the end.
    pub(super) fn tag(&mut self) -> Result<Option<Tag>, Damage> {
        let Some(first) = self.first_word()? else { return Ok(None) };
        let rest = self.word()?;
        let word = self.number(first);
        let packed_bytes = word >> 16;
        Ok(Some(if packed_bytes == 0 {
            Tag { kind: word, bytes: u64::from(self.number(rest)), packed: None }
        } else if packed_bytes <= 4 {
            Tag { kind: word & 0xffff, bytes: u64::from(packed_bytes), packed: Some(rest) }
        } else {
            return Err(Damage::format(format!("an element in 4 bytes claims to have {packed_bytes}")));
        }))
    }

    /// The tag that must follow.
    pub(super) fn some_tag(&mut self) -> Result<Tag, Damage> {
        self.tag()?.ok_or_else(|| Damage::Io(io::ErrorKind::UnexpectedEof.into()))
    }

    /// The elements within an element. Whoever reads them passes over them all with [`Self::leave`].
    pub(super) fn within(&mut self, tag: Tag) -> Elements<Take<&mut dyn Read>>
    where
        R: Sized,
    {
        self.position += tag.bytes;
        let inner: &mut dyn Read = &mut self.inner;
        Elements::new(inner.take(tag.bytes), self.order)
    }

    /// The bytes of an element that has few of them.
    pub(super) fn short(&mut self, tag: Tag, most: u64, what: &str) -> Result<Vec<u8>, Damage> {
        if tag.bytes > most {
            let Tag { bytes, .. } = tag;
            return Err(Damage::format(format!("{what} claims to have {bytes} bytes, more than {most}")));
        }
        let mut content = Vec::new();
        self.each_part(tag, |part| content.extend_from_slice(part))?;
        Ok(content)
    }

    /// Hands out the bytes of an element in parts, each but the last one a multiple of 8 bytes long, and passes over the
    /// padding behind them.
    pub(super) fn each_part(&mut self, tag: Tag, mut take: impl FnMut(&[u8])) -> Result<(), Damage> {
        if let Some(packed) = tag.packed {
            packed.get(..tag.bytes as usize).into_iter().for_each(take);
            return Ok(());
        }
        let mut left = tag.bytes;
        let mut buffer = vec![0; usize::try_from(left).unwrap_or(usize::MAX).min(1 << 16)];
        while left > 0 {
            let length = buffer.len().min(usize::try_from(left).unwrap_or(usize::MAX));
            let Some(part) = buffer.get_mut(..length) else { break };
            self.inner.read_exact(part)?;
            take(part);
            left -= length as u64;
            self.position += length as u64;
        }
        // The padding of the last element may be left out.
        let padding = self.position.next_multiple_of(ALIGNMENT) - self.position;
        self.position += io::copy(&mut self.inner.by_ref().take(padding), &mut io::sink())?;
        Ok(())
    }

    /// The number in four bytes.
    pub(super) fn number(&self, bytes: [u8; 4]) -> u32 {
        match self.order {
            ByteOrder::Little => u32::from_le_bytes(bytes),
            ByteOrder::Big => u32::from_be_bytes(bytes),
        }
    }

    fn word(&mut self) -> Result<[u8; 4], Damage> {
        let mut word = [0; 4];
        self.inner.read_exact(&mut word)?;
        self.position += word.len() as u64;
        Ok(word)
    }

    /// Four bytes, unless there are none at all.
    fn first_word(&mut self) -> Result<Option<[u8; 4]>, Damage> {
        let mut first = Vec::new();
        self.inner.by_ref().take(4).read_to_end(&mut first)?;
        self.position += first.len() as u64;
        match first.as_array() {
            Some(word) => Ok(Some(*word)),
            None if first.is_empty() => Ok(None),
            None => Err(Damage::Io(io::ErrorKind::UnexpectedEof.into())),
        }
    }
}

impl Elements<Take<&mut dyn Read>> {
    /// Passes over what has not been read of an element.
    pub(super) fn leave(mut self) -> Result<(), Damage> {
        io::copy(&mut self.inner, &mut io::sink())?;
        if self.inner.limit() > 0 { Err(Damage::Io(io::ErrorKind::UnexpectedEof.into())) } else { Ok(()) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn content(bytes: &[u8], order: ByteOrder) -> Vec<(u32, Vec<u8>)> {
        let mut elements = Elements::new(bytes, order);
        let mut found = Vec::new();
        while let Some(tag) = elements.tag().unwrap() {
            found.push((tag.kind, elements.short(tag, 100, "the test").unwrap()));
        }
        found
    }

    #[test]
    fn elements_are_long_or_packed_in_either_byte_order() {
        let little = b"\x01\0\0\0\x05\0\0\0abcde\0\0\0\x01\0\x02\0xy\0\0\x01\0\0\0\x01\0\0\0z";
        let big = b"\0\0\0\x01\0\0\0\x05abcde\0\0\0\0\x02\0\x01xy\0\0\0\0\0\x01\0\0\0\x01z";
        let expected = [b"abcde".to_vec(), b"xy".to_vec(), b"z".to_vec()].map(|content| (1, content));
        assert_eq!(content(little, ByteOrder::Little), expected);
        assert_eq!(content(big, ByteOrder::Big), expected);
    }

    #[test]
    fn what_stops_or_claims_too_much_is_refused() {
        let fails = |bytes: &[u8]| {
            let mut elements = Elements::new(bytes, ByteOrder::Little);
            elements.some_tag().and_then(|tag| elements.short(tag, 100, "it")).unwrap_err()
        };
        for cut in [&b""[..], b"\x01", b"\x01\0\0\0\x05", b"\x01\0\0\0\x05\0\0\0abc"] {
            assert!(matches!(fails(cut), Damage::Io(error) if error.kind() == io::ErrorKind::UnexpectedEof));
        }
        for claim in [&b"\x01\0\x05\0abcd"[..], b"\x01\0\0\0\xff\xff\xff\xff"] {
            assert!(matches!(fails(claim), Damage::Format(_)));
        }
    }
}
