//! The greatest common divisor of machine integers.

/// Stein's binary algorithm: only shifts and subtractions, since a division of 128 bits costs as much as a dozen of these.
/// `gcd(0, n) = n`.
pub(super) fn gcd(left: u128, right: u128) -> u128 {
    match (u64::try_from(left), u64::try_from(right)) {
        (Ok(left), Ok(right)) => u128::from(gcd_of_words(left, right)),
        (Ok(0), _) => right,
        (_, Ok(0)) => left,
        // One division brings both down to a word.
        (_, Ok(word)) => u128::from(gcd_of_words((left % u128::from(word)) as u64, word)),
        (Ok(word), _) => u128::from(gcd_of_words((right % u128::from(word)) as u64, word)),
        _ => gcd_of_pairs(left, right),
    }
}

fn gcd_of_pairs(left: u128, right: u128) -> u128 {
    let twos = (left | right).trailing_zeros();
    let (mut left, mut right) = (left >> left.trailing_zeros(), right >> right.trailing_zeros());
    while left != right {
        // The larger one is as often left as right: without a branch that cannot be foretold.
        let difference = left.abs_diff(right);
        right = left.min(right);
        left = difference >> difference.trailing_zeros();
        if let (Ok(small), Ok(other)) = (u64::try_from(left), u64::try_from(right)) {
            return u128::from(gcd_of_words(small, other)) << twos;
        }
    }
    left << twos
}

fn gcd_of_words(left: u64, right: u64) -> u64 {
    /// The number of bits by which two numbers must differ for a division to save more than it costs.
    const FAR_APART: u32 = 12;
    let (mut left, mut right) = (left, right);
    if left == 0 || right == 0 {
        return left | right;
    }
    if left.leading_zeros().abs_diff(right.leading_zeros()) > FAR_APART {
        (left, right) = (left.max(right) % left.min(right), left.min(right));
        if left == 0 {
            return right;
        }
    }
    let twos = (left | right).trailing_zeros();
    left >>= left.trailing_zeros();
    right >>= right.trailing_zeros();
    while left != right {
        // A difference and its opposite end in the same zeros. Counting them need not wait for the larger one.
        let zeros = left.wrapping_sub(right).trailing_zeros();
        let difference = left.abs_diff(right);
        right = left.min(right);
        left = difference >> zeros;
    }
    left << twos
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_is_euclids() {
        fn euclid(left: u128, right: u128) -> u128 {
            if right == 0 { left } else { euclid(right, left % right) }
        }
        let edges: Vec<u128> = [0, 1, 2, 3, 12, 97, 1 << 40, u128::from(u64::MAX), 1 << 64, (1 << 64) + 2]
            .into_iter()
            .chain([3 << 90, 5_u128.pow(50), 7_u128.pow(45), 1 << 127, u128::MAX, u128::MAX - 1])
            .collect();
        for &left in &edges {
            for &right in &edges {
                assert_eq!(gcd(left, right), euclid(left, right), "{left} {right}");
            }
        }
    }
}
