"""Bounded-error estimation as a regressor of scikit-learn.

>>> from boundfit.sklearn import BoundedErrorRegressor
>>> model = BoundedErrorRegressor(eps=0.5).fit([[0.0], [1.0], [2.0]], [0.0, 1.5, 2.0])
>>> model.predict([[3.0]])
array([3.])
>>> [float(end) for end in model.predict_interval([[3.0]])[0]]
[2.0, 4.0]
"""

from __future__ import annotations

from typing import Any, Literal

import numpy
from sklearn.base import BaseEstimator, RegressorMixin
from sklearn.utils.validation import check_is_fitted, validate_data

from ._columns import Number, Reading
from ._fit import Fit
from ._fitting import fit


class BoundedErrorRegressor(RegressorMixin, BaseEstimator):  # type: ignore[misc]
    """A line, of one feature, or a plane through the origin, of two, under errors of which nothing is known but a bound.

    ``eps`` bounds every error; it is a number, or a text as of :func:`boundfit.fit`: ``"1.2*min"`` is a multiple of the least
    bound, under which the set is never empty, but nothing is guaranteed then. ``estimator`` says which of the parameters
    ``predict`` takes: the middle of their box, the minimax or the least-squares estimate. ``fit_`` has the whole answer.
    """

    def __init__(
        self,
        eps: Number = "1.2*min",
        *,
        estimator: Literal["central", "minimax", "least_squares"] = "central",
        reading: Reading = "binary64",
    ) -> None:
        self.eps = eps
        self.estimator = estimator
        self.reading: Reading = reading

    def fit(self, X: Any, y: Any) -> BoundedErrorRegressor:
        """Fits the readings.

        :raises ValueError: where there are not one or two features, or the parameters that ``estimator`` names do not exist.
        """
        X, y = validate_data(self, X, y, y_numeric=True, dtype="float64", ensure_min_samples=2)
        columns = tuple(self._features(X).T.copy())
        # An answer is not kept in a pickle, but what it follows from.
        self._readings = columns, y.astype("float64")
        self.fit_: Fit = self._answer()
        theta = self._theta(self.fit_)
        self.coef_ = theta[:1] if len(columns) == 1 else theta
        self.intercept_ = float(theta[1]) if len(columns) == 1 else 0.0
        return self

    def _features(self, X: numpy.ndarray[Any, Any]) -> numpy.ndarray[Any, Any]:
        """The features that are fitted: all of them."""
        if X.shape[1] not in (1, 2):
            raise ValueError(f"X has {X.shape[1]} features: a set of two parameters takes one feature, or two")
        return X

    def _answer(self) -> Fit:
        columns, y = self._readings
        regressors: Any = columns[0] if len(columns) == 1 else columns
        return fit(regressors, y, self.eps, reading=self.reading, eui=False)

    def __getstate__(self) -> Any:
        state: Any = super().__getstate__()
        return {name: value for name, value in state.items() if name != "fit_"}

    def __setstate__(self, state: Any) -> None:
        super().__setstate__(state)
        if "_readings" in state:
            self.fit_ = self._answer()

    def _theta(self, answer: Fit) -> numpy.ndarray[Any, Any]:
        match self.estimator:
            case "central":
                if answer.is_empty:
                    raise ValueError(
                        f"no parameters agree with all readings within eps={self.eps!r}; the least bound that leaves any is "
                        f"{None if answer.epsilon_min is None else float(answer.epsilon_min)}"
                    )
                theta = None if answer.central is None else answer.central[:2]
            case "minimax":
                theta = None if answer.minimax is None else answer.minimax[1:3]
            case "least_squares":
                theta = answer.least_squares
            case other:
                raise ValueError(f'estimator={other!r}: expected "central", "minimax" or "least_squares"')
        if theta is None:
            raise ValueError(f"there is no {self.estimator} estimate: the set is {answer.kind}")
        return numpy.array([float(value) for value in theta])

    def predict(self, X: Any) -> numpy.ndarray[Any, Any]:
        """The values of the estimate."""
        check_is_fitted(self)
        validated: Any = validate_data(self, X, reset=False, dtype="float64")
        X = self._features(validated)
        values: numpy.ndarray[Any, Any] = X @ self.coef_ + self.intercept_
        return values

    def predict_interval(self, X: Any) -> numpy.ndarray[Any, Any]:
        """A row of two ends for each row of X: where the true line lies, if no error was larger than its bound. Rounded outward;
        infinite where nothing bounds it, NaN where the set is empty."""
        check_is_fitted(self)
        validated: Any = validate_data(self, X, reset=False, dtype="float64")
        X = self._features(validated)
        first = X[:, 0].tolist()
        second = X[:, 1].tolist() if X.shape[1] == 2 else [1.0] * len(first)
        return numpy.column_stack(self.fit_._core.ranges(first, second))
