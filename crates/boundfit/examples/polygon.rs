//! Intersects half-planes: a polygon with its measures and a proved bound, then an empty set with its contradiction.
//!
//! ```sh
//! cargo run -p boundfit --example polygon
//! ```
#![expect(clippy::print_stdout, reason = "an example for people at a terminal")]

use boundfit::{Error, Rational, Support, polygon};

fn main() -> Result<(), Error> {
    // Rows (a1, a2, b) mean a1·θ1 + a2·θ2 ≤ b.
    let set = polygon(&[["-1", "0", "0"], ["0", "-1", "0"], ["2", "3", "6"], ["1", "0", "2.5"]])?;
    println!("{}", set.region().kind().name());
    for vertex in set.region().vertices() {
        let [theta1, theta2] = vertex.point().coordinates();
        println!("  ({theta1}, {theta2}) on half-planes {:?}", vertex.active());
    }
    if let Some(area) = set.region().area() {
        println!("area {area}");
    }

    // The largest θ1 + θ2, with the multiples of half-planes that prove it.
    if let Support::Bounded { proof, .. } = set.support(&[Rational::one(), Rational::one()]) {
        println!("theta1 + theta2 <= {}, verified: {}", proof.value, proof.verify(set.system()).is_ok());
    }

    let empty = polygon(&[[1, 0, 0], [-1, 0, -1]])?;
    if let Some(certificate) = empty.region().certificate() {
        let verified = certificate.verify(empty.system()).is_ok();
        println!("{}, verified: {verified}", empty.region().kind().name());
        for multiplier in certificate.multipliers() {
            println!("  {} times half-plane {}", multiplier.value, multiplier.index);
        }
    }
    Ok(())
}
