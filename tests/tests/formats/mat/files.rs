//! MATLAB files, element by element.

use std::io::Write;

use flate2::Compression;
use flate2::write::ZlibEncoder;

/// A variable to be written: class and flags, dimensions, and numbers of an element type in little-endian order.
#[derive(Clone)]
pub(super) struct Variable {
    pub(super) name: &'static str,
    pub(super) class: u32,
    pub(super) dimensions: Vec<u32>,
    pub(super) kind: u32,
    pub(super) numbers: Vec<Vec<u8>>,
}

pub(super) fn doubles(name: &'static str, rows: u32, columns: u32, numbers: &[f64]) -> Variable {
    let numbers = numbers.iter().map(|number| number.to_le_bytes().to_vec()).collect();
    Variable { name, class: 6, dimensions: vec![rows, columns], kind: 9, numbers }
}

pub(super) fn number(value: u32, is_big: bool) -> Vec<u8> {
    if is_big { value.to_be_bytes().to_vec() } else { value.to_le_bytes().to_vec() }
}

pub(super) fn element(kind: u32, content: &[u8], is_big: bool) -> Vec<u8> {
    let mut bytes = [number(kind, is_big), number(content.len() as u32, is_big), content.to_vec()].concat();
    bytes.resize(bytes.len().next_multiple_of(8), 0);
    bytes
}

pub(super) fn matrix(variable: &Variable, is_big: bool) -> Vec<u8> {
    let words = |words: &[u32]| words.iter().flat_map(|&word| number(word, is_big)).collect::<Vec<u8>>();
    let mut numbers = variable.numbers.clone();
    if is_big {
        numbers.iter_mut().for_each(|number| number.reverse());
    }
    let parts = [
        element(6, &words(&[variable.class, 0]), is_big),
        element(5, &words(&variable.dimensions), is_big),
        element(1, variable.name.as_bytes(), is_big),
        element(variable.kind, &numbers.concat(), is_big),
    ];
    element(14, &parts.concat(), is_big)
}

pub(super) fn deflated(bytes: &[u8]) -> Vec<u8> {
    let mut encoder = ZlibEncoder::new(Vec::new(), Compression::best());
    encoder.write_all(bytes).unwrap();
    encoder.finish().unwrap()
}

pub(super) fn header(is_big: bool) -> Vec<u8> {
    let mut header = b"MATLAB 5.0 MAT-file, written by a test".to_vec();
    header.resize(124, b' ');
    header.extend(if is_big { b"\x01\x00MI" } else { b"\x00\x01IM" });
    header
}

pub(super) fn file(variables: &[Variable], is_big: bool, is_compressed: bool) -> Vec<u8> {
    let mut bytes = header(is_big);
    for variable in variables {
        let plain = matrix(variable, is_big);
        if is_compressed {
            let content = deflated(&plain);
            bytes.extend([number(15, is_big), number(content.len() as u32, is_big), content].concat());
        } else {
            bytes.extend(plain);
        }
    }
    bytes
}

/// One struct with these fields; a field without bytes is empty.
pub(super) fn structure(name: &str, fields: &[(&str, Vec<u8>)], is_big: bool) -> Vec<u8> {
    let words = |words: &[u32]| words.iter().flat_map(|&word| number(word, is_big)).collect::<Vec<u8>>();
    let mut names = Vec::new();
    for (field, _) in fields {
        names.extend(field.as_bytes());
        names.resize(names.len().next_multiple_of(8), 0);
    }
    let mut parts = [
        element(6, &words(&[2, 0]), is_big),
        element(5, &words(&[1, 1]), is_big),
        element(1, name.as_bytes(), is_big),
        element(5, &words(&[8]), is_big),
        element(1, &names, is_big),
    ]
    .concat();
    for (_, content) in fields {
        parts.extend(if content.is_empty() { element(14, &[], is_big) } else { content.clone() });
    }
    element(14, &parts, is_big)
}
