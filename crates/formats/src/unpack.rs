//! Compressed inputs as streams: gzip and Zstandard, told by their first bytes. The hash stays that of the file as it is.

use std::cell::RefCell;
use std::io::{self, BufRead, BufReader, Cursor, Read};
use std::rc::Rc;

use boundfit_exact::english::size_text;
use flate2::bufread::GzDecoder;
use ruzstd::decoding::errors::{FrameDecoderError, ReadFrameHeaderError};
use ruzstd::decoding::{BlockDecodingStrategy, FrameDecoder};
use sha2::{Digest, Sha256};

use crate::binary;
use crate::budget::HeldMemory;
use crate::error::InputErrorKind;
use crate::hash::hexadecimal;
use crate::limits::SizeLimits;
use crate::memory_use::MemoryUse;
use crate::packing::{ANY_WINDOW, Packing, most_unpacked};

/// A compressed input.
pub(crate) struct Unpacked {
    pub(crate) packed: Packed,
    /// The first bytes that it unpacks to, where they are known without reading.
    pub(crate) start: Option<Vec<u8>>,
    /// All of them.
    pub(crate) bytes: Box<dyn Read>,
}

/// The known facts about a compressed input while it is read.
#[derive(Clone)]
pub(crate) struct Packed(Rc<RefCell<State>>);

struct State {
    /// The hash of the bytes as they are in the file.
    hash: Sha256,
    /// `true` if these could not be read, so that an error is not the compression's.
    has_failed: bool,
    /// The most bytes that they may unpack to.
    limit: u64,
    /// The factor of its size up to which it may unpack.
    ratio: u64,
    /// The number of bytes of the file that were read.
    bytes: u64,
    /// The memory that unpacking takes, once there is a limit.
    memory: Option<HeldMemory>,
}

impl Packed {
    /// Unpacks an input, if it starts like a compressed one.
    pub(crate) fn unpacked(start: &[u8], bytes: Box<dyn Read>) -> Result<Unpacked, Box<dyn Read>> {
        let Some(packing) = Packing::of(start) else { return Err(bytes) };
        let state = State {
            hash: Sha256::new(),
            has_failed: false,
            limit: u64::MAX,
            ratio: u64::MAX,
            bytes: 0,
            memory: None,
        };
        let packed = Packed(Rc::new(RefCell::new(state)));
        let tap = BufReader::new(Tap { bytes, packed: packed.clone() });
        let (start, decoder): (_, Box<dyn Read>) = match packing {
            Packing::Gzip => (None, Box::new(Members::new(tap))),
            Packing::Zstandard => {
                let (start, tap) = start_of_frames(tap);
                let (decoder, packed) = (FrameDecoder::new(), packed.clone());
                (Some(start), Box::new(Frames { bytes: tap, decoder, is_within: false, window: 0, packed }))
            }
        };
        let bytes = Box::new(Unpacker { decoder, packed: packed.clone(), packing, total: 0 });
        Ok(Unpacked { packed, start, bytes })
    }

    /// Sets how many bytes there may be unpacked, how many for each byte of the file, and how many may be held.
    pub(crate) fn set_limits(&self, sizes: &SizeLimits) {
        let mut state = self.0.borrow_mut();
        (state.limit, state.ratio) = (sizes.unpacked, sizes.ratio);
        state.memory = Some(sizes.memory.nothing());
    }

    /// Asks for memory for the last bytes that were unpacked, so many in all.
    fn hold(&self, bytes: u64) -> io::Result<()> {
        let state = self.0.borrow();
        if bytes > ANY_WINDOW.max(state.bytes.saturating_mul(state.ratio)) {
            return Err(io::Error::other(InputErrorKind::HoldsTooMuch { ratio: state.ratio }));
        }
        // The library takes some bytes beside them.
        let bytes = bytes + 2 * BLOCK;
        let asked = state.memory.as_ref().map_or(Ok(()), |own| own.ask_for_all(bytes, MemoryUse::Unpacking));
        asked.map_err(io::Error::other)
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

/// The output of the decoder, up to the limit, with its errors named.
struct Unpacker {
    decoder: Box<dyn Read>,
    packed: Packed,
    packing: Packing,
    total: u64,
}

impl Read for Unpacker {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let count = self.decoder.read(buffer).map_err(|error| {
            let is_own = error.get_ref().is_some_and(|error| error.is::<InputErrorKind>());
            if is_own || self.packed.0.borrow().has_failed || error.kind() == io::ErrorKind::Interrupted {
                return error;
            }
            let reason = match error.kind() {
                io::ErrorKind::UnexpectedEof => "it stops too soon".to_owned(),
                _ => format!("it is damaged: {error}"),
            };
            io::Error::other(InputErrorKind::Unreadable {
                format: self.packing.name(),
                reason: reason.into(),
            })
        })?;
        self.total += count as u64;
        let State { limit, ratio, bytes, .. } = *self.packed.0.borrow();
        if self.total > limit {
            return Err(io::Error::other(InputErrorKind::TooMuchUnpacked { limit }));
        }
        if self.total > most_unpacked(bytes, ratio) {
            return Err(io::Error::other(InputErrorKind::UnpacksTooFar { ratio }));
        }
        Ok(count)
    }
}

/// Members of gzip one after the other (RFC 1952, 2.2). Zeros behind the last one fill a block of a tape, and say nothing.
struct Members<R> {
    /// The current member, which has the bytes; `None` at the end.
    member: Option<GzDecoder<R>>,
    is_within: bool,
    has_zeros: bool,
}

impl<R: BufRead> Members<R> {
    fn new(bytes: R) -> Self {
        Members { member: Some(GzDecoder::new(bytes)), is_within: true, has_zeros: false }
    }

    /// Begins the next member, if there is one.
    fn begin(&mut self) -> io::Result<()> {
        let Some(member) = &mut self.member else { return Ok(()) };
        loop {
            let next = member.get_mut().fill_buf()?;
            let zeros = next.iter().take_while(|byte| **byte == 0).count();
            if zeros == 0 && !next.is_empty() && self.has_zeros {
                return Err(io::Error::new(io::ErrorKind::InvalidData, "bytes follow zeros behind its end"));
            }
            if zeros == 0 {
                let is_at_end = next.is_empty();
                let bytes = self.member.take().map(GzDecoder::into_inner).filter(|_| !is_at_end);
                self.member = bytes.map(GzDecoder::new);
                self.is_within = true;
                return Ok(());
            }
            self.has_zeros = true;
            member.get_mut().consume(zeros);
        }
    }
}

impl<R: BufRead> Read for Members<R> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        loop {
            if !self.is_within {
                self.begin()?;
            }
            let Some(member) = &mut self.member else { return Ok(0) };
            let count = member.read(buffer)?;
            if count > 0 || buffer.is_empty() {
                return Ok(count);
            }
            self.is_within = false;
        }
    }
}

/// The most bytes that a block unpacks to (RFC 8878, 3.1.1.2.4).
const BLOCK: u64 = 1 << 17;

/// Frames of Zstandard one after the other. Memory: as much of the window of a frame as was unpacked, at most 128 MiB. Until the window is
/// full, or the frame ends, the library hands out nothing.
struct Frames<R> {
    bytes: R,
    decoder: FrameDecoder,
    is_within: bool,
    /// Bytes of the largest window so far.
    window: u64,
    packed: Packed,
}

/// Hands out bytes and notes them.
struct Noting<'a, R> {
    bytes: &'a mut R,
    noted: Vec<u8>,
}

impl<R: Read> Read for Noting<'_, R> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let count = self.bytes.read(buffer)?;
        self.noted.extend_from_slice(buffer.get(..count).unwrap_or_default());
        Ok(count)
    }
}

/// The most packed bytes of blocks that tell what is in a file.
const PACKED_START: u64 = 8 * (BLOCK + 3);

/// A block that is the last one of its frame, and empty (RFC 8878, 3.1.1.2).
const END_OF_FRAME: [u8; 3] = [1, 0, 0];

/// The first bytes that frames unpack to, as far as the first of them tells, and all bytes of the frames: before there are limits no
/// window is filled.
fn start_of_frames(mut bytes: BufReader<Tap>) -> (Vec<u8>, impl BufRead) {
    let mut noting = Noting { bytes: &mut bytes, noted: Vec::new() };
    // The reader reports damaged bytes.
    let start = start_of_frame(&mut noting).unwrap_or_default();
    let noted = noting.noted;
    (start, Cursor::new(noted).chain(bytes))
}

/// The first bytes of the first frame that is not to be passed over. The decoder is shown a frame with a window of one block, which
/// ends behind these bytes. Nothing is taken out of it before, so the blocks can repeat anything that they unpacked to.
fn start_of_frame(bytes: &mut Noting<'_, impl Read>) -> Option<Vec<u8>> {
    let mut decoder = FrameDecoder::new();
    let header = header_of_frame(bytes)?;
    decoder.reset(header.as_slice()).ok()?;
    let mut start = vec![0; binary::START as usize];
    let enough = BlockDecodingStrategy::UptoBytes(start.len());
    if !decoder.decode_blocks(bytes.take(PACKED_START), enough).ok()? {
        decoder.decode_blocks(END_OF_FRAME.as_slice(), BlockDecodingStrategy::All).ok()?;
    }
    let count = decoder.read(&mut start).ok()?;
    start.truncate(count);
    Some(start)
}

/// Reads the header of the first frame that is not to be passed over; gives one that says the same but for the window, the length and
/// the checksum.
fn header_of_frame(bytes: &mut impl Read) -> Option<Vec<u8>> {
    loop {
        let mut magic = [0; 4];
        bytes.read_exact(&mut magic).ok()?;
        if magic != [0x28, 0xb5, 0x2f, 0xfd] {
            let mut length = [0; 4];
            bytes.read_exact(&mut length).ok()?;
            let length = u64::from(u32::from_le_bytes(length));
            // Who writes more than that in front of a table is no friend.
            if length > BLOCK {
                return None;
            }
            io::copy(&mut bytes.by_ref().take(length), &mut io::sink()).ok()?;
            continue;
        }
        let mut descriptor = [0];
        bytes.read_exact(&mut descriptor).ok()?;
        let [descriptor] = descriptor;
        let is_single = descriptor & 0x20 != 0;
        let identity = [0_u64, 1, 2, 4].into_iter().nth(usize::from(descriptor & 3))?;
        let length = [u64::from(is_single), 2, 4, 8].into_iter().nth(usize::from(descriptor >> 6))?;
        io::copy(&mut bytes.by_ref().take(u64::from(!is_single)), &mut io::sink()).ok()?;
        let mut header = magic.to_vec();
        // No length, no checksum, the dictionary as it is, and a window of 128 KiB: no block may be larger than the window.
        header.extend([descriptor & 0x1b, 7 << 3]);
        bytes.by_ref().take(identity).read_to_end(&mut header).ok()?;
        io::copy(&mut bytes.by_ref().take(length), &mut io::sink()).ok()?;
        return Some(header);
    }
}

/// Returns the number of bytes before the current one that a frame may repeat, by its header (RFC 8878,
/// 3.1.1.1.2); `None` where the frame may repeat all bytes.
fn window_of(header: &[u8]) -> Option<u64> {
    let (descriptor, window) = (header.get(4)?, header.get(5)?);
    let is_single = descriptor & 0x20 != 0;
    let base = 1_u64 << (10 + (window >> 3));
    (!is_single).then(|| base + base / 8 * u64::from(window & 7))
}

impl<R: BufRead> Frames<R> {
    /// Begins the next frame; `false` where there is none.
    fn begin(&mut self) -> io::Result<bool> {
        loop {
            if self.bytes.fill_buf()?.is_empty() {
                return Ok(false);
            }
            let mut bytes = Noting { bytes: &mut self.bytes, noted: Vec::new() };
            match self.decoder.reset(&mut bytes) {
                Ok(()) => {
                    let window = window_of(&bytes.noted).unwrap_or_else(|| self.decoder.content_size());
                    self.window = self.window.max(window);
                    return Ok(true);
                }
                Err(FrameDecoderError::ReadFrameHeaderError(ReadFrameHeaderError::SkipFrame {
                    length,
                    ..
                })) => {
                    io::copy(&mut self.bytes.by_ref().take(length.into()), &mut io::sink())?;
                }
                Err(FrameDecoderError::WindowSizeTooBig { requested, max }) => {
                    let reason = format!(
                        "it takes the last {} that were unpacked, and {} may be taken; pack it anew with a smaller window",
                        size_text(requested),
                        size_text(max)
                    );
                    let format = "a Zstandard file";
                    return Err(io::Error::other(InputErrorKind::Unreadable {
                        format,
                        reason: reason.into(),
                    }));
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
            // With one more block.
            let unpacked = (self.decoder.blocks_decoded() as u64 + 1).saturating_mul(BLOCK);
            self.packed.hold(self.window.min(unpacked))?;
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
