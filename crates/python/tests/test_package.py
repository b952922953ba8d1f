"""The package itself: its help, types, imports and licences."""

import ast
import importlib.metadata
import pydoc
import re
import subprocess
import sys
from pathlib import Path

import pytest

import rough_contact as rc

HERE = Path(rc.__file__).parent


def helped(thing):
    return pydoc.plain(pydoc.render_doc(thing))


def test_results_explain_themselves():
    text = helped(rc.LoadCurve)
    units = rc.LoadCurve.units()
    for name in ("touching_fraction", "area_fraction", "mean_gap", "interpolation_indicator", "area_prediction_interval", "solver_seconds"):
        assert f"{name} : {units[name]}\n" in text, name
    assert "Points that carry pressure over all points" in text and "less 0.1013 points for each edge" in text
    for name in vars(rc.Point)["__dataclass_fields__"]:
        field = rc.Point.__dataclass_fields__[name]
        assert field.metadata["meaning"] and f"{name} : " in helped(rc.Point), name


def test_help_is_a_page():
    lines = helped(rc).splitlines()
    assert len(lines) < 120 and any("`solve`" in line for line in lines)


def imports(path):
    """The modules of this package that a module imports, anywhere in it."""
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.ImportFrom) and node.level == 1:
            yield from [node.module] if node.module else [alias.name for alias in node.names]


def test_imports_go_one_way():
    graph = {path.stem: set(imports(path)) for path in HERE.glob("*.py") if path.stem != "__init__"}
    done = set()

    def visit(name, above):
        assert name not in above, f"{' -> '.join(above)} -> {name}"
        if name not in done:
            for other in graph.get(name, ()):
                visit(other, [*above, name])
            done.add(name)

    for name in graph:
        visit(name, [])


TYPED = """
import numpy as np
import rough_contact as rc
s = rc.synth((8, 8), pixel='1um', hurst=0.8, rolloff='8um', cutoff='4um', rms_gradient=0.1, seed=1)
"""


@pytest.mark.parametrize(
    ("line", "is_right"),
    [
        ("rc.solve(s, modulus='110 GPa', pressure=['1MPa', '2MPa'])", True),
        ("rc.solve(s, modulus=110 * rc.units.GPa, pressure=np.ones(3) * rc.units.MPa)", True),
        ("rc.Moments(m0=1e-12 * rc.units.m**2, m2=0.1, m4=3e12 / rc.units.m**2)", True),
        ("rc.read(b'', pixel=('1um', '2um'))", True),
        ("rc.solve(s, modulus=110e9, pressure='1MPa')", False),
        ("rc.solve(s, modulus='110 GPa', pressure=[1e6, 2e6])", False),
        ("rc.solve(s, modulus='110 GPa', pressure=np.ones(3))", False),
        ("rc.Body(young=210e9, poisson=0.3)", False),
        ("rc.um", False),
    ],
)
def test_types(line, is_right, typed):
    assert (line not in typed) == is_right


@pytest.fixture(scope="module")
def typed(tmp_path_factory):
    """The lines that a type checker refuses."""
    pytest.importorskip("mypy")
    from mypy import api

    mark = next(m for m in test_types.pytestmark if m.name == "parametrize")
    lines = [line for line, _ in mark.args[1]]
    path = tmp_path_factory.mktemp("types") / "typed.py"
    path.write_text(TYPED + "\n".join(lines) + "\n")
    said, trouble, _ = api.run(["--strict", "--no-incremental", "--no-error-summary", str(path)])
    assert not trouble, trouble
    text = path.read_text().splitlines()
    wrong = {text[int(message.split(":")[1]) - 1] for message in said.splitlines() if ": error:" in message}
    assert wrong, said
    return wrong


def test_what_is_not_installed_is_named(monkeypatch, rough):
    for module in ("pandas", "xarray", "matplotlib", "matplotlib.pyplot"):
        monkeypatch.setitem(sys.modules, module, None)
    for call, name in ((rough.to_xarray, "tables"), (rough.statistics().to_pandas, "tables"), (rough.plot, "plot")):
        with pytest.raises(ImportError, match=rf"pip install 'rough-contact\[{name}\]'"):
            call()


def test_as_a_module():
    done = subprocess.run([sys.executable, "-m", "rough_contact", "--version"], capture_output=True, text=True, check=False)
    if done.returncode:
        assert done.returncode == 3 and "comes without it" in done.stderr
    else:
        assert done.stdout.startswith("rough-contact ")


def test_both_licences_come_along():
    files = importlib.metadata.files("rough-contact") or []
    named = {path.name for path in files if ".dist-info" in str(path)}
    if not any(str(path).endswith(".pth") for path in files):
        assert {"LICENSE-MIT", "LICENSE-APACHE"} <= named
    else:
        pytest.skip("installed from the sources")


def test_the_wheel_runs_on_old_systems():
    """On Linux with the C library of 2018: manylinux_2_28."""
    tags = importlib.metadata.distribution("rough-contact").read_text("WHEEL") or ""
    found = re.findall(r"manylinux_2_(\d+)", tags)
    if not found:
        pytest.skip("not made for other systems")
    assert min(map(int, found)) <= 28


def test_a_build_without_cargo_says_what_is_missing(tmp_path):
    """As pip asks the source distribution for what its build needs."""
    backend = Path(__file__).parents[1] / "backend"
    code = "import maturin_with_cargo; maturin_with_cargo.get_requires_for_build_wheel()"
    (tmp_path / "maturin.py").write_text("def get_requires_for_build_wheel(settings):\n    return []\n")
    environment = {"PATH": str(tmp_path), "PYTHONPATH": f"{backend}:{tmp_path}"}
    asked = subprocess.run([sys.executable, "-c", code], env=environment, capture_output=True, text=True, check=False)
    assert asked.returncode != 0 and "https://rustup.rs" in asked.stderr
