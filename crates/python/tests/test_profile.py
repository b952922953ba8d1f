"""Profiles: the same numbers as the command, to the last digit."""

import numpy as np
import pytest

import rough_contact as rc


@pytest.fixture(scope="module")
def trace(tmp_path_factory):
    """A trace of 4 mm in two columns, and its heights."""
    made = rc.synth((4, 8000), pixel="0.5um", hurst=0.8, rolloff="100um", cutoff="5um", rms_height="0.3um", seed=5)
    x = np.arange(8000) * 0.5
    heights = made.heights[1] * 1e6 + 1e-4 * x  # um, tilted
    path = tmp_path_factory.mktemp("traces") / "trace.txt"
    np.savetxt(path, np.column_stack([x, heights]), fmt="%.9f")
    return path, heights


OPTIONS = {
    "as it is": ([], {}),
    "filters": (["--s-filter", "5um", "--l-filter", "250um"], {"s_filter": "5um", "l_filter": "250um"}),
    "parabola": (["--level", "quadratic"], {"level": "quadratic"}),
    "cleaned": (["--outliers", "8", "--fill", "nearest", "--form", "polynomial:3"], {"outliers": 8, "fill": "nearest", "form": "polynomial:3"}),
}
UNITS = ["--layout", "list", "--lateral-unit", "um", "--height-unit", "um"]


@pytest.mark.parametrize("case", OPTIONS)
def test_statistics(command, trace, case):
    words, arguments = OPTIONS[case]
    path, heights = trace
    theirs = command("stats", path, *UNITS, *words)
    found = rc.read_profile(path, layout="list", lateral_unit="um", height_unit="um", **arguments)
    assert "error" not in theirs
    assert found.to_dict() == theirs
    assert found.heights.shape == (1, 8000) and found.spacing == pytest.approx(5e-7)
    if case == "as it is":
        assert np.allclose(found.heights[0] - found.heights[0].mean(), 1e-6 * (heights - heights.mean()), atol=1e-12)
        assert not found.heights.flags.writeable
        # Against numpy: Pq is the rms height of the trace without its line.
        x = np.arange(8000)
        rest = heights - np.polyval(np.polyfit(x, heights, 1), x)
        assert found.primary["Pq"] == pytest.approx(1e-6 * rest.std(), rel=1e-6)
        # The waves longer than the cut-off carry little of it.
        assert 0.8 * found.primary["Pa"] < found.roughness["Ra"] < found.primary["Pa"]
        assert repr(found) == "Profile(1 trace of 8000 points, 500 nm apart)"


def test_what_is_refused(trace, file):
    path, _ = trace
    with pytest.raises(rc.ReadError, match="this is a map; read it with rc.read"):
        rc.read_profile(file)
    with pytest.raises(rc.ReadError, match="rc.read_profile"):
        rc.read(path, layout="list", lateral_unit="um", height_unit="um")
    with pytest.raises(rc.ReadError, match="forms of maps"):
        rc.read_profile(path, layout="list", lateral_unit="um", height_unit="um", form="sphere")
    with pytest.raises(rc.ReadError, match="lateral_unit"):
        rc.read_profile(path, layout="list")
