"""Stores: made from words or a plan, opened, asked."""

from __future__ import annotations

import json
import os
import warnings
from collections.abc import Sequence
from typing import Any

from . import _core
from .pictures import Camera, Renderer

PathLike = str | os.PathLike[str]


class Store:
    """A store folder, opened: docs/formats.md describes its files."""

    def __init__(self, handle: _core.Store, catalogs: Sequence[str] = ()):
        self._handle = handle
        self._catalogs = tuple(catalogs)

    def __reduce__(self):  # another process opens the folder anew
        return _opened, (self.folder, self._catalogs)

    def __deepcopy__(self, memo: dict[int, Any]) -> Store:
        return self  # nothing in it changes

    def __repr__(self) -> str:
        return f"<marketgen.Store {self.folder!r}>"

    @property
    def folder(self) -> str:
        return self._handle.folder

    @property
    def manifest(self) -> dict[str, Any]:
        """store.json: name, seed, counts, hashes."""
        return json.loads(self._handle._manifest())

    @property
    def plan(self) -> dict[str, Any]:
        """plan.json, market-plan/1."""
        return json.loads(self._handle._plan())

    @property
    def layout(self) -> dict[str, Any]:
        """layout.json, market-layout/1: shell, zones, fixtures, aisles; millimetres."""
        return json.loads(self._handle._layout())

    @property
    def report(self) -> dict[str, Any]:
        """report.json: wishes met, rules broken, metrics."""
        return json.loads(self._handle._report())

    def query(self, table: str, where: str = "") -> list[dict[str, Any]]:
        """Rows of products, fixtures, zones, prices, materials or planogram.

        `where` keeps rows: "zone=dairy,price<2"; = != < <= > >= and ~ for "contains".
        Row i of query("products") without `where` is product i of Renderer.move().
        """
        return json.loads(self._handle._query(table, where))

    def camera_names(self) -> list[str]:
        """The views that every store has: top, entrance, aisle, checkout, and zone:<id> for each zone."""
        return self._handle.camera_names()

    def camera(self, name: str, width: int = 640, height: int = 480) -> Camera:
        """One of camera_names(), in pixels. Raises Error camera.unknown with the nearest name."""
        return self._handle.camera(name, width, height)

    def renderer(self, *, fine_print: bool = True, keep_light: bool = True) -> Renderer:
        """Builds what pictures need: about a second for 27,000 products, two when light has to be baked.

        fine_print  labels sharp at arm's length; False: a quarter of the memory
        keep_light  leave baked light in the cache folder, and take it from there
        """
        return Renderer(_core.create_renderer(self._handle, fine_print, keep_light))


def open_store(folder: PathLike, *, catalogs: Sequence[PathLike] = ()) -> Store:
    """Opens a store folder. `catalogs`: product files of your own that it was made with. Raises Error store.*, scene.*."""
    return _opened(os.fspath(folder), [os.fspath(file) for file in catalogs])


def _opened(folder: str, catalogs: Sequence[str]) -> Store:
    return Store(_core.open_store(folder, list(catalogs)), catalogs)


def generate(
    prompt: str,
    folder: PathLike,
    *,
    seed: int = 1,
    size: str = "",
    profile: str | None = None,
    style: str | None = None,
    plan: PathLike | None = None,
    catalogs: Sequence[PathLike] = (),
    previews: bool = False,
    strict: bool = False,
) -> Store:
    """Makes a store in `folder`, which must not exist or be empty, and opens it.

    prompt    what it should be, in words; "" with `plan`
    size      of the room, "24x15m"
    profile   kind of shop: "supermarket-eu", "discounter-eu", "convenience-us", ...
    style     look: "scandinavian", "industrial", ...
    plan      a market-plan/1 file instead of a prompt
    catalogs  product files of your own; each product stands in the store, or a warning says why not
    previews  draw its pictures, too (seconds)
    strict    raise layout.violation when a hard rule is broken

    Equal arguments make equal bytes. Nothing is left behind when it fails or is interrupted.
    """
    rows = [os.fspath(file) for file in catalogs]
    handle = _core.generate(
        prompt,
        os.fspath(folder),
        seed,
        size,
        profile,
        style,
        None if plan is None else os.fspath(plan),
        rows,
        previews,
        strict,
    )
    store = Store(handle, rows)
    for product in store.report.get("unstocked", []):
        warnings.warn(f"{product['sku']} stands nowhere in the store: {product['why']}", stacklevel=2)
    return store
