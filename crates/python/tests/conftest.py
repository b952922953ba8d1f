"""Surfaces and the command, for all tests."""

import json
import os
import subprocess
from pathlib import Path

import pytest

import rough_contact as rc

ROOT = Path(__file__).resolve().parents[3]


@pytest.fixture(scope="session")
def command():
    """The command as JSON: its path in ROUGH_CONTACT, or as the workspace builds it."""
    named = os.environ.get("ROUGH_CONTACT")
    places = [Path(named)] if named else [ROOT / "target" / p / "rough-contact" for p in ("release", "debug")]
    found = next((place for place in places if place.exists()), None)
    if found is None:
        pytest.skip("the command is not built; set ROUGH_CONTACT to its path")

    def run(*words):
        done = subprocess.run([found, *map(str, words), "--json", "--quiet"], capture_output=True, text=True, check=False)
        return json.loads(done.stdout)

    return run


@pytest.fixture(scope="session")
def rough():
    """64 x 48 points with room for light and heavy contact."""
    return rc.synth((64, 48), pixel="1um", hurst=0.8, rolloff="20um", cutoff="4um", rms_height="0.4um", seed=7)


@pytest.fixture(scope="session")
def file(rough, tmp_path_factory):
    """The same in a file that says its units."""
    path = tmp_path_factory.mktemp("maps") / "rough.x3p"
    rough.write(path)
    return path
