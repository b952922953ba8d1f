"""Real area of contact between rough surfaces: the deterministic solution with its error bars, and closed forms.

======================================  ==================================================================
`read`, `synth`, `Surface`, `info`      heights: from a file, made, from an array; what a file holds
`Surface.statistics`                    roughness
`solve`, `solve_many`, `Solver`         the contact at loads; of many maps; again and again, in a loop of one's own
`compare`, `summary`, `rerun`           every closed form beside the solution; many studies on one page; one again
`model`, `models`                       one closed form, from a surface, `Moments`, `Asperities`, `SelfAffine`, `Fractal`, `Numbers`
`ClosedForm`                            a closed form on arrays of any shape
`displacement`                          of a pressure map
`read_profile`, `compare_profiles`      traces of a stylus
`Body`, `material`, `contact_modulus`   what presses on each other
`units`, `results`                      units; what calls return
`Error`                                 what all exceptions derive from; ``.result`` and ``.partial`` keep what was found
`validate`                              the solver against exact solutions
======================================  ==================================================================

``help(rc.solve)`` and ``help(rc.LoadCurve)`` say what goes in and what comes out.
Quantities go in as text or with a unit, ``'110 GPa'`` or ``110 * rc.units.GPa``, and come out as floats in SI units.

>>> import rough_contact as rc
>>> s = rc.synth((128, 128), pixel='1um', hurst=0.8, rolloff='32um', cutoff='8um', rms_gradient=0.1, seed=1)
>>> curve = rc.solve(s, modulus='110 GPa', pressure='10MPa,100MPa')
>>> len(curve)
2
"""

import typing as _typing

from . import results as results, units as units
from ._again import (
    rerun as rerun,
    validate as validate,
)
from ._bodies import (
    Body as Body,
    contact_modulus as contact_modulus,
    material as material,
    materials as materials,
)
from ._closed import (
    Asperities as Asperities,
    ClosedForm as ClosedForm,
    Fractal as Fractal,
    Moments as Moments,
    Numbers as Numbers,
    SelfAffine as SelfAffine,
    model as model,
)
from ._errors import (
    AccuracyNotMet as AccuracyNotMet,
    ContactWarning as ContactWarning,
    Error as Error,
    InternalError as InternalError,
    Interrupted as Interrupted,
    MissingPoints as MissingPoints,
    ModelError as ModelError,
    NotConverged as NotConverged,
    ReadError as ReadError,
    SettingError as SettingError,
    SurfaceError as SurfaceError,
    UnitError as UnitError,
)
from ._many import solve_many as solve_many
from ._models import (
    ContactModel as ContactModel,
    Inputs as Inputs,
    models as models,
)
from ._profile import (
    Profile as Profile,
    read_profile as read_profile,
)
from ._profile_study import compare_profiles as compare_profiles
from ._progress import Progress as Progress
from ._results import (
    LoadCurve as LoadCurve,
    Point as Point,
)
from ._rough_contact import __version__ as __version__
from ._solve import (
    displacement as displacement,
    solve as solve,
)
from ._solver import Solver as Solver
from ._statistics import Statistics as Statistics
from ._study import (
    Comparison as Comparison,
    compare as compare,
)
from ._summary import summary as summary
from ._surface import (
    Surface as Surface,
    info as info,
    read as read,
    synth as synth,
)
from ._threads import default_threads as default_threads
from ._units import Q as Q

#: What was here under another name.
_MOVED = {
    **dict.fromkeys(("GPa", "MPa", "kPa", "Pa", "bar", "m", "mm", "um", "nm", "N", "kN", "mN", "Quantity"), "rc.units.{}"),
    "Unit": "rc.units.Quantity",
    "J_per_m2": "rc.units.J / rc.units.m**2",
    "ohm_m": "rc.units.ohm * rc.units.m",
    "W_per_m_K": "rc.units.W / rc.units.m / rc.units.K",
    **dict.fromkeys(results.__all__, "rc.results.{}"),
}

if not _typing.TYPE_CHECKING:

    def __getattr__(name: str) -> object:
        if name in _MOVED:
            raise AttributeError(f"rc.{name} is now {_MOVED[name].format(name)}")
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
