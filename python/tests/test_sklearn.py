"""The regressor of scikit-learn."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import numpy
import pytest
from boundfit.sklearn import BoundedErrorRegressor
from sklearn.pipeline import make_pipeline
from sklearn.preprocessing import MinMaxScaler
from sklearn.utils.estimator_checks import parametrize_with_checks


# Checks that fit three features and more, where a set of two parameters takes one, or two: that is refused. They pass of the first
# of these features, below.
MORE_FEATURES = """
check_dict_unchanged
check_dont_overwrite_parameters
check_dtype_object
check_estimators_dtypes
check_estimators_nan_inf
check_estimators_pickle
check_f_contiguous_array_estimator
check_fit2d_predict1d
check_fit_score_takes_y
check_methods_sample_order_invariance
check_methods_subset_invariance
check_n_features_in_after_fitting
check_pipeline_consistency
check_positive_only_tag_during_fit
check_regressor_data_not_an_array
check_regressors_int
check_regressors_no_decision_function
check_regressors_train
check_supervised_y_2d
""".split()


def expected_failures(estimator: BoundedErrorRegressor) -> dict[str, str]:
    return dict.fromkeys(MORE_FEATURES, "it fits more than two features, which is refused")


class OfFirstFeature(BoundedErrorRegressor):
    """Of any number of features the first one, so that every check says something."""

    def _features(self, X: Any) -> Any:
        return X[:, :1]

    def __sklearn_tags__(self) -> Any:
        tags = super().__sklearn_tags__()
        # One of ten features explains less than the score that is asked for.
        tags.regressor_tags.poor_score = True
        return tags


@parametrize_with_checks(
    [OfFirstFeature(), OfFirstFeature(estimator="minimax"), OfFirstFeature(estimator="least_squares")]
)
def test_whatever_has_nothing_to_do_with_their_number_holds_of_more_features(estimator: Any, check: Any) -> None:
    check(estimator)


@parametrize_with_checks(
    [BoundedErrorRegressor(), BoundedErrorRegressor(estimator="minimax"), BoundedErrorRegressor(estimator="least_squares")],
    expected_failed_checks=expected_failures,
)
def test_it_is_an_estimator_of_scikit_learn(estimator: Any, check: Any) -> None:
    check(estimator)


def test_intervals_are_guaranteed() -> None:
    random = numpy.random.default_rng(1)
    x = random.uniform(0, 10, (200, 1))
    y = 3 * x[:, 0] - 1 + random.uniform(-0.2, 0.2, 200)
    model = BoundedErrorRegressor(eps=0.2).fit(x, y)
    at = numpy.linspace(-5, 15, 50).reshape(-1, 1)
    ends = model.predict_interval(at)
    truth = 3 * at[:, 0] - 1
    assert ends.shape == (50, 2) and (ends[:, 0] <= truth).all() and (truth <= ends[:, 1]).all()
    assert (ends[:, 0] <= model.predict(at)).all() and (model.predict(at) <= ends[:, 1]).all()
    for point, (lower, upper) in zip(at[:, 0].tolist(), ends.tolist(), strict=True):
        exact = model.fit_.response(point)
        assert exact is not None and Fraction(lower) <= exact.lower and exact.upper <= Fraction(upper)
    assert model.score(x, y) > 0.99


def test_two_features_and_pipelines() -> None:
    phi = numpy.array([[1.0, 0], [0, 1], [1, 1]])
    model = BoundedErrorRegressor(eps=0.25, estimator="least_squares").fit(phi, [2, 3, 5])
    assert model.coef_.shape == (2,) and model.intercept_ == 0
    assert model.predict(phi) == pytest.approx([2, 3, 5])
    assert make_pipeline(MinMaxScaler(), BoundedErrorRegressor()).fit(phi[:, :1], [1, 2, 3]).predict(phi[:, :1]).shape == (3,)


def test_what_is_wrong_is_told() -> None:
    with pytest.raises(ValueError, match="X has 3 features"):
        BoundedErrorRegressor().fit(numpy.eye(3), [1, 2, 3])
    with pytest.raises(ValueError, match="no parameters agree with all readings within eps=0.1; the least bound .* 0.5"):
        BoundedErrorRegressor(eps=0.1).fit([[0], [1], [2]], [0, 1, 0])
    with pytest.raises(ValueError, match="there is no central estimate: the set is strip"):
        BoundedErrorRegressor(eps=0.1).fit([[1], [1]], [1, 1])
    with pytest.raises(ValueError, match='expected "central"'):
        BoundedErrorRegressor(estimator="median").fit([[0], [1]], [0, 1])  # type: ignore[arg-type]
