"""What calls return and nobody makes: for annotations and for help."""

from ._again import Validation
from ._closed import ModelCurve
from ._findings import Finding
from ._models import Citation, ModelInfo
from ._profile_study import ProfileComparison
from ._study import AreaError, ModelComparison, SurfaceComparison
from ._summary import Summary

__all__ = [
    "AreaError",
    "Citation",
    "Finding",
    "ModelComparison",
    "ModelCurve",
    "ModelInfo",
    "ProfileComparison",
    "Summary",
    "SurfaceComparison",
    "Validation",
]
