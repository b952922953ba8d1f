"""Every way in gives the same surface, the same loads, or is refused: nothing is dropped without a word."""

import inspect
import itertools
import math

import numpy as np
import pytest

import rough_contact as rc

um, MPa = rc.units.um, rc.units.MPa
MICRONS = np.arange(35.0).reshape(5, 7) % 11
HOLE = (2, 3)


def with_hole(under=np.nan):
    heights = MICRONS.copy()
    heights[HOLE] = under
    return heights


def masked(_=None):
    return np.ma.masked_array(with_hole(-9999.0), mask=np.isnan(with_hole()))


def frame():
    return pytest.importorskip("pandas").DataFrame(with_hole())


def data_array(**attrs):
    return pytest.importorskip("xarray").DataArray(with_hole(), dims=("y", "x"), attrs=attrs)


CONTAINERS = {
    "array": with_hole,
    "float32": lambda: with_hole().astype(np.float32),
    "masked": masked,
    "masked whole numbers": lambda: masked().astype(int),
    "list of rows": lambda: with_hole().tolist(),
    "list of masked rows": lambda: list(masked()),
    "tuple with None": lambda: tuple(tuple(None if np.isnan(h) else h for h in row) for row in with_hole()),
    "objects": lambda: with_hole().astype(object),
    "masked objects": lambda: masked().astype(object),
    "frame": frame,
    "frame with NA": lambda: frame().astype("Int64"),
    "xarray": data_array,
    "xarray x first": lambda: data_array().T,
}


def by_pint(values):
    return pytest.importorskip("pint").UnitRegistry().Quantity(values, "um")


def by_astropy(values):
    return values * pytest.importorskip("astropy.units").um


def with_attrs(values):
    return values.assign_attrs(units="um")


#: Keywords of each way, and whether it may refuse what it does not know.
WAYS = {
    "unit on the right": (lambda v: {"heights": v * um}, False),
    "unit on the left": (lambda v: {"heights": um * v}, False),
    "keyword": (lambda v: {"heights": v, "height_unit": "um"}, False),
    "attrs": (lambda v: {"heights": with_attrs(v)}, True),
    "attrs and keyword": (lambda v: {"heights": with_attrs(v), "height_unit": "um"}, True),
    "attrs and another keyword": (lambda v: {"heights": with_attrs(v), "height_unit": "nm"}, True),
    "unit and keyword": (lambda v: {"heights": v * um, "height_unit": "nm"}, True),
    "pint": (lambda v: {"heights": by_pint(v)}, True),
    "pint on the right": (lambda v: {"heights": v * by_pint(1.0).units}, True),
    "pint on the left": (lambda v: {"heights": by_pint(1.0).units * v}, True),
    "pint and keyword": (lambda v: {"heights": by_pint(v), "height_unit": "nm"}, True),
    "astropy": (lambda v: {"heights": by_astropy(v)}, True),
    "bare": (lambda v: {"heights": v}, True),
}


#: Packages that drop a mask before anybody sees it.
DROPPED = {("masked", "astropy"), ("masked whole numbers", "astropy"), ("masked objects", "astropy")} | {
    ("list of masked rows", way) for way in ("pint", "pint on the right", "pint on the left", "astropy")
}


@pytest.mark.parametrize(("container", "way"), [pair for pair in itertools.product(CONTAINERS, WAYS) if pair not in DROPPED])
@pytest.mark.filterwarnings("ignore")
def test_heights(container, way):
    expected = rc.Surface(with_hole(), pixel="1um", height_unit="um", fill="harmonic")
    make, may_refuse = WAYS[way]
    try:
        arguments = make(CONTAINERS[container]())
    except Exception:
        assert may_refuse  # the other package does not do it
        return
    refused = (rc.UnitError, rc.SurfaceError, TypeError)
    try:
        found = rc.Surface(**arguments, pixel="1um", fill="harmonic")
    except refused:
        assert may_refuse
        return
    assert way not in ("bare", "attrs and another keyword", "unit and keyword", "pint and keyword")
    assert found.missing == 1 and found == expected


@pytest.mark.parametrize("way", ["pint", "astropy", "attrs", "attrs and keyword"])
def test_the_optional_ways_work_where_the_package_has_them(way):
    make, _ = WAYS[way]
    container = data_array if way.startswith("attrs") else with_hole
    found = rc.Surface(**make(container()), pixel="1um", fill="harmonic")
    assert found == rc.Surface(with_hole(), pixel="1um", height_unit="um", fill="harmonic")
    if way == "pint":
        assert rc.Surface(by_pint(masked()), pixel="1um", fill="harmonic") == found


@pytest.mark.parametrize("heights", [MICRONS > 3, MICRONS * 1j, MICRONS.astype(str), MICRONS.astype(str).astype(object)])
@pytest.mark.parametrize("how", ["unit on the right", "unit on the left", "keyword"])
def test_what_is_no_real_number_is_refused(heights, how):
    with pytest.raises(TypeError):
        rc.Surface(**WAYS[how][0](heights), pixel="1um")


def test_advice_for_an_array_names_what_it_takes():
    with pytest.raises(rc.MissingPoints, match="fill='harmonic'") as refused:
        rc.Surface(masked() * um, pixel="1um")
    taken = inspect.signature(rc.Surface).parameters
    assert all(name in taken for name in ("fill",)) and "crop" not in str(refused.value)


LOADS = {
    "array": np.array,
    "list": list,
    "tuple": tuple,
    "series": lambda v: pytest.importorskip("pandas").Series(v),
    "xarray": lambda v: pytest.importorskip("xarray").DataArray(v, dims="p"),
    "masked": lambda v: np.ma.masked_array(v, mask=False),
}


@pytest.mark.parametrize("kind", LOADS)
def test_loads(rough, kind):
    values = LOADS[kind]([10, 100, 200])
    for given in (values * MPa, MPa * values):
        found = rc.model("persson", rough, modulus="110 GPa", pressure=given)
        assert found.mean_pressure.tolist() == [1e7, 1e8, 2e8]
    with pytest.raises(rc.UnitError):
        rc.model("persson", rough, modulus="110 GPa", pressure=values)


def test_nan_among_loads_gives_nan(rough):
    pressure = np.array([10, np.nan, 100]) * MPa
    alone = rc.solve(rough, modulus="110 GPa", pressure="10MPa,100MPa", maps=True)
    curve = rc.solve(rough, modulus="110 GPa", pressure=pressure, maps=True)
    assert np.isnan(curve.area_fraction).tolist() == [False, True, False] and curve.converged.tolist() == [True, False, True]
    assert curve.area_fraction[[0, 2]].tolist() == alone.area_fraction.tolist()
    assert (curve.pressure(2) == alone.pressure(1)).all() and "NaN" in repr(curve) and "NaN" in curve._repr_html_()
    with pytest.raises(LookupError):
        curve.pressure(1)
    model = rc.model("persson", rough, modulus="110 GPa", pressure=np.ma.masked_invalid([10, np.nan, 100]) * MPa)
    assert np.isnan(model.area_fraction).tolist() == [False, True, False] and model.errors[1] is not None
    for call in (rc.solve, lambda s, **k: rc.model("gw", s, **k), rc.compare):
        with pytest.raises(rc.SettingError, match="nan"):
            call(rough, modulus="110 GPa", pressure=math.nan * MPa)


SYNTH = {"shape": (16, 16), "pixel": "1um", "hurst": 0.8, "rolloff": "8um", "cutoff": "4um", "rms_gradient": 0.1, "seed": 1}
CALLS = {
    "synth": (rc.synth, SYNTH),
    "solve": (rc.solve, {"modulus": "110 GPa", "pressure": "10MPa"}),
    "compare": (rc.compare, {"modulus": "110 GPa", "pressure": "10MPa"}),
    "model": (lambda s, **k: rc.model("persson", s, **k), {"modulus": "110 GPa", "pressure": "10MPa"}),
    "Solver": (lambda s, **k: rc.Solver(**k).solve(s, pressure="10MPa"), {"modulus": "110 GPa"}),
    "cleaned": (lambda s, **k: s.cleaned(**k), {}),
    "Body": (rc.Body, {"young": "1GPa", "poisson": 0.3}),
    "validate": (rc.validate, {}),
    "cropped": (lambda s, **k: s.cropped(**k), {"y0": 0, "x0": 0, "ny": 4, "nx": 4}),
    "Moments": (lambda s, **k: rc.model("gw", rc.Moments(**k), modulus="1GPa", pressure="1MPa"), {"m0": "1um^2", "m2": 0.1, "m4": "1um^-2"}),
    "SelfAffine": (
        lambda s, **k: rc.model("persson", rc.SelfAffine(**k), modulus="1GPa", pressure="1MPa"),
        {"hurst": 0.8, "rolloff": "1um", "cutoff": "1nm", "m0": "1um^2"},
    ),
}
#: Each with how its bad numbers are given, and the unit they would have.
NUMBERS = {
    "synth": {"pixel": um, "hurst": 1, "rolloff": um, "cutoff": um, "rms_gradient": 1, "seed": 1, "quantise": um, "shape": None},
    "solve": {
        "modulus": MPa, "pressure": MPa, "tolerance": 1, "accuracy": 1, "hardness": MPa, "threads": 1,
        "resistivity": rc.units.ohm * rc.units.m, "conductivity": rc.units.W / rc.units.m / rc.units.K,
        "work_of_adhesion": rc.units.J / rc.units.m**2,
    },
    "compare": {
        "modulus": MPa, "pressure": MPa, "headline": MPa, "tolerance": 1, "accuracy": 1, "hardness": MPa, "gamma": 1, "threads": 1,
        "fractal_range": um, "resistivity": rc.units.ohm * rc.units.m,
    },
    "model": {"modulus": MPa, "pressure": MPa, "gamma": 1},
    "Solver": {"modulus": MPa, "tolerance": 1, "hardness": MPa, "threads": 1},
    "cleaned": {"outliers": 1, "s_filter": um, "l_filter": um},
    "Body": {"young": MPa, "poisson": 1, "hardness": MPa},
    "validate": {"finest": 1},
    "cropped": {"y0": 1, "x0": 1, "ny": 1, "nx": 1},
    "Moments": {"m0": um**2, "m2": 1, "m4": um**-2},
    "SelfAffine": {"hurst": 1, "rolloff": um, "cutoff": um, "m0": um**2},
}
EACH = [(call, name, bad) for call, names in NUMBERS.items() for name in names for bad in (math.nan, math.inf, -math.inf, -3.5)]


@pytest.mark.parametrize(("call", "name", "bad"), EACH)
def test_a_number_out_of_range_is_an_error_with_a_name(rough, call, name, bad):
    function, arguments = CALLS[call]
    unit = NUMBERS[call][name]
    value = (bad, 16) if unit is None else bad * unit
    given = {**arguments, name: value}
    if name == "hardness" and bad == math.inf or call == "validate" and bad > 0 and math.isfinite(bad):
        return
    with pytest.raises((rc.Error, TypeError)) as refused:
        function(**given) if call in ("synth", "Body", "validate") else function(rough, **given)
    assert not isinstance(refused.value, rc.InternalError), refused.value


def test_units_multiply_compare_and_refuse():
    u = rc.units
    assert 1 * u.MPa == 1000 * u.kPa and 1 * u.GPa != 1 * u.m and (1 * u.um == 1) is False
    assert 2 * u.mm**2 == 2e-6 * u.m * u.m and (3e12 / u.m**2).si == 3e12
    assert (1.5 * u.um).si == 1.5e-6 and (u.um * [1, 2] / u.s)[1] == 2e-6 * u.m / u.s
    assert u.N / u.mm**2 == u.MPa and u.J / u.m**2 == u.N / u.m and 1 * u.kPa < 1 * u.MPa
    assert (1 * u.um + 1 * u.nm).si == pytest.approx(1.001e-6) and -(1 * u.Pa) < 0 * u.Pa
    with pytest.raises(rc.UnitError):
        1 * u.um + 1 * u.Pa  # noqa: B018
    with pytest.raises(rc.UnitError):
        1 * u.um < 1  # noqa: B015
    with pytest.raises(rc.UnitError, match="bare array"):
        np.asarray([1.0] * u.um)
    moments = rc.Moments(m0=0.36 * u.um**2, m2=0.006, m4=4e9 / u.m**2)
    assert moments == rc.Moments(m0="0.36um^2", m2=0.006, m4="4e9m^-2")
    with pytest.raises(rc.UnitError, match=r"3e12 m\^-2.*rc.units.m\*\*-2"):
        rc.Moments(m0="1um^2", m2=0.1, m4=4e9)


def test_every_unit_that_is_advised_exists():
    from rough_contact._units import _KINDS, _si

    for kind, (_, _, text, unit) in _KINDS.items():
        if kind == "number":
            continue
        made = eval(f"2 * rc.units.{unit}", {"rc": rc})  # as the refusal says it
        assert _si(made, kind, "x", False) > 0 and _si(text, kind, "x", False) > 0


@pytest.mark.parametrize("name", ["um", "m", "N", "bar", "Unit", "Quantity", "J_per_m2", "Finding", "ModelCurve"])
def test_old_names_say_where_they_are(name):
    assert name not in dir(rc)
    with pytest.raises(AttributeError, match=rf"rc\.{name} is now rc\.(units|results)"):
        getattr(rc, name)


def test_few_names():
    names = [name for name in dir(rc) if not name.startswith("_")]
    assert len(names) < 52
    assert all(hasattr(rc.results, name) for name in rc.results.__all__)


# Surfaces of xarray.


def tilted():
    return 1.0 * np.arange(7) + 100.0 * np.arange(5)[:, None]


def coordinates(dims=("y", "x"), unit="um", **attrs):
    xarray = pytest.importorskip("xarray")
    made = xarray.DataArray(tilted(), {"y": 3.0 * np.arange(5), "x": 2.0 * np.arange(7)}, ("y", "x"), attrs=attrs)
    for name in ("y", "x"):
        if unit:
            made[name].attrs["units"] = unit
    return made.transpose(*dims)


def test_dimension_names_tell_the_axes():
    s = rc.Surface.of(coordinates(units="nm"))
    assert s.pixel == (3e-6, 2e-6) and s == rc.Surface(tilted(), pixel=["3um", "2um"], height_unit="nm")
    turned = coordinates(dims=("x", "y"), units="nm")
    assert rc.Surface.of(turned) == s and rc.Surface(turned, pixel=["3um", "2um"]) == s
    named = coordinates(units="nm").rename(y="row", x="column")
    assert rc.Surface.of(named) == s and rc.Surface.of(named.T) == s
    with pytest.raises(rc.SurfaceError, match="one axis"):
        rc.Surface.of(coordinates(units="nm").rename(y="column"))


def test_coordinates_without_units_are_asked_for():
    bare = coordinates(unit=None, units="nm")
    with pytest.raises(rc.UnitError, match="coordinates along y have no unit"):
        rc.Surface.of(bare)
    assert rc.Surface.of(bare, pixel=["3um", "2um"]) == rc.Surface.of(coordinates(units="nm"))
    with pytest.raises(rc.SurfaceError, match="give pixel as they say"):
        rc.Surface.of(coordinates(units="nm"), pixel="1um")
    with pytest.raises(rc.SurfaceError, match="give pixel as they say"):
        rc.Surface(coordinates(units="nm"), pixel="1um")


def test_a_unit_with_a_number_is_that_many():
    expected = rc.Surface(tilted(), pixel=["3um", "2um"], height_unit="nm")
    for unit in ("1e-9 m", "1e-9m", "0.001 um", "+1 nm", " 1 nm "):
        assert np.allclose(rc.Surface.of(coordinates(units=unit)).heights, expected.heights, rtol=1e-15)
    ten = rc.Surface(coordinates(units="10 nm"), pixel=["3um", "2um"])
    assert np.allclose(ten.heights, expected.scaled(10.0).heights, rtol=1e-15)
    assert rc.Surface.of(coordinates(unit="1e-6 m", units="nm")).pixel == pytest.approx((3e-6, 2e-6))
    loads = pytest.importorskip("xarray").DataArray([1.0, 2.0], dims="p", attrs={"units": "10 MPa"})
    assert rc.model("persson", rc.Moments(m2=0.01), modulus="110 GPa", pressure=loads).mean_pressure.tolist() == [1e7, 2e7]
    for unit in ("0 nm", "-1 nm", "1e999 nm", "10", "e3nm", "nm 10", "1e-9"):
        with pytest.raises(rc.UnitError, match="heights"):
            rc.Surface(coordinates(units=unit), pixel=["3um", "2um"])
    with pytest.raises(rc.UnitError, match="coordinates along y"):
        rc.Surface.of(coordinates(unit="0 um", units="nm"))


@pytest.mark.parametrize("name", ["height_unit", "lateral_unit", "override_height_unit"])
def test_a_unit_that_is_typed_stands_alone(tmp_path, name):
    """As for the command: of `height_unit='10nm'` nobody knows what was meant."""
    path = tmp_path / "map.txt"
    np.savetxt(path, tilted())
    rest = {"pixel": "1um", "layout": "matrix"}
    for wrong, why in (("10nm", "'10nm' has a number in front; write .*='nm'"), ("0.1 nm", "number"), ("1e-9 m", "number"), (1e-6, "= 1e-06 is no unit"), ("", "''"), ("e3nm", "e3nm"), ("GPa", "length")):
        calls = [lambda: rc.read(path, **rest, **{name: wrong}), lambda: rc.info(path, **{name: wrong})]
        if name == "height_unit":
            calls.append(lambda: rc.Surface(tilted(), pixel="1um", height_unit=wrong))
            calls.append(lambda: rc.Profile.of(np.sin(np.arange(800)), spacing="1um", height_unit=wrong))
            calls.append(lambda: rc.Surface.of(coordinates(), height_unit=wrong))
        for call in calls:
            with pytest.raises(rc.UnitError, match=f"{name}.*{why}" if why != "length" else name):
                call()
    other = {} if name == "override_height_unit" else {"height_unit": "nm"}
    assert rc.read(path, **{**rest, **other, name: " um "}).shape == (5, 7)


def test_two_units_are_refused():
    with pytest.raises(rc.UnitError, match="'um'.*'nm'"):
        rc.Surface.of(coordinates(units="nm"), height_unit="um")
    assert rc.Surface.of(coordinates(units="nm"), height_unit="nm").heights[4, 6] == 406e-9
    st = pytest.importorskip("SurfaceTopography")
    with pytest.raises(rc.UnitError, match="leave height_unit out"):
        rc.Surface.of(st.Topography(tilted(), (10.0, 14.0), unit="um"), height_unit="nm")


# What is said of the edges, everywhere the same.


def test_one_object_has_one_answer():
    x = 2 * np.pi * np.arange(32) / 32
    waves = 1e-7 * np.cos(4 * x)[:, None] * np.cos(3 * x) + 5e-8 * np.cos(11 * x)
    for repeats in (True, False, None):
        s = rc.Surface(waves + 1e-7 * x, pixel="1um", height_unit="m", repeats=repeats)
        study = rc.compare(s, modulus="110 GPa", pressure="10MPa,100MPa", models=["persson"], on_failure="keep")["heights"]
        model = rc.model("persson", s, modulus="110 GPa", pressure="10MPa,100MPa")
        curve = rc.solve(s, modulus="110 GPa", pressure="10MPa,100MPa", on_failure="keep")
        assert study.models["persson"].area_fraction.tolist() == model.area_fraction.tolist()
        assert [p["area_fraction"] for p in study.deterministic] == pytest.approx(curve.area_fraction, rel=1e-3)
        statistics = s.statistics()
        assert statistics.rms_gradient == study.statistics.rms_gradient and statistics.level == study.statistics.level
        assert statistics.level == curve.settings["level"] == model.to_dict()["level"]
        assert statistics.level == {True: "mean", False: "plane", None: "plane"}[repeats]
        assert statistics.boundary == ("periodic" if repeats else "open")
        assert s.levelled("auto").statistics().boundary == statistics.boundary


# Models of one's own.


class Own:
    name = "own"

    def __init__(self, areas):
        self.areas = areas

    def area_fraction(self, pressure, inputs):
        return self.areas(pressure)


PRESSURES = "100MPa,200MPa,300MPa,400MPa"


def study(rough, areas, **how):
    return rc.compare(rough, modulus="110 GPa", pressure=PRESSURES, models=[Own(areas)], **how)


@pytest.mark.parametrize("holes", [[0], [1], [3], [1, 2], [0, 3], [0, 1, 2]])
@pytest.mark.parametrize("as_mask", [False, True])
def test_nan_stays_without_an_answer(rough, holes, as_mask):
    def areas(pressure):
        found = np.linspace(0.01, 0.04, len(pressure))
        if as_mask:
            return np.ma.masked_array(found, mask=np.isin(np.arange(4), holes))
        found[holes] = np.nan
        return found

    found = study(rough, areas)["synth 7"].models["own"]
    assert np.flatnonzero(np.isnan(found.area_fraction)).tolist() == holes
    assert np.flatnonzero(np.isnan(found.area_error.signed)).tolist() == holes
    kept = [i for i in range(4) if i not in holes]
    assert found.area_fraction[kept] == pytest.approx(np.linspace(0.01, 0.04, 4)[kept], rel=1e-12)


@pytest.mark.parametrize(
    ("areas", "why"),
    [
        (lambda p: np.full(len(p), np.nan), "NaN at every load"),
        (lambda p: 0.01 * (1 + 1j) * np.ones(len(p)), "complex"),
        (lambda p: ["a"] * len(p), "real numbers"),
        (lambda p: np.full(len(p), 1.5), "not from 0 to 1"),
        (lambda p: 0.01, "shape"),
        (lambda p: 0.01 * np.ones(len(p)) * um, "number"),
    ],
)
def test_what_is_no_answer_is_an_error(rough, areas, why):
    with pytest.raises((rc.ModelError, rc.UnitError), match=why):
        study(rough, areas)
    kept = study(rough, areas, on_failure="keep")
    assert why in kept["synth 7"].models["own"].reason
    rows = kept.records()
    assert len(rows) == 4 and all(row["area_fraction"] is None and why in row["reason"] for row in rows)


def test_a_file_that_is_not_there_is_an_error_of_this_package(tmp_path):
    import pickle

    for call in (rc.read, rc.info, rc.read_profile, rc.rerun):
        with pytest.raises(rc.Error) as caught:
            call(tmp_path / "none.x3p")
        assert isinstance(caught.value, FileNotFoundError) and isinstance(caught.value, rc.ReadError)
        again = pickle.loads(pickle.dumps(caught.value))
        assert type(again) is type(caught.value) and str(again) == str(caught.value) and again.filename == caught.value.filename
        assert "none.x3p" in str(again) and again.to_dict()["kind"] == "unreadable"


def test_advice_is_in_the_language_of_python(rough):
    """No finding and no refusal names an option of the command."""
    heights = rough.heights + 2e-7 * np.random.default_rng(1).normal(size=(64, 1))
    heights[5, 5] += 1e-4
    s = rc.Surface(heights, pixel="1um", height_unit="m")
    found = rc.solve(s, modulus="110 GPa", pressure="100MPa,30GPa", hardness="20GPa", on_failure="keep", work_of_adhesion="0.1 J/m2")
    study = rc.compare(s, modulus="110 GPa", pressure="100MPa,1GPa", on_failure="keep")
    model = rc.model("gw", s, modulus="110 GPa", pressure="100MPa")
    findings = [*found.findings, *study["heights"].findings, *model.findings, *s.statistics().findings]
    assert len(findings) > 5
    for text in [f"{f.claim} {f.text}" for f in findings] + [repr(found), repr(study), repr(model)]:
        assert "--" not in text, text


# Mistakes of who asks, each with its name.


@pytest.mark.parametrize(
    ("call", "error", "why"),
    [
        (lambda s: rc.Surface(MICRONS, pixel="1um", height_unit="um", name=5), rc.SettingError, "name = 5"),
        (lambda s: rc.Surface(MICRONS, pixel="1um", height_unit="um", repeats="yes"), rc.SettingError, "repeats = 'yes'"),
        (lambda s: rc.Surface(s, pixel="1um", height_unit="um"), TypeError, "rc.Surface already"),
        (lambda s: rc.read("a.x3p", channel=2), rc.SettingError, "channel = 2"),
        (lambda s: rc.read("a.x3p", missing=[-9999]), rc.SettingError, "missing = -9999"),
        (lambda s: rc.read("a.x3p", missing=-9999), rc.SettingError, "missing='-9999'"),
        (lambda s: rc.read("a.x3p", form="cubic"), rc.SettingError, "form = 'cubic'"),
        (lambda s: s.cleaned(form=2), rc.SettingError, "form = 2"),
        (lambda s: s.cleaned(form="polynomial:20"), rc.SettingError, "polynomial:20"),
        (lambda s: s.cleaned(align_rows="no"), rc.SettingError, "align_rows = 'no'"),
        (lambda s: s.statistics(iso="yes"), rc.SettingError, "iso = 'yes'"),
        (lambda s: rc.solve(s, modulus="1GPa", pressure="1MPa", fast="no"), rc.SettingError, "fast = 'no'"),
        (lambda s: rc.solve(s, modulus="1GPa", pressure="1MPa", level=MICRONS), rc.SettingError, "level"),
        (lambda s: rc.solve(s, modulus=["110 GPa"], pressure="1MPa"), rc.UnitError, "modulus takes one quantity"),
        (lambda s: rc.solve(s, modulus=[110 * rc.units.GPa], pressure="1MPa"), rc.UnitError, "modulus takes one quantity"),
        (lambda s: gas(s, temperature="300K"), rc.UnitError, "gas temperature"),
        (lambda s: gas(s, accommodation=[0.9, 0.9, 0.9]), rc.SettingError, "gas accommodation"),
        (lambda s: gas(s, accommodation="much"), rc.UnitError, "gas accommodation"),
        (lambda s: rc.compare({"a": MICRONS}, modulus="1GPa"), TypeError, r"surfaces\['a'\] takes rc.Surface"),
        (lambda s: rc.compare({1: s}, modulus="1GPa"), TypeError, "key 1 of surfaces is no text"),
        (lambda s: rc.solve_many({1: s}, modulus="1GPa", pressure="1MPa"), TypeError, "key 1"),
        (lambda s: rc.compare(s, modulus="1GPa", models="nobody"), rc.SettingError, "'nobody'"),
        (lambda s: rc.Profile.of(MICRONS[:, :1], spacing="1um", height_unit="um"), rc.SurfaceError, "heights.T"),
        (lambda s: rc.model("cmy", s, hardness="elastic", conductivity="50 W/m/K", pressure="1MPa"), rc.SettingError, "hardness='elastic'"),
        (lambda s: rc.model("mikic", s, bodies=rc.material("copper"), pressure="1MPa"), rc.SettingError, "give conductivity"),
        (lambda s: rc.model("cmy", s, bodies=rc.material("copper"), pressure="1MPa"), rc.SettingError, "give conductivity"),
    ],
)
def test_a_mistake_is_no_bug_of_the_package(rough, call, error, why):
    with pytest.raises(error, match=why) as caught:
        call(rough)
    assert not isinstance(caught.value, rc.InternalError)


def gas(s, **more):
    return rc.solve(s, modulus="1GPa", pressure="1MPa", conductivity="50 W/m/K", gas={"gas": "air", **more})


def test_numbers_of_numpy_are_numbers(rough):
    both = gas(rough, accommodation=np.float32(0.5), temperature=np.float32(300))
    assert both.to_dict()["gas"] == gas(rough, accommodation=[0.5, 0.5], temperature=300).to_dict()["gas"]
    assert rc.solve(rough, modulus="1GPa", pressure="1MPa", certify=np.True_)[0].energy_bound is not None
    assert rc.compare(rough, modulus="110 GPa", pressure="100MPa", models="gw")["synth 7"].models.keys() == {"gw"}
