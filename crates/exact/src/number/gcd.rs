//! The greatest common divisor of machine integers.

/// Stein's binary algorithm: only shifts and subtractions, since a division of 128 bits costs as much as a dozen of these.
/// `gcd(0, n) = n`.
pub(super) fn gcd(left: u128, right: u128) -> u128 {
    match (u64::try_from(left), u64::try_from(right)) {
        (Ok(left), Ok(right)) => u128::from(gcd_of_words(left, right)),
        _ if left == 0 => right,
        _ if right == 0 => left,
        _ => {
            let twos = (left | right).trailing_zeros();
            let (mut left, mut right) = (left >> left.trailing_zeros(), right >> right.trailing_zeros());
            while left != right {
                if left < right {
                    (left, right) = (right, left);
                }
                left -= right;
                left >>= left.trailing_zeros();
                if let (Ok(small), Ok(other)) = (u64::try_from(left), u64::try_from(right)) {
                    return u128::from(gcd_of_words(small, other)) << twos;
                }
            }
            left << twos
        }
    }
}

fn gcd_of_words(left: u64, right: u64) -> u64 {
    if left == 0 || right == 0 {
        return left | right;
    }
    // Frequent, and the longest way for what follows.
    if left == 1 || right == 1 {
        return 1;
    }
    let twos = (left | right).trailing_zeros();
    let (mut left, mut right) = (left >> left.trailing_zeros(), right >> right.trailing_zeros());
    while left != right {
        if left < right {
            (left, right) = (right, left);
        }
        left -= right;
        left >>= left.trailing_zeros();
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
