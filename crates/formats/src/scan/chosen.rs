//! One block of a file that has several.

use boundfit_exact::Foreign;
use memchr::memchr_iter;

use crate::block::{AskedBlock, Block};
use crate::blocks::Blocks;
use crate::chunks::{Chunk, ChunkReader};
use crate::error::{InputError, InputErrorKind};
use crate::notes::BlockNote;

use super::batch::ScanOptions;
use super::first_record::Position;
use super::layout::Layout;
use super::notes::Notes;
use super::rows::RowReader;
use super::run::Run;

/// The most bytes between blocks that are held for the comments in them.
const MOST_BETWEEN: usize = 1 << 16;

/// The block that is asked for, where it begins.
pub(super) struct Chosen {
    wanted: AskedBlock,
    number: usize,
    name: Option<Foreign>,
    blocks: Blocks,
    /// The line that is reached, from 1, by all line ends and by line feeds alone.
    pub(super) lines: [u64; 2],
}

impl Chosen {
    /// Has the reader pass over what comes before the block that is asked for and the comments in front of it; `None` where no
    /// single one is asked for.
    ///
    /// # Errors
    /// When there is no such block.
    pub(super) fn find(
        file: &str,
        options: &ScanOptions,
        reader: &mut ChunkReader,
    ) -> Result<Option<Self>, InputError> {
        let dialect = &options.table.dialect;
        let wanted = match &options.table.block {
            None | Some(AskedBlock::All) => return Ok(None),
            Some(wanted) => wanted.clone(),
        };
        let mut lines = [1, 1];
        for _ in 0..dialect.skip_lines {
            pass_line(reader, &mut lines);
        }
        let mut blocks = Blocks::new(dialect.comment, dialect.delimiter, lines[0]);
        let mut at = 0;
        while let Some((end, behind)) = reader.line_at(at) {
            let begins = blocks.add(reader.pending().get(at..end).unwrap_or_default());
            let name = blocks.current().and_then(|block| block.name.clone());
            let is_wanted = match &wanted {
                AskedBlock::Number(number) => blocks.total() == *number,
                AskedBlock::Name(wanted) => name.as_ref() == Some(wanted),
                AskedBlock::All => false,
            };
            if begins == Some(true) && is_wanted {
                return Ok(Some(Chosen { number: blocks.total(), name, wanted, blocks, lines }));
            }
            at = behind;
            if begins.is_some() || at > MOST_BETWEEN {
                lines[0] = blocks.line();
                lines[1] += line_feeds(reader.pending().get(..at).unwrap_or_default());
                reader.skip(std::mem::take(&mut at));
            }
        }
        Err(match reader.failure() {
            Some(problem) => InputError::of_line(file, lines[1], problem),
            None => blocks.error(file, Some(&wanted)),
        })
    }
}

/// Has the reader pass over a line.
fn pass_line(reader: &mut ChunkReader, lines: &mut [u64; 2]) {
    if let Some((_, behind)) = reader.line_at(0) {
        lines[0] += 1;
        lines[1] += line_feeds(reader.pending().get(..behind).unwrap_or_default());
        reader.skip(behind);
    }
}

fn line_feeds(bytes: &[u8]) -> u64 {
    memchr_iter(b'\n', bytes).count() as u64
}

impl Run<'_, '_> {
    /// Reads the rows of a block from a position on, and passes over what comes behind it; gives how many rows there are.
    pub(super) fn read_chosen(
        &mut self,
        layout: &mut Layout,
        reader: &mut ChunkReader,
        position: Position,
        notes: &mut Notes,
        chosen: Chosen,
    ) -> Result<usize, InputError> {
        let Chosen { wanted, number, name, blocks, .. } = chosen;
        let mut blocks = blocks.resumed_at(position.lines);
        let mut rows = RowReader::new(layout, layout.mark, position.lines, position.rows);
        let mut is_behind = false;
        loop {
            let chunk = reader.next_chunk();
            let piece = chunk.as_deref().unwrap_or_else(|| reader.pending());
            blocks.read(piece);
            if !is_behind {
                let mut batch = layout.batch();
                let mut read = rows.read(piece, &mut batch);
                if chunk.is_none() && read.is_ok() {
                    read = rows.finish(&mut batch);
                }
                notes.add(rows.take_notes(), 0, false)?;
                is_behind = is_next_block(&read);
                if !is_behind {
                    read?;
                }
                self.hand_out(batch, piece.len() as u64)?;
            }
            match chunk {
                Some(chunk) => reader.recycle(vec![chunk]),
                None => break,
            }
        }
        let total = rows.total();
        if let Some(problem) = reader.failure() {
            return Err(InputError::of_file(self.file, problem));
        }
        refuse_several(&wanted, number, &blocks)
            .map_err(|problem| InputError::of_file(self.file, problem))?;
        layout.block = BlockNote::of(Some(number), name, blocks.total());
        Ok(total)
    }

    /// An error of reading rows, which lists the blocks if it is that another one begins. Rows up to this
    /// position were one block; the rest follows.
    pub(super) fn or_blocks(
        &self,
        error: InputError,
        layout: &Layout,
        reader: &mut ChunkReader,
        position: Position,
        (gap, rest): (crate::blocks::Gap, Vec<Chunk>),
    ) -> InputError {
        if !matches!(error.kind, InputErrorKind::NextBlock) {
            return error;
        }
        let dialect = &self.options.table.dialect;
        let between = gap.blank_lines + gap.comments;
        let last = position.lines.saturating_sub(1 + between).max(layout.first_line);
        let block =
            Block { name: layout.title.clone(), lines: [layout.first_line, last], rows: position.rows };
        let shape = (layout.syntax.delimiter, layout.shape.width);
        let has_comments = layout.syntax.comment.is_some();
        let mut blocks = Blocks::new(dialect.comment, dialect.delimiter, position.lines).after(
            block,
            shape,
            has_comments,
            gap,
            position.lines,
        );
        rest.iter().for_each(|chunk| blocks.read(chunk));
        while let Some(chunk) = reader.next_chunk() {
            blocks.read(&chunk);
            reader.recycle(vec![chunk]);
        }
        blocks.read(reader.pending());
        blocks.error(self.file, None)
    }
}

/// Refuses a name of several blocks, and a number that is the name of another block.
fn refuse_several(wanted: &AskedBlock, number: usize, blocks: &Blocks) -> Result<(), InputErrorKind> {
    let problem = match wanted {
        AskedBlock::Name(name) => Some(blocks.named(name.raw()).len())
            .filter(|count| *count > 1)
            .map(|count| InputErrorKind::AmbiguousBlock { name: name.clone(), count }),
        AskedBlock::Number(wanted) => blocks
            .named(&wanted.to_string())
            .into_iter()
            .find(|&named| named != number)
            .map(|named| InputErrorKind::BlockNameOrNumber { wanted: *wanted, named }),
        AskedBlock::All => None,
    };
    problem.map_or(Ok(()), Err)
}

fn is_next_block(read: &Result<(), InputError>) -> bool {
    matches!(read, Err(InputError { kind: InputErrorKind::NextBlock, .. }))
}
