"""A second body on the first: the same numbers as the command, to the last digit."""

import pytest

import rough_contact as rc

from test_command import without_times


@pytest.fixture(scope="module")
def bodies(rough, file, tmp_path_factory):
    """Two files, of other roughness."""
    second = rc.synth((64, 48), pixel="1um", hurst=0.7, rolloff="16um", cutoff="4um", rms_height="0.2um", seed=11)
    path = tmp_path_factory.mktemp("second") / "second.x3p"
    second.write(path)
    return file, path


PLACED = {
    "as a book": ([], {}),
    "as a calendar": (["--flip", "rows"], {"flip": "rows"}),
    "moved": (["--flip", "none", "--shift", "5um,-3um"], {"flip": "none", "shift": "5um,-3um"}),
    "moved, rows first": (["--shift", "5um,3um"], {"shift": ["3um", "5um"]}),
}


@pytest.mark.parametrize("case", PLACED)
def test_solve(command, bodies, case):
    words, arguments = PLACED[case]
    first, second = bodies
    load = ["--modulus", "110GPa", "--pressure", "100MPa,1GPa"]
    theirs = command("solve", first, "--against", second, *load, *words)
    ours = rc.solve(
        rc.read(first), modulus="110 GPa", pressure="100MPa,1GPa", against=rc.read(second), on_failure="keep", **arguments
    ).to_dict()
    theirs.pop("error", None)
    assert ours["pair"]["second"]["name"] == "second.x3p"
    assert without_times(ours) == without_times(theirs)


def test_load_is_over_the_common_part(command, bodies, tmp_path):
    first, second = bodies[0], tmp_path / "smaller.x3p"
    rc.read(bodies[1]).cropped(5, 5, 40, 30).write(second)
    words = ["--shift", "10um,0um", "--flip", "none", "--load", "1mN", "--modulus", "110GPa"]
    theirs = command("solve", first, "--against", second, *words)
    theirs.pop("error", None)
    ours = rc.solve(
        rc.read(first), modulus="110 GPa", load="1mN", against=rc.read(second), flip="none", shift="10um,0um", on_failure="keep"
    ).to_dict()
    rows, columns = ours["pair"]["shape"]
    assert rows <= 40 and columns <= 30
    assert ours["load_area"] == pytest.approx(rows * columns * 1e-12, rel=1e-9)
    assert without_times(ours) == without_times(theirs)


def test_statistics(command, bodies):
    first, second = bodies
    theirs = command("stats", first, "--against", second, "--flip", "rows")
    ours = rc.read(first).statistics(against=rc.read(second), flip="rows").to_dict()
    assert ours == theirs


@pytest.mark.parametrize("case", ["as a book", "moved"])
@pytest.mark.parametrize("name", ["gw", "persson", "stacked", "equation"])
def test_closed_forms(command, bodies, name, case):
    words, arguments = PLACED[case]
    first, second = bodies
    theirs = command("model", name, first, "--against", second, *words, "--modulus", "110GPa", "--pressure", "10MPa,1GPa")
    theirs.pop("error", None)
    ours = rc.model(name, rc.read(first), modulus="110 GPa", pressure="10MPa,1GPa", against=rc.read(second), **arguments)
    assert ours.to_dict() == theirs and theirs["pair"]["second"]["name"] == "second.x3p"
    # Two bodies are rougher than one.
    alone = rc.model(name, rc.read(first), modulus="110 GPa", pressure="10MPa,1GPa")
    assert (ours.area_fraction < alone.area_fraction).all()


def test_study(command, bodies, tmp_path):
    first, second = bodies
    theirs = command("compare", first, "--against", second, "--modulus", "110GPa", "--pressure", "100MPa,1GPa", "--out", tmp_path / "o")
    study = rc.compare(rc.read(first), modulus="110 GPa", pressure="100MPa,1GPa", against=rc.read(second), on_failure="keep")
    theirs = theirs["surfaces"][0]
    ours = study.json["surfaces"][0]
    assert ours["name"] == theirs["name"] and ours["pair"] == theirs["pair"] and ours["inputs"] == theirs["inputs"]
    for mine, other in zip(ours["deterministic"]["points"], theirs["deterministic"]["points"], strict=True):
        assert {**mine, "seconds": 0} == {**other, "seconds": 0}
    assert "pressed" in study.html or "against" in study.html


def test_a_pair_of_one_name_is_told_apart(bodies):
    first = rc.read(bodies[0])
    pair = rc.solve(first, modulus="110 GPa", pressure="1 GPa", against=first, flip="none", on_failure="keep").json["pair"]
    assert pair["first"]["name"] != pair["second"]["name"]


def test_what_is_refused(bodies, rough):
    with pytest.raises(TypeError, match="give against= too"):
        rc.solve(rough, modulus="110 GPa", pressure="1 GPa", flip="rows")
    with pytest.raises(TypeError, match="against takes an rc.Surface"):
        rc.solve(rough, modulus="110 GPa", pressure="1 GPa", against="second.x3p")
    with pytest.raises(TypeError, match="second body on a surface"):
        rc.model("gw", rc.Moments(m0="1um^2", m2=0.01, m4="1e10m^-2"), modulus="110 GPa", pressure="1MPa", against=rough)
    with pytest.raises(rc.UnitError, match="pair"):
        rc.solve(rough, modulus="110 GPa", pressure="1 GPa", against=rough, shift="5um")
    with pytest.raises(rc.SettingError):
        part = rough.cropped(0, 0, 40, 40)  # which does not repeat
        rc.solve(part, modulus="110 GPa", pressure="1 GPa", against=part, flip="none", shift=["1mm", "1mm"])
