"""maturin, which compiles with Cargo: where that is missing, the way out is said before anything is downloaded."""

import shutil

import maturin
from maturin import *  # noqa: F403 (the hooks of PEP 517)


def get_requires_for_build_wheel(config_settings=None):
    if shutil.which("cargo") is None:
        raise SystemExit(
            "rough-contact is compiled from Rust here, and no cargo is on the path. Install Rust from https://rustup.rs, "
            "or take a wheel: pip install --only-binary :all: rough-contact"
        )
    return maturin.get_requires_for_build_wheel(config_settings)


get_requires_for_build_editable = get_requires_for_build_wheel
