"""The study, and models of one's own."""

import json
import pickle
import sys
import time
from dataclasses import dataclass

import numpy as np
import pytest
from scipy import special

import rough_contact as rc


@dataclass
class Mine:
    """Persson's area with a free factor: erf(w sqrt(2) p/(E* g)), doi:10.1063/1.1388626."""

    w: float = 1.0
    name: str = "mine"
    citation: str = "after Persson, doi:10.1063/1.1388626"

    def area_fraction(self, pressure, inputs):
        return special.erf(self.w * np.sqrt(2) * pressure / (inputs.modulus * inputs.rms_gradient))


def timeless(value):
    """Without what differs from run to run."""
    if isinstance(value, dict):
        left_out = ("seconds", "setup_seconds", "preparation_seconds", "explanation", "path", "unix_time", "made", "repeat", "versions", "threads")
        return {k: timeless(v) for k, v in value.items() if k not in left_out}
    return [timeless(v) for v in value] if isinstance(value, list) else value


def test_the_same_results_as_the_command(command, file, tmp_path):
    theirs = command("compare", file, "--modulus", "110GPa", "--pressure", "100MPa,1GPa", "--out", tmp_path / "a")
    theirs.pop("error", None)
    study = rc.compare(rc.read(file), modulus="110 GPa", pressure="100MPa,1GPa")
    assert timeless(study.to_dict()) == timeless(theirs)
    study.write(tmp_path / "b")
    ours = json.loads((tmp_path / "b" / "results.json").read_text())
    assert timeless(ours) == timeless(json.loads((tmp_path / "a" / "results.json").read_text()))
    assert sorted(p.name for p in (tmp_path / "b").iterdir()) == sorted(p.name for p in (tmp_path / "a").iterdir())
    run = [(tmp_path / d / "run.toml").read_text().split("\n") for d in "ab"]
    assert [line for line in run[0] if "threads" not in line] == [line for line in run[1] if "threads" not in line]
    with pytest.raises(FileExistsError):
        study.write(tmp_path / "b")


@pytest.mark.parametrize(
    ("words", "arguments"),
    [
        (["--hardness", "20GPa"], {"hardness": "20 GPa"}),
        (
            ["--resistivity", "22nohm.m,70nohm.m", "--conductivity", "400W/m/K"],
            {"resistivity": [22e-9 * rc.units.ohm * rc.units.m, 70e-9 * rc.units.ohm * rc.units.m], "conductivity": 400 * rc.units.W / rc.units.m / rc.units.K},
        ),
        (["--edges", "mirrored", "--level", "mean"], {"edges": "mirrored", "level": "mean"}),
        (["--leak", "both"], {"leak": "both"}),
        (
            "--leak y --viscosity 1mPa.s --pressure-drop 1MPa --seal-length 1mm --seal-width 10mm".split(),
            {"leak": "y", "viscosity": "1 mPa.s", "pressure_drop": "1 MPa", "seal_length": "1mm", "seal_width": "10 mm"},
        ),
    ],
)
def test_options_are_those_of_the_command(command, file, tmp_path, words, arguments):
    ask = ["--modulus", "110GPa", "--pressure", "100MPa,1GPa", "--models", "persson", *words]
    theirs = command("compare", file, *ask, "--out", tmp_path / "a")
    theirs.pop("error", None)
    study = rc.compare(rc.read(file), modulus="110 GPa", pressure="100MPa,1GPa", models=["persson"], **arguments)
    assert timeless(study.to_dict()) == timeless(theirs)


def test_loads_are_chosen_as_the_command_does(command, file, tmp_path):
    theirs = command("compare", file, "--modulus", "110GPa", "--models", "persson", "--out", tmp_path / "a")
    study = rc.compare(rc.read(file), modulus="110 GPa", models=["persson"], on_failure="keep")
    theirs = [p["mean_pressure"] for p in theirs["surfaces"][0]["deterministic"]["points"]]
    assert [p["mean_pressure"] for p in study["rough.x3p"].deterministic] == theirs


def test_a_model_of_ones_own_is_the_built_in_one(rough):
    """Persson's area from the same rms gradient: the numbers that the built-in model gives."""
    study = rc.compare(rough, modulus="110 GPa", pressure="100MPa..1GPa:4", models=["persson", Mine()])
    models = study["synth 7"].models
    np.testing.assert_allclose(models["mine"].area_fraction, models["persson"].area_fraction, rtol=1e-12)
    np.testing.assert_allclose(models["mine"].area_error.signed, models["persson"].area_error.signed, rtol=1e-9)
    points = study["synth 7"].deterministic
    solved = np.array([p["area_fraction"] for p in points])
    np.testing.assert_allclose(models["mine"].area_fraction / solved - 1, models["mine"].area_error.signed, rtol=1e-9)
    assert "mine" in study.html and "after Persson" in study.html
    # Its time is that of Python, not that of looking its answers up.
    class Slow(Mine):
        def area_fraction(self, pressure, inputs):
            time.sleep(0.04)
            return super().area_fraction(pressure, inputs)

    slow = rc.compare(rough, modulus="110 GPa", pressure="100MPa..1GPa:4", models=[Slow()])
    assert slow["synth 7"].models["mine"].seconds >= 0.01


@pytest.mark.parametrize(
    "how",
    [{}, {"hardness": "3GPa"}, {"hardness": "1GPa"}, {"fractal_range": "4um,24um"}, {"level": "quadratic"}, {"edges": "mirrored"}, {"pressure": "1GPa,100MPa"}],
)
def test_a_model_of_ones_own_gets_what_the_built_in_ones_get(rough, how):
    got = []

    class Seeing(Mine):
        def area_fraction(self, pressure, inputs):
            got.append((pressure, inputs))
            return super().area_fraction(pressure, inputs)

    study = rc.compare(rough, modulus="110 GPa", models=["persson", Seeing()], on_failure="keep", **how)["synth 7"]
    ((pressure, inputs),) = got
    assert pressure.tolist() == [point["mean_pressure"] for point in study.deterministic]
    theirs = study.statistics
    for name in ("rms_height", "rms_gradient", "m0", "m2", "m4", "bandwidth", "hurst", "rolloff", "cutoff"):
        assert getattr(inputs, name) == getattr(theirs, name), name
    assert inputs.statistics.fractal_range == theirs.fractal_range and inputs.statistics.dimension == theirs.dimension
    mine = study.models["mine"].area_fraction
    assert not np.isnan(mine).any()
    np.testing.assert_allclose(mine, study.models["persson"].area_fraction, rtol=1e-12)


def test_what_a_model_says_of_itself(rough):
    class Spoken(Mine):
        def applies(self, inputs):
            return answer

    ask = {"modulus": "110 GPa", "pressure": "100MPa,1GPa"}
    for answer in (True, np.True_):
        assert rc.compare(rough, models=Spoken(), **ask)["synth 7"].models["mine"].applicable
    for answer in (False, np.False_, "for rubber only"):
        assert not rc.compare(rough, models=[Spoken()], **ask)["synth 7"].models["mine"].applicable
    for answer in (1, None, np.array([True, True])):
        with pytest.raises(rc.ModelError, match="applies returned"):
            rc.compare(rough, models=[Spoken()], **ask)
    named = Mine(name="short", citation=None)
    named.title = "A name in full"
    found = rc.compare(rough, models=[named, "gw"], **ask)["synth 7"].models
    assert found["short"].title == "A name in full" and found["gw"].title.startswith("Greenwood")
    assert found["short"].citation.title == "a model given in Python"
    named.title = None
    assert rc.compare(rough, models=[named], **ask)["synth 7"].models["short"].title == "short"


def test_progress_counts_each_surface(rough, capsys, monkeypatch):
    monkeypatch.setitem(sys.modules, "tqdm.auto", None)
    rc.compare({"a": rough, "b": rough}, modulus="110 GPa", pressure="100MPa,1GPa", models="gw", progress=True)
    said = capsys.readouterr().err.replace("\r", "\n").split("\n")
    assert [line for line in said if line] == ["a: 1 of 2 loads", "a: 2 of 2 loads", "b: 1 of 2 loads", "b: 2 of 2 loads"]


def test_a_model_is_asked_once_for_each_surface(rough):
    calls = []

    class Counting(Mine):
        def area_fraction(self, pressure, inputs):
            calls.append((pressure.shape, inputs.rms_gradient))
            return super().area_fraction(pressure, inputs)

    other = rc.synth((64, 64), pixel="1um", hurst=0.7, rolloff="16um", cutoff="4um", rms_gradient=0.1, seed=2)
    study = rc.compare({"a": rough, "b": other}, modulus="110 GPa", pressure="100MPa,1GPa", models=[Counting()])
    assert len(calls) == 2 and calls[0][0] == (2,) and list(study) == ["a", "b"]
    assert calls[1][1] == pytest.approx(0.1, rel=0.2)
    frame = study.to_pandas()
    assert len(frame) == 4 and set(frame.surface) == {"a", "b"} and "area_error" in frame


def test_models_that_fail(rough):
    class Broken(Mine):
        def area_fraction(self, pressure, inputs):
            raise ZeroDivisionError("by nothing")

    class Elsewhere(Mine):
        def applies(self, inputs):
            return "for rubber only"

    class Wrong(Mine):
        def area_fraction(self, pressure, inputs):
            return 2 * np.ones_like(pressure)

    class Short(Mine):
        def area_fraction(self, pressure, inputs):
            return [0.1]

    ask = {"modulus": "110 GPa", "pressure": "100MPa,1GPa"}
    with pytest.raises(ZeroDivisionError):
        rc.compare(rough, models=[Broken()], **ask)
    kept = rc.compare(rough, models=[Broken()], on_failure="keep", **ask)["synth 7"].models["mine"]
    assert not kept.applicable and "by nothing" in kept.reason
    not_here = rc.compare(rough, models=[Elsewhere()], **ask)["synth 7"].models["mine"]
    assert not not_here.applicable and "for rubber only" in not_here.reason
    for model in (Wrong(), Short()):
        with pytest.raises(rc.ModelError):
            rc.compare(rough, models=[model], **ask)
    with pytest.raises(TypeError):
        rc.compare(rough, models=[3], **ask)
    with pytest.raises(rc.SettingError, match="persson"):
        rc.compare(rough, models=["nobody"], **ask)


def test_the_cheapest_model(rough):
    surface = rc.compare(rough, modulus="110 GPa", pressure="100MPa,1GPa")["synth 7"]
    best = surface.cheapest(within=0.5)
    fitting = [m for m in surface.models.values() if (m.area_error.mean_absolute or 9) <= 0.5]
    assert best is not None and best.seconds == min(m.seconds for m in fitting)
    assert surface.cheapest(within=1e-9) is None


def test_a_study_travels(rough):
    study = rc.compare(rough, modulus="110 GPa", pressure="1GPa", models=["gw"])
    again = pickle.loads(pickle.dumps(study))
    assert again.to_dict() == study.to_dict() and "<table>" in again._repr_html_()
    assert "Greenwood" in repr(again) and len(repr(again)) < 1000


def test_models_have_sources():
    found = {model.name: model for model in rc.models()}
    assert {"gw", "bgt", "persson"} <= set(found)
    assert found["persson"].citation.doi.startswith("10.") and found["gw"].separation


def test_a_study_can_be_stopped(rough):
    class Enough(Exception):
        pass

    def stop(news):
        raise Enough

    with pytest.raises(Enough):
        rc.compare(rough, modulus="110 GPa", progress=stop)


def test_what_is_done_is_kept(rough):
    """Of a study that is stopped, by Ctrl-C or by an exception of the callback: the loads that were solved, by surface."""

    class Enough(Exception):
        pass

    for raised, caught in ((Enough, Enough), (KeyboardInterrupt, rc.Interrupted)):
        told = []

        def stop(news):
            told.append(news)
            if news.stage == "load" and news.index == 1:
                raise raised

        with pytest.raises(caught) as stopped:
            rc.compare({"a": rough, "b": rough}, modulus="110 GPa", pressure="10MPa,100MPa,1GPa", models=["gw"], progress=stop)
        kept = stopped.value.partial
        assert [p["mean_pressure"] for p in kept["a"]][:2] == [1e7, 1e8] and not kept["b"]
        assert 0 < kept["a"][0]["area_fraction"] < kept["a"][1]["area_fraction"]
        assert {news.stage for news in told} <= {"iteration", "load", "surface", "models"}
