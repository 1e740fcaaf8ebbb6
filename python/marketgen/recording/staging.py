"""Where the episodes of a file are acted out with the numbers and pictures that datasets have."""

from __future__ import annotations

import json
from typing import Any

from ..errors import Error


def episodes_of(path: str) -> list[str]:
    """Those of a file, as market-episode/1, in its order. Raises Error input.*, episode.*."""
    from ..environments.task_setup import ground_of

    return ground_of("checkout", None, path).episodes()


def place_of(episodes: list[dict[str, Any]], path: str) -> dict[str, Any]:
    """track, station, robot and tools, which they must share: their numbers mean the same then. Raises Error episode.impossible,
    usage.bad_flag."""
    if not episodes:
        raise Error("episode.impossible", path, "it has no episode for this shard")
    places = [{"track": one["track"], "station": one.get("station"), "robot": one["robot"], "tools": one.get("tools", "")} for one in episodes]
    for one, place in zip(episodes, places, strict=True):
        if place != places[0]:
            raise Error("usage.bad_flag", "episodes", f"{one['id']} is of {place}, others are of {places[0]}: a dataset is of one robot")
    return places[0]


def stages_of(path: str, place: dict[str, Any], size: tuple[int, int], options: dict[str, Any]) -> Any:
    """Stages of a file whose episodes are of `place`. `options`: cameras, quality, control_mode, realism."""
    from ..stages import Stages

    return Stages(path, {**options, "obs_mode": "rgbd", "width": size[0], "height": size[1], "tools": place["tools"]})


def documents_of(texts: list[str]) -> list[dict[str, Any]]:
    return [json.loads(text) for text in texts]
