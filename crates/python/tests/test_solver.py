"""The solver that starts from where it ended."""

import os
import pickle
import signal
import threading
import time

import numpy as np
import pytest

import rough_contact as rc


def test_the_answer_is_that_of_solve(rough):
    solver = rc.Solver(modulus="110 GPa", tolerance=1e-6)
    once = rc.solve(rough, modulus="110 GPa", pressure="100MPa,1GPa", tolerance=1e-6, maps=True, on_failure="keep")
    curve = solver.curve(rough, pressure="100MPa,1GPa", on_failure="keep")
    # From nothing, load by load, the work is the same: to the last digit.
    for name in ("area_fraction", "mean_gap", "max_pressure", "iterations"):
        assert np.array_equal(getattr(curve, name), getattr(once, name)), name
    assert np.array_equal(curve.pressure(1), once.pressure(1)) and np.array_equal(curve.gap(0), once.gap(0))
    assert curve.area_interval.shape == (2, 2)


def test_it_starts_from_the_last_solution(rough):
    solver = rc.Solver(modulus="110 GPa", tolerance=1e-8, maps=False)
    assert not solver.is_warm and "cold" in repr(solver)
    cold = solver.solve(rough, pressure="300 MPa")
    assert solver.is_warm
    again = solver.solve(rough, pressure="300 MPa")
    assert again.transforms < 0.5 * cold.transforms
    assert again.area_fraction == cold.area_fraction
    assert again.mean_gap == pytest.approx(cold.mean_gap, rel=1e-6)
    solver.forget()
    assert not solver.is_warm
    fresh = solver.solve(rough, pressure="300 MPa")
    assert (fresh.transforms, fresh.mean_gap) == (cold.transforms, cold.mean_gap)


def test_a_changed_surface_of_the_same_grid(rough):
    """Wear: the highest points go, and the answer is that of a solver that never saw the others."""
    solver = rc.Solver(modulus="110 GPa", tolerance=1e-8)
    solver.solve(rough, pressure="300 MPa")
    heights = np.minimum(rough.heights, np.quantile(rough.heights, 0.98))
    worn = rc.Surface(heights, pixel="1um", height_unit="m")
    warm = solver.solve(worn, pressure="300 MPa")
    cold = rc.Solver(modulus="110 GPa", tolerance=1e-8).solve(worn, pressure="300 MPa")
    assert warm.area_fraction == cold.area_fraction
    assert np.allclose(warm.pressure, cold.pressure, atol=1e-5 * cold.max_pressure)


def test_another_grid_starts_anew(rough):
    solver = rc.Solver(modulus="110 GPa")
    solver.solve(rough, pressure="300 MPa")
    small = rough.cropped(0, 0, 32, 40)
    found = solver.solve(small, pressure="300 MPa")
    alone = rc.Solver(modulus="110 GPa").solve(small, pressure="300 MPa")
    assert (found.mean_gap, found.transforms) == (alone.mean_gap, alone.transforms)


def test_gaps_and_forces(rough):
    solver = rc.Solver(bodies=rc.Body(young="210 GPa", poisson=0.3), level="none")
    by_gap = solver.solve(rough, gap="400 nm")
    assert by_gap.mean_gap == pytest.approx(4e-7, rel=1e-3)
    area = rough.size[0] * rough.size[1]
    by_force = solver.solve(rough, load=by_gap.mean_pressure * area * rc.units.N)
    assert by_force.mean_gap == pytest.approx(4e-7, rel=1e-2)


def test_one_load_for_solve(rough):
    with pytest.raises(rc.SettingError, match="one load"):
        rc.Solver(modulus="110 GPa").solve(rough, pressure="1MPa,2MPa")
    with pytest.raises(rc.UnitError):
        rc.Solver(modulus="110 GPa").solve(rough, pressure=1e6)


def test_progress_is_told_and_may_stop_it(rough):
    solver = rc.Solver(modulus="110 GPa")
    told = []
    solver.curve(rough, pressure="100MPa,1GPa", progress=told.append)
    assert [news.stage for news in told].count("load") == 2

    class Enough(Exception):
        pass

    def stop(news):
        raise Enough

    with pytest.raises(Enough):
        solver.curve(rough, pressure="100MPa,1GPa", progress=stop)
    assert solver.solve(rough, pressure="1 GPa").converged


@pytest.mark.skipif(os.name == "nt", reason="signals of Unix")
def test_ctrl_c_is_heard_soon_and_the_iterate_is_kept(request):
    # A shell lets what runs in the background ignore the signal.
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    request.addfinalizer(lambda: signal.signal(signal.SIGINT, before))
    big = rc.synth((1024, 1024), pixel="1um", hurst=0.8, rolloff="200um", cutoff="4um", rms_gradient=0.1, seed=3)
    solver = rc.Solver(modulus="110 GPa", tolerance=1e-10, maps=False, threads=1)
    sent = []

    def interrupt(news):
        if news.stage == "load" and not sent:
            sent.append(time.perf_counter())
            signal.raise_signal(signal.SIGINT)

    with pytest.raises(rc.Interrupted) as stopped:
        solver.curve(big, pressure="10MPa..1GPa:8", progress=interrupt)
    # A second on a machine of one's own; others may work here too.
    assert time.perf_counter() - sent[0] < 5
    assert 1 <= len(stopped.value.partial) < 8
    assert solver.is_warm


def test_it_stays_where_it_is(rough):
    solver = rc.Solver(modulus="110 GPa")
    with pytest.raises(TypeError, match="not pickled"):
        pickle.dumps(solver)
    big = rc.synth((512, 512), pixel="1um", hurst=0.8, rolloff="100um", cutoff="4um", rms_gradient=0.1, seed=3)
    busy = rc.Solver(modulus="110 GPa", tolerance=1e-10, maps=False, threads=1)
    begun = threading.Event()
    work = threading.Thread(target=lambda: busy.curve(big, pressure="1MPa..1GPa:8", progress=lambda news: begun.set()))
    work.start()
    try:
        assert begun.wait(30)
        with pytest.raises(RuntimeError, match="another thread"):
            busy.solve(rough, pressure="1 GPa")
    finally:
        work.join()
