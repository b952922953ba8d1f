"""The forward operator and the contact spots of a solution."""

import numpy as np
import pytest

import rough_contact as rc

E = 110e9


@pytest.mark.parametrize(("ky", "kx"), [(0, 3), (5, 0), (2, 7)])
def test_a_wave_of_pressure_is_a_wave_of_displacement(ky, kx):
    """u = 2 p/(E* q) (Johnson 1985, section 13.2); the mean pressure displaces nothing."""
    (ny, nx), (dy, dx) = (40, 64), (3e-6, 2e-6)
    y, x = np.mgrid[:ny, :nx]
    wave = np.cos(2 * np.pi * (ky * y / ny + kx * x / nx))
    q = 2 * np.pi * np.hypot(ky / (ny * dy), kx / (nx * dx))
    u = rc.displacement((5 + 3 * wave) * rc.units.MPa, pixel=["3um", "2um"], modulus=E * rc.units.Pa)
    np.testing.assert_allclose(u, 2 * 3e6 / (E * q) * wave, atol=1e-12 * u.max())
    assert not u.flags.writeable


def test_far_from_a_load_it_is_that_of_a_point(rough):
    """Boussinesq: u = F/(pi E* r); two bodies move as much as E* says."""
    p = np.zeros((3, 101))
    p[1, 0] = 1e9
    u = rc.displacement(p * rc.units.Pa, pixel="1um", modulus="110 GPa", boundary="free")
    assert u[1, 100] == pytest.approx(1e9 * 1e-12 / (np.pi * E * 100e-6), rel=1e-4)
    body = rc.Body(young="220 GPa", poisson=0.0)
    both = rc.displacement(p * rc.units.Pa, pixel="1um", bodies=(body, body), boundary="free")
    np.testing.assert_allclose(both, u, rtol=1e-12)


@pytest.mark.parametrize("how", [{}, {"boundary": "free"}, {"edges": "mirrored"}], ids=str)
def test_heights_gap_and_displacement_add_up(rough, how):
    """The gap is the distance of a flat from the surface that was pressed in."""
    curve = rc.solve(rough, modulus="110 GPa", pressure="30MPa,300MPa", level="none", maps=True, tolerance=1e-8, on_failure="keep", **how)
    for i in range(2):
        flat = curve.gap(i) + rough.heights - curve.displacement(i)
        assert np.ptp(flat) < 1e-6 * np.ptp(rough.heights)


def test_what_is_refused():
    for wrong in (np.ones(4) * rc.units.Pa, np.full((4, 4), np.nan) * rc.units.Pa):
        with pytest.raises(rc.SurfaceError, match="rows and columns"):
            rc.displacement(wrong, pixel="1um", modulus="1GPa")
    with pytest.raises(rc.UnitError):
        rc.displacement(np.ones((4, 4)), pixel="1um", modulus="1GPa")  # type: ignore[arg-type]
    with pytest.raises(rc.SurfaceError):
        rc.displacement(np.ones((4, 4)) * rc.units.Pa, pixel="0um", modulus="1GPa")


def test_an_array_of_xarray_is_told_by_its_dimensions():
    xarray = pytest.importorskip("xarray")
    pressure = np.zeros((32, 64))
    pressure[4:8, 10:20] = 1.0
    how = {"pixel": ["2um", "1um"], "modulus": "1GPa"}
    expected = rc.displacement(pressure * rc.units.MPa, **how)
    made = xarray.DataArray(pressure, {"y": 2.0 * np.arange(32), "x": 1.0 * np.arange(64)}, ("y", "x"), attrs={"units": "MPa"})
    for given in (made, made.T, made.drop_vars(["x", "y"]).T):
        assert (rc.displacement(given, **how) == expected).all()
    for axis in "yx":
        made[axis].attrs["units"] = "um"
    assert (rc.displacement(made.T, **how) == expected).all()
    with pytest.raises(rc.SurfaceError, match="1e-06 m along y"):
        rc.displacement(made, pixel="1um", modulus="1GPa")


def test_spots_are_those_of_scipy():
    ndimage, csgraph, sparse = (pytest.importorskip(f"scipy.{name}") for name in ("ndimage", "sparse.csgraph", "sparse"))
    s = rc.synth((64, 48), pixel="1um", hurst=0.8, rolloff="12um", cutoff="4um", rms_gradient=0.1, seed=3)
    for how in ({"boundary": "free"}, {}):
        curve = rc.solve(s, modulus="110 GPa", pressure="1GPa", maps="pressure", distributions=True, on_failure="keep", **how)
        labels = curve.spots(0)
        expected, count = ndimage.label(curve.pressure(0) > 0, np.ones((3, 3)))
        if how:
            np.testing.assert_array_equal(labels, expected)
            continue
        # Across the seam: labels that lie beside each other on the ring are one.
        touches = expected > 0
        edges = [(0, 1), (1, 0), (1, 1), (1, -1)]
        pairs = np.concatenate([np.stack([expected, np.roll(expected, edge, (0, 1))])[:, touches & np.roll(touches, edge, (0, 1))] for edge in edges], axis=1)
        graph = sparse.coo_matrix((np.ones(pairs.shape[1]), pairs), shape=(count + 1, count + 1))
        components, which = csgraph.connected_components(graph, directed=False)
        ours = labels[touches]
        assert labels.max() == components - 1 < count and (labels[~touches] == 0).all()
        assert len({*zip(which[expected[touches]].tolist(), ours.tolist())}) == labels.max()
        assert labels.max() == curve.json["points"][0]["distributions"]["spots"]["count"]
        _, first = np.unique(labels.ravel(), return_index=True)
        assert (np.diff(first[1:]) > 0).all()  # in the order of rows
