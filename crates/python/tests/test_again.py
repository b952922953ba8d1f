"""What is repeated: run files, exact solutions, traces of ridges. The command answers the same."""

import math

import numpy as np
import pytest

import rough_contact as rc

from test_compare import timeless


def test_a_run_file_repeats_the_study(file, rough, tmp_path):
    s = rc.read(file, form="polynomial:2", crop=(2, 3, 40, 32))
    first = rc.compare([s, rough], modulus="110 GPa", pressure="100MPa,1GPa", models=["persson", "gw"])
    first.write(tmp_path / "first")
    again = rc.rerun(tmp_path / "first" / "run.toml", threads=1)
    assert list(again.surfaces) == list(first.surfaces)
    assert timeless(again.to_dict()["surfaces"]) == timeless(first.to_dict()["surfaces"])
    assert again.to_dict()["settings"] == {**first.to_dict()["settings"], "threads": 1}


def test_a_run_file_of_the_command(command, file, tmp_path):
    theirs = command("compare", file, "--modulus", "110GPa", "--pressure", "100MPa", "--models", "persson", "--out", tmp_path / "a")
    again = rc.rerun(tmp_path / "a" / "run.toml")
    assert timeless(again.to_dict()["surfaces"]) == timeless(theirs["surfaces"])


def test_what_cannot_be_repeated_is_refused(file, tmp_path):
    copy = tmp_path / "copy.x3p"
    copy.write_bytes(file.read_bytes())
    before = rc.read(copy)
    rc.synth((64, 48), pixel="1um", hurst=0.8, rolloff="20um", cutoff="4um", rms_height="0.4um", seed=8).write(copy, overwrite=True)
    rc.compare(before, modulus="110 GPa", pressure="100MPa", models=["gw"]).write(tmp_path / "a")
    with pytest.raises(rc.SettingError, match="has changed since"):
        rc.rerun(tmp_path / "a" / "run.toml")
    array = rc.Surface(rc.read(file).heights, pixel="1um", height_unit="m", name="mine")
    rc.compare(array, modulus="110 GPa", pressure="100MPa", models=["gw"]).write(tmp_path / "b")
    with pytest.raises(rc.SettingError, match="'mine' was handed over"):
        rc.rerun(tmp_path / "b" / "run.toml")
    other = tmp_path / "other.toml"
    other.write_text("a = 1")
    with pytest.raises(rc.SettingError, match="no run file"):
        rc.rerun(other)
    with pytest.raises(FileNotFoundError):
        rc.rerun(tmp_path / "none.toml")


def test_the_validation_is_that_of_the_command(command):
    found = rc.validate(finest=64)
    assert found.to_dict() == command("validate", "--finest", "64")
    assert len(found) == len(found.to_pandas()) > 5
    assert {row["case"] for row in found.rows} >= {"sinusoid"}
    assert all(row["exact"] > 0 and abs(row["error"]) < 0.2 for row in found.rows if row["shape"][-1] >= 64)
    with pytest.raises(rc.SettingError):
        rc.validate(finest=2)


@pytest.fixture(scope="module")
def wave(tmp_path_factory):
    """Sixteen periods of a cosine of 0.2 um along 4096 points, in two columns."""
    x = np.arange(4096) * 0.0625
    path = tmp_path_factory.mktemp("ridges") / "wave.txt"
    np.savetxt(path, np.column_stack([x, 0.2 * np.cos(2 * np.pi * x / 16)]), fmt="%.12f")
    return path


UNITS = {"layout": "list", "lateral_unit": "um", "height_unit": "um"}


def test_ridges_in_plane_strain_are_westergaard_s(command, wave):
    trace = rc.read_profile(wave, **UNITS)
    full = math.pi * 100e9 * 0.2 / 16  # Pa, at which all touches: Westergaard 1939
    curve = rc.solve(trace, modulus="100 GPa", pressure=[0.2 * full, 0.5 * full] * rc.units.Pa, plane_strain=True, maps=True)
    exact = 2 / math.pi * np.arcsin(np.sqrt([0.2, 0.5]))
    assert np.allclose(curve.area_fraction, exact, rtol=0.02)
    assert curve.pressure(0).shape == (1, 4096)
    words = ["--layout", "list", "--lateral-unit", "um", "--height-unit", "um", "--plane-strain", "--modulus", "100GPa"]
    theirs = command("solve", wave, *words, "--pressure", ",".join(f"{p!r}Pa" for p in [0.2 * full, 0.5 * full]))
    assert timeless(curve.to_dict()["points"]) == timeless(theirs["points"])


def test_what_is_no_section_of_ridges_is_refused(rough, wave):
    trace = rc.read_profile(wave, **UNITS)
    with pytest.raises(rc.SettingError, match="plane_strain=True"):
        rc.solve(trace, modulus="100 GPa", pressure="1GPa")
    with pytest.raises(rc.SettingError, match="this is a profile"):
        rc.Solver(modulus="100 GPa").solve(trace, pressure="1GPa")
    with pytest.raises(rc.SettingError, match="this is a map"):
        rc.solve(rough, modulus="100 GPa", pressure="1GPa", plane_strain=True)
    for more in ({"accuracy": "3%"}, {"stiffness": True}, {"boundary": "free"}, {"against": rough}):
        with pytest.raises(rc.SettingError, match="plane_strain"):
            rc.solve(trace, modulus="100 GPa", pressure="1GPa", plane_strain=True, **more)
    filtered = rc.read_profile(wave, s_filter="5um", **UNITS)
    with pytest.raises(rc.SettingError, match="no period"):
        rc.solve(filtered, modulus="100 GPa", pressure="1GPa", plane_strain=True)
