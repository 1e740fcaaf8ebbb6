"""For LeRobot's own programs: the environment type "marketgen".

    lerobot-eval --env.discover_packages_path=marketgen.lerobot --env.type=marketgen --env.task=tasks.jsonl --policy.path=act

LeRobot imports this package for the option above, which registers EpisodesEnv with Gymnasium and MarketGenEnv with LeRobot.
"""

from .config import MarketGenEnv
from .episodes_env import EpisodesEnv

__all__ = ["EpisodesEnv", "MarketGenEnv"]
