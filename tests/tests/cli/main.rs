//! The program from outside: options, files in and out, messages, exit statuses.

mod atomic_output;
mod bad_input;
mod bad_usage;
mod bounds;
mod brief;
mod check;
mod convert;
mod dialects;
mod exchange;
mod fleet;
mod help;
mod input_formats;
mod json;
mod judge;
mod large;
mod limits;
mod line_forms;
mod names;
mod output;
mod packed;
mod polygon;
mod reduce;
mod replacing;
mod selection;
mod sweep;
mod workbooks;
