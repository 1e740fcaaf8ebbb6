"""How long a server is waited for, so that Ctrl-C is heard meanwhile."""

from __future__ import annotations

import math
import time

from .. import _core

LOOK_UP_S = 0.2  # how often an interrupt is looked for


class Deadline:
    """`limit_s` of wall time from now on; 0: none."""

    def __init__(self, limit_s: float):
        self._end = time.monotonic() + (limit_s or math.inf)

    def is_over(self) -> bool:
        return time.monotonic() >= self._end

    def slice_s(self) -> float:
        """How long to wait before looking again. Raises KeyboardInterrupt."""
        _core.check_interrupt()
        return min(LOOK_UP_S, max(0.0, self._end - time.monotonic()))
