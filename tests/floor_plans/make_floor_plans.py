#!/usr/bin/env python3
"""Floor plans with known truth: SVG, DXF, PNG and JPEG drawings of shops, and what is in them.

    .venv/bin/python tests/floor_plans/make_floor_plans.py FOLDER [--seed 1] [--count 40]

FOLDER/truth.json lists for each drawing its file, the --floor-plan-scale it needs (empty: the file says it), and in millimetres, in the
frame of the shop, the outline (inner faces of the walls), openings [x0, y0, x1, y1, "door" or "window"] and columns [x, y, side].
The same seed makes the same files.
"""

import argparse
import json
import math
import pathlib
import random

from PIL import Image, ImageDraw, ImageFilter

SHAPES = ["rectangle", "L", "T", "U", "chamfer", "trapezoid", "stepped", "plus"]
VECTOR_STYLES = ["double", "bodies", "closed", "gaps", "lines", "blocks"]
PICTURE_STYLES = ["solid", "hollow", "line"]
# What layers are called: AIA, plain English, German, Chinese, and nothing.
NAMES = [
    {"wall": "A-WALL", "door": "A-DOOR", "window": "A-GLAZ", "column": "S-COLS", "dim": "A-ANNO-DIMS", "furniture": "A-FURN"},
    {"wall": "Walls", "door": "Doors", "window": "Windows", "column": "Columns", "dim": "Dimensions", "furniture": "Furniture"},
    {"wall": "Wände", "door": "Türen", "window": "Fenster", "column": "Stützen", "dim": "Bemaßung", "furniture": "Möbel"},
    {"wall": "墙体", "door": "门", "window": "窗", "column": "柱", "dim": "尺寸标注", "furniture": "家具"},
    None,
]


def step(rng, low, high):
    return rng.randrange(low, high + 1, 100)


def outline_of(rng, shape):
    w, d = step(rng, 14000, 44000), step(rng, 12000, 30000)
    a, b = int(w * rng.uniform(0.3, 0.5)) // 100 * 100, int(d * rng.uniform(0.3, 0.5)) // 100 * 100
    if shape == "rectangle":
        points = [(0, 0), (w, 0), (w, d), (0, d)]
    elif shape == "L":
        points = [(0, 0), (w, 0), (w, d - b), (w - a, d - b), (w - a, d), (0, d)]
    elif shape == "T":
        c = (w - a) // 2
        points = [(0, 0), (w, 0), (w, d - b), (w - c, d - b), (w - c, d), (c, d), (c, d - b), (0, d - b)]
    elif shape == "U":
        c = int(w * 0.33)
        points = [(0, 0), (w, 0), (w, d), (w - c, d), (w - c, d - b), (c, d - b), (c, d), (0, d)]
    elif shape == "chamfer":
        e = int(min(w, d) * 0.25)
        points = [(0, 0), (w, 0), (w, d - e), (w - e, d), (0, d)]
    elif shape == "trapezoid":
        points = [(0, 0), (w, 0), (w - w // 8, d), (w // 10, d)]
    elif shape == "stepped":
        points = [(0, 0), (w, 0), (w, d // 2), (w - a // 2, d // 2), (w - a // 2, d * 3 // 4), (w - a, d * 3 // 4), (w - a, d), (0, d)]
    else:
        e, f = w // 5, d // 5
        points = [(e, 0), (w - e, 0), (w - e, f), (w, f), (w, d - f), (w - e, d - f), (w - e, d), (e, d), (e, d - f), (0, d - f), (0, f), (e, f)]
    if rng.random() < 0.3 and shape in ("L", "chamfer", "stepped"):
        points = [(w - x, y) for x, y in reversed(points)]
    return points, w, d


def along(edge, t):
    (x0, y0), (x1, y1) = edge
    length = math.dist(*edge)
    return (x0 + (x1 - x0) * t / length, y0 + (y1 - y0) * t / length)


def inwards(edge):
    (x0, y0), (x1, y1) = edge
    length = math.dist(*edge)
    return (-(y1 - y0) / length, (x1 - x0) / length)


def edges_of(points):
    return [(points[i], points[(i + 1) % len(points)]) for i in range(len(points))]


def openings_of(rng, points):
    """Per edge a sorted list of (from, to, kind)."""
    edges = edges_of(points)
    openings = [[] for _ in edges]
    for i in range(len(edges)):
        length = math.dist(*edges[i])
        wanted = 2 if i == 0 else rng.choice([0, 0, 1, 1, 2])
        at = rng.uniform(900, 2500)
        for _ in range(wanted):
            kind = "door" if i == 0 or rng.random() < 0.6 else "window"
            width = step(rng, 900, 2000) if kind == "door" else step(rng, 1200, 3000)
            if i == 0:
                width = step(rng, 1600, 2400)
            if at + width + 900 > length:
                break
            openings[i].append((round(at), round(at) + width, kind))
            at += width + rng.uniform(1200, max(1300, length / 3))
    return openings


def columns_of(rng, points, w, d):
    size, gap = rng.choice([300, 400, 500, 600]), rng.choice([5000, 6000, 7500])
    columns = []
    for x in range(gap, w - 1000, gap):
        for y in range(gap, d - 1000, gap):
            box = [(x + sx * (size / 2 + 700), y + sy * (size / 2 + 700)) for sx in (-1, 0, 1) for sy in (-1, 0, 1)]
            if all(inside(points, p) for p in box):
                columns.append([x, y, size])
    return columns if rng.random() < 0.8 else []


def inside(points, p):
    odd = False
    for (x0, y0), (x1, y1) in edges_of(points):
        if (y0 > p[1]) != (y1 > p[1]) and p[0] < x0 + (x1 - x0) * (p[1] - y0) / (y1 - y0):
            odd = not odd
    return odd


def offset(points, by):
    """Outwards, corners mitred. Counter-clockwise."""
    moved = []
    for i in range(len(points)):
        e, f = (points[i - 1], points[i]), (points[i], points[(i + 1) % len(points)])
        n, m = inwards(e), inwards(f)
        det = n[0] * m[1] - n[1] * m[0]
        a = n[0] * points[i][0] + n[1] * points[i][1] - by
        b = m[0] * points[i][0] + m[1] * points[i][1] - by
        moved.append(((a * m[1] - b * n[1]) / det, (n[0] * b - m[0] * a) / det))
    return moved


class Shop:
    """Everything that is drawn, as lists of (role, kind, points or (centre, radius, from, to))."""

    def __init__(self, rng, shape):
        self.points, self.w, self.d = outline_of(rng, shape)
        self.openings = openings_of(rng, self.points)
        self.columns = columns_of(rng, self.points, self.w, self.d)
        self.thickness = rng.choice([150, 200, 240, 300])
        self.round_columns = rng.random() < 0.3
        self.edges = edges_of(self.points)

    def truth(self):
        openings = []
        for edge, holes in zip(self.edges, self.openings):
            for a, b, kind in holes:
                openings.append([*along(edge, a), *along(edge, b), kind])
        columns = [[x, y, s * math.sqrt(math.pi) / 2 if self.round_columns else s] for x, y, s in self.columns]
        return {"outline": self.points, "openings": openings, "columns": columns}

    def breaks(self):
        """Around the shop: ("corner", i) and ("gap", i, from, to)."""
        out = []
        for i, holes in enumerate(self.openings):
            out.append(("corner", i))
            out += [("gap", i, a, b) for a, b, _ in holes]
        return out

    def chains(self, outer_too=True):
        """The walls between the gaps: (inner points, outer points)."""
        outer = offset(self.points, self.thickness)
        marks = self.breaks()
        first = next((k for k, m in enumerate(marks) if m[0] == "gap"), None)
        if first is None:
            return None
        marks = marks[first:] + marks[:first]

        def both(i, t):
            p, n = along(self.edges[i], t), inwards(self.edges[i])
            return p, (p[0] - n[0] * self.thickness, p[1] - n[1] * self.thickness)

        chains, inner, out = [], [], []
        for mark in [*marks, marks[0]]:
            if mark[0] == "corner":
                inner.append(self.points[mark[1]])
                out.append(outer[mark[1]])
                continue
            if inner:
                p, q = both(mark[1], mark[2])
                chains.append(([*inner, p], [*out, q]))
            p, q = both(mark[1], mark[3])
            inner, out = [p], [q]
        return chains

    def door_symbols(self, rng):
        """Per door: lines and arcs; per window: a rectangle in the wall and a line."""
        symbols = []
        for edge, holes in zip(self.edges, self.openings):
            n = inwards(edge)
            for a, b, kind in holes:
                p, q = along(edge, a), along(edge, b)
                if kind == "window":
                    r = (q[0] - n[0] * self.thickness, q[1] - n[1] * self.thickness)
                    s = (p[0] - n[0] * self.thickness, p[1] - n[1] * self.thickness)
                    symbols.append(("window", [("polygon", [p, q, r, s])]))
                    continue
                leaves = [(p, q, b - a)] if b - a <= 1300 else [(p, q, (b - a) / 2), (q, p, (b - a) / 2)]
                parts = []
                for hinge, towards, radius in leaves:
                    tip = (hinge[0] + n[0] * radius, hinge[1] + n[1] * radius)
                    start = math.atan2(towards[1] - hinge[1], towards[0] - hinge[0])
                    end = math.atan2(n[1], n[0])
                    turn = (end - start + math.pi) % (2 * math.pi) - math.pi
                    parts.append(("line", [hinge, tip]))
                    parts.append(("arc", hinge, radius, start, turn))
                symbols.append(("door", parts))
        return symbols


def turned(p, angle, about=(0, 0)):
    c, s = math.cos(angle), math.sin(angle)
    x, y = p[0] - about[0], p[1] - about[1]
    return (about[0] + c * x - s * y, about[1] + s * x + c * y)


class Drawing:
    """Shapes by layer, in millimetres and already turned."""

    def __init__(self, angle):
        self.angle, self.items = angle, []

    def line(self, layer, points, closed=False, width=0, fill=False, group=None):
        self.items.append(("line", layer, [turned(p, self.angle) for p in points], closed, width, fill, group))

    def arc(self, layer, centre, radius, start, turn, group=None):
        self.items.append(("arc", layer, turned(centre, self.angle), radius, start + self.angle, turn, group))

    def circle(self, layer, centre, radius, group=None):
        self.items.append(("circle", layer, turned(centre, self.angle), radius, group))

    def text(self, layer, at, text):
        self.items.append(("text", layer, turned(at, self.angle), text))


def draw_walls(drawing, shop, style, layer):
    chains = shop.chains()
    if style == "closed" or chains is None:
        drawing.line(layer("wall"), shop.points, closed=True)
        if style != "closed":
            drawing.line(layer("wall"), offset(shop.points, shop.thickness), closed=True)
        return
    for inner, outer in chains:
        body = [*inner, *reversed(outer)]
        if style == "gaps":
            drawing.line(layer("wall"), inner)
        elif style == "lines":  # exploded
            for a, b in edges_of(body):
                drawing.line(layer("wall"), [a, b])
        elif style == "thick":  # the middle of the wall, as wide as that
            drawing.line(layer("wall"), [((p[0] + q[0]) / 2, (p[1] + q[1]) / 2) for p, q in zip(inner, outer)], width=shop.thickness)
        else:
            drawing.line(layer("wall"), body, closed=True, fill=style in ("bodies", "solid"))


def draw(shop, rng, style, names, angle, noise=True):
    layer = (lambda role: names[role]) if names else (lambda role: "0")
    drawing = Drawing(angle)
    draw_walls(drawing, shop, style, layer)
    for number, (kind, parts) in enumerate(shop.door_symbols(rng)):
        if kind == "window" and not names:
            continue  # without a name a window is part of the wall or a gap
        group = f"{kind}-{number}"
        for part in parts:
            if part[0] == "line":
                drawing.line(layer(kind), part[1], group=group)
            elif part[0] == "polygon":
                drawing.line(layer(kind), part[1], closed=True, group=group)
            else:
                drawing.arc(layer(kind), *part[1:], group=group)
    for x, y, size in shop.columns:
        if shop.round_columns:
            drawing.circle(layer("column"), (x, y), size / 2, group="column")
        else:
            h = size / 2
            drawing.line(layer("column"), [(x - h, y - h), (x + h, y - h), (x + h, y + h), (x - h, y + h)], closed=True, fill=True, group="column")
    if noise and names:
        y = -shop.thickness - 1500
        drawing.line(layer("dim"), [(0, y), (shop.w, y)])
        drawing.text(layer("dim"), (shop.w / 2, y - 400), f"{shop.w}")
        for k in range(4):
            x = 2500 + k * 2200
            drawing.line(layer("furniture"), [(x, 4000), (x + 900, 4000), (x + 900, 8000), (x, 8000)], closed=True)
    return drawing


def write_svg(path, drawing, mm, unit, paper):
    """`mm`: of floor in a user unit; `unit`: how the width is written, None: not at all; `paper`: 1 : N."""
    xs = [p[0] for item in drawing.items if item[0] == "line" for p in item[2]]
    ys = [p[1] for item in drawing.items if item[0] == "line" for p in item[2]]
    left, top = min(xs) - 3000, max(ys) + 3000
    wide, high = max(xs) + 3000 - left, top - (min(ys) - 3000)
    place = lambda p: f"{(p[0] - left) / mm:.4f},{(top - p[1]) / mm:.4f}"
    out = ['<?xml version="1.0" encoding="UTF-8"?>']
    size = ""
    if unit:
        per = {"mm": 1, "cm": 10, "in": 25.4}[unit]
        size = f' width="{wide / per / paper:.5f}{unit}" height="{high / per / paper:.5f}{unit}"'
    out.append(f'<svg xmlns="http://www.w3.org/2000/svg"{size} viewBox="0 0 {wide / mm:.4f} {high / mm:.4f}">')
    layers = {}
    for item in drawing.items:
        layers.setdefault(item[1], []).append(item)
    for number, (layer, items) in enumerate(layers.items()):
        name = f' id="{layer}"' if layer != "0" else f' id="layer{number}"'
        out.append(f'<g{name} fill="none" stroke="black" stroke-width="{20 / mm:.4f}">')
        for item in items:
            if item[0] == "line":
                _, _, points, closed, width, fill, _ = item
                tag = "polygon" if closed else "polyline"
                extra = f' stroke-width="{width / mm:.4f}"' if width else ""
                extra += ' fill="black" stroke="none"' if fill else ""
                out.append(f'<{tag} points="{" ".join(map(place, points))}"{extra}/>')
            elif item[0] == "arc":
                _, _, c, r, start, turn, _ = item
                a, b = (c[0] + r * math.cos(start), c[1] + r * math.sin(start)), (c[0] + r * math.cos(start + turn), c[1] + r * math.sin(start + turn))
                out.append(f'<path d="M {place(a)} A {r / mm:.4f} {r / mm:.4f} 0 0 {0 if turn > 0 else 1} {place(b)}"/>')
            elif item[0] == "circle":
                x, y = place(item[2]).split(",")
                out.append(f'<circle cx="{x}" cy="{y}" r="{item[3] / mm:.4f}"/>')
            else:
                x, y = place(item[2]).split(",")
                out.append(f'<text x="{x}" y="{y}" font-size="{400 / mm:.3f}">{item[3]}</text>')
        out.append("</g>")
    out.append("</svg>")
    path.write_text("\n".join(out), encoding="utf-8")


def write_dxf(path, drawing, mm, insunits, blocks):
    out = []
    put = lambda *pairs: out.extend(f"{code}\n{value}" for code, value in pairs)
    xy = lambda p, code=10: ((code, f"{p[0] / mm:.6f}"), (code + 10, f"{p[1] / mm:.6f}"))
    put((0, "SECTION"), (2, "HEADER"))
    if insunits:
        put((9, "$INSUNITS"), (70, insunits))
    put((0, "ENDSEC"))

    def entity(item, base=(0, 0)):
        shift = lambda p: (p[0] - base[0], p[1] - base[1])
        if item[0] == "line":
            points = [shift(p) for p in item[2]]
            if len(points) == 2 and not item[3]:
                put((0, "LINE"), (8, item[1]), *xy(points[0]), *xy(points[1], 11))
                return
            put((0, "LWPOLYLINE"), (8, item[1]), (90, len(points)), (70, 1 if item[3] else 0))
            for p in points:
                put(*xy(p))
        elif item[0] == "arc":
            _, layer, c, r, start, turn, _ = item
            a, b = (start, start + turn) if turn > 0 else (start + turn, start)
            put((0, "ARC"), (8, layer), *xy(shift(c)), (40, f"{r / mm:.6f}"), (50, math.degrees(a)), (51, math.degrees(b)))
        elif item[0] == "circle":
            put((0, "CIRCLE"), (8, item[1]), *xy(shift(item[2])), (40, f"{item[3] / mm:.6f}"))
        else:
            put((0, "TEXT"), (8, item[1]), *xy(shift(item[2])), (40, 300 / mm), (1, item[3]))

    groups = {}
    loose = []
    for number, item in enumerate(drawing.items):
        group = item[-1] if item[0] != "text" else None
        if blocks and group:
            groups.setdefault(group if group != "column" else f"column-{number}", []).append(item)
        else:
            loose.append(item)
    bases = {}
    put((0, "SECTION"), (2, "BLOCKS"))
    for name, items in groups.items():
        bases[name] = items[0][2][0] if items[0][0] == "line" else items[0][2]
        put((0, "BLOCK"), (8, "0"), (2, f"B{len(bases)}"), (70, 0), (10, 0), (20, 0))
        for item in items:
            entity(item, bases[name])
        put((0, "ENDBLK"), (8, "0"))
    put((0, "ENDSEC"), (0, "SECTION"), (2, "ENTITIES"))
    for item in loose:
        entity(item)
    for number, (name, items) in enumerate(groups.items()):
        put((0, "INSERT"), (8, items[0][1]), (2, f"B{number + 1}"), *xy(bases[name]))
    put((0, "ENDSEC"), (0, "EOF"))
    path.write_text("\n".join(out) + "\n", encoding="utf-8")


def write_picture(path, drawing, rng, mm, line_px, quality):
    xs = [p[0] for item in drawing.items if item[0] == "line" for p in item[2]]
    ys = [p[1] for item in drawing.items if item[0] == "line" for p in item[2]]
    left, top = min(xs) - 2500, max(ys) + 2500
    fine = 3  # drawn larger and made smaller: edges get grey
    scale = fine / mm
    place = lambda p: ((p[0] - left) * scale, (top - p[1]) * scale)
    size = (int((max(xs) + 2500 - left) * scale), int((top - min(ys) + 3500) * scale))
    size = (size[0] // fine * fine, size[1] // fine * fine)
    image = Image.new("L", size, 255)
    pen = ImageDraw.Draw(image)
    width = line_px * fine
    for item in drawing.items:
        if item[0] == "line":
            points = [place(p) for p in item[2]]
            if item[5]:
                pen.polygon(points, fill=20)
            else:
                pen.line([*points, points[0], points[1]] if item[3] else points, fill=20, width=width, joint="curve")
        elif item[0] == "arc":
            _, _, c, r, start, turn, _ = item
            steps = [place((c[0] + r * math.cos(start + turn * k / 24), c[1] + r * math.sin(start + turn * k / 24))) for k in range(25)]
            pen.line(steps, fill=20, width=width, joint="curve")
        elif item[0] == "circle":
            x, y = place(item[2])
            r = item[3] * scale
            pen.ellipse([x - r, y - r, x + r, y + r], fill=20)
        else:
            pen.text(place(item[2]), item[3], fill=20, font_size=500 * scale)
    image = image.resize((size[0] // fine, size[1] // fine), Image.Resampling.BOX)
    if quality:
        image = image.filter(ImageFilter.GaussianBlur(0.6))
        noise = Image.frombytes("L", image.size, rng.randbytes(image.size[0] * image.size[1]))
        image = Image.blend(image, noise, 0.12)
        image.convert("RGB").save(path, quality=quality)
    else:
        image.save(path)


def make(folder, index, seed):
    rng = random.Random(f"{seed}/{index}")
    kind = ["svg", "dxf", "png", "svg", "dxf", "jpg", "svg", "dxf", "png", "dxf"][index % 10]
    shop = Shop(rng, SHAPES[(index * 3 + index // 8) % len(SHAPES)])
    file = folder / f"{index:02d}.{kind}"
    entry = {"file": file.name, "scale": "", **shop.truth()}
    if kind in ("png", "jpg"):
        style = PICTURE_STYLES[(index // 3) % 3]
        names = {role: role for role in ("wall", "door", "window", "column", "dim", "furniture")}
        if style != "solid":  # windows that are lines among lines are part of the wall
            shop.openings = [[(a, b, k) for a, b, k in holes if k == "door"] for holes in shop.openings]
        mm = rng.choice([10, 12.5, 16, 20])
        drawing = draw(shop, rng, {"solid": "solid", "hollow": "double", "line": "gaps"}[style], names, math.radians(rng.uniform(-2, 2)))
        drawing.items = [i for i in drawing.items if i[1] not in ("furniture",)]
        write_picture(file, drawing, rng, mm, 2 if style != "line" else 3, rng.choice([60, 80]) if kind == "jpg" else 0)
        entry.update(shop.truth(), scale=f"1 px = {mm} mm", style=style)
    else:
        names = NAMES[(index // 2) % len(NAMES)]
        style = rng.choice([*VECTOR_STYLES, "thick"] if kind == "svg" else VECTOR_STYLES)
        if not names:  # then windows are no more than gaps
            shop.openings = [[(a, b, k) for a, b, k in holes if k == "door"] for holes in shop.openings]
        angle = math.radians(rng.choice([0, 0, 0, rng.uniform(-30, 30)]))
        drawing = draw(shop, rng, style, names, angle)
        if kind == "svg":
            how = rng.choice(["mm", "cm", "in", "none", "paper"])
            mm = rng.choice([1, 10, 25])
            write_svg(file, drawing, mm, None if how == "none" else ("mm" if how == "paper" else how), 100 if how == "paper" else 1)
            entry["scale"] = {"none": f"1 unit = {mm} mm", "paper": "1:100"}.get(how, "")
        else:
            insunits, mm = rng.choice([(4, 1), (5, 10), (6, 1000), (1, 25.4), (0, 10)])
            write_dxf(file, drawing, mm, insunits, style == "blocks")
            entry["scale"] = "" if insunits else "1 unit = 10 mm"
        entry.update(shop.truth(), style=f"{style}, {'named ' + names['wall'] if names else 'no names'}")
    return entry


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--count", type=int, default=40)
    args = parser.parse_args()
    args.folder.mkdir(parents=True, exist_ok=True)
    truth = [make(args.folder, i, args.seed) for i in range(args.count)]
    (args.folder / "truth.json").write_text(json.dumps(truth, ensure_ascii=False, indent=1), encoding="utf-8")


if __name__ == "__main__":
    main()
