"""What the commands `python -m marketgen.NAME` have in common.

They end as the program's own do: 0 done, 1 what was checked is not so, 2 bad usage or input, 3 it could not be finished, 130
interrupted.
"""

from __future__ import annotations

import sys
import time
import types
import warnings
from collections.abc import Callable
from typing import Any

from . import _core
from .errors import Error

EVERY_S = 10.0  # between lines where standard error is no terminal


def ended(command: Callable[[], int], kept: str = "", unlike: str = "") -> int:
    """The exit status of `command`; what it raises and warns of is told, a line each.

    kept    what is said beside "interrupted"
    unlike  the code of an error that says that what was checked is not so
    """
    warnings.showwarning = _told_warning
    try:
        return command()
    except Error as error:
        print(f"error[{error.code}] {error.where}: {error.message}", file=sys.stderr)
        return 1 if error.code == unlike else _core.exit_status_of(error.code)
    except KeyboardInterrupt:
        print(f"interrupted{kept}", file=sys.stderr)
        return _core.exit_status_of("internal.interrupted")


def _told_warning(message: Warning | str, category: type[Warning], *_place: Any) -> None:
    print(f"warning: {message}", file=sys.stderr)


class Told:
    """Progress on standard error: one line that is overwritten on a terminal, else a line now and then."""

    def __init__(self) -> None:
        self._terminal, self._last = sys.stderr.isatty(), -EVERY_S

    def __call__(self, done: int, total: int, text: str) -> None:
        line = f"{done}/{total} {text}"[:100]
        now = time.monotonic()
        if self._terminal:
            print(f"\r\x1b[K{line}", end="\n" if done == total else "", file=sys.stderr, flush=True)
        elif done == total or now - self._last >= EVERY_S:
            self._last = now
            print(line, file=sys.stderr, flush=True)


def callable_module(function: Callable[..., Any]) -> type[types.ModuleType]:
    """A class for a module that does what `function` does: `import marketgen.record` puts the module where marketgen has the
    function of that name."""

    class CallableModule(types.ModuleType):
        def __call__(self, *arguments: Any, **options: Any) -> Any:
            return function(*arguments, **options)

    return CallableModule
