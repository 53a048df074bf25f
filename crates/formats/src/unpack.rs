//! Compressed inputs as streams: gzip and Zstandard, told by their first bytes. The hash stays that of the file as it is.

use std::cell::RefCell;
use std::io::{self, BufRead, BufReader, Read};
use std::rc::Rc;

use flate2::bufread::MultiGzDecoder;
use ruzstd::decoding::errors::{FrameDecoderError, ReadFrameHeaderError};
use ruzstd::decoding::{BlockDecodingStrategy, FrameDecoder};
use sha2::{Digest, Sha256};
use thiserror::Error;

use crate::hash::hexadecimal;
use crate::limits::most_unpacked;

/// How an input is compressed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Packing {
    Gzip,
    Zstandard,
}

impl Packing {
    /// The compression of a file that starts like this.
    fn of(start: &[u8]) -> Option<Self> {
        if start.starts_with(b"\x1f\x8b") {
            return Some(Packing::Gzip);
        }
        // A frame, or one to be passed over (RFC 8878, 3.1.1 and 3.1.2).
        let is_skippable = matches!(start, [0x50..=0x5f, 0x2a, 0x4d, 0x18, ..]);
        (start.starts_with(b"\x28\xb5\x2f\xfd") || is_skippable).then_some(Packing::Zstandard)
    }

    /// The name with its article.
    fn name(self) -> &'static str {
        match self {
            Packing::Gzip => "a gzip file",
            Packing::Zstandard => "a Zstandard file",
        }
    }
}

/// What is wrong with a compressed input.
#[derive(Debug, Error)]
pub(crate) enum UnpackError {
    /// It unpacks to more than may be.
    #[error("it unpacks to more than {limit} bytes")]
    TooLong {
        /// The most bytes.
        limit: u64,
    },
    /// It unpacks to more than may be for its size.
    #[error("it unpacks to more than {ratio} times its size")]
    TooFar {
        /// How many times its size it may unpack to.
        ratio: u64,
    },
    /// It cannot be unpacked.
    #[error("{reason}")]
    Damaged {
        /// The format, with its article.
        format: &'static str,
        /// The library's words.
        reason: String,
    },
}

/// What is known of a compressed input while it is read.
#[derive(Clone)]
pub(crate) struct Packed(Rc<RefCell<State>>);

struct State {
    /// Of the bytes as they are in the file.
    hash: Sha256,
    /// Whether these could not be read, so that an error is not the compression's.
    has_failed: bool,
    /// The most bytes that they may unpack to.
    limit: u64,
    /// How many times its size that may be.
    ratio: u64,
    /// How many bytes of the file were read.
    bytes: u64,
}

impl Packed {
    /// The bytes that a compressed input unpacks to, if it starts like one.
    pub(crate) fn unpacked(
        start: &[u8],
        bytes: Box<dyn Read>,
    ) -> Result<(Self, Box<dyn Read>), Box<dyn Read>> {
        let Some(packing) = Packing::of(start) else { return Err(bytes) };
        let state =
            State { hash: Sha256::new(), has_failed: false, limit: u64::MAX, ratio: u64::MAX, bytes: 0 };
        let packed = Packed(Rc::new(RefCell::new(state)));
        let tap = BufReader::new(Tap { bytes, packed: packed.clone() });
        let decoder: Box<dyn Read> = match packing {
            Packing::Gzip => Box::new(MultiGzDecoder::new(tap)),
            Packing::Zstandard => {
                Box::new(Frames { bytes: tap, decoder: FrameDecoder::new(), is_within: false })
            }
        };
        Ok((packed.clone(), Box::new(Unpacker { decoder, packed, packing, total: 0 })))
    }

    /// Sets how many bytes there may be unpacked, and how many for each byte of the file.
    pub(crate) fn set_limits(&self, limit: u64, ratio: u64) {
        let mut state = self.0.borrow_mut();
        (state.limit, state.ratio) = (limit, ratio);
    }

    /// SHA-256 of the bytes of the file that were read, in hexadecimal.
    pub(crate) fn sha256(&self) -> String {
        hexadecimal(&self.0.borrow().hash)
    }
}

/// The bytes of the file, hashed on their way to the decoder.
struct Tap {
    bytes: Box<dyn Read>,
    packed: Packed,
}

impl Read for Tap {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let mut state = self.packed.0.borrow_mut();
        match self.bytes.read(buffer) {
            Ok(count) => {
                state.hash.update(buffer.get(..count).unwrap_or_default());
                state.bytes += count as u64;
                Ok(count)
            }
            Err(error) => {
                state.has_failed = error.kind() != io::ErrorKind::Interrupted;
                Err(error)
            }
        }
    }
}

/// What comes out of the decoder, up to the limit, with its errors named.
struct Unpacker {
    decoder: Box<dyn Read>,
    packed: Packed,
    packing: Packing,
    total: u64,
}

impl Read for Unpacker {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let count = self.decoder.read(buffer).map_err(|error| {
            if self.packed.0.borrow().has_failed || error.kind() == io::ErrorKind::Interrupted {
                return error;
            }
            let reason = match error.kind() {
                io::ErrorKind::UnexpectedEof => "it stops too soon".to_owned(),
                _ => format!("it is damaged: {error}"),
            };
            io::Error::other(UnpackError::Damaged { format: self.packing.name(), reason })
        })?;
        self.total += count as u64;
        let State { limit, ratio, bytes, .. } = *self.packed.0.borrow();
        if self.total > limit {
            return Err(io::Error::other(UnpackError::TooLong { limit }));
        }
        if self.total > most_unpacked(bytes, ratio) {
            return Err(io::Error::other(UnpackError::TooFar { ratio }));
        }
        Ok(count)
    }
}

/// Frames of Zstandard one after the other. Memory: the window of a frame, at most 100 MB.
struct Frames<R> {
    bytes: R,
    decoder: FrameDecoder,
    is_within: bool,
}

impl<R: BufRead> Frames<R> {
    /// Begins the next frame; `false` where there is none.
    fn begin(&mut self) -> io::Result<bool> {
        loop {
            if self.bytes.fill_buf()?.is_empty() {
                return Ok(false);
            }
            match self.decoder.reset(&mut self.bytes) {
                Ok(()) => return Ok(true),
                Err(FrameDecoderError::ReadFrameHeaderError(ReadFrameHeaderError::SkipFrame {
                    length,
                    ..
                })) => {
                    io::copy(&mut self.bytes.by_ref().take(length.into()), &mut io::sink())?;
                }
                Err(error) => return Err(io::Error::new(io::ErrorKind::InvalidData, error.to_string())),
            }
        }
    }

    /// Refuses a frame whose checksum is not that of what came out of it.
    fn check(&self) -> io::Result<()> {
        let (stated, found) = (self.decoder.get_checksum_from_data(), self.decoder.get_calculated_checksum());
        match stated {
            Some(_) if stated != found => {
                Err(io::Error::new(io::ErrorKind::InvalidData, "the checksum is another one"))
            }
            _ => Ok(()),
        }
    }
}

impl<R: BufRead> Read for Frames<R> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        loop {
            if !self.is_within {
                if !self.begin()? {
                    return Ok(0);
                }
                self.is_within = true;
            }
            if self.decoder.can_collect() == 0 && !self.decoder.is_finished() {
                let decoded =
                    self.decoder.decode_blocks(&mut self.bytes, BlockDecodingStrategy::UptoBlocks(1));
                decoded.map_err(|error| io::Error::new(io::ErrorKind::InvalidData, error.to_string()))?;
            }
            let count = self.decoder.read(buffer)?;
            if count > 0 || buffer.is_empty() {
                return Ok(count);
            }
            if self.decoder.is_finished() {
                self.check()?;
                self.is_within = false;
            }
        }
    }
}
