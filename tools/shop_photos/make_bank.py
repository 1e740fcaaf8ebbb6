#!/usr/bin/env python3
"""Makes data/photo_bank.json, what `marketgen.read_photo` matches photos against.

    PYTHONPATH=build/release/python .venv/bin/python tools/shop_photos/make_bank.py PHOTOS... [--drawings FOLDER] [--others FOLDER]
        [--out data/photo_bank.json]

PHOTOS are folders of render_shop_photos.py, each of a seed of its own; DRAWINGS one of tests/zone_drawings/make_zone_drawings.py; OTHERS any pictures that show no shop.

Numbers of the pictures come from the program itself (src/marketgen/photo), so that a photo is read with what the bank was made with. Here
the reader of parts is fitted (two perceptrons), the axes along which classes lie apart are found (linear discriminants), and for each
attribute the share of votes from which on a reading counts as sure: the lowest at which, over the bank's own photos, each read with its
shop's fifth of the bank left out, at least SURE_RIGHT are right. An attribute for which there is none is never sure.
"""

import argparse
import json
import multiprocessing
import pathlib
import random

import numpy as np
from PIL import Image

from marketgen import _core
from render_shop_photos import CLASSES, PARTS, ROOT, class_of, materials

SURE_RIGHT, MIN_SURE = 0.90, 0.03  # share right; share of photos below which no threshold is believed
UNITS, VOTERS, NEARNESS = 24, 25, 1.0
CELL_PX, CELLS_A_PHOTO = 4, 110  # of the pictures of parts, a quarter of the photos' size
FOLDS = 5
GROUPS = {
    "floor": ["floor", "light"], "floor_color": ["floor", "light"],
    "wall": ["wall", "light"], "wall_color": ["wall", "light"],
    "ceiling": ["ceiling", "light", "lamps"], "ceiling_color": ["ceiling", "light"],
    "fixture": ["fixture", "light"], "fixture_color": ["fixture", "light"],
    "lamps": ["lamps"],
    "light": ["light", "floor", "ceiling", "wall", "goods"],
    "direction": ["lines", "room"], "aisle": ["lines", "room", "floor"],
    "levels": ["lines", "room", "goods", "fixture"], "shop": ["room", "goods", "fixture", "lines", "whole"],
    "subject": ["whole", "lines", "room", "light"],
}
AISLES_MM = [("narrow", 0, 1500), ("medium", 1500, 2150), ("wide", 2150, 3500)]
LIGHT_K = [("warm", 0, 3400), ("neutral", 3400, 4600), ("cool", 4600, 1e9)]
MIN_SHOWN = 0.04  # share of a photo that shows a part of which something is asked
KIND_OF_SHOP = {"convenience-cn": "convenience-us", "supermarket-us": "supermarket-eu", "organic-eu": "supermarket-eu"}  # look alike


def color_class(color):
    """The name that a person gives to a colour "#rrggbb"."""
    r, g, b = (int(color[i : i + 2], 16) / 255 for i in (1, 3, 5))
    high, low = max(r, g, b), min(r, g, b)
    chroma = high - low
    if high < 0.32 and chroma < 0.12:
        return "dark"
    if chroma < 0.075:
        return "white" if low > 0.8 else "grey"
    hue = 60 * (((g - b) / chroma) % 6 if high == r else (b - r) / chroma + 2 if high == g else (r - g) / chroma + 4)
    if 15 <= hue < 70:
        if low > 0.72:
            return "white" if chroma < 0.1 else "beige"
        return "beige" if high > 0.7 and chroma < 0.36 else "brown" if chroma < 0.55 or high < 0.6 else "yellow"
    if hue < 15 or hue >= 300:
        return "red"
    return "green" if hue < 165 else "blue"


def labels_of(photo, folder, rows):
    """Class and material by attribute, of what is known and to be seen in a photo."""
    truth = photo["truth"]
    parts = np.asarray(Image.open(folder / f"{photo['file']}.parts.png"))
    known = {"shop": (KIND_OF_SHOP.get(truth["shop"], truth["shop"]), ""), "lamps": (truth["lamps"], ""), "subject": ("room", "")}
    known["light"] = (next(name for name, low, high in LIGHT_K if low <= truth["kelvin"] < high), "")
    if (parts == PARTS["ceiling"]).mean() < MIN_SHOWN:
        del known["lamps"]
    for part in CLASSES:
        if part in truth and (parts == PARTS[part]).mean() >= MIN_SHOWN:
            row = rows[truth[part]]
            known[part] = (class_of(part, row), row["id"])
            known[f"{part}_color"] = (color_class(row["color"]), row["id"])
    if "direction" in truth:
        known["direction"] = (truth["direction"], "")
    if "levels" in truth:
        known["levels"] = (str(truth["levels"]), "")
    for name, low, high in AISLES_MM:
        if low < truth.get("aisle_mm", 0) <= high:
            known["aisle"] = (name, "")
    return known


class Perceptron:
    """One hidden layer of rectified units, softmax; Adam on the cross entropy."""

    def __init__(self, numbers, labels, seed, epochs=14):
        rng = np.random.default_rng(seed)
        self.mean, self.scale = numbers.mean(0), 1 / (numbers.std(0) + 1e-6)
        x = (numbers - self.mean) * self.scale
        n = x.shape[1]
        w = [rng.normal(0, (2 / n) ** 0.5, (n + 1, UNITS)), rng.normal(0, (1 / UNITS) ** 0.5, (UNITS + 1, len(PARTS)))]
        weight = 1 / np.bincount(labels, minlength=len(PARTS)).clip(1) ** 0.5
        first, second, step = [np.zeros_like(m) for m in w], [np.zeros_like(m) for m in w], 0
        for epoch in range(epochs):
            rate = 2e-3 * (1 - epoch / epochs) + 1e-4
            order = rng.permutation(len(x))
            for at in range(0, len(x), 512):
                rows = order[at : at + 512]
                ones = np.ones((len(rows), 1))
                inputs = np.hstack([x[rows], ones])
                unit = np.hstack([np.maximum(inputs @ w[0], 0), ones])
                share = softmax(unit @ w[1])
                share[np.arange(len(rows)), labels[rows]] -= 1
                share *= (weight[labels[rows]] / weight[labels[rows]].mean())[:, None] / len(rows)
                slopes = [inputs.T @ ((share @ w[1][:-1].T) * (unit[:, :-1] > 0)), unit.T @ share]
                step += 1
                for i, slope in enumerate(slopes):
                    slope = slope + 1e-5 * w[i]
                    first[i] = 0.9 * first[i] + 0.1 * slope
                    second[i] = 0.999 * second[i] + 0.001 * slope**2
                    w[i] -= rate * (first[i] / (1 - 0.9**step)) / (np.sqrt(second[i] / (1 - 0.999**step)) + 1e-8)
        self.weights = w

    def shares(self, numbers):
        ones = np.ones((len(numbers), 1))
        unit = np.maximum(np.hstack([(numbers - self.mean) * self.scale, ones]) @ self.weights[0], 0)
        return softmax(np.hstack([unit, ones]) @ self.weights[1])

    def to_dict(self):
        return {"mean": short(self.mean), "scale": short(self.scale),
                "hidden": short(self.weights[0].T), "output": short(self.weights[1].T)}


def softmax(scores):
    shares = np.exp(scores - scores.max(1, keepdims=True))
    return shares / shares.sum(1, keepdims=True)


def short(numbers, digits=5):
    return [float(f"{x:.{digits}g}") for x in np.ravel(numbers)]


def true_parts(file, columns, count):
    """Index of each cell's part, -1 where no part has 60 % of it."""
    parts = np.asarray(Image.open(f"{file}.parts.png"))
    labels = np.full(count, -1)
    for cell in range(count):
        row, column = divmod(cell, columns)
        block = parts[row * CELL_PX : (row + 1) * CELL_PX, column * CELL_PX : (column + 1) * CELL_PX]
        seen = np.bincount(block.ravel(), minlength=len(PARTS) + 1)[1:]
        if block.size and seen.max() >= 0.6 * block.size:
            labels[cell] = seen.argmax()
    return labels


def sample(work):
    """Cells of one photo for the reader of parts: their numbers and parts."""
    file, model, seed = work
    columns, first = _core._photo_first_numbers(str(file))
    numbers = first if model is None else _core._photo_second_numbers(str(file), model)
    labels = true_parts(file, columns, len(first))
    known = np.flatnonzero(labels >= 0)
    rng = np.random.default_rng(seed)
    known = rng.choice(known, min(len(known), CELLS_A_PHOTO), replace=False)
    return numbers[known], labels[known]


def features(work):
    return _core._photo_features(*work)


def fit_parts(pool, files):
    models, held_out = [], files[::10]
    for stage in range(2):
        first = None if stage == 0 else json.dumps(models[0].to_dict())
        work = [(file, first, number) for number, file in enumerate(files)]
        drawn = pool.map(sample, work, chunksize=16)
        fit = [cells for number, cells in enumerate(drawn) if number % 10]
        numbers, labels = np.vstack([n for n, _ in fit]), np.concatenate([part for _, part in fit])
        models.append(Perceptron(numbers, labels, seed=stage))
        test = [cells for number, cells in enumerate(drawn) if number % 10 == 0]
        guess = models[-1].shares(np.vstack([n for n, _ in test])).argmax(1)
        print(f"parts, stage {stage + 1}: {(guess == np.concatenate([p for _, p in test])).mean():.3f} right of {len(held_out)} photos' cells")
    return models


def discriminants(x, votes, classes):
    """Axes along which classes lie apart, spread within classes about 1."""
    within, between = np.zeros((x.shape[1],) * 2), np.zeros((x.shape[1],) * 2)
    for index in range(classes):
        own = x[votes == index]
        if len(own) == 0:
            continue
        middle = own.mean(0)
        within += (own - middle).T @ (own - middle) / len(x)
        between += np.outer(middle, middle) / classes
    within += 0.05 * np.eye(x.shape[1])
    values, vectors = np.linalg.eigh(np.linalg.inv(np.linalg.cholesky(within)) @ between @ np.linalg.inv(np.linalg.cholesky(within)).T)
    axes = vectors[:, ::-1][:, : max(1, classes - 1)].T @ np.linalg.inv(np.linalg.cholesky(within))
    return axes[:8]


def vote(places, votes, asked, classes):
    """As vote_on() of src/marketgen/photo/bank.cpp: winner and its share, for each row of `asked`."""
    winners, shares = [], []
    for place in asked:
        apart = ((places - place) ** 2).sum(1)
        near = np.argsort(apart, kind="stable")[:VOTERS]
        weight = NEARNESS / (NEARNESS + apart[near])
        each = np.bincount(votes[near], weight, minlength=classes)
        winners.append(each.argmax())
        shares.append(each.max() / each.sum())
    return np.array(winners), np.array(shares)


def sure_vote(right, shares):
    """The lowest share from which on SURE_RIGHT are right; 1.5 when there is none."""
    order = np.argsort(-shares)
    good = right[order].cumsum() / np.arange(1, len(order) + 1)
    enough = np.flatnonzero(good >= SURE_RIGHT)
    enough = enough[enough >= max(20, MIN_SURE * len(order))]
    return float(np.ceil(shares[order[enough[-1]]] * 1000) / 1000) if len(enough) else 1.5


def fit_attribute(name, found, labels, shops):
    rows = [i for i, known in enumerate(labels) if name in known]
    classes = sorted({labels[i][name][0] for i in rows})
    votes = np.array([classes.index(labels[i][name][0]) for i in rows])
    x = np.array([sum((found[i][group] for group in GROUPS[name]), []) for i in rows])
    mean, scale = x.mean(0), 1 / (x.std(0) + 1e-6)
    x = (x - mean) * scale
    fold = np.array([hash_fold(shops[i]) for i in rows])
    winner, share = np.zeros(len(rows), int), np.zeros(len(rows))
    for k in range(FOLDS):
        fit = fold != k
        axes = discriminants(x[fit], votes[fit], len(classes))
        winner[~fit], share[~fit] = vote(x[fit] @ axes.T, votes[fit], x[~fit] @ axes.T, len(classes))
    right = winner == votes
    least = sure_vote(right, share)
    sure = share >= least
    of_sure = right[sure].mean() if sure.any() else float("nan")
    print(f"{name:14} {len(rows):5} photos, {len(classes)} classes: {right.mean():.3f} right; sure of {sure.mean():.3f}, of those {of_sure:.3f}")
    axes = discriminants(x, votes, len(classes))
    return {"name": name, "classes": classes, "groups": GROUPS[name], "mean": short(mean), "scale": short(scale),
            "axes": short(axes), "places": [round(float(p), 2) for p in np.ravel(x @ axes.T)], "votes": votes.tolist(),
            "materials": [labels[i][name][1] for i in rows] if labels[rows[0]][name][1] else [],
            "voters": VOTERS, "sure_vote": least}


def hash_fold(shop):
    return random.Random(f"fold {shop}").randrange(FOLDS)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("photos", type=pathlib.Path, nargs="+")
    parser.add_argument("--drawings", type=pathlib.Path)
    parser.add_argument("--others", type=pathlib.Path)
    parser.add_argument("--out", type=pathlib.Path, default=ROOT / "data" / "photo_bank.json")
    args = parser.parse_args()
    rows = {row["id"]: row for row in materials()}
    files, labels, shops = [], [], []
    for folder in args.photos:
        for line in (folder / "photos.jsonl").read_text().splitlines():
            photo = json.loads(line)
            files.append(folder / photo["file"])
            labels.append(labels_of(photo, folder, rows))
            shops.append(f"{folder} {photo['number']}")
    count = len(files)
    for subject, folder in [("drawing", args.drawings), ("other", args.others)]:
        pictures = sorted(p for p in folder.iterdir() if p.suffix in {".jpg", ".png"}) if folder else []
        files += pictures
        labels += [{"subject": (subject, "")}] * len(pictures)
        shops += [f"{subject} {p.name}" for p in pictures]
    with multiprocessing.Pool(2) as pool:
        models = fit_parts(pool, files[:count])
        texts = [json.dumps(model.to_dict()) for model in models]
        found = pool.map(features, [(str(file), *texts) for file in files], chunksize=16)
    attributes = [fit_attribute(name, found, labels, shops) for name in GROUPS]
    bank = {"first_parts": models[0].to_dict(), "second_parts": models[1].to_dict(), "attributes": attributes}
    args.out.with_suffix(".part").write_text(json.dumps(bank, separators=(",", ":")) + "\n")
    args.out.with_suffix(".part").rename(args.out)
    print(f"{args.out}: {args.out.stat().st_size / 1e6:.1f} MB")


if __name__ == "__main__":
    main()
