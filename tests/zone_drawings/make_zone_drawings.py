#!/usr/bin/env python3
"""Drawings of shops' zones with known truth: PNG and JPEG pictures, and what is in them.

    .venv/bin/python tests/zone_drawings/make_zone_drawings.py FOLDER [--seed 1] [--count 100] [--small] [--what shelves|black]

FOLDER/truth.json lists for each drawing its file, style, whether it is photographed, the dimensions written on it (0: none), and in
millimetres, in the frame of the shop (south-west corner, y north), width, depth, doors [x0, y0, x1, y1] and zones {words, x, y, w, d};
a zone without words and colour is bare floor. Needs a font with Chinese letters: Debian's fonts-wqy-microhei. The same seed and fonts
make the same files. --small: small JPEG pictures, for the tests' own set.

--what shelves: the same drawings with shelves in their zones, as strokes, bars or narrow boxes side by side; a zone has "runs" [how many,
"x" or "y"] in the truth where it has some. --what black: hatched in black in directions and distances that differ from zone to zone,
hatched so in one colour, and zones of one or two colours with lines between them.
"""

import argparse
import io
import json
import math
import pathlib
import random

import numpy as np
from PIL import Image, ImageDraw, ImageFilter, ImageFont

STYLES = ["flat", "marker", "hatched", "pencil", "legend"]
BLACK_STYLES = ["black", "one pen", "lined"]
SHELF_FORMS = ["line", "bar", "box", "cells", "grey"]
NO_SHELVES = {"Checkout", "收银", "Storage", "仓库"}
ENGLISH = ["Produce", "Fruit & Veg", "Dairy", "Bakery", "Frozen", "Meat", "Drinks", "Snacks", "Checkout", "Fish", "Deli", "Wine",
           "Beverages", "Household", "Health & Beauty", "Grocery", "Pet food", "Storage"]
CHINESE = ["蔬果", "乳品", "烘焙", "冷冻", "肉类", "饮料", "零食", "收银", "水产", "熟食", "日用品", "酒水", "粮油", "仓库"]
COLOURS = [(244, 143, 138), (255, 204, 102), (165, 214, 120), (120, 190, 240), (190, 150, 225), (110, 215, 205), (250, 160, 215),
           (205, 160, 110), (240, 240, 110), (130, 150, 230)]
PENS = [(205, 45, 40), (235, 130, 20), (40, 150, 50), (30, 95, 205), (130, 50, 170), (0, 150, 150), (220, 50, 150), (140, 85, 30),
        (190, 170, 0), (85, 85, 190)]
LATIN_FONTS = ["/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf", "/usr/share/fonts/truetype/lato/Lato-Regular.ttf",
               "/usr/share/fonts/truetype/open-sans/OpenSans-Regular.ttf"]
CHINESE_FONT = "/usr/share/fonts/truetype/wqy/wqy-microhei.ttc"


def divide(rng, w, d, wanted):
    """A guillotine division into rectangles (x, y, w, d), none narrower than 3 m."""
    parts = [(0, 0, w, d)]
    while len(parts) < wanted:
        parts.sort(key=lambda p: -p[2] * p[3])
        for i, (x, y, a, b) in enumerate(parts):
            if max(a, b) < 6400:
                continue
            t = rng.uniform(0.35, 0.65)
            if a >= b:
                cut = int(a * t) // 100 * 100
                new = [(x, y, cut, b), (x + cut, y, a - cut, b)]
            else:
                cut = int(b * t) // 100 * 100
                new = [(x, y, a, cut), (x, y + cut, a, b - cut)]
            if min(new[0][2:] + new[1][2:]) < 3000:
                continue
            parts[i:i + 1] = new
            break
        else:
            break
    return parts


def neighbours(a, b):
    """Two rectangles with a border in common."""
    over_x = min(a[0] + a[2], b[0] + b[2]) - max(a[0], b[0])
    over_y = min(a[1] + a[3], b[1] + b[3]) - max(a[1], b[1])
    return (over_x == 0 and over_y > 0) or (over_y == 0 and over_x > 0)


def told_apart(rng, zones, kinds):
    """Of each zone an index below `kinds` that no neighbour has, as far as there are enough."""
    chosen = []
    for i, zone in enumerate(zones):
        near = {chosen[k] for k in range(i) if neighbours(zone, zones[k])}
        free = [k for k in range(kinds) if k not in near] or list(range(kinds))
        chosen.append(rng.choice(free))
    return chosen


def doors_of(rng, w, d):
    doors = []
    for side in rng.sample("SNEW", rng.choice([1, 1, 2, 2, 3])):
        length = w if side in "SN" else d
        width = rng.randrange(1200, 2900, 100)
        at = rng.randrange(800, length - width - 800, 100)
        doors.append({"S": (at, 0, at + width, 0), "N": (at, d, at + width, d), "W": (0, at, 0, at + width), "E": (w, at, w, at + width)}[side])
    return doors


class Sheet:
    def __init__(self, rng, style, small):
        self.rng, self.style = rng, style
        self.w, self.d = rng.randrange(12000, 40001, 100), rng.randrange(10000, 30001, 100)
        self.chinese = rng.random() < 0.35
        self.wall = rng.randrange(150, 350, 10)
        self.zones = divide(rng, self.w, self.d, rng.randrange(4, 11))
        names = rng.sample(CHINESE if self.chinese else ENGLISH, len(self.zones))
        self.names = names
        self.bare = rng.randrange(len(self.zones)) if style != "pencil" and len(self.zones) > 4 and rng.random() < 0.3 else -1
        if self.bare >= 0:
            self.names[self.bare] = ""
        self.doors = doors_of(rng, self.w, self.d)
        longer = (520 if small else rng.randrange(900, 1500))
        self.px = longer / max(self.w, self.d)
        self.left = self.top = int(longer * 0.11)
        right = int(longer * (0.34 if style == "legend" else 0.11))
        self.size = (int(self.w * self.px) + self.left + right, int(self.d * self.px) + 2 * self.top)
        self.dimensions = rng.random() < 0.5
        self.image = Image.new("RGB", self.size, (252, 252, 250))
        self.draw = ImageDraw.Draw(self.image)
        latin = rng.choice(LATIN_FONTS)
        self.font_file = CHINESE_FONT if self.chinese else latin
        order = list(range(len(COLOURS)))
        rng.shuffle(order)
        self.colour = order
        self.runs = [None] * len(self.zones)
        if style == "lined":
            self.colour = [order[rng.randrange(2)] for _ in self.zones]
        # Directions and distances of the hatching (share of the sheet's width); 90 degrees is upright.
        self.hatching = [(a, g) for g in (0.010, 0.021) for a in (0, 45, 90, 135)]
        if style in ("black", "one pen"):
            self.hatching = [self.hatching[k] for k in told_apart(rng, self.zones, rng.choice([4, 4, 8]))]

    def at(self, x, y):
        return (self.left + x * self.px, self.top + (self.d - y) * self.px)

    def font(self, size):
        return ImageFont.truetype(self.font_file, max(9, round(size)))

    def text(self, centre, words, box_w, box_h, ink=(20, 20, 20), anchor="mm"):
        size = min(box_h * 0.5, self.size[0] * 0.032)
        while size > 9 and self.font(size).getlength(words) > box_w * 0.88:
            size -= 1
        self.draw.text(centre, words, font=self.font(size), fill=ink, anchor=anchor)

    def wobbly(self, a, b, ink, width, wobble):
        n = max(2, int(math.dist(a, b) / 12))
        points, dx, dy = [], 0, 0
        for i in range(n + 1):
            points.append((a[0] + (b[0] - a[0]) * i / n + dx, a[1] + (b[1] - a[1]) * i / n + dy))
            dx, dy = 0.8 * dx + self.rng.gauss(0, wobble), 0.8 * dy + self.rng.gauss(0, wobble)
        self.draw.line(points, fill=ink, width=width, joint="curve")

    def fill(self, box, index):
        x0, y0, x1, y1 = box
        rng, colour = self.rng, COLOURS[self.colour[index]]
        if self.style in ("flat", "legend"):
            self.draw.rectangle(box, fill=colour)
        elif self.style == "lined":
            self.draw.rectangle(box, fill=COLOURS[self.colour[index]], outline=(30, 30, 30), width=2)
        elif self.style == "marker":
            inset = rng.uniform(2, 7)
            pen = max(5, self.size[0] // 90)
            y = y0 + inset + pen / 2
            while y < y1 - inset - pen / 3:
                ends = x0 + inset + rng.uniform(0, pen), x1 - inset - rng.uniform(0, pen)
                shade = tuple(int(min(255, c + rng.gauss(0, 6))) for c in colour)
                self.wobbly((ends[0] + pen / 2, y), (ends[1] - pen / 2, y), shade, pen, 0.3)
                y += pen * rng.uniform(0.75, 1.15)
        else:
            if self.style == "hatched":
                pen, gap = PENS[self.colour[index]], rng.uniform(0.009, 0.014) * self.size[0]
                angle = math.radians(rng.choice([30, 45, 60, 90, 120, 135, 150]))
            else:
                pen = (30, 30, 30) if self.style == "black" else PENS[self.colour[0]]
                degrees, gap = self.hatching[index]
                angle, gap = math.radians(degrees + rng.uniform(-4, 4)), gap * self.size[0]
            mask = Image.new("L", self.size, 0)
            ink = ImageDraw.Draw(mask)
            cx, cy, far = (x0 + x1) / 2, (y0 + y1) / 2, max(self.size)
            for i in range(-int(far / gap), int(far / gap)):
                ox, oy = cx - math.sin(angle) * i * gap, cy + math.cos(angle) * i * gap
                ink.line([(ox - far * math.cos(angle), oy - far * math.sin(angle)), (ox + far * math.cos(angle), oy + far * math.sin(angle))],
                         fill=255, width=max(1, self.size[0] // 500))
            window = Image.new("L", self.size, 0)
            ImageDraw.Draw(window).rectangle((x0 + 1, y0 + 1, x1 - 1, y1 - 1), fill=255)
            self.image.paste(pen, (0, 0), Image.composite(mask, Image.new("L", self.size, 0), window))

    def walls(self):
        grey = self.rng.randrange(70, 105)
        ink = (grey,) * 3 if self.style == "pencil" else (25, 25, 25)
        t = self.wall
        for a, b, on in [((-t, 0), (self.w + t, 0), "S"), ((-t, self.d), (self.w + t, self.d), "N"), ((0, -t), (0, self.d + t), "W"),
                         ((self.w, -t), (self.w, self.d + t), "E")]:
            k = 0 if on in "SN" else 1
            level = a[1 - k]
            gaps = sorted((door[k], door[k + 2]) for door in self.doors if door[1 - k] == door[3 - k] == level)
            start = a[k]
            for low, high in gaps + [(b[k], b[k])]:
                p = [start, low]
                start = high
                if self.style == "pencil":
                    mid = level + (t / 2 if level > 0 else -t / 2)
                    ends = [(s, mid) if k == 0 else (mid, s) for s in p]
                    self.wobbly(self.at(*ends[0]), self.at(*ends[1]), ink, max(3, round(t * self.px * 0.6)), 0.15)
                    continue
                out = level + (t if level > 0 else -t)
                corners = [(p[0], level), (p[1], out)] if k == 0 else [(level, p[0]), (out, p[1])]
                (xa, ya), (xb, yb) = self.at(*corners[0]), self.at(*corners[1])
                self.draw.rectangle((min(xa, xb), min(ya, yb), max(xa, xb), max(ya, yb)), fill=ink)
        return ink

    def labels(self):
        rng = self.rng
        for index, ((x, y, w, d), name) in enumerate(zip(self.zones, self.names)):
            if not name or self.style == "legend":
                continue
            cx, cy = self.name_at.get(index, self.at(x + w / 2, y + d / 2))
            if self.style in ("hatched", "black", "one pen"):  # written on a patch left free
                half = min(w * self.px * 0.45, self.size[0] * 0.09), self.size[0] * 0.02
                self.draw.rectangle((cx - half[0], cy - half[1], cx + half[0], cy + half[1]), fill=(252, 252, 250))
                self.text((cx, cy), name, 2 * half[0], d * self.px)
            else:
                self.text((cx, cy), name, w * self.px, d * self.px, (60, 60, 60) if self.style == "pencil" else (20, 20, 20))

    def legend(self):
        x, y = self.left + (self.w + self.wall) * self.px + self.size[0] * 0.04, self.top + 10
        side = self.size[0] * 0.03
        for index, name in enumerate(self.names):
            if not name:
                continue
            self.draw.rectangle((x, y, x + side, y + side), fill=COLOURS[self.colour[index]], outline=(60, 60, 60))
            self.text((x + side * 1.4, y + side / 2), name, self.size[0] - x - side * 1.6, side * 2.0, anchor="lm")
            y += side * 1.6

    def outside(self):
        unit = self.size[0] * 0.022
        if self.dimensions:
            def words(mm):
                return {0: f"{mm / 1000:.1f} m", 1: f"{mm / 1000:.1f}".replace(".", ",") + " m", 2: f"{mm / 1000:.1f} 米", 3: f"{mm}"}[form]
            form = self.rng.choice([0, 2, 3] if self.chinese else [0, 1, 3])
            x, y = self.at(self.w / 2, self.d + self.wall)
            self.draw.text((x, y - unit * 1.5), words(self.w), font=self.font(unit), fill=(40, 40, 40), anchor="mm")
        for number, (x0, y0, x1, y1) in enumerate(self.doors[:2]):
            name = (["入口", "出口"] if self.chinese else ["ENTRANCE", "EXIT"])[number]
            if self.rng.random() < 0.4 or y0 != y1 or (y0 > 0 and self.dimensions):
                continue
            x, y = self.at((x0 + x1) / 2, y0)
            self.draw.text((x, y + (self.wall * self.px + unit * 1.2) * (1 if y0 == 0 else -1)), name, font=self.font(unit), fill=(40, 40, 40), anchor="mm")

    def shelf(self, box, along_x, form):
        """One run of shelves: corners on the picture."""
        x0, y0, x1, y1 = box
        grey = (85, 85, 85) if self.style == "pencil" else (30, 30, 30)
        thin = max(1, self.size[0] // 500)
        if form == "line":
            middle = ((x0, (y0 + y1) / 2), (x1, (y0 + y1) / 2)) if along_x else (((x0 + x1) / 2, y0), ((x0 + x1) / 2, y1))
            self.wobbly(*middle, grey, thin + 1, 0.25)
        elif form == "bar":
            self.draw.rectangle(box, fill=grey)
        elif form == "grey":
            self.draw.rectangle(box, fill=(190, 190, 190), outline=grey, width=thin)
        else:
            self.draw.rectangle(box, outline=grey, width=thin)
            for k in range(1, 5 if form == "cells" else 0):
                x, y = x0 + (x1 - x0) * k / 5, y0 + (y1 - y0) * k / 5
                self.draw.line([(x, y0), (x, y1)] if along_x else [(x0, y), (x1, y)], fill=grey, width=thin)

    def shelves(self, rng):
        """Runs side by side in zones that have room, with the name above them or on a patch over them."""
        form, deep = rng.choice(SHELF_FORMS), rng.choice([900, 1000, 1200])
        may_lie_over = rng.random() < 0.4 and self.style not in ("legend", "hatched", "marker")
        for index, ((x, y, w, d), name) in enumerate(zip(self.zones, self.names)):
            if not name or name in NO_SHELVES or rng.random() < 0.3:
                continue
            along_x = rng.random() < 0.5
            half = min(w * self.px * 0.45, self.size[0] * 0.1), self.size[0] * 0.022
            over = may_lie_over and (half[0] < 0.3 * w * self.px if along_x else half[1] < 0.3 * d * self.px)
            band = 0 if over or self.style == "legend" else max(1500, 0.05 * max(self.w, self.d))
            inset = rng.uniform(700, 1200)
            x0, y0, x1, y1 = x + inset, y + inset, x + w - inset, y + d - inset - band
            length, across = (x1 - x0, y1 - y0) if along_x else (y1 - y0, x1 - x0)
            pitch = deep + rng.uniform(1500, 2600)
            count = min(7, int((across - deep) / pitch) + 1)
            if length < 2500 or count < 2:
                continue
            start = (across - deep - (count - 1) * pitch) / 2
            for k in range(count):
                low = start + k * pitch
                ends = (x0, y0 + low, x1, y0 + low + deep) if along_x else (x0 + low, y0, x0 + low + deep, y1)
                (xa, ya), (xb, yb) = self.at(ends[0], ends[3]), self.at(ends[2], ends[1])
                self.shelf((xa, ya, xb, yb), along_x, form)
            self.runs[index] = [count, "x" if along_x else "y"]
            cx, cy = self.at(x + w / 2, y + d / 2)
            if over:
                ground = COLOURS[self.colour[index]] if self.style == "flat" else (252, 252, 250)
                self.draw.rectangle((cx - half[0], cy - half[1], cx + half[0], cy + half[1]), fill=ground)
            elif band:
                self.name_at[index] = self.at(x + w / 2, y + d - band * 0.55)

    def make(self, shelves_rng=None):
        self.name_at = {}
        for index, (x, y, w, d) in enumerate(self.zones):
            (xa, ya), (xb, yb) = self.at(x, y + d), self.at(x + w, y)
            if self.style != "pencil" and index != self.bare:
                self.fill((xa, ya, xb, yb), index)
        ink = self.walls()
        for x, y, w, d in self.zones if self.style == "pencil" else []:
            corners = [self.at(x, y), self.at(x + w, y), self.at(x + w, y + d), self.at(x, y + d)]
            for i, (px, py) in enumerate([(x, y), (x + w, y), (x + w, y + d), (x, y + d)]):
                qx, qy = [(x, y), (x + w, y), (x + w, y + d), (x, y + d)][(i + 1) % 4]
                outer = (px == qx and px in (0, self.w)) or (py == qy and py in (0, self.d))
                if not outer and (i in (1, 2)):
                    self.wobbly(corners[i], corners[(i + 1) % 4], tuple(c + 15 for c in ink), 2, 0.5)
        if shelves_rng:
            self.shelves(shelves_rng)
        self.labels()
        self.outside()
        if self.style == "legend":
            self.legend()
        return self.image


def solve(source, target):
    rows = []
    for (x, y), (u, v) in zip(target, source):
        rows += [[x, y, 1, 0, 0, 0, -u * x, -u * y], [0, 0, 0, x, y, 1, -v * x, -v * y]]
    return np.linalg.solve(np.array(rows, float), np.array([c for p in source for c in p], float))


def seen(rng, sheet, photographed):
    """The sheet a few degrees askew; photographed from aside on a table, in uneven light."""
    w, h = sheet.size
    turn = math.radians(rng.uniform(-4, 4))
    tilt, spin = (math.radians(rng.uniform(5, 30)), rng.uniform(0, 2 * math.pi)) if photographed else (0, 0)
    far = 2.2 * max(w, h)
    corners = []
    for x, y in [(0, 0), (w, 0), (w, h), (0, h)]:
        x, y = x - w / 2, y - h / 2
        x, y = x * math.cos(turn) - y * math.sin(turn), x * math.sin(turn) + y * math.cos(turn)
        along, across = x * math.cos(spin) + y * math.sin(spin), -x * math.sin(spin) + y * math.cos(spin)
        depth = far + along * math.sin(tilt)
        along, across = along * math.cos(tilt) * far / depth, across * far / depth
        corners.append((along * math.cos(spin) - across * math.sin(spin), along * math.sin(spin) + across * math.cos(spin)))
    low = np.array(corners).min(axis=0) - (20 if photographed else 0)
    size = tuple(int(v) for v in np.array(corners).max(axis=0) - low + (20 if photographed else 0))
    placed = [(x - low[0], y - low[1]) for x, y in corners]
    back = solve([(0, 0), (w, 0), (w, h), (0, h)], placed)
    table = rng.choice([(120, 85, 60), (90, 95, 100), (60, 70, 90)]) if photographed else (252, 252, 250)
    image = sheet.transform(size, Image.PERSPECTIVE, tuple(back), Image.BICUBIC, fillcolor=table)
    if not photographed:
        return image
    pixels = np.asarray(image, float)
    yy, xx = np.mgrid[0:size[1], 0:size[0]]
    way = rng.uniform(0, 2 * math.pi)
    ramp = (xx / size[0] - 0.5) * math.cos(way) + (yy / size[1] - 0.5) * math.sin(way)
    light = 0.8 + rng.uniform(0.1, 0.35) * ramp
    tint = np.array([1.0, rng.uniform(0.93, 1.0), rng.uniform(0.82, 1.0)])
    noise = np.random.default_rng(rng.randrange(1 << 30)).normal(0, rng.uniform(1, 5), pixels.shape)
    pixels = pixels * light[..., None] * tint + noise
    image = Image.fromarray(np.clip(pixels, 0, 255).astype(np.uint8))
    return image.filter(ImageFilter.GaussianBlur(rng.uniform(0.2, 0.8)))


def main():
    arguments = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    arguments.add_argument("folder", type=pathlib.Path)
    arguments.add_argument("--seed", type=int, default=1)
    arguments.add_argument("--count", type=int, default=100)
    arguments.add_argument("--small", action="store_true")
    arguments.add_argument("--what", choices=["zones", "shelves", "black"], default="zones")
    options = arguments.parse_args()
    options.folder.mkdir(parents=True, exist_ok=True)
    truths = []
    for number in range(options.count):
        rng = random.Random(options.seed * 100003 + number)
        styles = BLACK_STYLES if options.what == "black" else STYLES
        style = styles[number % len(styles)]
        photographed = number // len(styles) % 2 == 1
        sheet = Sheet(rng, style, options.small)
        shelves_rng = random.Random(options.seed * 100003 + number + 50000) if options.what == "shelves" else None
        image = seen(rng, sheet.make(shelves_rng), photographed)
        name = f"{number:03}." + ("jpg" if photographed or rng.random() < 0.3 or options.small else "png")
        data = io.BytesIO()
        if name.endswith("jpg"):
            image.save(data, "JPEG", quality=60 if options.small else rng.randrange(60, 91))
        else:
            image.save(data, "PNG")
        (options.folder / name).write_bytes(data.getvalue())
        truths.append({
            "file": name, "style": style, "photographed": photographed, "width": sheet.w, "depth": sheet.d,
            "dimensions": [sheet.w, 0] if sheet.dimensions else [0, 0], "doors": [list(door) for door in sheet.doors],
            "zones": [{"words": n, "x": x, "y": y, "w": w, "d": d} | ({"runs": r} if r else {})
                      for (x, y, w, d), n, r in zip(sheet.zones, sheet.names, sheet.runs)]})
    (options.folder / "truth.json").write_text(json.dumps(truths, ensure_ascii=False, indent=1) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
