"""The ``coulter`` command of the package; ``python -m coulter`` is the same."""

import signal
import sys
import sysconfig
from pathlib import Path

from . import _native


def main() -> int:
    """Executes the command line of this process as the ``coulter`` program does.

    Returns:
        The exit code: 0 done (good or doubtful), 1 broken, 2 the request was wrong, 128 + n stopped by signal n.
    """
    # Signals belong to the command: it stops a run at its next step, or leaves them their usual effect.
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    installed = Path(sysconfig.get_path("scripts")) / "coulter"
    program = installed if installed.exists() else Path(sys.argv[0])
    return _native.main(program, ["coulter", *sys.argv[1:]])


if __name__ == "__main__":
    sys.exit(main())
