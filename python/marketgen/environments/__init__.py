"""Gymnasium environments. Importing marketgen registers them where Gymnasium is installed.

    gymnasium.make("MarketGen/CheckoutUnloading-v1", store="shop", obs_mode="rgbd", control_mode="pd_ee_delta_pose")
    gymnasium.make("MarketGen/InAisleCollection-v1", episodes="tasks.jsonl")
    gymnasium.make_vec("MarketGen/CheckoutUnloading-v1", num_envs=16, store="shop")
"""

import gymnasium

from .checkout import CheckoutUnloading, CheckoutUnloadingVector
from .default_store import default_store
from .in_aisle import InAisleCollection, InAisleCollectionVector

__all__ = [
    "CheckoutUnloading",
    "CheckoutUnloadingVector",
    "InAisleCollection",
    "InAisleCollectionVector",
    "default_store",
]

for _env, _vector in ((CheckoutUnloading, CheckoutUnloadingVector), (InAisleCollection, InAisleCollectionVector)):
    gymnasium.register(
        f"MarketGen/{_env.__name__}-v1",
        entry_point=f"{_env.__module__}:{_env.__name__}",
        vector_entry_point=f"{_vector.__module__}:{_vector.__name__}",
    )
