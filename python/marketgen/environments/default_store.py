"""The store of environments that were given none."""

import functools
import pathlib

from .. import _core
from ..store import Store, generate, open_store

DEFAULT_PROMPT = "a corner shop of 63 m2 with cold drinks, snacks, canned food and one checkout"


@functools.lru_cache(maxsize=1)
def default_store() -> Store:
    """A small shop, made once into the cache folder."""
    folder = pathlib.Path(_core.cache_folder()) / "stores" / f"{_core.__version__}-corner-shop"
    if not (folder / "store.json").exists():
        try:
            return generate(DEFAULT_PROMPT, folder, seed=1, size="9x7m")
        except _core.Error as error:
            if error.code != "store.exists":  # another process was first
                raise
    return open_store(folder)
