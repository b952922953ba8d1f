"""The same numbers as the command, to the last digit."""

import pytest

import rough_contact as rc


def without_times(answer):
    """What is left when every time is taken out."""
    if isinstance(answer, dict):
        # `explanation` is in words, with its time.
        return {key: without_times(value) for key, value in answer.items() if key not in ("seconds", "explanation")}
    return [without_times(value) for value in answer] if isinstance(answer, list) else answer


CASES = {
    "pressures": (["--pressure", "3GPa,1MPa..1GPa:5"], {"pressure": "3GPa,1MPa..1GPa:5"}),
    "gaps": (["--gap", "1um,300nm"], {"gap": ["1um", "300nm"]}),
    "forces": (["--load", "1N,2N"], {"load": "1N,2N"}),
    "area": (["--load", "1N", "--area", "2mm2"], {"load": "1N", "area": "2mm2"}),
    "accuracy": (["--pressure", "300MPa,1GPa", "--accuracy", "20%"], {"pressure": "300MPa,1GPa", "accuracy": 0.2}),
    "certified": (
        ["--pressure", "100MPa", "--stiffness", "--certify"],
        {"pressure": "100MPa", "stiffness": True, "certify": True},
    ),
    "hardness": (["--pressure", "100MPa", "--hardness", "20GPa"], {"pressure": "100MPa", "hardness": "20GPa"}),
    "conduction": (
        ["--pressure", "100MPa", "--resistivity", "22nohm.m,70nohm.m", "--conductivity", "400W/m/K"],
        {"pressure": "100MPa", "resistivity": ["22nohm.m", "70nohm.m"], "conductivity": "400W/m/K"},
    ),
    "leak": (
        "--pressure 100MPa --leak both --viscosity 1mPa.s --pressure-drop 1MPa --seal-length 1mm --seal-width 10mm".split(),
        {
            "pressure": "100MPa",
            "leak": "both",
            "viscosity": "1 mPa.s",
            "pressure_drop": "1 MPa",
            "seal_length": "1mm",
            "seal_width": "10 mm",
        },
    ),
    "free": (["--pressure", "100MPa", "--boundary", "free"], {"pressure": "100MPa", "boundary": "free"}),
    "mirrored": (
        ["--pressure", "100MPa", "--edges", "mirrored", "--distributions"],
        {"pressure": "100MPa", "edges": "mirrored", "distributions": True},
    ),
    "settings": (
        ["--pressure", "1GPa", "--method", "polonsky-keer", "--tolerance", "1e-6", "--level", "none"],
        {"pressure": "1GPa", "method": "polonsky-keer", "tolerance": 1e-6, "level": "none"},
    ),
    "single precision": (["--pressure", "1GPa", "--precision", "f32"], {"pressure": "1GPa", "precision": "f32"}),
    "not converged": (["--pressure", "1GPa", "--tolerance", "1e-15"], {"pressure": "1GPa", "tolerance": 1e-15}),
}


@pytest.mark.parametrize("case", CASES)
def test_solve(command, file, case):
    words, arguments = CASES[case]
    theirs = command("solve", file, "--modulus", "110GPa", *words)
    theirs.pop("error", None)
    ours = rc.solve(rc.read(file), modulus="110 GPa", on_failure="keep", **arguments).to_dict()
    assert without_times(ours) == without_times(theirs)


def test_bodies(command, file):
    elastic = ["--young", "210GPa", "--poisson", "0.3", "--young", "70GPa", "--poisson", "0.33"]
    theirs = command("solve", file, *elastic, "--pressure", "100MPa")
    pair = (rc.Body(young="210GPa", poisson=0.3), rc.Body(young=70 * rc.units.GPa, poisson=0.33))
    ours = rc.solve(rc.read(file), bodies=pair, pressure="100MPa").to_dict()
    assert without_times(ours) == without_times(theirs)
    assert ours["modulus"] == rc.contact_modulus(*pair)


def test_cleaning_and_fill(command, file):
    words = ["--outliers", "3", "--fill", "harmonic", "--form", "sphere", "--s-filter", "3um", "--l-filter", "30um"]
    theirs = command("solve", file, "--modulus", "110GPa", "--pressure", "100MPa", *words)
    s = rc.read(file, outliers=3, fill="harmonic", form="sphere", s_filter="3um", l_filter=30 * rc.units.um)
    ours = rc.solve(s, modulus="110 GPa", pressure="100MPa").to_dict()
    assert without_times(ours) == without_times(theirs)
    assert s.missing > 0 and len(s.cleaning) == 4


@pytest.mark.parametrize("boundary", ["open", "periodic"])
def test_statistics(command, file, boundary):
    theirs = command("stats", file, "--iso", "--scales", "--boundary", boundary)
    found = rc.read(file).statistics(iso=True, scales=True, boundary=boundary)
    assert found.to_dict() == theirs
    assert found.rms_gradient == theirs["rms_gradient"]
    assert found.iso25178["Sdr"] == theirs["iso25178"]["Sdr"]


def test_info(command, file):
    assert rc.info(file) == command("info", file)


def test_text_quantities_are_those_of_the_command(command, file):
    """Sixteen loads of a range, and the refusals with the same words."""
    theirs = command("solve", file, "--modulus", "110GPa", "--pressure", "1kPa..1GPa:16")
    ours = rc.solve(rc.read(file), modulus="110GPa", pressure="1kPa..1GPa:16")
    assert ours.mean_pressure.tolist() == [p["mean_pressure"] for p in theirs["points"]]
    refused = command("solve", file, "--modulus", "110Gpa", "--pressure", "1MPa")["error"]["message"]
    with pytest.raises(rc.UnitError, match="did you mean GPa"):
        rc.solve(rc.read(file), modulus="110Gpa", pressure="1MPa")
    assert "did you mean GPa" in refused
