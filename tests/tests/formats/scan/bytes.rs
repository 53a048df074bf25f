//! The same results for bytes in chunks of any size.

use std::collections::VecDeque;
use std::io::{self, Read};

use boundfit_formats::{ColumnSelector, LONGEST_LINE, ScanOptions, Source};
use boundfit_tests::reference_table;

use super::both::{POOLS, batches, by_reference, found};

/// An event: the reader's response to a call.
#[derive(Clone)]
enum Event {
    /// Gives these bytes, or the first of them if the buffer is smaller.
    Bytes(Vec<u8>),
    Interrupted,
    Fails,
}

struct Script(VecDeque<Event>);

impl Read for Script {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        match self.0.pop_front() {
            None => Ok(0),
            Some(Event::Bytes(bytes)) if bytes.is_empty() => self.read(buffer),
            Some(Event::Bytes(bytes)) => {
                let count = bytes.len().min(buffer.len());
                buffer[..count].copy_from_slice(&bytes[..count]);
                if count < bytes.len() {
                    self.0.push_front(Event::Bytes(bytes[count..].to_vec()));
                }
                Ok(count)
            }
            Some(Event::Interrupted) => Err(io::ErrorKind::Interrupted.into()),
            Some(Event::Fails) => Err(io::Error::other("the disk is gone")),
        }
    }
}

fn source(events: &[Event]) -> Source {
    Source::new("data.csv", Script(events.iter().cloned().collect()))
}

fn columns() -> [ColumnSelector; 2] {
    ["x", "y"].map(ColumnSelector::name_or_number)
}

const TABLES: [&str; 4] = [
    "\u{feff}\n\nx;y\n1;2\n3;4.5\n5;6\n",
    "x,y\r\n1,\"2\"\r\n\r\n3,\"4\n\"\r\n5,6\r\n",
    "x,y\r1,2\r3,4\r",
    "x,y\n1,2\n3,4\n5,z\n7\n",
];

#[test]
fn one_byte_at_a_time_and_interrupted() {
    for table in TABLES {
        let expected = by_reference(table.as_bytes(), &columns(), &ScanOptions::default());
        let one_by_one = table.bytes().map(|byte| Event::Bytes(vec![byte]));
        let events: Vec<Event> = one_by_one.flat_map(|byte| [Event::Interrupted, byte]).collect();
        for chunk_bytes in [1, 7, 4096] {
            let options = ScanOptions { chunk_bytes, ..ScanOptions::default() };
            let scanned = POOLS[1].install(|| batches(source(&events), &columns(), &options));
            let actual = scanned.map(|(scanned, batches)| found(scanned, &batches));
            assert_eq!(actual, expected, "{table:?} in chunks of {chunk_bytes}");
        }
    }
}

/// The program reports a fault before the reader's failure first, and else the failure with its line.
#[test]
fn a_reader_that_fails() {
    for table in TABLES {
        for end in 0..=table.len() {
            let bytes = Event::Bytes(table.as_bytes()[..end].to_vec());
            let events = [bytes, Event::Fails];
            let bytes = &table.as_bytes()[..end];
            let options = ScanOptions::default().table;
            let expected = reference_table::read(bytes, Some("the disk is gone"), &columns(), &options).err();
            for chunk_bytes in [1, 7, 4096] {
                let options = ScanOptions { chunk_bytes, ..ScanOptions::default() };
                let actual = POOLS[1].install(|| batches(source(&events), &columns(), &options)).err();
                assert_eq!(actual, expected, "{table:?} until {end} in chunks of {chunk_bytes}");
            }
            assert!(expected.is_some());
        }
    }
}

/// A line that is too long is refused where it stands; one as long as may be is read.
#[test]
fn a_line_without_end() {
    let longest = format!("x,y\n1,2\n3,{}4\n", " ".repeat(LONGEST_LINE - 4));
    let options = ScanOptions::default();
    let expected = by_reference(longest.as_bytes(), &columns(), &options);
    assert_eq!(expected.as_ref().map(|found| found.rows_total), Ok(2));
    let too_long = format!("x,y\n1,2\n3,{}4\n5,z\n", " ".repeat(LONGEST_LINE - 3));
    let refused = by_reference(too_long.as_bytes(), &columns(), &options);
    assert_eq!(
        refused.as_ref().err().map(String::as_str),
        Some("data.csv: line 3: the line is longer than 16777216 bytes (the limit)")
    );
    let first = format!("x{}\n", " ".repeat(LONGEST_LINE));
    let at_once = by_reference(first.as_bytes(), &columns(), &options);
    for chunk_bytes in [1 << 12, 1 << 19, usize::MAX] {
        let options = ScanOptions { chunk_bytes, ..ScanOptions::default() };
        for (text, expected) in [(&longest, &expected), (&too_long, &refused), (&first, &at_once)] {
            let events = [Event::Bytes(text.clone().into_bytes())];
            let scanned = batches(source(&events), &columns(), &options);
            let actual = scanned.map(|(scanned, batches)| found(scanned, &batches));
            assert!(&actual == expected, "chunks of {chunk_bytes}: {:?}", actual.err());
        }
    }
}
