"""Stores: made from words or a plan, opened, asked."""

from __future__ import annotations

import base64
import html
import json
import pathlib
import warnings
from collections.abc import Mapping, Sequence
from typing import Any

from . import _core, arguments
from .arguments import MAX_SECONDS, MAX_SEED, MAX_SIDE_PX, MAX_TOKENS, PathLike, Progress
from .errors import Error, StoreWarning
from .pictures import Camera, Renderer
from .views import View, show

MAX_SETTLE_SECONDS, MAX_LIFT_M = 60.0, 0.1


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

    def _repr_png_(self) -> bytes:
        """layout.png, drawn anew: what notebooks show that can show pictures alone."""
        return self._handle._layout_png()

    def _repr_html_(self) -> str:
        """How notebooks show it: what it has, its plan, and its aisle when that was drawn."""
        manifest = self.manifest
        rows = "".join(
            f"<tr><th style='text-align:left'>{name}</th><td style='text-align:right'>{count:,}</td></tr>"
            for name, count in manifest["counts"].items()
        )
        pictures = [self._repr_png_()]
        view = pathlib.Path(self.folder) / "previews" / "aisle.png"
        if view.is_file():
            pictures.append(view.read_bytes())
        shown = "".join(
            f"<img style='max-width:48%;max-height:320px' src='data:image/png;base64,{base64.b64encode(png).decode()}'>"
            for png in pictures
        )
        name, folder = html.escape(manifest["name"]), html.escape(self.folder)
        return f"<b>{name}</b> <code>{folder}</code><table>{rows}</table>{shown}"

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

    def show(self, *, height: int = 600, port: int = 0) -> View:
        """The store's page, as `marketgen view` has it: in a notebook's cell, or a browser at the address that it says.

        height  of the cell, pixels
        port    to listen on, of 127.0.0.1; 0 any free one

        It is served by threads of this process until close() of the answer, which a `with` does, or until Python ends. The
        browser has to run on this machine, or to reach the port through `ssh -L`. Raises Error server.cannot_listen,
        usage.unavailable where the page is not installed.
        """
        return show(self._handle, height, port)

    def query(self, table: str, where: str = "") -> list[dict[str, Any]]:
        """Rows of products, fixtures, zones, prices, materials or planogram.

        `where` keeps rows: "zone=dairy,price<2"; = != < <= > >= and ~ for "contains".
        Row i of query("products") without `where` is product i of Renderer.move().
        """
        return json.loads(self._handle._query(arguments.a_text("table", table), arguments.a_text("where", where)))

    def patches(self, say: str) -> list[dict[str, Any]]:
        """What edit(say) would do, as market-patch/1 patches; nothing is written. Warnings and errors as there."""
        return self._said(arguments.a_text("say", say), strict=False)[0]

    def edit(
        self,
        say: str = "",
        folder: PathLike | None = None,
        *,
        patches: Sequence[Mapping[str, Any]] | None = None,
        planogram: PathLike | None = None,
        previews: bool = False,
        strict: bool = False,
        progress: Progress | None = None,
    ) -> Store:
        """A changed store in a new folder; what is not named is as it was, to the last bit (docs/editing.md). This one is not written.

        say       what shall change, in words: "swap dairy and bakery"
        folder    to make; left out: FOLDER-edit-1, or the next number that is free
        patches   instead of words, market-patch/1 patches: [{"swap_leaves": {"a": "dairy", "b": "bakery"}}]
        planogram instead of words, a CSV file of what shall stand on its shelves (docs/planogram.md)
        previews  draw its pictures, too (seconds)
        strict    raise brief.not_understood when a word was not understood, brief.contradiction when the words contradict themselves
        progress  as of generate()

        Returns this store when it is so already. A StoreWarning says what was not understood, what was given up for another
        word, what is so already, and which wishes of the prompt are no longer met. Raises Error layout.violation when a hard rule would be broken anew,
        plan.* and json.* of patches, planogram.* of a planogram, store.exists. Nothing is left behind when it fails or is interrupted.
        """
        say, strict = arguments.a_text("say", say), arguments.a_truth("strict", strict)
        target = None if folder is None else arguments.a_path("folder", folder)
        if (say != "") + (patches is not None) + (planogram is not None) != 1:
            name = "patches" if patches is not None and (say or planogram is not None) else "planogram" if planogram is not None else "say"
            raise arguments.bad(name, {"say": say, "patches": patches, "planogram": planogram}[name], "either words, patches or a planogram")
        if planogram is not None:
            said = json.loads(self._handle._planogram_patches(arguments.a_path("planogram", planogram)))["patches"]
            if not said:
                return self
        elif patches is None:
            said, unparsed = self._said(say, strict)
            if strict and unparsed:
                raise Error("brief.not_understood", "say", f"not understood: {', '.join(map(repr, unparsed))}")
            if not said:
                return self
        else:
            said = arguments.documents("patches", patches)
        document = json.dumps({"schema": "market-patch/1", "patches": said})
        handle, lost = self._handle._edit(
            document, say, target, arguments.a_truth("previews", previews), arguments.a_progress(progress)
        )
        for wish in lost:
            warnings.warn(f'no longer met: "{wish}"', StoreWarning, stacklevel=2)
        return Store(handle, self._catalogs)

    def _said(self, words: str, strict: bool) -> tuple[list[dict[str, Any]], list[str]]:
        document, unparsed, so_already, given_up = self._handle._said(words)
        for dropped, kept, why, contradicts in given_up:
            if strict and contradicts:
                raise Error("brief.contradiction", "say", f'"{dropped}" and "{kept}": {why}')
            warnings.warn(f'given up: "{dropped}" for "{kept}": {why}', StoreWarning, stacklevel=3)
        for text in unparsed:
            warnings.warn(f'not understood: "{text}"', StoreWarning, stacklevel=3)
        for wish in so_already:
            warnings.warn(f'so already: "{wish}"', StoreWarning, stacklevel=3)
        return json.loads(document)["patches"], unparsed

    def compliance(self, planogram: PathLike) -> dict[str, Any]:
        """How far the store stands as a planogram, a CSV file, says: market-compliance/1 (docs/planogram.md).

        `score` is the share of planned facings that are met. Raises Error planogram.* where a row cannot be on its shelf.
        """
        return json.loads(self._handle._compliance(arguments.a_path("planogram", planogram)))

    def shop(
        self,
        request: str,
        *,
        sold_out: Sequence[str] = (),
        planner: str = "offline",
        planner_url: str | None = None,
        record: PathLike | None = None,
        max_tokens: int = MAX_TOKENS,
        max_seconds: float = MAX_SECONDS,
        max_usd: float | None = None,
        usd_per_million: tuple[float, float] | None = None,
    ) -> dict[str, Any]:
        """What to buy here for a request in words, and what instead where it is sold out: market-shopping/1 (docs/shopping.md).

        request   a meal, a list, persons, a budget, what is at home, a diet: "breakfast for two under 10 euros"
        sold_out  SKUs that are not there today, beside those of which no item stands in the store
        planner   who plans: "offline", or a language model, "openai:gpt-4o-mini" or "replay:FOLDER"; where it fails, the offline
                  plan stands, and `shopper` says why
        planner_url, record, max_tokens, max_seconds, max_usd, usd_per_million  as of generate()

        `lines` has each product once: `sku`, `name`, `net`, `count` packs at `price`, what it `answers`, `why`, and up to three
        `substitutes`. `total` and all prices are in `money`, the store's; `unmet` says what the plan does not do, and why. Equal
        stores and requests have equal plans offline; they are those of `marketgen shop --json`.

        Raises Error shopping.not_understood with the words at fault, or when nothing is asked for; shopping.other_money when the
        budget is in another money than the store's; catalog.unknown_sku when the store does not sell what is said to be sold
        out; those of planners. Other Python threads run meanwhile.
        """
        plan = self._handle._shop(
            arguments.a_text("request", request),
            arguments.texts("sold_out", sold_out, "a list of SKUs"),
            arguments.a_text("planner", planner),
            arguments.planner_access(planner_url, record, max_tokens, max_seconds, max_usd, usd_per_million),
        )
        return json.loads(plan)

    def settle(
        self,
        region: Sequence[float],
        *,
        seconds: float = 2.0,
        lift_m: float = 0.0,
        soft: bool = True,
        progress: Progress | None = None,
    ) -> list[dict[str, Any]]:
        """Lets all goods of a region go at once, in the physics that episodes run in (docs/physics.md): where each then is.

        region   (x0, y0, x1, y1), metres, of at most 1,024 goods by the middle of their feet; the rest of the store stands, and moves where it is pushed
        seconds  simulated, up to 60
        lift_m   raised by so much first, up to 0.1, but for what hangs on a peg: they fall, instead of standing as they were stocked
        soft     bags and pouches bend; False: they are rigid, as exports have them
        progress as of generate()

        One dict a product: `row` (of query("products"), as Renderer.move() takes it), `id`, `pose` (x, y, z, qw, qx, qy, qz in the
        store's frame) and whether it `rests`. Equal stores and arguments have equal answers. Raises Error physics.bad_command
        when more goods stand there, physics.failed.
        """
        x0, y0, x1, y1 = corners = arguments.numbers("region", region, 4)
        if not (x0 < x1 and y0 < y1):
            raise arguments.bad("region", region, "x0, y0, x1, y1 with x0 < x1 and y0 < y1")
        rows = self._handle._settle(
            corners,
            arguments.a_number("seconds", seconds, 0, MAX_SETTLE_SECONDS),
            arguments.a_number("lift_m", lift_m, 0, MAX_LIFT_M),
            arguments.a_truth("soft", soft),
            arguments.a_progress(progress),
        )
        return [{"row": row, "id": name, "pose": tuple(pose), "rests": rests} for row, name, pose, rests in rows]

    def camera_names(self) -> list[str]:
        """The views that every store has: top, entrance, aisle, checkout, and zone:<id> for each zone."""
        return self._handle.camera_names()

    def camera(self, name: str, width: int = 640, height: int = 480) -> Camera:
        """One of camera_names(), in pixels. Raises Error camera.unknown with the nearest name."""
        width, height = arguments.a_whole("width", width, 1, MAX_SIDE_PX), arguments.a_whole("height", height, 1, MAX_SIDE_PX)
        return self._handle.camera(arguments.a_text("name", name), width, height)

    def renderer(
        self, *, fine_print: bool = True, keep_light: bool = True, progress: Progress | None = None
    ) -> Renderer:
        """Builds what pictures need: about a second for 27,000 products, two when light has to be baked.

        fine_print  labels sharp at arm's length; False: a quarter of the memory
        keep_light  leave baked light in the cache folder, and take it from there
        progress    as of generate()
        """
        fine_print = arguments.a_truth("fine_print", fine_print)
        keep_light = arguments.a_truth("keep_light", keep_light)
        return Renderer(_core.create_renderer(self._handle, fine_print, keep_light, arguments.a_progress(progress)))


def open_store(folder: PathLike, *, catalogs: Sequence[PathLike] = ()) -> Store:
    """Opens a store folder. `catalogs`: product files of your own that it was made with. Raises Error store.*, scene.*."""
    return _opened(arguments.a_path("folder", folder), arguments.paths("catalogs", catalogs))


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
    country: str | None = None,
    time: str | None = None,
    vary: Mapping[str, int] | None = None,
    plan: PathLike | None = None,
    planogram: PathLike | None = None,
    floor_plan: PathLike | None = None,
    floor_plan_scale: str | None = None,
    image: PathLike | Sequence[PathLike] | None = None,
    planner: str = "offline",
    planner_url: str | None = None,
    record: PathLike | None = None,
    max_tokens: int = MAX_TOKENS,
    max_seconds: float = MAX_SECONDS,
    max_usd: float | None = None,
    usd_per_million: tuple[float, float] | None = None,
    catalogs: Sequence[PathLike] = (),
    previews: bool = False,
    strict: bool = False,
    progress: Progress | None = None,
) -> Store:
    """Makes a store in `folder`, which must not exist or be empty, and opens it.

    prompt    what it should be, in words; "" with `plan`, and if you like with `floor_plan` or `image`
    size      of the room, "24x15m"
    profile   kind of shop: "supermarket-eu", "discounter", "convenience-us", ...
    style     look: "scandinavian", "industrial", ...
    country   whose money and units price tags have: "us", "gb", "cn", "jp", ...; by itself euro, or what the kind of shop says
    time      weekday and hour that the shelves show, "Sat 17:30": what shoppers took since the last restocking is gone; by itself no time
    vary      seeds of single axes in the place of `seed`: {"planogram": 3, "fill": 8}; axes are "layout", "planogram", "fill",
              "disorder" and "prices" (docs/plan.md)
    plan      a market-plan/1 file instead of a prompt
    planogram what stands on the shelves that it names, a CSV file like that of store.export("planogram", ...); its fixtures are those
              that this plan or prompt with this seed makes (docs/planogram.md)
    floor_plan        SVG, DXF, PNG or JPEG of the room: outline, doors and columns (docs/drawings.md)
    floor_plan_scale  its scale where the file says none: "1 unit = 10 mm", "1 px = 2 cm", "1:100"
    image     PNG or JPEG, or a list of them: photos of shops, whose materials, light and shelves the store gets (docs/photos.md), and
              one drawing of zones at most, with names on them; they stand where it has them (docs/drawings.md)
    planner   who plans: "offline", or a language model, "openai:gpt-4o-mini" or "replay:FOLDER", which is shown the pictures, too
              (docs/prompts.md); store.report["planner"] says whose plan the store has, and what it cost
    planner_url       base URL of another server of that kind
    record            folder to keep the exchange with the model in
    max_tokens, max_seconds, max_usd  limits of what the model may cost; max_usd needs usd_per_million
    usd_per_million   price of a million tokens read, and written: (0.15, 0.6)
    catalogs  product files of your own; each product stands in the store, or a warning says why not
    previews  draw its pictures, too (seconds)
    strict    raise layout.violation when a hard rule is broken
    progress  called as progress(done, total, text) in this thread: so much of the stage `text` is done; what it raises ends
              the work, and is raised here

    A UserWarning says what of a floor plan, drawing or photo was doubtful or left out, and where a language model reads photos otherwise. A StoreWarning says that nothing of the prompt was understood, or which of your products stand nowhere.
    Equal arguments make equal bytes. Nothing is left behind when it fails or is interrupted.
    """
    rows = arguments.paths("catalogs", catalogs)
    handle = _core.generate(
        arguments.a_text("prompt", prompt),
        arguments.a_path("folder", folder),
        arguments.a_whole("seed", seed, 0, MAX_SEED),
        arguments.a_text("size", size),
        None if profile is None else arguments.a_text("profile", profile),
        None if style is None else arguments.a_text("style", style),
        None if country is None else arguments.a_text("country", country),
        None if time is None else arguments.a_text("time", time),
        [] if vary is None else [f"{axis}={seed}" for axis, seed in arguments.seeds("vary", vary, MAX_SEED).items()],
        None if plan is None else arguments.a_path("plan", plan),
        None if planogram is None else arguments.a_path("planogram", planogram),
        None if floor_plan is None else arguments.a_path("floor_plan", floor_plan),
        None if floor_plan_scale is None else arguments.a_text("floor_plan_scale", floor_plan_scale),
        [] if image is None else arguments.path_or_paths("image", image),
        arguments.a_text("planner", planner),
        arguments.planner_access(planner_url, record, max_tokens, max_seconds, max_usd, usd_per_million),
        rows,
        arguments.a_truth("previews", previews),
        arguments.a_truth("strict", strict),
        arguments.a_progress(progress),
    )
    store = Store(handle, rows)
    for warning in store.report.get("planner", {}).get("warnings", []):
        warnings.warn(warning, UserWarning, stacklevel=2)
    for product in store.report.get("unstocked", []):
        warnings.warn(f"{product['sku']} stands nowhere in the store: {product['why']}", StoreWarning, stacklevel=2)
    if not store.report.get("understood", True):
        warnings.warn(
            f"nothing of the prompt was understood; {store.folder} is the usual store. Describe it in English, "
            'as in "a 24 x 15 m supermarket with a bakery" (docs/prompts.md)',
            StoreWarning,
            stacklevel=2,
        )
    return store
