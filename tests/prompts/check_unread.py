#!/usr/bin/env python3
"""Checks unread.jsonl against SPEC.md and ids.txt. Prints only ids, kinds and counts, never any text of a prompt."""
import json, re, sys, collections, pathlib
HERE = pathlib.Path(__file__).resolve().parent
ids_txt = (HERE / "ids.txt").read_text(encoding="utf-8")
a, rest = ids_txt.split("FIXTURE KINDS", 1)
b, rest = rest.split("\nSTYLES ", 1)
c, rest = rest.split("\nPROFILES ", 1)
d, e = rest.split("\nMATERIAL FAMILIES:", 1)
ZONES = set(re.findall(r"^\s+(\w+) :", a, re.M))
FIX = set(re.findall(r"^\s+(\w+) :", b, re.M))
STYLES = set(re.findall(r"([\w-]+) \(", c))
PROFILES = set(re.findall(r"([\w-]+) \(", d)) | {"dark-store", "kiosk", "cash-and-carry", "pharmacy", "forecourt"}
MATS = {m.strip() for m in e.strip().split(",")}
CMP = {"equal", "at_least", "at_most", "about"}
RELS = "near far along at left_of right_of behind facing between not_adjacent".split()
PLACES = ZONES | set("north south east west back front left right center checkout entrance exit".split())
WALLS = {"north", "south", "east", "west", None}
num = lambda v: isinstance(v, (int, float)) and not isinstance(v, bool) and v > 0
cnt = lambda v: v is None or (isinstance(v, int) and not isinstance(v, bool) and v >= 0)
zn = lambda v: v is None or v in ZONES
cmp_ = lambda v: v in CMP
F = {  # kind: {field: test}
 "size": dict(width_m=lambda v: v is None or num(v), depth_m=lambda v: v is None or num(v)),
 "area": dict(zone=lambda v: v in ZONES | {"store"}, m2=num, comparison=cmp_),
 "zone": dict(zone=lambda v: v in ZONES, count=cnt, comparison=cmp_),
 "no_zone": dict(zone=lambda v: v in ZONES),
 "only_zones": dict(zones=lambda v: isinstance(v, list) and v and set(v) <= ZONES),
 "fixture": dict(fixture=lambda v: v in FIX, zone=zn, count=cnt, comparison=cmp_),
 "no_fixture": dict(fixture=lambda v: v in FIX, zone=zn),
 "runs": dict(fixture=lambda v: v in FIX, zone=zn, count=lambda v: cnt(v) and v, sides=lambda v: v in (1, 2, None)),
 "aisles": dict(count=lambda v: cnt(v) and v, comparison=cmp_),
 "aisle_width": dict(m=num, comparison=cmp_, zone=zn),
 "levels": dict(zone=zn, count=lambda v: cnt(v) and v, comparison=cmp_),
 "shelf_pitch": dict(zone=zn, m=num, comparison=cmp_),
 "height": dict(of=lambda v: v in FIX | {"fixture", "ceiling"}, zone=zn, m=num, comparison=cmp_),
 "relation": dict(relation=lambda v: v in RELS, a=lambda v: v in ZONES, b=lambda v: v in PLACES, c=lambda v: v is None or v in PLACES),
 "opening": dict(opening=lambda v: v in "entrance exit service emergency window".split(), wall=lambda v: v in WALLS,
                 end=lambda v: v in ("left", "right", "center", None), count=cnt),
 "checkouts": dict(type=lambda v: v in ("checkout_lane", "self_checkout", "any"), count=cnt, comparison=cmp_),
 "profile": dict(profile=lambda v: v in PROFILES),
 "style": dict(style=lambda v: v in STYLES),
 "material": dict(part=lambda v: v in "floor wall ceiling fixture".split(), family=lambda v: v in MATS),
 "color": dict(part=lambda v: v in "fixture accent wall floor".split(), color=lambda v: isinstance(v, str) and v.isascii()),
 "light": dict(what=lambda v: v in ("kelvin", "lux"), value=lambda v: v is None or num(v), degree=lambda v: v in ("warm", "cold", "bright", "dim", None)),
 "stock": dict(what=lambda v: v in "fill out_of_stock misplaced untidy".split(), value=lambda v: v is None or 0 <= v <= 1,
               degree=lambda v: v in ("none", "few", "some", "many", "all", None), zone=zn),
 "product": dict(product=lambda v: isinstance(v, str) and v, present=lambda v: isinstance(v, bool), zone=zn),
 "endcaps": dict(wanted=lambda v: isinstance(v, bool)),
 "name": dict(name=lambda v: isinstance(v, str) and v),
}
bad, seen, prompts = [], set(), set()
kinds, langs, vals = collections.Counter(), collections.Counter(), collections.defaultdict(collections.Counter)
conf = cannot = 0
for n, line in enumerate((HERE / "unread.jsonl").read_text(encoding="utf-8").splitlines(), 1):
    try: r = json.loads(line)
    except ValueError: bad.append((n, "not JSON")); continue
    i = r.get("id")
    if list(r) != "id language prompt wishes conflicts cannot notes".split(): bad.append((i, "keys"))
    if i in seen: bad.append((i, "id twice"))
    seen.add(i)
    p = r["prompt"]
    if p in prompts: bad.append((i, "prompt twice"))
    prompts.add(p)
    if r["language"] not in ("en", "zh"): bad.append((i, "language"))
    langs[r["language"]] += 1
    if r["language"] == "zh" and not re.search("[\u4e00-\u9fff]", p): bad.append((i, "no Chinese"))
    full = set()
    for x in r["wishes"]:
        k = x.get("kind"); kinds[k] += 1
        if k not in F: bad.append((i, "kind", k)); continue
        if not x.get("text") or x["text"] not in p: bad.append((i, k, "text is no substring"))
        extra = set(x) - {"text", "kind", "strength", "except_zones"} - set(F[k])
        if extra: bad.append((i, k, "unknown fields", sorted(extra)))
        if x.get("strength", "prefer") not in ("must", "prefer"): bad.append((i, k, "strength"))
        if not set(x.get("except_zones", [])) <= ZONES: bad.append((i, k, "except_zones"))
        for f, t in F[k].items():
            if f not in x: bad.append((i, k, "missing", f))
            elif not t(x[f]): bad.append((i, k, "value of", f))
        if k == "size" and x["width_m"] is None and x["depth_m"] is None: bad.append((i, "empty size"))
        if k == "relation" and (x["c"] is None) == (x["relation"] == "between"): bad.append((i, "c of relation"))
        if k == "fixture" and x["count"] is None and x["comparison"] != "at_least": bad.append((i, "fixture comparison"))
        if k == "name" and x["name"] not in p: bad.append((i, "name"))
        s = json.dumps(x, sort_keys=True, ensure_ascii=False)
        if s in full: bad.append((i, k, "wish twice"))
        full.add(s)
        for f in ("relation", "style", "profile", "fixture", "what", "opening", "family"):
            if f in x: vals[f][x[f]] += 1
    for c in r["conflicts"]:
        conf += 1
        if len(c) != 2 or any(t not in p for t in c): bad.append((i, "conflict"))
        if any(x["text"] in c for x in r["wishes"]): bad.append((i, "conflict also a wish"))
    for t in r["cannot"]:
        cannot += 1
        if t not in p: bad.append((i, "cannot"))
want = {f"un-{n:03d}" for n in range(1, 61)}
if seen != want: bad.append(("ids", sorted(want ^ seen)))
print(dict(langs), "wishes", sum(kinds.values()), "conflicts", conf, "cannot", cannot)
print(dict(kinds.most_common()))
print("kinds not used:", sorted(set(F) - set(kinds)))
for f in vals: print(f, dict(vals[f].most_common()))
print("unused styles", sorted(STYLES - set(vals["style"])), "profiles", sorted(PROFILES - set(vals["profile"])), "fixtures", sorted(FIX - set(vals["fixture"])), "materials", sorted(MATS - set(vals["family"])))
for x in bad: print("BAD", x)
sys.exit(bool(bad))
