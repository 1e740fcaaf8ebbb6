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
import os
import pathlib

# In a wheel the data rows lie inside the package; in a build tree the library finds those of the sources.
_rows = pathlib.Path(__file__).parent / "share" / "marketgen" / "data"
if _rows.is_dir():
    os.environ.setdefault("MARKETGEN_DATA", str(_rows))

from ._core import __version__  # noqa: E402
from .errors import Error  # noqa: E402
from .evaluation import Evaluation, Policy, evaluate  # noqa: E402
from .pictures import Camera, Frame, Renderer, camera_from_dict, camera_to_dict, render_batch  # noqa: E402
from .store import Store, generate, open_store  # noqa: E402

if importlib.util.find_spec("gymnasium"):
    from . import environments as _environments  # noqa: F401  registers them

__all__ = [
    "Camera",
    "Error",
    "Evaluation",
    "Frame",
    "Policy",
    "Renderer",
    "Store",
    "__version__",
    "camera_from_dict",
    "camera_to_dict",
    "evaluate",
    "generate",
    "open_store",
    "render_batch",
]
