"""Materials of the table and a work of adhesion."""

import math

import pytest

import rough_contact as rc


def test_a_material_is_a_body_of_the_table() -> None:
    copper = rc.material("Copper")
    assert (copper.young, copper.poisson) == (117e9, 0.34)
    assert copper.hardness == pytest.approx(369e6 / math.sin(math.radians(68)), rel=1e-9)
    assert "annealed" in copper.name
    assert "copper" in rc.materials() and len(rc.materials()) >= 25
    assert rc.material("pdms").hardness is None
    with pytest.raises(rc.SettingError, match="steel-304"):
        rc.material("steel")
    with pytest.raises(rc.SettingError, match="Poisson"):
        rc.material("pmma")


def test_whether_bodies_stick_is_said() -> None:
    s = rc.synth((64, 64), pixel="1um", hurst=0.8, rolloff="32um", cutoff="8um", rms_gradient=0.1, seed=1)
    steel = rc.solve(s, modulus="115 GPa", pressure="100MPa", work_of_adhesion="50 mJ/m2")
    assert any("Adhesion is negligible" in f.claim for f in steel.findings)
    with pytest.warns(rc.ContactWarning, match="not negligible"):
        rubber = rc.solve(s, modulus="1 MPa", pressure="1kPa", work_of_adhesion=0.05 * rc.units.J / rc.units.m**2)
    assert any("does not model it" in f.claim for f in rubber.findings)
    with pytest.raises(rc.UnitError):
        rc.solve(s, modulus="1 MPa", pressure="1kPa", work_of_adhesion=0.05)
    with pytest.raises(rc.SettingError):
        rc.solve(s, modulus="1 MPa", pressure="1kPa", work_of_adhesion="-1 mJ/m2")
