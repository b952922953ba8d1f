"""Many maps on one page: what the command keeps of them, digit by digit."""

import json
import pickle

import numpy as np
import pytest

import rough_contact as rc

from test_compare import timeless


@pytest.fixture(scope="module")
def files(tmp_path_factory):
    """Three maps, and a file that is cut off."""
    folder = tmp_path_factory.mktemp("many")
    for seed in (1, 2, 3):
        made = rc.synth((48, 64), pixel="1um", hurst=0.8, rolloff="20um", cutoff="4um", rms_height="0.4um", seed=seed)
        made.write(folder / f"{seed}.x3p")
    (folder / "4.x3p").write_bytes((folder / "1.x3p").read_bytes()[:900])
    return folder


def one(path):
    return rc.compare({str(path): rc.read(path)}, modulus="110 GPa", pressure="100MPa,1GPa", on_failure="keep").digest()


@pytest.fixture(scope="module")
def page(files):
    kept, failed = [], {}
    for path in sorted(files.glob("*.x3p")):
        try:
            kept.append(pickle.loads(pickle.dumps(one(path))))
        except rc.ReadError as error:
            failed[str(path)] = error
    return rc.summary(kept, failed=failed)


def test_what_is_kept_is_what_the_command_keeps(command, files, page, tmp_path):
    theirs = command("compare", files, "--modulus", "110GPa", "--pressure", "100MPa,1GPa", "--summary", "--out", tmp_path / "a")
    kept = {f.pop("file"): f for f in theirs["files"]}
    assert [name for name, f in kept.items() if "shape" not in f] == list(page.failed)
    assert len(page) == 3 and set(page.maps) | set(page.failed) == set(kept)
    for name, ours in page.maps.items():
        other = kept[name]
        other.pop("error", None)
        # A study looks closer than a page over many does, and may find more to check.
        assert [c for c in ours["checks"] if c in other["checks"]] == other["checks"]
        left_out = ("checks", "to_check")
        assert timeless({k: v for k, v in ours.items() if k not in left_out}) == timeless({k: v for k, v in other.items() if k not in left_out})
    assert (tmp_path / "a" / "report.html").read_text().count("<figure") == page.html.count("<figure")


def test_page_and_table(page, tmp_path):
    assert repr(page) == "Summary(3 maps, 1 without an answer)"
    rows = page.records()
    assert len(rows) == 3 and all(np.isfinite(row["models.persson.area_error"]) for row in rows)
    assert "4.x3p" in page.html and "http:" not in page.html.replace("http://www.w3.org/2000/svg", "")
    assert json.dumps(page.to_dict())
    page.write(tmp_path / "page.html")
    assert (tmp_path / "page.html").read_text() == page.html
    with pytest.raises(FileExistsError):
        page.write(tmp_path / "page.html")
    assert list(page.to_pandas()["map"]) == list(page.maps)


def test_what_was_not_asked_the_same_is_refused(files, page):
    name = sorted(files.glob("*.x3p"))[0]
    first = one(name)
    with pytest.raises(rc.SettingError, match="called"):
        rc.summary([first, first])
    other = rc.compare({"other": rc.read(name)}, modulus="70 GPa", pressure="100MPa,1GPa", on_failure="keep")
    with pytest.raises(rc.SettingError, match="modulus"):
        rc.summary([first, other])
    with pytest.raises(rc.SettingError, match="at least one"):
        rc.summary([])


def test_distributions_of_a_study(files):
    study = rc.compare(rc.read(sorted(files.glob("*.x3p"))[0]), modulus="110 GPa", pressure="100MPa,1GPa", on_failure="keep")
    surface = study["1.x3p"]
    solved = rc.solve(rc.read(sorted(files.glob("*.x3p"))[0]), modulus="110 GPa", pressure="100MPa,1GPa", maps=True, distributions=True, on_failure="keep")
    i = [p["mean_pressure"] for p in surface.deterministic].index(surface.headline_pressure)
    assert surface.distributions == solved.to_dict()["points"][i]["distributions"]
    gap, pressure = solved.gap(i), solved.pressure(i)
    found = surface.distributions["gap"]
    apart = np.maximum(gap[pressure <= 0], 0)
    assert found["mean"] == pytest.approx(apart.mean(), rel=1e-12)
    share = [(np.count_nonzero(apart <= g) + np.count_nonzero(pressure > 0)) / gap.size for g in found["gaps"]]
    np.testing.assert_allclose(found["below"], share, atol=1.5 / gap.size)
