//! Writes a lesson about readings: one HTML file that needs neither network nor server.
//!
//! ```sh
//! cargo run -p boundfit --example teach --features lesson -- lesson.html
//! ```
#![expect(clippy::print_stdout, reason = "an example for people at a terminal")]

use std::error::Error;
use std::{env, fs};

use boundfit::lesson::{LessonOptions, lesson_data, page};
use boundfit::{Observations, Reading};

fn main() -> Result<(), Box<dyn Error>> {
    let problem = Observations::line(&[0, 1, 2, 3], &["0", "1.5", "2", "3.5"])?.error_bound("0.5")?;
    let fit = problem.fit();
    let options = LessonOptions { title: Some("Four readings".into()), ..LessonOptions::default() };

    // The numbers of the page, for whoever shows them in another way.
    let data = lesson_data(&problem, &fit, Reading::Decimal, &options)?;
    let count = |part: &str| data[part].as_array().map_or(0, Vec::len);
    println!("{}: {} readings, {} questions", data["title"], count("readings"), count("questions"));

    match env::args().nth(1) {
        Some(file) => {
            fs::write(&file, page(&problem, &fit, Reading::Decimal, &options)?)?;
            println!("{file}: open it in a browser");
        }
        None => println!("name a file to write the page"),
    }
    Ok(())
}
