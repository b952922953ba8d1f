"""Profiles: the same numbers as the command, to the last digit."""

import pickle

import numpy as np
import pytest

import rough_contact as rc

from test_compare import timeless


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
        # Against numpy: Pq is the rms height of the trace without its line, behind the Gaussian filter of 2.5 µm.
        x = np.arange(8000)
        rest = heights - np.polyval(np.polyfit(x, heights, 1), x)
        weights = np.exp(-np.pi * (np.arange(-7, 8) * 0.5 / 2.5) ** 2 / (np.log(2) / np.pi))
        rest = np.convolve(rest, weights, "same") / np.convolve(np.ones(8000), weights, "same")
        assert found.primary["Pq"] == pytest.approx(1e-6 * rest.std(), rel=1e-6)
        # The waves longer than the cut-off carry little of it.
        assert 0.8 * found.primary["Pa"] < found.roughness["Ra"] < found.primary["Pa"]
        assert repr(found) == "Profile(1 trace of 8000 points, 500 nm apart)"


@pytest.mark.parametrize("name", ["gw", "bgt", "greenwood-elliptical", "persson", "stacked", "multiscale"])
def test_closed_forms(command, trace, name):
    path, _ = trace
    ask = ["--modulus", "110GPa", "--pressure", "1MPa,100MPa,1GPa", "--level", "quadratic"]
    theirs = command("model", name, path, *UNITS, *ask)
    theirs.pop("error", None)
    profile = rc.read_profile(path, layout="list", lateral_unit="um", height_unit="um")
    ours = rc.model(name, profile, modulus="110 GPa", pressure="1MPa,100MPa,1GPa", level="quadratic")
    assert ours.to_dict() == theirs and len(theirs["points"]) == 3
    again = pickle.loads(pickle.dumps(profile))
    assert again.to_dict() == profile.to_dict() and again.name == "trace.txt"


def test_study(command, trace, tmp_path):
    path, _ = trace
    words = ["--s-filter", "5um", "--l-filter", "250um"]
    theirs = command("compare", path, *UNITS, *words, "--modulus", "110GPa", "--out", tmp_path / "a")
    profile = rc.read_profile(path, layout="list", lateral_unit="um", height_unit="um", s_filter="5um", l_filter="250um")
    study = rc.compare_profiles(profile, modulus="110 GPa")
    assert "error" not in theirs and timeless(study.to_dict()) == timeless(theirs)
    study.write(tmp_path / "b")
    names = [sorted(p.name for p in (tmp_path / d).iterdir()) for d in "ab"]
    assert names[0] == names[1] and "area.svg" in names[0]
    for name in ["curves.csv", "area.svg", "trace.svg"]:
        assert (tmp_path / "a" / name).read_bytes() == (tmp_path / "b" / name).read_bytes()
    # The models answer as they do alone, and the run can be repeated by the command.
    gw = next(m for m in study["trace.txt"]["models"] if m["model"] == "gw")
    pressures = [p["mean_pressure"] for p in gw["points"]]
    alone = rc.model("gw", profile, modulus="110 GPa", pressure=np.array(pressures) * rc.units.Pa)
    assert [p["area_fraction"] for p in gw["points"]] == alone.area_fraction.tolist()
    again = command("compare", "--from", tmp_path / "b" / "run.toml", "--out", tmp_path / "c")
    assert timeless(again["profiles"]) == timeless(theirs["profiles"])
    assert "trace.txt: area" in repr(study) and list(study) == ["trace.txt"]
    one = rc.compare_profiles({"a": profile, "b": profile}, modulus="110 GPa", pressure="1MPa,100MPa", models=["gw"], headline="100MPa")
    assert len(one) == 2 and one["b"]["headline_pressure"] == 1e8 and "area-2.svg" in one.files


def test_a_study_of_profiles_refuses(trace, rough):
    path, _ = trace
    profile = rc.read_profile(path, layout="list", lateral_unit="um", height_unit="um")
    with pytest.raises(TypeError, match="rc.Profile"):
        rc.compare_profiles(rough, modulus="110 GPa")
    with pytest.raises(rc.SettingError, match="headline|computed"):
        rc.compare_profiles(profile, modulus="110 GPa", pressure="1MPa", headline="2MPa")
    with pytest.raises(rc.SettingError, match="nobody"):
        rc.compare_profiles(profile, modulus="110 GPa", models=["nobody"])


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


def test_profiles_of_arrays(tmp_path):
    rng = np.random.default_rng(1)
    heights = np.convolve(rng.normal(size=8200), np.hanning(60), "same")[100:8100] * 0.05
    path = tmp_path / "trace.txt"
    np.savetxt(path, np.column_stack([np.arange(8000) * 0.5, heights]), fmt="%.17g")
    read = rc.read_profile(path, layout="list", lateral_unit="um", height_unit="um")
    made = rc.Profile.of(heights, spacing="0.5um", height_unit="um")
    assert np.allclose(made.heights, read.heights, rtol=1e-15) and made.spacing == pytest.approx(read.spacing)
    assert made.roughness == pytest.approx(read.roughness, rel=1e-9)
    assert (rc.Profile.of(heights * rc.units.um, spacing="0.5um").heights == made.heights).all()
    assert rc.Profile.of(np.stack([heights, heights[::-1]]) * rc.units.um, spacing="0.5um").heights.shape == (2, 8000)
    # Whatever the traces are, they are taken as they are.
    tiny = rc.Profile.of(heights * 1e-9 / 3, spacing="0.5um", height_unit="m")
    assert (tiny.heights == heights * 1e-9 / 3).all() and tiny.spacing == 0.5e-6
    options = {"s_filter": "5um", "l_filter": "250um", "level": "quadratic"}
    again = rc.read_profile(path, layout="list", lateral_unit="um", height_unit="um", **options)
    there = rc.Profile.of(heights, spacing="0.5um", height_unit="um", **options)
    assert there.roughness == pytest.approx(again.roughness, rel=1e-9) and there.roughness["Rq"] != made.roughness["Rq"]
    for wrong in ("0um", "-1um"):
        with pytest.raises(rc.SurfaceError):
            rc.Profile.of(heights, spacing=wrong, height_unit="um")
    with pytest.raises(rc.SurfaceError, match="dimensions"):
        rc.Profile.of(heights.reshape(2, 2, -1), spacing="1um", height_unit="um")
    with pytest.raises(rc.SurfaceError):
        rc.Profile.of(np.where(np.arange(8000) == 7, np.inf, heights), spacing="1um", height_unit="um")
    holed = np.ma.masked_array(heights, mask=np.arange(8000) == 7)
    with pytest.raises(rc.MissingPoints, match="fill='nearest'$"):
        rc.Profile.of(holed * rc.units.um, spacing="0.5um")
    assert rc.Profile.of(holed * rc.units.um, spacing="0.5um", fill="nearest").to_dict()["missing"] == 1
    assert "<table>" in made._repr_html_() and "Ra" in made._repr_html_()
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    assert "um" in made.plot().get_ylabel()


def test_a_profile_of_xarray_is_told_by_its_dimensions():
    xarray = pytest.importorskip("xarray")
    heights = np.random.default_rng(0).normal(size=(3, 2000)).cumsum(1)
    expected = rc.Profile.of(heights, spacing="0.5um", height_unit="nm")
    made = xarray.DataArray(heights, {"trace": [0.0, 1.0, 5.0], "x": 0.5 * np.arange(2000)}, ("trace", "x"), attrs={"units": "nm"})
    made.x.attrs["units"] = "um"
    for given in (made, made.T, made.drop_vars("x").T):
        found = rc.Profile.of(given, spacing="0.5um")
        assert (found.heights == expected.heights).all() and found.spacing == expected.spacing
    one = rc.Profile.of(made[1].drop_vars("trace"), spacing="0.5um")
    assert (one.heights == expected.heights[1]).all()
    for given in (made, made.T, made[1], made[1].rename(x="y")):
        with pytest.raises(rc.SurfaceError, match="spacing = 1e-06 m along x"):
            rc.Profile.of(given, spacing="1um")
