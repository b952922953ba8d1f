"""The command that comes with the package."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

import rough_contact as rc

COMMAND = Path(sys.executable).parent / ("rough-contact.exe" if os.name == "nt" else "rough-contact")


@pytest.mark.skipif(not COMMAND.exists(), reason="installed from source, without the command")
def test_the_command_on_the_path_is_the_command(command, file):
    named = os.environ["ROUGH_CONTACT"]
    for words in (["--version"], ["--help"], ["stats", file, "--json"], ["solve", file, "--modulus", "bad"]):
        answers = [subprocess.run([which, *words], capture_output=True, check=False) for which in (COMMAND, named)]
        assert answers[0].stdout == answers[1].stdout and answers[0].returncode == answers[1].returncode, words
        assert answers[0].stderr == answers[1].stderr
    shown = subprocess.run([COMMAND, "--version"], capture_output=True, text=True, check=True).stdout
    assert rc.__version__ in shown
