"""Gymnasium environments. Importing marketgen registers them where Gymnasium is installed.

    gymnasium.make("MarketGen/CheckoutUnloading-v1", store="shop", obs_mode="rgbd", control_mode="pd_ee_delta_pose")
    gymnasium.make("MarketGen/InAisleCollection-v1", episodes="tasks.jsonl")
    gymnasium.make_vec("MarketGen/CheckoutUnloading-v1", num_envs=16, store="shop")
    gymnasium.make("MarketGen/CheckoutOneItem-v1")    # the first task for a learner: numbers in, numbers out
"""

import gymnasium

from .checkout import CheckoutUnloading, CheckoutUnloadingVector
from .in_aisle import InAisleCollection, InAisleCollectionVector
from .one_item import CheckoutOneItem, CheckoutOneItemVector

__all__ = [
    "CheckoutOneItem",
    "CheckoutOneItemVector",
    "CheckoutUnloading",
    "CheckoutUnloadingVector",
    "InAisleCollection",
    "InAisleCollectionVector",
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
