"""``python -m rough_contact``: the command ``rough-contact`` that came with this package."""

import shutil
import subprocess
import sys
import sysconfig


def main() -> int:
    """Runs it; its exit status."""
    command = shutil.which("rough-contact", path=sysconfig.get_path("scripts"))
    if command is None:
        print("rough_contact: the command is not here; a package that is built from its sources comes without it", file=sys.stderr)
        return 3
    return subprocess.run([command, *sys.argv[1:]], check=False).returncode


if __name__ == "__main__":
    sys.exit(main())
