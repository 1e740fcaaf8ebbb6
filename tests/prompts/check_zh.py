#!/usr/bin/env python3
"""Checks zh.jsonl against SPEC.md: JSON, substrings, kinds, fields, ids; prints counts by kind."""
import json, os, re, collections
here = os.path.dirname(os.path.abspath(__file__))
ids = open(os.path.join(here, "ids.txt"), encoding="utf-8").read()
zpart, rest = ids.split("FIXTURE KINDS", 1)
fpart, rest = rest.split("STYLES", 1)
ZONES = set(re.findall(r"^\s+(\w+) :", zpart, re.M))
FIX = set(re.findall(r"^\s+(\w+) :", fpart, re.M))
STYLES = set(re.findall(r"([\w-]+) \(", rest.split("PROFILES")[0]))
PROFILES = set(re.findall(r"([\w-]+) \(", rest.split("PROFILES")[1].split("MATERIAL")[0])) | {"dark-store", "kiosk", "cash-and-carry", "pharmacy", "forecourt"}
FAMILIES = {x.strip() for x in rest.split("MATERIAL FAMILIES:")[1].split("\n")[0].split(",")}
assert len(ZONES) == 21 and len(FIX) == 24 and len(STYLES) == 19 and len(FAMILIES) == 16, (len(ZONES), len(FIX), len(STYLES), len(FAMILIES))
CMP = {"equal", "at_least", "at_most", "about"}
PLACES = ZONES | {"north", "south", "east", "west", "back", "front", "left", "right", "center", "entrance", "exit"}
RELS = set("near far along at left_of right_of behind facing between not_adjacent".split())
num = lambda v: isinstance(v, (int, float)) and not isinstance(v, bool)
cnt = lambda v: isinstance(v, int) and not isinstance(v, bool) and v >= 0
n_ = lambda f: (lambda v: v is None or f(v))
in_ = lambda s: (lambda v: v in s)
zone, fix, cmp_ = in_(ZONES), in_(FIX), in_(CMP)
K = {
 "size": dict(width_m=n_(num), depth_m=n_(num)), "area": dict(zone=in_(ZONES | {"store"}), m2=num, comparison=cmp_),
 "zone": dict(zone=zone, count=n_(cnt), comparison=cmp_), "no_zone": dict(zone=zone), "only_zones": dict(zones=lambda v: v and all(z in ZONES for z in v)),
 "fixture": dict(fixture=fix, zone=n_(zone), count=n_(cnt), comparison=cmp_), "no_fixture": dict(fixture=fix, zone=n_(zone)),
 "runs": dict(fixture=fix, zone=n_(zone), count=cnt, sides=in_((1, 2, None))), "aisles": dict(count=cnt, comparison=cmp_),
 "aisle_width": dict(m=num, comparison=cmp_, zone=n_(zone)), "levels": dict(zone=n_(zone), count=cnt, comparison=cmp_),
 "shelf_pitch": dict(zone=n_(zone), m=num, comparison=cmp_), "height": dict(of=in_(FIX | {"fixture", "ceiling"}), zone=n_(zone), m=num, comparison=cmp_),
 "relation": dict(relation=in_(RELS), a=zone, b=in_(PLACES), c=n_(in_(PLACES))),
 "opening": dict(opening=in_("entrance exit service emergency window".split()), wall=in_(["north", "south", "east", "west", None]), end=in_(["left", "right", "center", None]), count=n_(cnt)),
 "checkouts": dict(type=in_("checkout_lane self_checkout any".split()), count=cnt, comparison=cmp_), "profile": dict(profile=in_(PROFILES)), "style": dict(style=in_(STYLES)),
 "material": dict(part=in_("floor wall ceiling fixture".split()), family=in_(FAMILIES)), "color": dict(part=in_("fixture accent wall floor".split()), color=lambda v: re.fullmatch("[a-z]+", v)),
 "light": dict(what=in_(["kelvin", "lux"]), value=n_(num), degree=in_(["warm", "cold", "bright", "dim", None])),
 "stock": dict(what=in_("fill out_of_stock misplaced untidy".split()), value=n_(lambda v: 0 <= v <= 1), degree=in_(["none", "few", "some", "many", "all", None]), zone=n_(zone)),
 "product": dict(sku=lambda v: v and isinstance(v, str), present=in_([True, False]), zone=n_(zone)), "endcaps": dict(wanted=in_([True, False])), "name": dict(name=lambda v: v and isinstance(v, str)),
}
bad, seen, kinds, nc, nn, pref, lens = [], set(), collections.Counter(), 0, 0, 0, []
for ln, line in enumerate(open(os.path.join(here, "zh.jsonl"), encoding="utf-8"), 1):
    o = json.loads(line); i = o["id"]; pr = o["prompt"]; lens.append(len(pr))
    if set(o) != {"id", "language", "prompt", "wishes", "conflicts", "cannot", "notes"}: bad.append((i, "keys"))
    if i in seen or i != "zh-%03d" % ln or o["language"] != "zh": bad.append((i, "id/language"))
    seen.add(i)
    dup = set()
    for w in o["wishes"]:
        k = w["kind"]; f = {x: y for x, y in w.items() if x not in ("text", "kind", "strength")}
        kinds[k] += 1; pref += w.get("strength") == "prefer"
        if w.get("strength", "must") not in ("must", "prefer"): bad.append((i, "strength", w))
        if not w["text"] or w["text"] not in pr: bad.append((i, "text not in prompt", w["text"]))
        if k not in K or set(f) != set(K[k]): bad.append((i, "kind/fields", w)); continue
        for x, ok in K[k].items():
            if not ok(f[x]): bad.append((i, x, f[x]))
        if k == "relation" and (f["relation"] == "between") != (f["c"] is not None): bad.append((i, "between/c", w))
        key = json.dumps([k, f], sort_keys=True)
        if key in dup: bad.append((i, "same wish twice", w))
        dup.add(key)
    for pair in o["conflicts"]:
        nc += 1
        if len(pair) != 2 or any(t not in pr for t in pair): bad.append((i, "conflict", pair))
        if any(t in w["text"] or w["text"] in t for t in pair for w in o["wishes"]): bad.append((i, "conflict also a wish", pair))
    for t in o["cannot"]:
        nn += 1
        if t not in pr: bad.append((i, "cannot", t))
    if not (o["wishes"] or o["conflicts"] or o["cannot"]): bad.append((i, "empty"))
for b in bad: print("BAD", *b)
print(len(seen), "prompts,", sum(kinds.values()), "wishes,", pref, "prefer,", nc, "conflicts,", nn, "cannot; prompt length", min(lens), "to", max(lens), "characters")
print(", ".join("%s %d" % x for x in kinds.most_common()), "| unused:", sorted(set(K) - set(kinds)))
raise SystemExit(bool(bad))
