"""MarketGen: words in, a complete stocked supermarket out, and measures how well robots work in it.

    import marketgen

    store = marketgen.generate("a kiosk of 40 m2 with snacks and cold drinks", "shop", seed=7)
    frame = store.renderer().render(store.camera("aisle"))
    frame.save("aisle.png")
    print(store.query("products", "category=snacks")[0])

Calls that fail raise marketgen.Error with a stable code. Long calls let other threads run, end at Ctrl-C, and use all
cores; what they make does not depend on how many there are.
"""

import importlib.util
import sys

from . import _core, policies
from ._core import __version__
from .episode_files import write_episodes
from .errors import Error, IsolationWarning, StoreWarning
from .evaluation import Evaluation, Policy, evaluate
from .motion import read_motion
from .photos import read_photo
from .pictures import Camera, Frame, Renderer, camera_from_dict, camera_to_dict, render_batch
from .rankings import leaderboard, merge, tables
from .recording import Recording, record, record_drives, replay_check
from .store import Store, generate, open_store
from .views import View

_core.use_python(sys.executable or "")  # its helper processes have this environment's packages

if importlib.util.find_spec("gymnasium"):
    from .environments import make_vec  # noqa: F401  and registers them


def __getattr__(name):
    if name == "make_vec":
        raise Error("usage.unavailable", "make_vec", "environments need Gymnasium: pip install gymnasium")
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


__all__ = [
    "Camera",
    "Error",
    "Evaluation",
    "Frame",
    "IsolationWarning",
    "Policy",
    "Recording",
    "Renderer",
    "Store",
    "StoreWarning",
    "View",
    "__version__",
    "camera_from_dict",
    "camera_to_dict",
    "evaluate",
    "generate",
    "leaderboard",
    "merge",
    "open_store",
    "policies",
    "read_motion",
    "read_photo",
    "record",
    "record_drives",
    "render_batch",
    "replay_check",
    "tables",
    "write_episodes",
]
