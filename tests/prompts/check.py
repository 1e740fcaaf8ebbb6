#!/usr/bin/env python3
"""Checks files of prompts against SPEC.md and ids.txt: check.py [FILE ...], all of them when none is named.

Says ids, kinds and names of fields only, never a word of a prompt: one of the files is sealed.
"""
import collections
import json
import pathlib
import re
import sys

from prompt_files import SEALED, read_prompts

HERE = pathlib.Path(__file__).resolve().parent
OPENED = (7, 24)  # of the sealed ones: shown by a search before the file was compressed
FILES = {  # ids
    "en.jsonl": [f"en-{i:03d}" for i in range(1, 61)],
    "zh.jsonl": [f"zh-{i:03d}" for i in range(1, 51)],
    "fresh_en.jsonl": [f"fr-en-{i:03d}" for i in range(1, 61)],
    "fresh_zh.jsonl": [f"fr-zh-{i:03d}" for i in range(1, 51)],
    "conflicts_en.jsonl": [f"cf-en-{i:03d}" for i in range(1, 61)],
    "conflicts_zh.jsonl": [f"cf-zh-{i:03d}" for i in range(1, 61)],
    "opened.jsonl": [f"un-{i:03d}" for i in OPENED],
    SEALED: [f"un-{i:03d}" for i in range(1, 61) if i not in OPENED],
}

IDS = (HERE / "ids.txt").read_text(encoding="utf-8")
SECTIONS = re.split(r"^(?:ZONE TYPES|FIXTURE KINDS|STYLES|PROFILES|MATERIAL FAMILIES).*", IDS, flags=re.M)
ZONES, FIXTURES = (set(re.findall(r"^\s+(\w+) :", section, re.M)) for section in SECTIONS[1:3])
STYLES, PROFILES = (
    set(re.findall(r"([a-z-]+) \(", re.search(rf"^{title} (.*)$", IDS, re.M)[1])) for title in ("STYLES", "PROFILES")
)
PROFILES |= {"dark-store", "kiosk", "cash-and-carry", "pharmacy", "forecourt"}
FAMILIES = set(re.search(r"^MATERIAL FAMILIES: (.*)$", IDS, re.M)[1].strip().split(", "))
PLACES = set("north south east west back front left right center checkout entrance exit".split())


def is_number(value):
    return isinstance(value, (int, float)) and not isinstance(value, bool) and value >= 0


def is_count(value):
    return isinstance(value, int) and is_number(value)


def is_text(value):
    return isinstance(value, str) and value.strip() != ""


def is_yes_or_no(value):
    return isinstance(value, bool)


def are_zones(value):
    return isinstance(value, list) and bool(value) and set(value) <= ZONES


def one_of(*names):
    allowed = set().union(*(name.split() if isinstance(name, str) else name for name in names))
    return lambda value: value in allowed


def optional(test):
    return lambda value: value is None or test(value)


zone, fixture = one_of(ZONES), one_of(FIXTURES)
comparison = one_of("equal at_least at_most about")
KINDS = {
    "size": {"width_m": optional(is_number), "depth_m": optional(is_number)},
    "area": {"zone": one_of(ZONES, "store"), "m2": is_number, "comparison": comparison},
    "zone": {"zone": zone, "count": optional(is_count), "comparison": optional(comparison)},
    "no_zone": {"zone": zone},
    "only_zones": {"zones": are_zones},
    "fixture": {"fixture": fixture, "zone": optional(zone), "count": optional(is_count), "comparison": optional(comparison)},
    "no_fixture": {"fixture": fixture, "zone": optional(zone)},
    "runs": {"fixture": fixture, "zone": optional(zone), "count": is_count, "sides": one_of({1, 2, None})},
    "aisles": {"count": is_count, "comparison": comparison},
    "aisle_width": {"m": is_number, "comparison": comparison, "zone": optional(zone)},
    "levels": {"zone": optional(zone), "count": is_count, "comparison": comparison},
    "shelf_pitch": {"zone": optional(zone), "m": is_number, "comparison": comparison},
    "height": {"of": one_of(FIXTURES, "fixture ceiling"), "zone": optional(zone), "m": is_number, "comparison": comparison},
    "relation": {
        "relation": one_of("near far along at left_of right_of behind facing between not_adjacent"),
        "a": one_of(ZONES, FIXTURES),
        "b": one_of(ZONES, PLACES, FIXTURES),
        "c": optional(one_of(ZONES, PLACES, FIXTURES)),
    },
    "opening": {
        "opening": one_of("entrance exit service emergency window"),
        "wall": optional(one_of("north south east west")),
        "end": optional(one_of("left right center")),
        "count": optional(is_count),
    },
    "checkouts": {"type": one_of("checkout_lane self_checkout any"), "count": is_count, "comparison": comparison},
    "profile": {"profile": one_of(PROFILES)},
    "style": {"style": one_of(STYLES)},
    "material": {"part": one_of("floor wall ceiling fixture"), "family": one_of(FAMILIES)},
    "color": {"part": one_of("fixture accent wall floor"), "color": lambda value: is_text(value) and re.fullmatch("[a-z]+", value)},
    "light": {"what": one_of("kelvin lux"), "value": optional(is_number), "degree": optional(one_of("warm cold bright dim"))},
    "stock": {
        "what": one_of("fill out_of_stock misplaced untidy"),
        "value": optional(lambda value: is_number(value) and value <= 1),
        "degree": optional(one_of("none few some many all")),
        "zone": optional(zone),
    },
    "product": {"sku": is_text, "present": is_yes_or_no, "zone": optional(zone)},
    "endcaps": {"wanted": is_yes_or_no},
    "name": {"name": is_text},
}
FURTHER = {
    "strength": one_of("must prefer"),
    "except": are_zones,
    "across": one_of("front"),
    "all_kinds": is_yes_or_no,
    "fixture": fixture,
}


def faults_of_fields(kind, fields):
    for name, test in KINDS[kind].items():
        if name not in fields or not test(fields[name]):
            yield f"{kind}: {name}"
    for name in set(fields) - set(KINDS[kind]):
        if name not in FURTHER or not FURTHER[name](fields[name]):
            yield f"{kind}: {name} is unknown"


def faults_of_wish(wish, prompt):
    kind = wish.get("kind")
    if kind not in KINDS:
        yield f"kind {kind}"
        return
    if not wish.get("text") or wish["text"] not in prompt:
        yield f"{kind}: text is not in the prompt"
    fields = {name: value for name, value in wish.items() if name not in ("text", "kind")}
    yield from faults_of_fields(kind, fields)
    if {"count", "comparison"} <= set(fields) and (fields["count"] is None) != (fields["comparison"] is None):
        yield f"{kind}: a count without its comparison, or the other way round"
    if kind == "relation" and (fields.get("relation") == "between") != (fields.get("c") is not None):
        yield "relation: c"
    if kind == "size" and fields.get("width_m") is None and fields.get("depth_m") is None:
        yield "size: empty"
    if kind == "name" and fields.get("name") not in prompt:
        yield "name: it is not in the prompt"


def faults_of_record(record):
    if set(record) != {"id", "language", "prompt", "wishes", "conflicts", "cannot", "notes"}:
        yield "names of its fields"
        return
    prompt, wishes = record["prompt"], record["wishes"]
    if record["language"] == "zh" and not re.search("[\u4e00-\u9fff]", prompt):
        yield "no Chinese"
    for wish in wishes:
        yield from faults_of_wish(wish, prompt)
    unlike = [json.dumps({name: wish[name] for name in wish if name != "text"}, sort_keys=True) for wish in wishes]
    yield from ("the same wish twice" for times in collections.Counter(unlike).values() if times > 1)
    for pair in record["conflicts"]:
        if len(pair) != 2 or any(text not in prompt for text in pair):
            yield "conflict"
        if any(text == wish["text"] for text in pair for wish in wishes):
            yield "a conflict is also a wish"
    if any(text not in prompt for text in record["cannot"]):
        yield "cannot"
    if not (wishes or record["conflicts"] or record["cannot"]):
        yield "asks for nothing"


def check(path):
    """Faults of a file, and its totals as one line."""
    records = read_prompts(path)
    faults = [f"{record.get('id')}: {fault}" for record in records for fault in faults_of_record(record)]
    if [record.get("id") for record in records] != FILES[path.name]:
        faults.append("ids")
    language = path.stem.removeprefix("fresh_").removeprefix("conflicts_")
    languages = {language} if language in ("en", "zh") else {"en", "zh"}
    if not {record["language"] for record in records} <= languages:
        faults.append("language")
    if len({record["prompt"] for record in records}) != len(records):
        faults.append("a prompt twice")
    wishes = sum(len(record["wishes"]) for record in records)
    return faults, f"{path.name}: {len(records)} prompts, {wishes} wishes"


def main():
    faulty = False
    for path in [pathlib.Path(name) for name in sys.argv[1:]] or [HERE / name for name in FILES]:
        faults, totals = check(path)
        print(totals, *faults, sep="\n  ")
        faulty = faulty or bool(faults)
    return faulty


if __name__ == "__main__":
    sys.exit(main())
