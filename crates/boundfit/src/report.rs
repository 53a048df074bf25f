//! Answers as text, LaTeX and Markdown ([`Document`]), JSON, CSV, WKT, scripts and files of cdd and lrs; proofs of them.
//!
//! ```
//! use boundfit::Observations;
//! use boundfit::report::{Style, region_wkt};
//!
//! let fit = Observations::line(&[0, 1, 2], &["0", "1.5", "2"])?.error_bound("1/2")?.fit();
//! let wkt = region_wkt(fit.fps.polyhedron(), &Style::default())?;
//! assert!(wkt.starts_with("POLYGON ((0.5 0.5,"), "{wkt}");
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub use boundfit_report::{
    Document, EndRounding, InverseLine, LONGEST_FRACTION, NewReadings, NextReadingReport, Origin,
    OutliersReport, RangeReport, StatusCsv, StatusReport, Style, WindowReport, brief_document, fit_csv,
    fit_document, fit_json, fit_script, guarantee_document, h_representation, linearity_csv,
    linearity_document, linearity_json, next_reading_csv, next_reading_document, next_reading_json,
    outliers_csv, outliers_document, outliers_json, range_csv, range_document, range_json, region_script,
    region_wkt, status_document, sweep_document, v_representation, vertices_csv, x_error_csv,
    x_error_document, x_error_json, x_error_wkt,
};
#[cfg(feature = "files")]
pub use boundfit_report::{
    NoOutliersProof, linearity_proof, outliers_proof, polygon_document, polygon_json, proof_json,
    range_proof, status_proof, x_error_proof,
};
// Python's and the browser's glue write their documents from smaller parts; nobody else is promised these.
#[doc(hidden)]
pub use boundfit_report::*;
