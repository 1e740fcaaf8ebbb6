"""Where the episodes of a file are acted out."""

from __future__ import annotations

import json
import threading
from typing import Any


class Stages:
    """Environments of a file's episodes, by track and station, and what agents are told there.

    path     of the file
    options  of the environments (TaskOptions)
    """

    def __init__(self, path: str, options: dict[str, Any]):
        self._path, self._options, self._setups = path, options, {}
        self._rows: list[dict[str, Any]] | None = None
        self._lock = threading.Lock()

    def environment(self, track: str, station: str | None, **rendering: Any):
        """`rendering`: render_mode, render_size, render_camera; without it nothing is drawn by render()."""
        from .environments.checkout import CheckoutUnloading
        from .environments.in_aisle import InAisleCollection
        from .environments.task_setup import CHECKOUT_STATION, TaskSetup

        key = track, station
        if key not in self._setups:
            where = station or CHECKOUT_STATION
            self._setups[key] = TaskSetup(track, episodes=self._path, station=where, **self._options)
        kind = CheckoutUnloading if track == "checkout" else InAisleCollection
        return kind(setup=self._setups[key], **rendering)

    def task(self, env, info: dict[str, Any]) -> dict[str, Any]:
        """What the agent is told before it begins."""
        task = json.loads(env.environment.task())
        known = {"map": info["map"]} if "map" in info else {}
        numbers = {"action_names": env.action_names, "action_units": env.setup.action_units, "robot_names": env.robot_names}
        return task | known | numbers | {"catalogue": self._catalogue(env)}

    def _catalogue(self, env) -> list[dict[str, Any]]:
        with self._lock:
            if self._rows is None:
                self._rows = [json.loads(row) for row in env.setup.ground.catalogue()]
            return self._rows
