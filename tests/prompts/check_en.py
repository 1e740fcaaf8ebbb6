"""Check en.jsonl against SPEC.md and ids.txt: python3 check_en.py"""
import collections, json, pathlib, re, sys

HERE = pathlib.Path(__file__).parent
ids = (HERE / "ids.txt").read_text(encoding="utf8")
part = re.split(r"^(?:ZONE TYPES|FIXTURE KINDS|STYLES|PROFILES|MATERIAL FAMILIES).*", ids, flags=re.M)
col = lambda s: set(re.findall(r"^\s+(\w+) :", s, flags=re.M))
ZONES, FIX = col(part[1]), col(part[2])
STYLES = set(re.findall(r"([a-z-]+) \(", re.search(r"^STYLES (.*)$", ids, re.M)[1]))
PROFILES = set(re.findall(r"([a-z-]+) \(", re.search(r"^PROFILES (.*)$", ids, re.M)[1]))
PROFILES |= {"dark-store", "kiosk", "cash-and-carry", "pharmacy", "forecourt"}
MATS = set(re.search(r"^MATERIAL FAMILIES: (.*)$", ids, re.M)[1].strip().split(", "))
PLACES = {"north", "south", "east", "west", "back", "front", "left", "right", "center", "checkout", "entrance", "exit"}
CMP = {"equal", "at_least", "at_most", "about"}
REL = {"near", "far", "along", "at", "left_of", "right_of", "behind", "facing", "between", "not_adjacent"}
num = lambda v: isinstance(v, (int, float)) and not isinstance(v, bool) and v >= 0
cnt = lambda v: isinstance(v, int) and not isinstance(v, bool) and v >= 0
opt = lambda f: lambda v: v is None or f(v)
one = lambda s: lambda v: v in s
txt = lambda v: isinstance(v, str) and v.strip() != ""
boo = lambda v: isinstance(v, bool)
zone, fix, cmp_ = one(ZONES), one(FIX), one(CMP)
KINDS = {
    "size": dict(width_m=opt(num), depth_m=opt(num)),
    "area": dict(zone=one(ZONES | {"store"}), m2=num, comparison=cmp_),
    "zone": dict(zone=zone, count=opt(cnt), comparison=opt(cmp_)),
    "no_zone": dict(zone=zone),
    "only_zones": dict(zones=lambda v: isinstance(v, list) and v and set(v) <= ZONES),
    "fixture": dict(fixture=fix, zone=opt(zone), count=opt(cnt), comparison=opt(cmp_)),
    "no_fixture": dict(fixture=fix, zone=opt(zone)),
    "runs": dict(fixture=fix, zone=opt(zone), count=cnt, sides=one({1, 2, None})),
    "aisles": dict(count=cnt, comparison=cmp_),
    "aisle_width": dict(m=num, comparison=cmp_, zone=opt(zone)),
    "levels": dict(zone=opt(zone), count=cnt, comparison=cmp_),
    "shelf_pitch": dict(zone=opt(zone), m=num, comparison=cmp_),
    "height": dict(of=one(FIX | {"fixture", "ceiling"}), zone=opt(zone), m=num, comparison=cmp_),
    "relation": dict(relation=one(REL), a=one(ZONES | FIX), b=one(ZONES | PLACES | FIX), c=opt(one(ZONES | PLACES | FIX))),
    "opening": dict(opening=one({"entrance", "exit", "service", "emergency", "window"}),
                    wall=opt(one({"north", "south", "east", "west"})), end=opt(one({"left", "right", "center"})), count=opt(cnt)),
    "checkouts": dict(type=one({"checkout_lane", "self_checkout", "any"}), count=cnt, comparison=cmp_),
    "profile": dict(profile=one(PROFILES)),
    "style": dict(style=one(STYLES)),
    "material": dict(part=one({"floor", "wall", "ceiling", "fixture"}), family=one(MATS)),
    "color": dict(part=one({"fixture", "accent", "wall", "floor"}), color=lambda v: txt(v) and v.isalpha()),
    "light": dict(what=one({"kelvin", "lux"}), value=opt(num), degree=one({"warm", "cold", "bright", "dim", None})),
    "stock": dict(what=one({"fill", "out_of_stock", "misplaced", "untidy"}), value=opt(lambda v: num(v) and v <= 1),
                  degree=one({"none", "few", "some", "many", "all", None}), zone=opt(zone)),
    "product": dict(sku=txt, present=boo, zone=opt(zone)),
    "endcaps": dict(wanted=boo),
    "name": dict(name=txt),
}
EXTRA = {"strength": one({"must", "prefer"}), "except": lambda v: isinstance(v, list) and v and set(v) <= ZONES,
         "across": one({"front"}), "all_kinds": boo, "fixture": fix}
bad, seen, kinds, words, prompts = [], set(), collections.Counter(), [], set()
nconf = ncan = 0
for n, line in enumerate((HERE / "en.jsonl").read_text(encoding="utf8").splitlines(), 1):
    r = json.loads(line)
    say = lambda m: bad.append(f"{r.get('id', n)}: {m}")
    if set(r) != {"id", "language", "prompt", "wishes", "conflicts", "cannot", "notes"}: say("keys of the line")
    if r["id"] in seen: say("id twice")
    seen.add(r["id"])
    if r["language"] != "en": say("language")
    if r["prompt"] in prompts: say("prompt twice")
    prompts.add(r["prompt"]); words.append(len(r["prompt"].split()))
    got = set()
    for w in r["wishes"]:
        k = w.get("kind"); kinds[k] += 1
        if k not in KINDS: say(f"kind {k}"); continue
        if not w.get("text") or w["text"] not in r["prompt"]: say(f"text not in prompt: {w.get('text')}")
        f = {x: v for x, v in w.items() if x not in ("text", "kind")}
        for x, test in KINDS[k].items():
            if x not in f: say(f"{k}: {x} missing")
            elif not test(f[x]): say(f"{k}: {x}={f[x]!r} ({w['text']})")
        for x in set(f) - set(KINDS[k]):
            if x not in EXTRA or not EXTRA[x](f[x]): say(f"{k}: unknown field {x}")
        if "count" in f and "comparison" in f and (f["count"] is None) != (f["comparison"] is None): say(f"{k}: count without comparison")
        if k == "relation" and (f["relation"] == "between") != (f["c"] is not None): say("relation: c")
        s = json.dumps({"kind": k, **f}, sort_keys=True)
        if s in got: say(f"same wish twice: {s}")
        got.add(s)
    for c in r["conflicts"]:
        nconf += 1
        if len(c) != 2: say("conflict is no pair")
        for t in c:
            if t not in r["prompt"]: say(f"conflict not in prompt: {t}")
            if any(t == w["text"] for w in r["wishes"]): say(f"conflict also a wish: {t}")
    for t in r["cannot"]:
        ncan += 1
        if t not in r["prompt"]: say(f"cannot not in prompt: {t}")
if seen != {f"en-{i:03d}" for i in range(1, 61)}: bad.append("ids are not en-001 to en-060")
print(len(seen), "prompts,", sum(kinds.values()), "wishes,", nconf, "conflicts,", ncan, "cannot; words min/median/max",
      min(words), sorted(words)[len(words) // 2], max(words), "; last two", words[-2:])
print(", ".join(f"{k} {v}" for k, v in kinds.most_common()), "| unused:", sorted(set(KINDS) - set(kinds)))
print("\n".join(bad) or "all right")
sys.exit(bool(bad))
