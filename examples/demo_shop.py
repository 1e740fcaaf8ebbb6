"""The store that examples use when they are given none: a small shop, made once into out/examples/shop."""

import pathlib

import marketgen

FOLDER = pathlib.Path("out/examples")
PROMPT = "a corner shop with cold drinks, snacks and one checkout"


def open_or_make(folder=None):
    """The store of `folder`, or the small shop."""
    if folder is not None:
        return marketgen.open_store(folder)
    if (FOLDER / "shop" / "store.json").exists():
        return marketgen.open_store(FOLDER / "shop")
    return marketgen.generate(PROMPT, FOLDER / "shop", seed=5, size="9x7m")
