"""Arrays, files, units, and the surfaces of other packages."""

import copy
import pickle
from types import SimpleNamespace

import numpy as np
import pytest

import rough_contact as rc


def ramp(ny=5, nx=7):
    """h = 1 nm x ix + 100 nm x iy: a flip, a transposition and a lost unit all show."""
    return 1.0 * np.arange(nx) + 100.0 * np.arange(ny)[:, None]


def test_arrays_of_every_kind_are_one():
    one = rc.Surface(ramp(), pixel=["3um", "2um"], height_unit="nm")
    assert one.shape == (5, 7) and one.pixel == (3e-6, 2e-6)
    assert one.heights[4, 6] == 406e-9 and one.heights.flags.c_contiguous
    others = [
        rc.Surface(ramp().astype(np.float32), pixel=["3um", "2um"], height_unit="nm"),
        rc.Surface(ramp().astype(np.int16), pixel=(3 * rc.units.um, 2 * rc.units.um), height_unit="nm"),
        rc.Surface(np.asfortranarray(ramp()), pixel="2um,3um", height_unit="nm"),
        rc.Surface(ramp().tolist(), pixel=["3um", "2um"], height_unit="nm"),
        rc.Surface(ramp() * rc.units.nm, pixel=np.array([3, 2]) * rc.units.um),
        rc.Surface(ramp()[::-1][::-1], pixel=["3um", "2um"], height_unit="nm"),
    ]
    for other in others:
        assert other == one
    assert rc.Surface(ramp().T, pixel=["2um", "3um"], height_unit="nm") != one


def test_masked_points_are_missing():
    """A mask that is lost would make a height of whatever lies under it."""
    heights = np.ma.masked_array(ramp(), mask=False)
    heights[2, 3] = np.ma.masked
    heights.data[2, 3] = 1e9
    with pytest.raises(rc.MissingPoints, match="fill='harmonic'"):
        rc.Surface(heights, pixel="1um", height_unit="nm")
    filled = rc.Surface(heights, pixel="1um", height_unit="nm", fill="harmonic")
    assert filled.missing == 1
    assert filled.heights[2, 3] == pytest.approx(203e-9, rel=1e-9)  # a ramp solves Laplace's equation
    nan = ramp()
    nan[2, 3] = np.nan
    assert rc.Surface(nan, pixel="1um", height_unit="nm", fill="harmonic") == filled
    whole = np.ma.masked_array(ramp().astype(int), mask=np.isnan(nan))
    assert rc.Surface(whole, pixel="1um", height_unit="nm", fill="harmonic") == filled


@pytest.mark.parametrize(
    ("arguments", "error"),
    [
        ({"heights": ramp(), "pixel": "1um"}, rc.UnitError),
        ({"heights": ramp(), "pixel": 1e-6, "height_unit": "nm"}, rc.UnitError),
        ({"heights": ramp(), "pixel": "1MPa", "height_unit": "nm"}, rc.UnitError),
        ({"heights": ramp(), "pixel": "-1um", "height_unit": "nm"}, rc.SurfaceError),
        ({"heights": ramp()[0], "pixel": "1um", "height_unit": "nm"}, rc.SurfaceError),
        ({"heights": ramp()[:1], "pixel": "1um", "height_unit": "nm"}, rc.SurfaceError),
        ({"heights": ramp() * np.nan, "pixel": "1um", "height_unit": "nm", "fill": "nearest"}, rc.SurfaceError),
        ({"heights": ramp() * 1j, "pixel": "1um", "height_unit": "nm"}, TypeError),
        ({"heights": ramp() > 3, "pixel": "1um", "height_unit": "nm"}, TypeError),
        ({"heights": np.full((5, 7), "a"), "pixel": "1um", "height_unit": "nm"}, TypeError),
        ({"heights": np.full((5, 7), np.inf), "pixel": "1um", "height_unit": "nm"}, rc.SurfaceError),
    ],
)
def test_refused_arrays(arguments, error):
    with pytest.raises(error):
        rc.Surface(**arguments)


def test_a_surface_does_not_change(rough):
    with pytest.raises(AttributeError):
        rough.pixel = (1, 1)
    with pytest.raises(ValueError):
        rough.heights[0, 0] = 0
    mine = rough.heights.copy()
    mine[0, 0] = 0
    assert np.asarray(rough) is rough.heights


@pytest.mark.parametrize("protocol", [2, 5])
def test_pickles(rough, protocol):
    text = pickle.dumps(rough, protocol)
    again = pickle.loads(text)
    assert again == rough and hash(again) == hash(rough) and not again.heights.flags.writeable
    assert protocol == 2 or len(text) < rough.heights.nbytes + 2000
    assert again.statistics().to_dict() == rough.statistics().to_dict()
    for value in (rc.Body(young="210GPa", poisson=0.3, hardness="2GPa", name="steel"), rough.statistics(), rc.units.GPa):
        assert pickle.loads(pickle.dumps(value, protocol)) == value or value is rc.units.GPa


@pytest.mark.parametrize("ending", ["x3p", "sdf", "txt", "npy"])
def test_files_there_and_back(rough, tmp_path, ending):
    path = tmp_path / f"map.{ending}"
    rough.write(path)
    with pytest.raises(FileExistsError):
        rough.write(path)
    rough.write(path, overwrite=True)
    said = {"pixel": "1um", "height_unit": "m"} if ending == "npy" else {}
    again = rc.read(path, **said)
    np.testing.assert_array_equal(again.heights, rough.heights)
    assert again.pixel == pytest.approx(rough.pixel, rel=1e-12) and again.name == path.name


def test_refused_files(tmp_path, rough):
    with pytest.raises(FileNotFoundError):
        rc.read(tmp_path / "none.x3p")
    bad = tmp_path / "bad.x3p"
    bad.write_bytes(b"PK\x03\x04 nothing")
    with pytest.raises(rc.ReadError):
        rc.read(bad)
    path = tmp_path / "map.npy"
    rough.write(path)
    with pytest.raises(rc.ReadError, match="pixel='1um'.*height_unit='um'"):
        rc.read(path)
    with pytest.raises(rc.SettingError, match="ending"):
        rough.write(tmp_path / "map.doc")
    with pytest.raises(rc.ReadError, match="profile"):
        rc.read(path, pixel="1um", height_unit="m", crop=(0, 0, 1, 9))
    assert rc.read(path, pixel="1um", height_unit="m", crop="middle").shape == tuple(-(-n // 2) for n in rough.shape)
    with pytest.raises(rc.ReadError, match="complete"):
        rc.read(path, pixel="1um", height_unit="m", crop="half")  # type: ignore[arg-type]
    np.save(path, np.where(ramp() > 300, np.nan, ramp()))
    assert rc.read(path, pixel="1um", height_unit="m", crop="complete").shape == (3, 7)
    with pytest.raises(rc.MissingPoints):
        rc.read(path, pixel="1um", height_unit="nm")


def test_parts(rough):
    part = rough.cropped(3, 5, 10, 20)
    np.testing.assert_array_equal(part.heights, rough.heights[3:13, 5:25])
    with pytest.raises(rc.SurfaceError):
        rough.cropped(60, 0, 10, 10)
    flat = rough.levelled("plane")
    y, x = np.mgrid[0:64, 0:48]
    basis = np.stack([np.ones(x.size), x.ravel(), y.ravel()], axis=1)
    fit = basis @ np.linalg.lstsq(basis, rough.heights.ravel(), rcond=None)[0]
    np.testing.assert_allclose(flat.heights.ravel(), rough.heights.ravel() - fit, atol=1e-18)


def test_statistics_against_numpy(rough):
    s = rough.levelled("mean")
    found = s.statistics(level="none")
    h = s.heights
    assert found.rms_height == pytest.approx(np.sqrt(np.mean(h**2)), rel=1e-12)
    assert found.mean_abs_height == pytest.approx(np.abs(h).mean(), rel=1e-12)
    assert found.peak_height == pytest.approx(h.max(), rel=1e-12)
    assert found.kurtosis == pytest.approx(np.mean(h**4) / np.mean(h**2) ** 2, rel=1e-12)
    assert found.units()["m4"] == "m-2"
    series = found.to_pandas()
    assert series["m2"] == found.m2 and series.attrs["units"]["m0"] == "m2"


def test_units_of_other_packages(rough):
    pint = pytest.importorskip("pint")
    u = pint.UnitRegistry()
    plain = rc.solve(rough, modulus="110 GPa", pressure="100MPa").area_fraction
    assert rc.solve(rough, modulus=110 * u.GPa, pressure=[100] * u.MPa).area_fraction == plain
    with pytest.raises(rc.UnitError):
        rc.solve(rough, modulus=110 * u.GPa, pressure=3 * u.metre)
    with pytest.raises(rc.UnitError):
        rc.solve(rough, modulus="110 GPa", pressure="1MPa", tolerance=1 * u.metre)
    s = rc.Surface(ramp() * u.nm, pixel=1 * u.um)
    assert s.heights[4, 6] == pytest.approx(406e-9, rel=1e-14)


def test_astropy(rough):
    units = pytest.importorskip("astropy.units")
    found = rc.solve(rough, modulus=110 * units.GPa, pressure=[0.1, 1] * units.GPa)
    assert found.mean_pressure == pytest.approx([1e8, 1e9])


def test_xarray():
    xarray = pytest.importorskip("xarray")
    s = rc.Surface(ramp(), pixel=["3um", "2um"], height_unit="nm")
    again = rc.Surface.of(s.to_xarray())
    np.testing.assert_array_equal(again.heights, s.heights)
    assert again.pixel == pytest.approx(s.pixel, rel=1e-12)
    uneven = s.to_xarray().assign_coords(x=np.arange(7.0) ** 2)
    with pytest.raises(rc.SurfaceError, match="evenly"):
        rc.Surface.of(uneven)
    bare = xarray.DataArray(ramp(), dims=("y", "x"))
    with pytest.raises(rc.UnitError, match="height_unit"):
        rc.Surface.of(bare)
    assert rc.Surface.of(bare, height_unit="nm", pixel=["3um", "2um"]) == s


def test_surface_topography_keeps_x_first():
    st = pytest.importorskip("SurfaceTopography")
    topography = st.Topography(ramp().T, (7 * 2.0, 5 * 3.0), unit="um")
    s = rc.Surface.of(topography)
    assert s.shape == (5, 7) and s.pixel == pytest.approx((3e-6, 2e-6))
    assert s.heights[4, 6] == pytest.approx(406e-6)
    with pytest.raises(rc.UnitError, match="height_unit"):
        rc.Surface.of(st.Topography(ramp().T, (14.0, 15.0)))


def test_surfalize():
    surfalize = pytest.importorskip("surfalize")
    s = rc.Surface.of(surfalize.Surface(ramp() / 1000, 2.0, 3.0))
    assert s.pixel == (3e-6, 2e-6) and s.heights[4, 6] == pytest.approx(406e-9)


def test_anything_else_is_no_surface(rough):
    with pytest.raises(TypeError, match="SurfaceTopography"):
        rc.Surface.of(SimpleNamespace(a=1))
    with pytest.raises(TypeError, match="rc.Surface"):
        rc.solve(rough.heights, modulus="1GPa", pressure="1MPa")


def test_plots(rough):
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    axes = rough.plot(unit="mm")
    assert "mm" in axes.get_xlabel()
    plt.figure()
    axes = rc.solve(rough, modulus="110 GPa", pressure="1MPa,100MPa,1GPa").plot()
    assert axes.get_xlabel() == "mean pressure (MPa)"
    plt.close("all")


def test_files_in_memory(rough, file, tmp_path):
    import io

    content = file.read_bytes()
    expected = rc.read(file)
    with open(file, "rb") as opened:
        sources = [content, bytearray(content), memoryview(content), io.BytesIO(content), opened]
        found = [rc.read(source) for source in sources]
    assert all(surface == expected for surface in found)
    assert [surface.name for surface in found] == ["bytes"] * 4 + ["rough.x3p"]
    assert rc.info(content)["format"] == rc.info(file)["format"]
    with pytest.raises(TypeError, match="'rb'"):
        rc.read(io.StringIO("1 2\n3 4"))
    with pytest.raises(rc.ReadError):
        rc.read(b"this is no surface")


def test_cleaning_in_memory_is_that_of_reading(rough, tmp_path):
    heights = rough.heights.copy()
    heights[10, 20] += 1e-4
    heights += 1e-7 * np.random.default_rng(1).normal(size=(64, 1))
    s = rc.Surface(heights, pixel="1um", height_unit="m")
    s.write(tmp_path / "map.x3p")
    for how in (
        {"outliers": 8, "fill": "harmonic"}, {"align_rows": True}, {"form": "plane"}, {"form": "polynomial:3", "s_filter": "4um"}, {"l_filter": "20um"},
    ):
        there, here = rc.read(tmp_path / "map.x3p", **how), s.cleaned(**how)
        assert here == there and here.cleaning == there.cleaning and here.cleaning
    with pytest.raises(rc.MissingPoints):
        s.cleaned(outliers=8)
    assert s.cleaned(outliers=8, fill="nearest").missing == 1
    assert (s.scaled(2.5).heights == 2.5 * s.heights).all() and s.scaled(2.5).pixel == s.pixel
    # What was known before stays known.
    clean = s.cleaned(outliers=8, fill="harmonic")
    for again in (clean.scaled(2.0), clean.cropped(0, 0, 32, 32), clean.levelled()):
        assert again.missing == 1 and again.cleaning == clean.cleaning
    twice = clean.cleaned(form="plane")
    assert twice.missing == 1 and [step["step"] for step in twice.cleaning] == [*(step["step"] for step in clean.cleaning), "form"]


def test_what_repeats_goes_on_repeating(rough, tmp_path):
    x = np.random.default_rng(0).normal(size=(64, 64)).cumsum(0)
    given = rc.Surface(x, pixel="1um", height_unit="nm", repeats=np.True_)
    for s in (given, rough, given.levelled("mean")):
        for same in (s.scaled(1.0), s.cleaned(outliers=1e6), s.levelled("none").scaled(1.0), pickle.loads(pickle.dumps(s)).scaled(1.0), s.cropped(0, 0, *s.shape)):
            assert same == s or same.shape == s.shape
            found, wanted = same.statistics(), s.statistics()
            assert (found.level, found.boundary, found.rms_gradient) == (wanted.level, "periodic", pytest.approx(wanted.rms_gradient, rel=1e-9))
        for less in (s.cropped(0, 0, 32, 48), s.cleaned(s_filter="4um"), s.cropped(0, 0, 32, 32).scaled(1.0)):
            assert less.statistics().boundary == "open"
    assert rc.Surface(x, pixel="1um", height_unit="nm").scaled(1.0).statistics().boundary == "open"
    rough.write(tmp_path / "map.x3p")
    assert rc.read(tmp_path / "map.x3p").scaled(1.0).statistics().boundary == "open"


def test_what_is_handed_out_changes_nothing(rough):
    first = rough.statistics(scales=True)
    for change in (lambda s: s.asperities.update(radius=1.0), lambda s: s.json.update(m0=1.0), lambda s: s.summits.clear()):
        change(rough.statistics(scales=True))
    assert rough.statistics(scales=True) == first and rough.statistics(scales=True).to_dict() == first.to_dict()
    curve = rc.solve(rough, modulus="110 GPa", pressure="100MPa,1GPa", maps=True)
    profile = rc.Profile.of(np.sin(np.arange(800) / 50), spacing="0.5 um", height_unit="um")
    study = rc.compare(rough, modulus="110 GPa", pressure="100MPa,1GPa", models="gw")["synth 7"].models["gw"]
    f = rc.ClosedForm("gw", rough, modulus="110 GPa")
    before = curve.to_dict()
    curve[0].residuals.clear()
    assert curve.to_dict() == before

    def handed_out(copied):
        yield from copied(first).scales["x"].values()
        yield from (copied(profile).heights, copied(curve).pressure(0), copied(curve[0]).pressure, copied(curve[0]).gap, copied(study).area_error.signed)

    for copied in (lambda x: x, copy.deepcopy, lambda x: pickle.loads(pickle.dumps(x))):
        assert not any(array.flags.writeable for array in handed_out(copied))
    others = (*rough.psd(), *rough.bearing_curve(), curve.bars(), curve.spots(0), curve.displacement(0), study.area_fraction, f("1MPa"), f.mean_gap("1MPa"))
    assert not any(array.flags.writeable for array in others)


def test_bearing_curve(rough):
    heights, fraction = rough.bearing_curve()
    level = np.median(rough.heights)
    assert fraction[np.searchsorted(-heights, -level, side="right") - 1] == pytest.approx((rough.heights >= level).mean())


def test_power_spectrum(rough):
    """The variance is that of the map, and one wave stands at its wavenumber."""
    q, c = rough.psd()
    assert (np.diff(q) > 0).all() and (c >= 0).all()
    variance = np.trapezoid(2 * np.pi * q * c, q)
    assert variance == pytest.approx(rough.statistics(level="mean").rms_height ** 2, rel=0.1)
    x = 2 * np.pi * np.arange(64) / 64
    wave = rc.Surface(np.tile(np.cos(5 * x), (64, 1)), pixel="1um", height_unit="nm", repeats=True)
    q, c = wave.psd()
    assert q[np.argmax(c)] == pytest.approx(5 * 2 * np.pi / 64e-6, rel=1e-6)


def test_scales_against_numpy(rough):
    """Autocorrelation by a padded FFT, slope and curvature by differences, along both axes."""
    found = rough.statistics(level="mean", scales=True).scales
    h = rough.heights - rough.heights.mean()
    for axis, z in (("x", h), ("y", h.T)):
        n = z.shape[1]
        correlation = np.fft.irfft(np.abs(np.fft.rfft(z, 2 * n)) ** 2).sum(axis=0) / z.var() / z.shape[0]
        scales = found[axis]
        lags = np.rint(scales["distance"] / 1e-6).astype(int)
        np.testing.assert_allclose(scales["autocorrelation"], correlation[lags] / (n - lags), atol=1e-9)
        for i, (lag, d) in enumerate(zip(lags, scales["distance"])):
            assert scales["slope"][i] == pytest.approx(np.sqrt(np.mean((z[:, lag:] - z[:, :-lag]) ** 2)) / d, rel=1e-9)
            bend = z[:, 2 * lag :] - 2 * z[:, lag : n - lag] + z[:, : n - 2 * lag]
            expected = np.sqrt(np.mean(bend**2)) / d**2 if bend.size else np.nan
            assert scales["curvature"][i] == pytest.approx(expected, rel=1e-9, nan_ok=True)
