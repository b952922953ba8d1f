"""The questions that command, page and app are asked too (fixtures/questions): the same numbers."""

import json
from pathlib import Path

import pytest

import rough_contact as rc

DATA = Path(__file__).resolve().parents[3] / "fixtures" / "questions"
QUESTIONS = json.loads((DATA / "questions.json").read_text())


def timeless(value):
    """Without what differs from run to run."""
    if isinstance(value, dict):
        left_out = ("explanation", "path", "unix_time", "made", "repeat", "versions", "threads", "speed")
        return {k: timeless(v) for k, v in value.items() if k not in left_out and "seconds" not in k}
    return [timeless(v) for v in value] if isinstance(value, list) else value


def body(given):
    if "material" in given:
        return rc.material(given["material"])
    return rc.Body(young=given["young"], poisson=given["poisson"])


def words(question):
    """As options of the command."""
    line = [DATA / question["file"]]
    for given in question["bodies"]:
        for key in ("material", "young", "poisson"):
            line += [f"--{key}", str(given[key])] if key in given else []
    keys = ("hardness", "pressure", "load", "area", "pixel", "lateral_unit", "height_unit", "level", "edges", "outliers", "crop", "layout")
    for key in keys:
        line += [f"--{key.replace('_', '-')}", str(question[key]).replace(" ", "")] if key in question else []
    line += ["--fill", question.get("fill", "harmonic")]
    line += ["--resistivity", ",".join(question["resistivity"])] if "resistivity" in question else []
    return line + (["--against", DATA / question["against"]] if "against" in question else [])


def ask(question):
    """In Python."""
    how = {key: question[key] for key in ("pixel", "height_unit", "outliers", "crop") if key in question}
    how["fill"] = question.get("fill", "harmonic")
    given = {"bodies": [body(b) for b in question["bodies"]], "hardness": question.get("hardness")}
    if "lateral_unit" in question:
        trace = rc.read_profile(DATA / question["file"], lateral_unit=question["lateral_unit"], height_unit=question["height_unit"], fill=how["fill"], layout="list")
        return rc.compare_profiles(trace, **given, pressure=question["pressure"]).to_dict()
    surface = rc.read(DATA / question["file"], **how)
    more = {key: question[key] for key in ("level", "edges") if key in question}
    if "resistivity" in question:
        more["resistivity"] = ",".join(question["resistivity"])
    if "against" in question:
        more["against"] = rc.read(DATA / question["against"], **how)
    return rc.compare(surface, **given, pressure=question["pressure"], **more).to_dict()


@pytest.mark.parametrize("question", QUESTIONS, ids=[q["name"] for q in QUESTIONS])
def test_the_numbers_are_those_of_the_command(command, question, tmp_path):
    if "load" in question:
        pytest.skip("rc.compare takes pressures")
    if "refused" in question:
        with pytest.raises(rc.SettingError):
            ask(question)
        return
    theirs = command("compare", *words(question), "--threads", "1", "--out", tmp_path / "a")
    ours = ask(question)
    for key in ("settings", "surfaces", "profiles", "materials"):
        assert timeless(ours.get(key)) == timeless(theirs.get(key)), key


def test_a_hardness_that_is_known_is_used(rough):
    both = (rc.material("steel-304"), rc.material("copper"))
    known = rc.solve(rough, bodies=both, pressure="10MPa")
    assert known.json["hardness"]["pascals"] == pytest.approx(both[1].hardness)
    assert [used["name"] for used in known.json["materials"]] == ["steel-304", "copper"]
    typed = rc.Body(young=both[1].young * rc.units.Pa, poisson=0.34, hardness="398MPa")
    assert rc.solve(rough, bodies=typed, pressure="10MPa").json["hardness"]["pascals"] == 398e6
    left_out = rc.solve(rough, bodies=both, pressure="10MPa", hardness="elastic")
    assert "hardness" not in left_out.json
    assert known.area_fraction[0] > 2 * left_out.area_fraction[0]
    assert rc.model("persson-yield", rough, bodies=both, pressure="10MPa").inputs["hardness"] == pytest.approx(both[1].hardness)
