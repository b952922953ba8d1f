"""Real area of contact between rough surfaces: the deterministic solution with its error bars, and closed forms.

Quantities go in as text or with a unit, ``'110 GPa'`` or ``110 * rc.GPa``, and come out as floats in SI units.

>>> import rough_contact as rc
>>> s = rc.synth((128, 128), pixel='1um', hurst=0.8, rolloff='32um', cutoff='8um', rms_gradient=0.1, seed=1)
>>> curve = rc.solve(s, modulus='110 GPa', pressure='10MPa,100MPa')
>>> len(curve)
2
"""

from ._again import Validation, rerun, validate
from ._bodies import Body, contact_modulus, material, materials
from ._closed import Asperities, Fractal, ModelCurve, Moments, Numbers, SelfAffine, model
from ._errors import (
    AccuracyNotMet,
    ContactWarning,
    Error,
    InternalError,
    Interrupted,
    MissingPoints,
    ModelError,
    NotConverged,
    ReadError,
    SettingError,
    SurfaceError,
    UnitError,
)
from ._findings import Finding
from ._models import Citation, ContactModel, Inputs, ModelInfo, models
from ._profile import Profile, read_profile
from ._profile_study import ProfileComparison, compare_profiles
from ._progress import Progress
from ._results import LoadCurve, Point
from ._rough_contact import __version__
from ._solve import solve
from ._solver import Solver
from ._statistics import Statistics
from ._study import AreaError, Comparison, ModelComparison, SurfaceComparison, compare
from ._summary import Summary, summary
from ._surface import Surface, info, read, synth
from ._threads import default_threads
from ._units import (
    GPa,
    J_per_m2,
    MPa,
    N,
    Pa,
    Q,
    Quantity,
    Unit,
    W_per_m_K,
    bar,
    kN,
    kPa,
    m,
    mm,
    mN,
    nm,
    ohm_m,
    um,
)

__all__ = [
    "AccuracyNotMet",
    "AreaError",
    "Asperities",
    "Body",
    "Citation",
    "Comparison",
    "ContactModel",
    "ContactWarning",
    "Error",
    "Finding",
    "Fractal",
    "GPa",
    "Inputs",
    "InternalError",
    "Interrupted",
    "J_per_m2",
    "LoadCurve",
    "MPa",
    "MissingPoints",
    "ModelComparison",
    "ModelCurve",
    "ModelError",
    "ModelInfo",
    "Moments",
    "Numbers",
    "N",
    "NotConverged",
    "Pa",
    "Point",
    "Profile",
    "ProfileComparison",
    "Progress",
    "Q",
    "Quantity",
    "ReadError",
    "SelfAffine",
    "SettingError",
    "Solver",
    "Statistics",
    "Summary",
    "Surface",
    "SurfaceComparison",
    "SurfaceError",
    "Unit",
    "UnitError",
    "Validation",
    "W_per_m_K",
    "__version__",
    "bar",
    "compare",
    "compare_profiles",
    "contact_modulus",
    "default_threads",
    "info",
    "kN",
    "kPa",
    "m",
    "mN",
    "material",
    "materials",
    "mm",
    "model",
    "models",
    "nm",
    "ohm_m",
    "read",
    "read_profile",
    "rerun",
    "solve",
    "summary",
    "synth",
    "um",
    "validate",
]
