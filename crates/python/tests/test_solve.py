"""The solver against exact solutions, and what a call may do besides."""

import json
import multiprocessing
import os
import pickle
import signal
import threading
import time

import numpy as np
import pytest
from scipy import special

import rough_contact as rc

E = 110e9  # Pa


def sphere(n, radius, pixel):
    x = (np.arange(n) - n / 2 + 0.5) * pixel
    return rc.Surface(-(x[:, None] ** 2 + x**2) / (2 * radius), pixel=pixel * rc.units.m, height_unit="m")


def test_hertz():
    """p0 = 2 E* a/(pi R), a^3 = 3 F R/(4 E*): Johnson (1985) Contact Mechanics, section 4.2."""
    force, radius = 1.0, 1e-3
    a = (3 * force * radius / (4 * E)) ** (1 / 3)
    errors = []
    for n in (32, 64, 128):
        pixel = 1.6 * 2 * a / n
        s = sphere(n, radius, pixel)
        found = rc.solve(s, modulus=E * rc.units.Pa, load=force * rc.units.N, boundary="free", level="none", tolerance=1e-8)
        area = found.area_fraction[0] * s.size[0] * s.size[1]
        assert abs(area / (np.pi * a**2) - 1) < pixel / a  # half a pixel along the rim
        errors.append([found.max_pressure[0] * np.pi * radius / (2 * E * a) - 1, found.approach[0] * radius / a**2 - 1])
    order = np.log2(np.abs(np.array(errors[:-1]) / errors[1:]))
    assert ((order > 1.8) & (order < 2.2)).all(), order


def test_a_wave_pressed_flat():
    """Full contact of a wave of amplitude A: p* = pi E* A/L, Westergaard (1939); u = p/(pi E* / L)."""
    n, length, amplitude = 64, 64e-6, 1e-8
    x = np.arange(n) * 1e-6
    s = rc.Surface(np.tile(amplitude * np.cos(2 * np.pi * x / length), (n, 1)), pixel="1um", height_unit="m")
    full = np.pi * E * amplitude / length
    mean = 2 * full
    found = rc.solve(s, modulus=E * rc.units.Pa, pressure=mean * rc.units.Pa, level="none", maps=True, tolerance=1e-10)
    assert found.area_fraction[0] == 1.0
    exact = mean + full * np.cos(2 * np.pi * x / length)
    np.testing.assert_allclose(found.pressure(0), np.tile(exact, (n, 1)), rtol=1e-8)
    # Part of it: A_r/A = 2/pi asin sqrt(p/p*).
    part = rc.solve(s, modulus=E * rc.units.Pa, pressure=0.5 * full * rc.units.Pa, level="none", tolerance=1e-8)
    assert part.area_fraction[0] == pytest.approx(2 / np.pi * np.arcsin(np.sqrt(0.5)), abs=1 / n)


def test_light_contact_is_near_persson(rough):
    """erf(sqrt(2) p/(E* g)): Persson (2001), doi:10.1063/1.1388626, which is some ten per cent low."""
    s = rc.synth((512, 512), pixel="1um", hurst=0.8, rolloff="128um", cutoff="16um", rms_gradient=0.1, seed=3)
    found = rc.solve(s, modulus="110 GPa", pressure=np.array([0.3, 1.0]) * rc.units.GPa)
    persson = special.erf(np.sqrt(2) * found.mean_pressure / (E * s.statistics().rms_gradient))
    ratio = found.area_fraction / persson
    assert ((1.0 < ratio) & (ratio < 1.4)).all(), ratio


def test_invariants(rough):
    curve = rc.solve(rough, modulus="110 GPa", pressure="1GPa,10MPa,100MPa", maps=True)
    assert curve.mean_pressure.tolist() == [1e9, 1e7, 1e8]  # the order asked
    for i, point in enumerate(curve):
        p, g = curve.pressure(i), curve.gap(i)
        assert p.shape == rough.shape and p.dtype == np.float64
        assert p.mean() == pytest.approx(point.mean_pressure, rel=1e-12)
        assert (p >= 0).all() and np.count_nonzero(p) == point.contact_pixels
        assert p.max() == point.max_pressure
        assert (g >= 0).all() and not g[p > 0].any()
        assert g.mean() == pytest.approx(point.mean_gap, rel=1e-3)
        assert not p.flags.writeable and not g.flags.writeable
        with pytest.raises(ValueError):
            p[0, 0] = 1.0


def test_rows_and_columns_stay_apart():
    """A wave along x alone: pressure differs along columns only."""
    x = np.arange(48) * 2e-6
    s = rc.Surface(np.tile(1e-8 * np.cos(2 * np.pi * x / 96e-6), (16, 1)), pixel=["1um", "2um"], height_unit="m")
    assert s.pixel == (1e-6, 2e-6) and s.size == (16e-6, 96e-6)
    found = rc.solve(s, modulus="1 GPa", pressure="100 kPa", level="none", maps=True)
    p = found.pressure(0)
    assert np.ptp(p, axis=0).max() < 1e-6 * p.max() < np.ptp(p)


def test_threads_do_not_matter(rough):
    one, three = (rc.solve(rough, modulus="110 GPa", pressure="100MPa", threads=n).to_dict() for n in (1, 3))
    for answer in (one, three):
        answer["points"][0]["seconds"] = None
    assert one == three


def test_the_lock_is_released(rough):
    """Another Python thread goes on while the solver works."""
    big = rc.synth((512, 512), pixel="1um", hurst=0.8, rolloff="100um", cutoff="4um", rms_height="0.4um", seed=7)
    counted, stop = [0], threading.Event()

    def count():
        while not stop.is_set():
            counted[0] += 1
            time.sleep(0.001)

    other = threading.Thread(target=count)
    other.start()
    try:
        rc.solve(big, modulus="110 GPa", pressure="1MPa..1GPa:8")
    finally:
        stop.set()
        other.join()
    assert counted[0] > 20


def test_progress_is_told_on_this_thread_and_may_stop(rough):
    seen, here = [], threading.get_ident()

    def tell(news):
        assert threading.get_ident() == here
        seen.append(news)

    rc.solve(rough, modulus="110 GPa", pressure="1MPa..1GPa:4", progress=tell)
    done = [news for news in seen if news.stage == "load"]
    assert len(done) == 4 and done[0].mean_pressure == 1e6 and done[0].count == 4

    class Enough(Exception):
        pass

    def enough(news):
        raise Enough

    with pytest.raises(Enough):
        rc.solve(rough, modulus="110 GPa", pressure="1MPa..1GPa:4", progress=enough)


@pytest.mark.skipif(os.name == "nt", reason="signals of Unix")
@pytest.mark.parametrize("loads", [0, 1])
def test_ctrl_c(loads, request):
    """Stops soon, and what was done is not lost."""
    # A shell lets what runs in the background ignore the signal.
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    request.addfinalizer(lambda: signal.signal(signal.SIGINT, before))
    big = rc.synth((1024, 1024), pixel="1um", hurst=0.8, rolloff="100um", cutoff="4um", rms_height="0.4um", seed=7)
    asked = []

    def interrupt():
        asked.append(time.monotonic())
        os.kill(os.getpid(), signal.SIGINT)

    def after_a_load(news):
        if news.stage == "load" and not asked:
            interrupt()

    timer = threading.Timer(0.05, interrupt)
    if not loads:
        timer.start()
    with pytest.raises(KeyboardInterrupt) as caught:
        rc.solve(big, modulus="110 GPa", pressure="1MPa..10GPa:64", progress=after_a_load if loads else None)
    assert isinstance(caught.value, rc.Interrupted)
    if loads:
        assert 1 <= len(caught.value.partial) < 64
        assert caught.value.partial.converged.all()
    # A second on a machine of one's own; others may work here too.
    assert time.monotonic() - asked[0] < 5


def _child(queue, surface):
    queue.put(rc.solve(surface, modulus="110 GPa", pressure="100MPa").area_fraction[0])


@pytest.mark.skipif("fork" not in multiprocessing.get_all_start_methods(), reason="no fork here")
@pytest.mark.filterwarnings("ignore::DeprecationWarning")
def test_a_forked_child_solves(rough):
    before = rc.solve(rough, modulus="110 GPa", pressure="100MPa").area_fraction[0]
    rough.statistics()
    context = multiprocessing.get_context("fork")
    queue = context.Queue()
    child = context.Process(target=_child, args=(queue, rough))
    child.start()
    try:
        assert queue.get(timeout=60) == before
    finally:
        child.kill()


def test_failures_keep_what_was_found(rough):
    with pytest.raises(rc.NotConverged) as caught:
        rc.solve(rough, modulus="110 GPa", pressure="100MPa,1GPa", tolerance=1e-15)
    kept = caught.value.result
    assert len(kept) == 2 and not kept.converged.all() and (kept.area_fraction > 0).all()
    again = pickle.loads(pickle.dumps(caught.value))
    assert str(again) == str(caught.value) and again.kind == caught.value.kind
    assert again.result.to_dict() == kept.to_dict()
    with pytest.raises(rc.AccuracyNotMet) as caught:
        rc.solve(rough, modulus="110 GPa", pressure="100MPa", accuracy="0.01%")
    assert caught.value.result.accuracy is not None
    mixed = rc.solve(rough, modulus="110 GPa", pressure="100MPa,30GPa", hardness="20GPa", on_failure="keep")
    assert mixed.converged.tolist() == [True, False] and np.isnan(mixed.area_fraction[1])
    assert "above the hardness" in repr(mixed[1])


@pytest.mark.parametrize(
    ("arguments", "error"),
    [
        ({"modulus": 110e9, "pressure": "1MPa"}, rc.UnitError),
        ({"modulus": "110um", "pressure": "1MPa"}, rc.UnitError),
        ({"modulus": "110GPa", "pressure": [1e6]}, rc.UnitError),
        ({"modulus": "110GPa", "pressure": "0Pa"}, rc.SettingError),
        ({"modulus": "110GPa", "pressure": "1MPa", "gap": "1um"}, TypeError),
        ({"modulus": "110GPa"}, TypeError),
        ({"pressure": "1MPa"}, TypeError),
        ({"modulus": "-1GPa", "pressure": "1MPa"}, rc.SettingError),
        ({"modulus": "110GPa", "pressure": "1MPa", "tolerance": 2.0}, rc.SettingError),
        ({"modulus": "110GPa", "pressure": "1MPa", "tolerance": "1um"}, rc.UnitError),
        ({"modulus": "110GPa", "pressure": "1MPa", "method": "magic"}, rc.SettingError),
        ({"modulus": "110GPa", "pressure": "1MPa", "accuracy": 0.05, "fast": True}, rc.SettingError),
        ({"modulus": "110GPa", "gap": "1um", "boundary": "free"}, rc.SettingError),
        ({"modulus": "110GPa", "pressure": "1MPa", "leak": "x", "boundary": "free"}, rc.SettingError),
        ({"modulus": "110GPa", "pressure": "1MPa", "leak": "z"}, rc.SettingError),
        ({"modulus": "110GPa", "pressure": "1MPa", "leak": "x", "viscosity": "1mPa.s"}, rc.SettingError),
        ({"modulus": "110GPa", "pressure": "1MPa", "seal_width": "1mm"}, rc.SettingError),
        ({"modulus": "110GPa", "pressure": "1MPa", "leak": "x", "viscosity": "1MPa"}, rc.UnitError),
        ({"modulus": "110GPa", "pressure": "1MPa", "threads": 0}, rc.SettingError),
        ({"modulus": "110GPa", "pressure": "1MPa", "nonsense": 1}, TypeError),
    ],
)
def test_refusals(rough, arguments, error):
    with pytest.raises(error):
        rc.solve(rough, **arguments)


def test_a_finding_of_weight_is_a_warning(rough):
    with pytest.warns(rc.ContactWarning, match="No usual solid bears"):
        curve = rc.solve(rough, modulus="110 GPa", pressure="1GPa")
    assert any(f.weight == "check" for f in curve.findings)


def test_results(rough):
    curve = rc.solve(rough, modulus="110 GPa", pressure="100MPa..1GPa:3,1MPa", maps="pressure")
    again = pickle.loads(pickle.dumps(curve))
    assert again.to_dict() == curve.to_dict() and (again.pressure(1) == curve.pressure(1)).all()
    assert not again.pressure(1).flags.writeable
    with pytest.raises(AttributeError):
        curve.mean_pressure = 0
    with pytest.raises(LookupError, match="maps=True"):
        curve.gap(0)
    with pytest.raises(IndexError):
        curve[4]
    assert curve[-1].mean_pressure == 1e6 and curve[-1].area_interval[0] == 0.0
    part = curve[1:3]
    assert len(part) == 2 and (part.pressure(0) == curve.pressure(1)).all()
    bars = curve.bars()
    assert bars.shape == (2, 4) and (bars > 0).all()
    low, high = curve.area_interval[0]
    assert curve.area_fraction[0] - bars[0, 0] == pytest.approx(low, rel=1e-12)
    assert curve.area_fraction[0] + bars[1, 0] == pytest.approx(high, rel=1e-12)
    assert (curve.bars(prediction=True)[:, :3] > bars[:, :3]).all()
    assert json.loads(json.dumps(curve.to_dict())) == curve.to_dict()
    assert "<table>" in curve._repr_html_() and "100 MPa" in repr(curve)


def test_tables(rough):
    pandas, xarray = pytest.importorskip("pandas"), pytest.importorskip("xarray")
    curve = rc.solve(rough, modulus="110 GPa", pressure="100MPa,1GPa", maps=True)
    frame = curve.to_pandas()
    assert isinstance(frame, pandas.DataFrame) and frame.attrs["units"]["mean_pressure"] == "Pa"
    assert frame.area_interval_low.tolist() == curve.area_interval[:, 0].tolist()
    assert frame["residuals.preconditioned"].max() < 1e-4
    assert not [name for name in frame if name.endswith("_low") and "interval" not in name]
    thinned = curve.json["points"][1]["coarser"]
    assert thinned and [frame[f"coarser.{i}.area_fraction"][1] for i in range(len(thinned))] == [each["area_fraction"] for each in thinned]
    data = curve.to_xarray()
    assert isinstance(data, xarray.Dataset) and data.pressure.dims == ("load", "y", "x")
    assert float(data.pressure[0].mean()) == pytest.approx(1e8)
    assert data.mean_pressure.values.tolist() == [1e8, 1e9] and data.mean_pressure.attrs["units"] == "Pa"
    low = data.area_interval.sel(end="low")
    assert low.values.tolist() == curve.area_interval[:, 0].tolist()
    for name in data.variables:
        if name != "end":
            assert data[name].attrs["units"] == ("m" if name in "yx" else rc.Point.units()["load" if name == "force" else name])
    again = rc.Surface.of(data.gap[0])
    assert again.pixel == rough.pixel and again.heights.tolist() == curve.gap(0).tolist()


def test_loads_are_told_by_their_place(rough):
    told = []
    rc.solve(rough, modulus="110 GPa", pressure="100MPa,1MPa,10MPa,1MPa", progress=told.append)
    done = [(news.index, news.mean_pressure) for news in told if news.stage == "load"]
    assert sorted(done) == [(0, 1e8), (1, 1e6), (2, 1e7), (3, 1e6)]
    told.clear()
    rc.solve(rough, modulus="110 GPa", pressure="30GPa,100MPa", hardness="20GPa", on_failure="keep", progress=told.append)
    assert sorted(news.index for news in told if news.stage == "load") == [0, 1]


def test_a_callback_that_raises_keeps_what_is_done(rough):
    class Enough(Exception):
        pass

    def stop(news):
        if news.stage == "load":
            raise Enough

    with pytest.raises(Enough) as stopped:
        rc.solve(rough, modulus="110 GPa", pressure="1MPa..1GPa:8", progress=stop)
    kept = stopped.value.partial
    assert 1 <= len(kept) < 8 and kept.converged.all() and kept.mean_pressure[0] == 1e6


@pytest.mark.parametrize("loads", ["30MPa,2GPa,100MPa,300MPa,1GPa", "1GPa,300MPa,100MPa,30MPa", ["30MPa", np.nan * rc.units.Pa, "100MPa", "1GPa"]])
def test_what_is_done_keeps_its_own_maps(rough, loads):
    done = 0

    def stop(news):
        nonlocal done
        done += news.stage == "load"
        if done == 2:
            raise StopIteration

    with pytest.raises(StopIteration) as stopped:
        rc.solve(rough, modulus="110 GPa", pressure=loads, tolerance=1e-9, maps=True, leak="x", progress=stop)
    kept = stopped.value.partial
    assert len(kept) >= 2 and sorted(kept.maps) == list(range(len(kept)))
    whole = rc.solve(rough, modulus="110 GPa", pressure=kept.mean_pressure * rc.units.Pa, tolerance=1e-9, maps=True, leak="x")
    for i, (part, alone) in enumerate(zip(kept, whole)):
        assert part.pressure.mean() == pytest.approx(part.mean_pressure, rel=1e-6)
        assert (kept.spots(i) == whole.spots(i)).all() and part.gap.mean() == pytest.approx(part.mean_gap, rel=1e-3)
        assert part.area_fraction == pytest.approx(alone.area_fraction, rel=1e-3)
    leaks = [point["leak"]["x"]["permeability"] for point in kept.json["points"]]
    assert np.argsort(leaks).tolist() == np.argsort(-kept.mean_pressure).tolist()


def test_times(rough):
    start = time.perf_counter()
    curve = rc.solve(rough, modulus="110 GPa", pressure="10MPa,100MPa")
    passed = time.perf_counter() - start
    assert 0 < curve.solver_seconds.sum() <= curve.seconds <= passed and curve.seconds > 0.8 * passed
    assert curve[1].solver_seconds == curve.solver_seconds[1] == curve.to_dict()["points"][1]["seconds"]


def test_statistics_are_taken_once(rough):
    s = rc.synth((512, 512), pixel="1um", hurst=0.8, rolloff="100um", cutoff="4um", rms_gradient=0.1, seed=3)
    first = s.statistics()
    start = time.perf_counter()
    assert s.statistics() == first and time.perf_counter() - start < 0.01
    assert s.statistics(iso=True) != first and s.statistics(level="none").level == "none"


def test_many_maps_in_one_call(rough):
    maps = {str(k): rc.synth((32, 32), pixel="1um", hurst=0.8, rolloff="16um", cutoff="6um", rms_gradient=0.1, seed=k) for k in range(6)}
    maps["flat"] = rc.Surface(np.zeros((32, 32)), pixel="1um", height_unit="m")
    found = rc.solve_many(maps, modulus="110 GPa", pressure="100MPa,30GPa", hardness="20GPa", threads=3)
    assert list(found) == list(maps)
    for name, surface in maps.items():
        try:
            alone = rc.solve(surface, modulus="110 GPa", pressure="100MPa,30GPa", hardness="20GPa")
        except rc.Error as error:
            assert type(found[name]) is type(error) and str(found[name]) == str(error)
            continue
        assert found[name].area_fraction.tolist() == alone.area_fraction.tolist()
    kept = rc.solve_many(list(maps.values())[:3], modulus="110 GPa", pressure="100MPa")
    assert [len(curve) for curve in kept.values()] == [1, 1, 1]
    with pytest.raises(TypeError):
        rc.solve_many(maps, modulus="110 GPa", pressure="100MPa", nonsense=1)
    with pytest.raises(rc.Interrupted) as stopped:
        rc.solve_many(maps, modulus="110 GPa", pressure="100MPa", threads=1, progress=_interrupt)
    assert isinstance(stopped.value.partial, dict)


def _interrupt(news):
    raise KeyboardInterrupt
