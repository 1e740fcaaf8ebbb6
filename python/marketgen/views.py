"""Stores in a browser, and in a notebook's cell: the page of `marketgen view`."""

from __future__ import annotations

import html
import weakref

from . import _core, arguments
from ._core import _View

MAX_PORT, MIN_HEIGHT_PX, MAX_HEIGHT_PX = 65535, 100, 10_000


class View:
    """A store's page, or that of an episode in it, served on this machine until close(), or until Python ends.

    Stands in a notebook's cell as the page itself (docs/viewer.md); address is for a browser. Of `Store.show()`, and of the
    `show()` of an environment.
    """

    def __init__(self, served: _View, folder: str, height: int, place: str = ""):
        self._served = served
        self._height = height
        self.folder = folder
        self.address = served.address + place
        self._end = weakref.finalize(self, served.close)

    def close(self) -> None:
        """No one is answered any more; the second time nothing happens."""
        self._end()

    @property
    def closed(self) -> bool:
        return not self._end.alive

    def __enter__(self) -> View:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def __repr__(self) -> str:
        return f"<marketgen.View of {self.folder!r}, {'closed' if self.closed else self.address}>"

    def _repr_html_(self) -> str:
        """What a notebook shows: the page in a frame, and its address for a window of its own."""
        if self.closed:
            return html.escape(repr(self))
        address = html.escape(self.address, quote=True)
        return (
            f"<iframe src='{address}' title='{html.escape(self.folder, quote=True)}' allow='fullscreen'"
            f" style='width:100%;height:{self._height}px;border:0'></iframe><a href='{address}' target='_blank'>{address}</a>"
        )


def show(store: _core.Store, height: int, port: int) -> View:
    """See Store.show()."""
    height = arguments.a_whole("height", height, MIN_HEIGHT_PX, MAX_HEIGHT_PX)
    served = _core._serve(store, arguments.a_whole("port", port, 0, MAX_PORT))
    return View(served, store.folder, height)


def watch(store: _core.Store, height: int, port: int) -> View:
    """The page of an episode in the store, which its environment brings up to date."""
    height = arguments.a_whole("height", height, MIN_HEIGHT_PX, MAX_HEIGHT_PX)
    served = _core._serve(store, arguments.a_whole("port", port, 0, MAX_PORT), watch=True)
    return View(served, store.folder, height, "?store=0&drive=")
