//! Half-planes from files and from bytes.

use std::io::Cursor;

use boundfit_exact::{Limits, Reading};
use boundfit_formats::{SizeLimits, Source, TableOptions, read_half_planes};
use boundfit_geometry::{Direction, Point, Polyhedron, Region, clipping, envelope};
use boundfit_report::{h_representation as written_h, v_representation as written_v};

use crate::deep::{Case, PlacedCase, h_representation};
use crate::oracle::Row;

/// Refuses an H- or V-representation, or reads it. Half-planes that were read and written again are the same system.
/// Both algorithms agree on its region, and both representations that reports write give the same set.
pub fn ine_parser(data: &[u8]) {
    for reading in [Reading::Decimal, Reading::Binary64] {
        let options = TableOptions {
            reading,
            limits: Limits { digits: 40, exponent: 100 },
            sizes: SizeLimits { rows: 1_000, ..SizeLimits::default() },
            ..TableOptions::default()
        };
        let read =
            |bytes: &[u8]| read_half_planes(Source::new("set.ine", Cursor::new(bytes.to_vec())), &options);
        let Ok(file) = read(data) else { return };
        assert_eq!(file.system.len(), file.origins.len());
        assert!(file.origins.iter().all(|origin| origin.row >= 1));
        let exact = TableOptions { limits: Limits::default(), ..TableOptions::default() };
        let written = Cursor::new(h_representation(&file.system).into_bytes());
        let again = read_half_planes(Source::new("set.ine", written), &exact);
        assert_eq!(again.map(|again| again.system).ok().as_ref(), Some(&file.system));
        if file.system.len() <= 12 {
            let region = envelope::intersect(&file.system);
            assert_eq!(region, clipping::intersect(&file.system));
            assert_eq!(region.check_invariants(&file.system), Ok(()));
            let polyhedron = Polyhedron::intersect(file.system);
            for written in [written_h(&polyhedron), written_v(&polyhedron)] {
                let source = Source::new("set", Cursor::new(written.clone().into_bytes()));
                let again = read_half_planes(source, &exact).map(|again| Polyhedron::intersect(again.system));
                assert_eq!(again.map(|again| shape(again.region())).ok(), Some(shape(&region)), "{written}");
            }
        }
    }
}

/// A region without the indices of half-planes.
fn shape(region: &Region) -> (Vec<Point>, Vec<Direction>, Vec<Direction>, Option<bool>) {
    let vertices = region.vertices().iter().map(|vertex| vertex.point().clone()).collect();
    let is_bounded = region.witness().map(|_| region.is_bounded());
    (vertices, region.rays(), region.lines(), is_bounded)
}

/// The first byte says how many bytes make a coefficient, the rest are rows: clipping, the fast intersection, brute force
/// and the exact simplex agree.
pub fn polygon_against_oracle(data: &[u8]) {
    let Some((&first, rest)) = data.split_first() else { return };
    let width = [1, 2, 4][usize::from(first % 3)];
    let number = |bytes: &[u8]| {
        let unsigned = bytes.iter().rev().fold(0_i128, |value, &byte| value << 8 | i128::from(byte));
        // Two's complement, without the one value whose size is out of the oracle's range.
        let half = 1 << (8 * width - 1);
        if unsigned < half { unsigned } else { (unsigned - 2 * half).max(1 - half) }
    };
    let row = |bytes: &[u8]| -> Option<Row> {
        let numbers: Vec<i128> = bytes.chunks_exact(width).map(number).collect();
        numbers.try_into().ok()
    };
    let rows: Vec<Row> = rest.chunks_exact(3 * width).take(12).filter_map(row).collect();
    let case = PlacedCase::in_place(rows);
    if let Err(message) = case.check() {
        panic!("{message}\n{}", case.fixture());
    }
}
