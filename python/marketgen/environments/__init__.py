"""Gymnasium environments. Importing marketgen registers them where Gymnasium is installed.

    gymnasium.make("MarketGen/CheckoutUnloading-v1", store="shop", obs_mode="rgbd", control_mode="pd_ee_delta_pose")
    gymnasium.make("MarketGen/InAisleCollection-v1", episodes="tasks.jsonl")
    gymnasium.make_vec("MarketGen/CheckoutUnloading-v1", num_envs=16, store="shop")
    gymnasium.make("MarketGen/CheckoutOneItem-v1")    # the first task for a learner: numbers in, numbers out
    gymnasium.make("MarketGen/DriveToProduct-v1")     # a stage of the whole task, for learners
"""

from typing import Any

import gymnasium

from .. import arguments
from .checkout import CheckoutUnloading, CheckoutUnloadingVector
from .drive_to_product import DriveToProduct
from .in_aisle import InAisleCollection, InAisleCollectionVector
from .one_item import CheckoutOneItem, CheckoutOneItemVector
from .open_cooler import OpenCooler
from .pick_from_shelf import PickFromShelf
from .place_in_basket import PlaceInBasket

MAX_ENVS = 4096

__all__ = [
    "CheckoutOneItem",
    "CheckoutOneItemVector",
    "CheckoutUnloading",
    "CheckoutUnloadingVector",
    "DriveToProduct",
    "InAisleCollection",
    "InAisleCollectionVector",
    "OpenCooler",
    "PickFromShelf",
    "PlaceInBasket",
    "make_vec",
]

for _env, _vector in (
    (CheckoutUnloading, CheckoutUnloadingVector),
    (CheckoutOneItem, CheckoutOneItemVector),
    (InAisleCollection, InAisleCollectionVector),
):
    gymnasium.register(
        f"MarketGen/{_env.__name__}-v1",
        entry_point=f"{_env.__module__}:{_env.__name__}",
        vector_entry_point=f"{_vector.__module__}:{_vector.__name__}",
    )

for _stage in (DriveToProduct, PickFromShelf, PlaceInBasket, OpenCooler):  # many in one: Gymnasium's own vector environments
    gymnasium.register(f"MarketGen/{_stage.__name__}-v1", entry_point=f"{_stage.__module__}:{_stage.__name__}")


def make_vec(name: str, num_envs: int = 1, **options: Any) -> gymnasium.vector.VectorEnv:
    """Many environments stepped in one call: gymnasium.make_vec, of ours, with or without "MarketGen/".

    options  those of the environment, and autoreset_mode, copy, render_mode, render_size, render_camera
    """
    known = [spec for spec in gymnasium.registry if spec.startswith("MarketGen/")]
    full = name if isinstance(name, str) and name.startswith("MarketGen/") else f"MarketGen/{name}"
    arguments.a_name("name", full, known)
    return gymnasium.make_vec(full, arguments.a_whole("num_envs", num_envs, 1, MAX_ENVS), **options)
