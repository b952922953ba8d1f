"""Closed forms: the numbers of the command, and their own integrals."""

import pickle
import time

import numpy as np
import pytest
from scipy import integrate, optimize

import rough_contact as rc

MOMENTS = ["--m0", "0.36um^2", "--m2", "0.006", "--m4", "4e9m^-2"]
TYPED = {
    "moments": (["gw", *MOMENTS], "gw", lambda: rc.Moments(m0="0.36um^2", m2=0.006, m4="4e9m^-2")),
    "bgt": (["bgt", *MOMENTS], "bgt", lambda: rc.Moments(m0="0.36um^2", m2=0.006, m4="4e9m^-2")),
    "asperities": (
        ["gw", "--asperity-density", "3e10m^-2", "--asperity-radius", "5um", "--asperity-height-std", "0.3um"],
        "gw",
        lambda: rc.Asperities(density="3e10m^-2", radius=5 * rc.units.um, height_std="0.3um"),
    ),
    "self-affine": (
        ["persson", "--hurst", "0.8", "--rolloff", "20um", "--cutoff", "1um", "--m0", "0.1um^2"],
        "persson",
        lambda: rc.SelfAffine(hurst=0.8, rolloff="20um", cutoff="1um", m0="0.1um^2"),
    ),
    "stacked": (
        ["stacked", "--hurst", "0.8", "--rolloff", "20um", "--cutoff", "1um", "--m0", "0.1um^2"],
        "stacked",
        lambda: rc.SelfAffine(hurst=0.8, rolloff="20um", cutoff="1um", m0="0.1um^2"),
    ),
    "archard": (
        ["archard", "--sphere-radius", "1mm,10um", "--sphere-density", "1mm^-2,1e4mm^-2"],
        "archard",
        lambda: rc.Numbers(sphere_radius="1mm,10um", sphere_density="1mm^-2,1e4mm^-2"),
    ),
    "m2 alone": (["persson", "--m2", "0.006"], "persson", lambda: rc.Moments(m2=0.006)),
    "a hardness": (
        ["persson-yield", "--m2", "0.006", "--hardness", "2GPa"],
        "persson-yield",
        lambda: rc.Numbers(m2=0.006, hardness="2GPa"),
    ),
    "yan-komvopoulos": (
        ["yan-komvopoulos", "--dimension", "2.4", "--roughness", "0.1nm", "--area", "1mm^2"],
        "yan-komvopoulos",
        lambda: rc.Fractal(dimension=2.4, roughness="0.1nm", area="1mm^2"),
    ),
    "fractal": (
        ["majumdar-bhushan", "--dimension", "1.3", "--roughness", "0.1nm", "--area", "1mm^2"],
        "majumdar-bhushan",
        lambda: rc.Fractal(dimension=1.3, roughness="0.1nm", area="1mm^2"),
    ),
}


@pytest.mark.parametrize("case", TYPED)
def test_typed(command, case):
    words, name, source = TYPED[case]
    theirs = command("model", *words, "--modulus", "110GPa", "--pressure", "1MPa..100MPa:5")
    theirs.pop("error", None)
    assert rc.model(name, source(), modulus="110 GPa", pressure="1MPa..100MPa:5").to_dict() == theirs


@pytest.mark.parametrize("name", ["gw", "bgt", "greenwood-elliptical", "persson", "equation", "stacked", "multiscale"])
def test_of_a_surface(command, file, name):
    theirs = command("model", name, file, "--modulus", "110GPa", "--pressure", "1MPa,100MPa,1GPa")
    theirs.pop("error", None)
    ours = rc.model(name, rc.read(file), modulus="110 GPa", pressure="1MPa,100MPa,1GPa")
    assert ours.to_dict() == theirs


def test_greenwood_williamson_against_its_integrals():
    """p = 4/3 E* eta sqrt(R) int (z-d)^(3/2) phi dz, A = pi eta R int (z-d) phi dz: doi:10.1098/rspa.1966.0242."""
    eta, radius, s, e_star = 3e10, 5e-6, 0.3e-6, 110e9
    d = np.array([0.3e-6, 0.6e-6, 0.9e-6])
    found = rc.model("gw", rc.Asperities(density=f"{eta}m^-2", radius=radius * rc.units.m, height_std=s * rc.units.m),
                     modulus=e_star * rc.units.Pa, separation=d * rc.units.m)

    def moment(x, n):
        t = x / s
        phi = lambda u: (u - t) ** n * np.exp(-u * u / 2) / np.sqrt(2 * np.pi)  # noqa: E731
        return s**n * integrate.quad(phi, t, t + 20, epsabs=0, epsrel=1e-12)[0]

    p = [4 / 3 * e_star * eta * np.sqrt(radius) * moment(x, 1.5) for x in d]
    area = [np.pi * eta * radius * moment(x, 1) for x in d]
    np.testing.assert_allclose(found.mean_pressure, p, rtol=1e-10)
    np.testing.assert_allclose(found.area_fraction, area, rtol=1e-10)
    # And back: the pressures lead to the same separations.
    back = rc.model("gw", rc.Asperities(density=f"{eta}m^-2", radius=radius * rc.units.m, height_std=s * rc.units.m),
                    modulus=e_star * rc.units.Pa, pressure=found.mean_pressure * rc.units.Pa)
    np.testing.assert_allclose(back.separation, d, rtol=1e-9)
    root = optimize.brentq(lambda x: 4 / 3 * e_star * eta * np.sqrt(radius) * moment(x, 1.5) - p[1], 0, 2e-6)
    assert root == pytest.approx(d[1], rel=1e-9)


def test_refusals():
    moments = rc.Moments(m0="0.36um^2", m2=0.006, m4="4e9m^-2")
    ask = {"modulus": "110 GPa", "pressure": "1MPa"}
    with pytest.raises(rc.UnitError):
        rc.Moments(m0=0.36e-12, m2=0.006, m4="4e9m^-2")
    with pytest.raises(rc.SettingError, match="persson"):
        rc.model("nobody", moments, **ask)
    with pytest.raises(rc.SettingError, match="max_amplitude_ratio"):
        rc.model("stacked", moments, **ask)
    with pytest.raises(rc.SettingError, match="gw"):
        rc.model("persson", moments, modulus="110 GPa", separation="1um")
    with pytest.raises(rc.ModelError) as caught:
        rc.model("majumdar-bhushan", rc.Fractal(dimension=1.6, roughness="0.1nm", area="1mm^2"), **ask)
    assert "1.6" in str(caught.value) and caught.value.result.errors[0] is not None
    with pytest.raises(TypeError):
        rc.model("gw", 3, **ask)
    with pytest.raises(TypeError):
        rc.model("gw", moments, modulus="110 GPa")
    # More than the whole surface at the second load: that one has no answer.
    some = rc.model("gw", moments, modulus="110 GPa", pressure="1MPa,1TPa")
    assert np.isnan(some.area_fraction).tolist() == [False, True] and some.errors[0] is None
    assert "more than the whole surface" in str(some.errors[1])
    again = pickle.loads(pickle.dumps(some))
    assert again.to_dict() == some.to_dict() and "Greenwood" in repr(some)
    assert pickle.loads(pickle.dumps(moments)) == moments


def test_a_joint_from_height_slope_and_hardness() -> None:
    roughness = rc.Numbers(rms_height="0.6um", mean_slope=0.1)
    asked = {"conductivity": "180W/m/K,16W/m/K", "pressure": "1MPa,10MPa", "hardness": "1.2GPa"}
    found = rc.model("cmy", roughness, area="400mm2", **asked)
    for point, expected in zip(found.json["points"], [7272.82, 64819.1]):
        assert abs(point["thermal_conductance"] / expected - 1) < 1e-6
        assert abs(point["thermal_resistance"] * point["thermal_conductance"] * 4e-4 - 1) < 1e-12
    air = rc.model("cmy", roughness, gas={"gas": "air", "accommodation": 0.9}, **asked).json["points"][0]
    assert air["joint_conductance"] > air["gas_conductance"] > 0
    two = rc.Numbers(rms_height="0.36um,0.48um", mean_slope=[0.06, 0.08])
    both = rc.model("cmy", two, **asked).json["points"][0]["thermal_conductance"]
    assert abs(both / found.json["points"][0]["thermal_conductance"] - 1) < 1e-12
    with pytest.raises(rc.ModelError):
        rc.model("cmy", roughness, **{**asked, "pressure": "2GPa"})
    made = rc.synth((64, 64), pixel="1um", hurst=0.8, rolloff="16um", cutoff="6um", rms_height="0.6um", seed=1)
    of_map = rc.model("cmy", made, **asked).json["points"][0]
    assert abs(of_map["thermal_resistance"] * of_map["thermal_conductance"] * 64e-6**2 - 1) < 1e-12
    with pytest.raises(rc.SettingError, match="modulus is no input of cmy"):
        rc.model("cmy", roughness, modulus="110 GPa", **asked)
    with pytest.raises(rc.SettingError, match="conductivity = 0"):
        rc.model("cmy", roughness, **{**asked, "conductivity": "0W/m/K"})
    with pytest.raises(rc.SettingError, match="modulus or bodies"):
        rc.model("mikic", made, conductivity="180W/m/K", pressure="1MPa")
    with pytest.raises(TypeError):
        rc.model("cmy", roughness, gas="air", pressure="1MPa", hardness="1.2GPa")


@pytest.mark.parametrize("name", ["persson", "gw", "bgt"])
def test_a_closed_form_on_arrays(rough, name):
    f = rc.ClosedForm(name, rough, modulus="110 GPa")
    pressure = np.geomspace(1, 300, 6).reshape(2, 3)
    found = rc.model(name, rough, modulus="110 GPa", pressure=pressure.ravel() * rc.units.MPa)
    assert f(pressure * rc.units.MPa).tolist() == found.area_fraction.reshape(2, 3).tolist()
    np.testing.assert_array_equal(f.mean_gap(pressure * rc.units.MPa).ravel(), found.mean_gap)
    assert f("10 MPa,20MPa").shape == (2,) and f(10 * rc.units.MPa).shape == ()
    holed = f(np.ma.masked_invalid([1, np.nan]) * rc.units.MPa)
    assert np.isnan(holed).tolist() == [False, True]
    again = pickle.loads(pickle.dumps(f))
    assert again("10 MPa") == f("10 MPa")
    with pytest.raises(rc.UnitError):
        f(1e6)


def test_a_closed_form_on_arrays_is_fast():
    """No text is made of each number: 0.03 us a pressure for 5.5 us."""
    moments = rc.Moments(m0="0.36um^2", m2=0.006, m4="4e9m^-2")
    f = rc.ClosedForm("persson", moments, modulus="110 GPa")
    pressure = np.linspace(1, 300, 2000) * rc.units.MPa
    times = []
    for call in (f, lambda p: rc.model("persson", moments, modulus="110 GPa", pressure=p)):
        start = time.perf_counter()
        call(pressure)
        times.append(time.perf_counter() - start)
    assert times[0] < 0.2 * times[1]
