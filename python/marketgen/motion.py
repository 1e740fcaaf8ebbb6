"""What moved in an episode, as `eval --record-motion` and evaluate(record_motion=True) keep it."""

from __future__ import annotations

from typing import Any

import numpy as np

from . import _core, arguments
from .arguments import PathLike

POSE_NUMBERS = 7


def read_motion(path: PathLike) -> dict[str, Any]:
    """A market-motion/1 as arrays, in the store's frame: metres, radians, unit quaternions (w, x, y, z).

    path  motion/ID.bin.gz of a folder of results

    Returns episode, episode_hash, scene_hash, policy, realism, robot; step_s; dofs, names of the robot's degrees of freedom;
    states, float32 (steps, dofs), the first at the beginning; store_from_robot, float64 (7,), the frame of the states;
    things, each with kind ("item", "product", "basket"), number, sku, steps uint32 (n,), poses float32 (n, 7);
    joints, each with joint, a row of the store's joints, steps uint32 (n,), positions float32 (n,). Between two rows a thing
    stands still. track, station, lane, tools and instruction are the episode's (track is "" in files of before they were kept);
    events, by their first step, each with kind ("held", "contact", "toppled", "dropped", "displaced", "base_collision",
    "protective_stop"), step and last_step, target ("nothing", "item", "product", "fixture", "room", "other": the basket at a
    counter or the robot itself), number and sku of an item or product, force_n of a contact. The arrays cannot be written to. Raises Error input.*, scene.*.
    """
    motion = _core.read_motion(arguments.a_path("path", path))
    states = np.frombuffer(motion["states"], np.float32)
    motion["states"] = states.reshape(-1, len(motion["dofs"]))
    motion["store_from_robot"] = np.array(motion["store_from_robot"])
    for thing in motion["things"]:
        thing["steps"] = np.frombuffer(thing["steps"], np.uint32)
        thing["poses"] = np.frombuffer(thing["poses"], np.float32).reshape(-1, POSE_NUMBERS)
    for joint in motion["joints"]:
        joint["steps"] = np.frombuffer(joint["steps"], np.uint32)
        joint["positions"] = np.frombuffer(joint["positions"], np.float32)
    return motion
