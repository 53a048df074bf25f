//! Claims as people and programs print them, off by known parts of the width. The referee and the second judge, which
//! was written from the manual's table alone, name the same verdict for each.

use boundfit_check::{Answer, ClaimLimits, ClaimText, ProgramRows, parse_claim_pui, read_claims};
use boundfit_estimation::Problem;
use boundfit_exact::{Rational, Rounding};
use boundfit_lp::{End, Judgement, PuiEnd, Referee, RoundedTo};
use boundfit_tests::generate::seeded;
use boundfit_tests::lp_cases::{fine, line_problem, number, ten_to};
use boundfit_tests::readings::problem;
use boundfit_tests::second_judge::{self, Finding, Said};
use boundfit_tests::shape::Tally;
use rand::RngExt;
use rand_chacha::ChaCha8Rng;

use super::judge::{Judge, Truth};

/// The verdicts from best to worst, as in the table.
const ORDER: [&str; 8] = [
    "exact",
    "rounded",
    "within tolerance",
    "loose",
    "infeasible point",
    "unsafe",
    "inverted interval",
    "wrong status",
];

/// One claimed end: its text, and what the second judge makes of it; `None` claims that there is no end.
type Claim = Option<(String, Said)>;

/// A fit: any, with a set that is one point, or unbounded.
fn fit(rng: &mut ChaCha8Rng) -> Problem {
    match rng.random_range(0..6) {
        0 => {
            let [theta1, theta2] = match rng.random_range(0..2) {
                0 => [fine(rng), fine(rng)],
                _ => [Rational::zero(), Rational::from(rng.random_range(-3..=3))],
            };
            let reading = |x: i64| (Rational::from(x), Rational::from(x) * &theta1 + &theta2);
            line_problem(&[reading(1), reading(2), reading(5)], &Rational::zero())
        }
        1 => line_problem(&[(Rational::from(2), fine(rng))], &Rational::ratio(1, 3)),
        _ => problem(rng),
    }
}

/// The number near the true end, or any where there is none, that is printed or stored.
fn perturbed(rng: &mut ChaCha8Rng, truth: &Truth, width: Option<&Rational>) -> Rational {
    let Truth::At(exact) = truth else { return fine(rng) };
    let unit = width.filter(|width| width.is_positive()).cloned().unwrap_or_else(|| exact.abs());
    let unit = if unit.is_zero() { Rational::one() } else { unit };
    let places = [3, 5, 6, 7, 9, 12, 15, 18, 30];
    let part = ten_to(-places[rng.random_range(0..places.len())]);
    let part = part * Rational::from(rng.random_range(1..=20));
    match rng.random_range(0..8) {
        0 => exact.clone(),
        1..=3 => exact + unit * part,
        4..=6 => exact - unit * part,
        _ => exact + fine(rng),
    }
}

/// A claim as text, with its precision told from the text by the second judge.
fn typed(rng: &mut ChaCha8Rng, value: &Rational) -> Claim {
    let text = match rng.random_range(0..6) {
        0 => value.to_string(),
        1 => value.decimal(rng.random_range(1..=18), Rounding::Nearest).compact().to_string(),
        2 => value.to_decimal(rng.random_range(19..=40), Rounding::Nearest),
        _ => value.to_decimal(rng.random_range(1..=18), Rounding::Nearest),
    };
    let said = Said::typed(&text, number(&text));
    Some((text, said))
}

/// A claim as a double.
fn double(value: &Rational) -> Claim {
    let double = value.to_f64();
    Some((format!("{double:e}"), Said::exactly(Rational::from_f64(double).unwrap())))
}

/// The answer of four claims, read as the program reads it: from the command line, or from JSON with doubles or texts.
fn answer(
    problem: &Problem,
    claims: &[[Claim; 2]; 2],
    point: Option<&[Claim; 2]>,
    are_texts: bool,
) -> Answer {
    if are_texts && point.is_none() {
        let word = |claim: &Claim, end| match (claim, end) {
            (Some((text, _)), _) => text.clone(),
            (None, End::Lower) => "-inf".to_owned(),
            (None, End::Upper) => "inf".to_owned(),
        };
        let words = PuiEnd::ALL.map(|end| word(end.of(claims), end.end()));
        return parse_claim_pui(&words.join(",")).unwrap();
    }
    let word = |claim: &Claim| match claim {
        None => "null".to_owned(),
        Some((text, _)) if are_texts => format!("\"{text}\""),
        Some((text, _)) => text.clone(),
    };
    let pair = |pair: &[Claim; 2]| format!("[{}, {}]", word(&pair[0]), word(&pair[1]));
    let points = point.map_or("null".to_owned(), |point| vec![pair(point); 4].join(", "));
    let points = if point.is_some() { format!("[{points}]") } else { points };
    let text = format!("{{\"pui\": [{}, {}], \"points\": {points}}}", pair(&claims[0]), pair(&claims[1]));
    let file = ClaimText { file: "claim.json".into(), text };
    read_claims(&[file], &ClaimLimits::default()).unwrap().answers(problem).remove(0)
}

/// The second judge's verdicts on both ends of an interval.
fn expected(
    judge: &Judge<'_>,
    axis: usize,
    claims: &[Claim; 2],
    point: Option<&[Said; 2]>,
    tolerance: &Rational,
) -> [Finding; 2] {
    let ends = [End::Lower, End::Upper];
    let values = [0, 1].map(|place| {
        let (Truth::At(exact), Some((_, said))) = (judge.truth(axis, ends[place]), &claims[place]) else {
            return None;
        };
        let truth = second_judge::Truth {
            end: exact,
            width: judge.width(axis),
            epsilon: judge.epsilon(),
            tolerance: tolerance.clone(),
        };
        Some(second_judge::judge_end(said, &truth, place == 1))
    });
    let is_inverted = match claims {
        [Some((_, lower)), Some((_, upper))] => {
            second_judge::is_inverted(lower, upper, values.each_ref().map(Option::as_ref))
        }
        _ => false,
    };
    let is_excused = point.is_none_or(|point| judge.excuses(point));
    [0, 1].map(|place| {
        let is_unbounded = judge.truth(axis, ends[place]) == Truth::Unbounded;
        let mut finding = match (&values[place], &claims[place]) {
            (Some(finding), _) => finding.clone(),
            (None, None) if is_unbounded => Finding { verdict: "exact", rounded_to: None },
            _ => Finding { verdict: "wrong status", rounded_to: None },
        };
        let rank = |verdict: &str| ORDER.iter().position(|own| *own == verdict).unwrap();
        let mut worsen = |verdict: &'static str| {
            if rank(verdict) > rank(finding.verdict) {
                finding.verdict = verdict;
            }
        };
        if !is_excused {
            worsen("infeasible point");
        }
        if is_inverted {
            worsen("inverted interval");
        }
        finding
    })
}

fn name(judgement: &Judgement) -> Finding {
    let rounded_to = judgement.rounded_to.map(|to| match to {
        RoundedTo::Binary64 => None,
        RoundedTo::Digits(digits) => Some(digits),
    });
    Finding { verdict: judgement.verdict.name(), rounded_to }
}

#[test]
fn the_second_judge_agrees_on_every_claim() {
    let mut rng = seeded(141);
    let mut tallies = [Tally::default(), Tally::default()];
    let (mut judged, mut points, mut unbounded) = (0, 0, 0);
    while judged < 60_000 {
        let problem = fit(&mut rng);
        let rows = ProgramRows::new(&problem);
        let tolerance = [ten_to(-6), Rational::zero(), ten_to(-2)][rng.random_range(0..3)].clone();
        let judge = Judge::new(rows.rows(), &tolerance);
        let referee = Referee::new(rows.rows().to_vec(), tolerance.clone());
        for _ in 0..20 {
            let are_texts = rng.random_bool(0.6);
            let print = |rng: &mut ChaCha8Rng, value: &Rational| {
                if are_texts { typed(rng, value) } else { double(value) }
            };
            let claim = |rng: &mut ChaCha8Rng, end: PuiEnd| {
                let truth = judge.truth(end.axis(), end.end());
                let is_end = if truth == Truth::Unbounded { 0.3 } else { 0.95 };
                let value = perturbed(rng, &truth, judge.width(end.axis()).as_ref());
                rng.random_bool(is_end).then(|| print(rng, &value)).flatten()
            };
            let claims = PuiEnd::each(|end| claim(&mut rng, end));
            let point = rng.random_bool(0.3).then(|| {
                let attained =
                    judge.attained_at(0, End::Upper).unwrap_or_else(|| [fine(&mut rng), fine(&mut rng)]);
                attained.map(|value| {
                    let value = perturbed(&mut rng, &Truth::At(value), None);
                    if are_texts { typed(&mut rng, &value) } else { double(&value) }
                })
            });
            let answer = answer(&problem, &claims, point.as_ref(), are_texts);
            let said = point.as_ref().map(|point| point.clone().map(|claim| claim.unwrap().1));
            for axis in [0, 1] {
                let found = referee.judge_interval(axis, &answer.claims[axis]);
                let wanted = expected(&judge, axis, &claims[axis], said.as_ref(), &tolerance);
                assert_eq!(found.each_ref().map(name), wanted, "{:?} {:?}", claims[axis], found);
                for (place, judgement) in found.iter().enumerate() {
                    assert_eq!(judgement.tau.is_some() || judgement.violation.is_some(), point.is_some());
                    tallies[usize::from(are_texts)].count(judgement.verdict.name());
                    let end = [End::Lower, End::Upper][place];
                    unbounded += usize::from(judge.truth(axis, end) == Truth::Unbounded);
                    judged += 1;
                }
                points += usize::from(judge.width(axis).is_some_and(|width| width.is_zero()));
            }
        }
    }
    tallies.iter().for_each(|tally| tally.assert_each(300, &ORDER));
    assert!(points >= 3_000 && unbounded >= 3_000, "{points} {unbounded}");
}
