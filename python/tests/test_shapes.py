"""Any shape and kind of array: a surface, or a mistake that names its keyword."""

import re

import numpy as np
import pytest

import knotfit

hypothesis = pytest.importorskip("hypothesis", reason="hypothesis is not installed")
from hypothesis import HealthCheck, given, settings  # noqa: E402
from hypothesis import strategies as st  # noqa: E402
from hypothesis.extra import numpy as npst  # noqa: E402

quick = settings(max_examples=60, deadline=None, database=None, suppress_health_check=list(HealthCheck))
kinds = st.one_of(npst.floating_dtypes(sizes=(16, 32, 64)), npst.integer_dtypes(), npst.unsigned_integer_dtypes(),
                  npst.boolean_dtypes(), npst.complex_number_dtypes(), npst.unicode_string_dtypes(max_len=3))
NAMES = r"^(xyz|uv|weights|normals|control_points|nan_policy|row|rows|point|points|all \d|no points|a grid|\d|column)"


@quick
@given(xyz=npst.arrays(kinds, npst.array_shapes(max_dims=4, max_side=7)),
       uv=st.none() | npst.arrays(st.sampled_from([np.float64, np.float32]), npst.array_shapes(max_dims=3, max_side=7)),
       policy=st.sampled_from(["raise", "omit"]))
def test_whatever_comes_in_is_fitted_or_refused_by_name(xyz, uv, policy):
    try:
        fit = knotfit.fit(xyz, uv, control_points=4, knots="uniform", between=False, nan_policy=policy, correct=False)
    except (ValueError, TypeError) as e:
        assert str(e) and "--" not in str(e) and "`" not in str(e)
    else:
        assert fit.surface.size == (4, 4) and len(fit.errors) == len(xyz)


@quick
@given(data=st.data(), dtype=st.sampled_from(["<f8", ">f8", "<f4", ">f4", "<i4", ">i2", "u1", "f2"]),
       n=st.integers(16, 60), d=st.integers(1, 5), order=st.sampled_from("CF"), step=st.integers(1, 3))
def test_every_layout_is_taken_by_its_numbers(data, dtype, n, d, order, step):
    values = data.draw(npst.arrays(np.dtype(dtype), (n * step, d),
                                   elements={"min_value": 0, "max_value": 100}))
    values = np.asarray(values, order=order)[::step]
    uv = np.random.default_rng(n).random((n, 2))

    def found(array):
        try:
            fit = knotfit.fit(array, uv, control_points=4, knots="uniform", between=False)
        except ValueError as e:  # values that are all equal, or one far off
            return str(e)
        return fit.surface, fit.errors.tobytes()

    assert found(values) == found(np.ascontiguousarray(values, dtype=np.float64))


@quick
@given(u=npst.arrays(np.float64, npst.array_shapes(max_dims=3, max_side=4), elements=st.floats(0, 1)),
       shapes=npst.mutually_broadcastable_shapes(num_shapes=2, max_dims=3, max_side=4))
def test_places_broadcast_as_numpy_does(fixed, u, shapes):
    a, b = (np.resize(u, shape) for shape in shapes.input_shapes)
    values = fixed.surface(a, b)
    assert values.shape == (*shapes.result_shape, 3)
    wide = np.broadcast_arrays(a, b)
    for index in np.ndindex(*shapes.result_shape):
        assert (values[index] == fixed.surface(wide[0][index], wide[1][index])).all()


def test_names_are_in_messages_of_mistaken_shapes():
    for arguments in [(np.zeros(3),), (np.zeros((3, 2)),), (np.zeros((3, 3)), np.zeros((3, 3)))]:
        with pytest.raises(ValueError) as raised:
            knotfit.fit(*arguments)
        assert re.match(NAMES, str(raised.value))
