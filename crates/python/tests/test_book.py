"""The examples of the book and of the two READMEs, run as they are printed."""

import doctest
import re
from pathlib import Path

import numpy as np
import pytest

import rough_contact as rc

ROOT = Path(__file__).resolve().parents[3]
PAGES = ["docs/src/python.md", "README.md", "crates/python/README.md"]
FLAGS = doctest.NORMALIZE_WHITESPACE | doctest.ELLIPSIS | doctest.IGNORE_EXCEPTION_DETAIL


class Spaces(doctest.OutputChecker):
    """Doctest takes only ASCII for a space; numbers and units are joined by narrow ones."""

    def check_output(self, want, got, optionflags):
        return super().check_output(want, got.replace("\u202f", " "), optionflags)


class Client:
    """What the page calls `client`, in this process."""

    def map(self, function, arguments):
        return [function(argument) for argument in arguments]

    def gather(self, futures):
        return futures


@pytest.mark.parametrize("page", PAGES)
def test_examples(page, tmp_path, monkeypatch):
    path = ROOT / page
    if not path.exists():
        pytest.skip("the sources are not here")
    blocks = re.findall(r"^```python\n(.*?)^```", path.read_text(encoding="utf-8"), re.M | re.S)
    assert blocks
    monkeypatch.chdir(tmp_path)
    ground = rc.synth((128, 128), pixel="1um", hurst=0.8, rolloff="64um", cutoff="8um", rms_gradient=0.1, seed=1, name="ground")
    ground.write("ground.x3p")
    ground.cropped(0, 0, 64, 64).write("map.x3p")
    names = {"rc": rc, "np": np, "s": ground, "heights": ground.heights, "paths": ["ground.x3p", "map.x3p"], "client": Client()}
    failed: list[str] = []
    for number, block in enumerate(blocks):
        if ">>>" in block:
            test = doctest.DocTestParser().get_doctest(block, names, f"{page} {number}", page, 0)
            doctest.DocTestRunner(checker=Spaces(), optionflags=FLAGS, verbose=False).run(test, out=failed.append, clear_globs=False)
            names = test.globs
        else:
            exec(compile(block, f"{page} {number}", "exec"), names)
    assert not failed, "".join(failed)
