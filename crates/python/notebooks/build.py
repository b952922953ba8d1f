"""Executes the notebooks of the cells below and writes them with their outputs; `--execute` writes nothing.

The text lives here, where a change shows; `--check` compares it with the notebooks.
"""

import sys
from pathlib import Path

import nbformat
from nbclient import NotebookClient
from nbformat.v4 import new_code_cell, new_markdown_cell, new_notebook

HERE = Path(__file__).parent

QUICK_START = [
    """# Quick start

How much of two rough surfaces really touches? A surface is read or made, a load is put on it, and every number comes
with how accurate it is. Quantities go in with units, and come out as floats in SI units.""",
    """
import rough_contact as rc

s = rc.synth((256, 256), pixel='1um', hurst=0.8, rolloff='64um', cutoff='8um', rms_gradient=0.1, seed=1, name='ground')
# A measured one: rc.read('map.x3p', fill='harmonic'); an array: rc.Surface(heights, pixel='1um', height_unit='nm')
s""",
    "Its roughness, each number with its unit. What may change a conclusion stands on top.",
    "s.statistics()",
    """## A measured file

A measurement is tilted, has spikes, and points are missing. One is made here, so that the notebook runs anywhere.""",
    """
import tempfile
from pathlib import Path

import numpy as np

rng = np.random.default_rng(1)
heights = s.heights + 1e-8 * np.arange(256)                              # a tilt
heights[tuple(rng.integers(0, 256, (2, 20)))] += 5e-6                    # spikes
heights[rng.random(heights.shape) < 0.002] = np.nan                      # missing points
path = Path(tempfile.mkdtemp()) / 'measured.npy'
np.save(path, heights)
rc.info(path, pixel='1um', height_unit='m')['missing']""",
    "Read, cleaned, solved and drawn. Spikes become missing, the tilt is taken off, missing points are filled from around them.",
    """
measured = rc.read(path, pixel='1um', height_unit='m', outliers=8, form='plane', fill='harmonic')
steel = rc.Body(young='210 GPa', poisson=0.3)
touching = rc.solve(measured, bodies=(steel, steel), pressure='10MPa..1GPa:5')
touching.plot()
[step['step'] for step in measured.cleaning], measured.missing""",
    "The contact of the surface with a flat, both of steel, at five loads. `±` is the error interval of the area.",
    """
curve = rc.solve(s, bodies=(steel, steel), pressure='10MPa..1GPa:5', maps=True)
curve""",
    "Numbers are numpy vectors under the names of the command's JSON; tables are pandas frames.",
    """
print(curve.area_fraction)
curve.to_pandas()[['mean_pressure', 'area_fraction', 'area_interval_low', 'area_interval_high', 'mean_gap']]""",
    """
import matplotlib.pyplot as plt

figure, (left, right) = plt.subplots(1, 2, figsize=(10, 4))
curve.plot(left)
right.imshow(curve.pressure(2) / 1e9, cmap='magma', interpolation='nearest')
right.set_title(f'pressure (GPa) at {curve.mean_pressure[2] / 1e6:.0f} MPa')
figure.tight_layout()""",
    "The area for an error of at most 10 %: grid, precision and tolerance are chosen for it.",
    """
planned = rc.solve(s, modulus='115 GPa', pressure='300 MPa', accuracy='10%')
print(planned.accuracy['explanation'])""",
]

WHICH_MODEL = [
    """# Which model on my surface?

Closed forms are a million times cheaper than a solution of the contact, and wrong by an amount that depends on the
surface. `compare` solves the contact and asks every model beside it.""",
    """
import numpy as np
import rough_contact as rc

s = rc.synth((256, 256), pixel='1um', hurst=0.8, rolloff='64um', cutoff='8um', rms_gradient=0.1, seed=1, name='ground')
study = rc.compare(s, modulus='110 GPa')
study""",
    "The cheapest model whose area is right within 10 % on average over the loads:",
    """
best = study['ground'].cheapest(within=0.10)
print(f'{best.title}: {best.area_error.mean_absolute:.0%}, {best.seconds * 1e9:.0f} ns a load' if best else 'none within 10 %')""",
    "Signed errors by load, one column for each model:",
    """
table = study.to_pandas().pivot(index='mean_pressure', columns='model', values='area_error')
table.round(2)""",
    """A model of one's own needs a name and an area fraction. It is called once for each surface with all loads, and
stands in table and report beside the others.""",
    """
from dataclasses import dataclass
from math import erf, sqrt

@dataclass
class Corrected:
    'Persson (2001), doi:10.1063/1.1388626, with a factor in front of the load.'
    factor: float
    name: str = 'corrected'

    def area_fraction(self, pressure, inputs):
        load = self.factor * pressure / (inputs.modulus * inputs.rms_gradient)
        return [erf(sqrt(2) * x) for x in load]

mine = rc.compare(s, modulus='110 GPa', models=['persson', Corrected(1.2)])
for name, model in mine['ground'].models.items():
    print(f'{name:10} {model.area_error.mean_absolute:.1%}')""",
    "The whole report is one page; `study.write('report')` writes it with data, figures and `run.toml`, which repeats it.",
    """
import tempfile
from pathlib import Path

folder = Path(tempfile.mkdtemp()) / 'report'
study.write(folder)
sorted(path.name for path in folder.iterdir())""",
]

THOUSAND = [
    """# A thousand surfaces

Many maps are solved by many processes: here two of a local Dask cluster, the same code on a real one. Only small
dictionaries travel. A file that cannot be read costs the others nothing.""",
    """
import os
import tempfile
from pathlib import Path

import rough_contact as rc

COUNT = int(os.environ.get('SURFACES', '1000'))
folder = Path(tempfile.mkdtemp())
for seed in range(COUNT):
    gradient = 0.05 * (1 + seed % 5)
    rc.synth((64, 64), pixel='1um', hurst=0.8, rolloff='16um', cutoff='6um', rms_gradient=gradient, seed=seed).write(folder / f'{seed:04}.x3p')
(folder / '0007.x3p').write_bytes(b'this is no surface')
paths = sorted(str(path) for path in folder.iterdir())
len(paths)""",
    """
import warnings

def one(path):
    'The contact of one file: what was found, or why there is nothing.'
    warnings.simplefilter('ignore', rc.ContactWarning)
    try:
        s = rc.read(path, fill='harmonic')
        curve = rc.solve(s, modulus='110 GPa', pressure='300 MPa', threads=1, on_failure='keep')
    except rc.Error as why:
        return {'file': Path(path).name, 'error': str(why)}
    return {'file': Path(path).name, 'rms_gradient': s.statistics().rms_gradient, **curve.records()[0]}""",
    """
from dask.distributed import Client, LocalCluster

cluster = LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None, processes=True)
with Client(cluster) as client:
    rows = client.gather(client.map(one, paths))
cluster.close()
failed = [row for row in rows if row.get('error')]
len(rows), failed""",
    "The answers are those of one process, to the last digit:",
    """
some = paths[::max(1, len(paths) // 20)]
by_name = {row['file']: row for row in rows}
for path in some:
    serial, parallel = one(path), dict(by_name[Path(path).name])
    for row in (serial, parallel):
        for key in [key for key in row if key.endswith('seconds')]:
            del row[key]
    assert serial == parallel, path
print(len(some), 'compared')""",
    """
import pandas as pd

frame = pd.DataFrame([row for row in rows if not row.get('error')])
frame.groupby((frame.rms_gradient / 0.05).round() * 0.05).area_fraction.describe()[['count', 'mean', 'std']]""",
    """Every model beside the solution, on some of them: one page of how they differ, as `rough-contact compare --summary`
makes it. A worker sends back what the page keeps of a study, not the study.""",
    """
def study(path):
    'What the page keeps of one study.'
    warnings.simplefilter('ignore', rc.ContactWarning)
    found = rc.compare({Path(path).name: rc.read(path)}, modulus='110 GPa', pressure='100MPa..1GPa:3', threads=1, on_failure='keep')
    return found.digest()

page = rc.summary([study(path) for path in some if not by_name[Path(path).name].get('error')], failed={row['file']: row['error'] for row in failed})
page.write(folder / 'report.html')
page""",
]

ALL = {"quick-start": QUICK_START, "which-model": WHICH_MODEL, "a-thousand-surfaces": THOUSAND}


def notebook(cells):
    """Text and code in turn: text that begins with a line break is code."""
    made = new_notebook(metadata={"kernelspec": {"name": "python3", "display_name": "Python 3", "language": "python"}})
    for i, cell in enumerate(cells):
        is_code = cell.startswith("\n") or "\n" not in cell and cell.endswith(("()", "curve"))
        new = new_code_cell(cell.strip()) if is_code else new_markdown_cell(cell)
        new["id"] = f"cell-{i}"
        made.cells.append(new)
    return made


def main():
    for name, cells in ALL.items():
        made = notebook(cells)
        if "--check" in sys.argv:
            there = nbformat.read(HERE / f"{name}.ipynb", as_version=4)
            code = [c for c in there.cells if c.cell_type == "code"]
            if [c.source for c in there.cells] != [c.source for c in made.cells] or not all(c.execution_count for c in code):
                raise SystemExit(f"{name}.ipynb is not what build.py makes: run it")
            continue
        NotebookClient(made, timeout=1200, kernel_name="python3", record_timing=False).execute()
        print(name, "executed")
        if "--execute" not in sys.argv:
            nbformat.write(made, HERE / f"{name}.ipynb")


if __name__ == "__main__":
    main()
