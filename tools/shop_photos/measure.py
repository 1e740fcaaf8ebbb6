#!/usr/bin/env python3
"""How often `marketgen.read_photo` is right about photos of shops of known look.

    PYTHONPATH=build/release/python .venv/bin/python tools/shop_photos/measure.py PHOTOS [--others FOLDER] [--drawings FOLDER]
        [--truth FILE]

PHOTOS is a folder of render_shop_photos.py whose seed the bank was not made with. Prints a row for each attribute: how many readings were
right of all, and how many of those with a confidence of 0.5 and more, which are those that `generate --image` uses; and what was taken for
a photo of a shop that is none. --truth writes what is known of each photo, by the bank's classes: tests/shop_photos/truth.json.
"""

import argparse
import collections
import json
import math
import pathlib
import time

import marketgen
from make_bank import labels_of
from render_shop_photos import materials

SURE = 0.5


def interval(right, count):
    """Wilson's 95 % interval of a share, in percent."""
    if count == 0:
        return "-"
    z, share = 1.96, right / count
    middle, half = share + z * z / (2 * count), z * math.sqrt(share * (1 - share) / count + z * z / (4 * count * count))
    low, high = (100 * (middle + sign * half) / (1 + z * z / count) for sign in (-1, 1))
    return f"{right} of {count} ({100 * share:.1f} %, {low:.1f} to {high:.1f})"


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("photos", type=pathlib.Path)
    parser.add_argument("--others", type=pathlib.Path)
    parser.add_argument("--drawings", type=pathlib.Path)
    parser.add_argument("--truth", type=pathlib.Path)
    args = parser.parse_args()
    rows = {row["id"]: row for row in materials()}
    truths = []
    counts, seconds, same = collections.defaultdict(lambda: [0, 0, 0, 0]), [], [0, 0]
    for line in (args.photos / "photos.jsonl").read_text().splitlines():
        photo = json.loads(line)
        began = time.perf_counter()
        read = marketgen.read_photo(args.photos / photo["file"])
        seconds.append(time.perf_counter() - began)
        answers = {one["attribute"]: one for one in read["attributes"]}
        answers["subject"] = {"value": read["subject"], "confidence": read["subject_confidence"]}
        labels = labels_of(photo, args.photos, rows)
        truths.append({"file": photo["file"], "truth": [{"attribute": key, "value": value} for key, (value, _) in labels.items()]})
        for attribute, (value, material) in labels.items():
            answer = answers[attribute]
            right, sure = answer["value"] == value, answer["confidence"] >= SURE
            for index, counted in enumerate([True, right, sure, sure and right]):
                counts[attribute][index] += counted
            if material and sure:
                same[0] += answer["material"] == material
                same[1] += 1
    if args.truth:
        args.truth.write_text("[\n" + ",\n".join(json.dumps(one) for one in truths) + "\n]\n")
    for attribute, (count, right, sure, sure_right) in counts.items():
        print(f"{attribute:14} {interval(right, count):40} sure: {interval(sure_right, sure)}")
    used = [row for attribute, row in counts.items() if attribute != "subject"]
    print(f"{'all but subject':14} {interval(sum(r[1] for r in used), sum(r[0] for r in used)):40} "
          f"sure: {interval(sum(r[3] for r in used), sum(r[2] for r in used))}")
    print(f"very material of ours, where its kind or colour is sure: {interval(*same)}")
    print(f"seconds a photo: median {sorted(seconds)[len(seconds) // 2]:.3f}, worst {max(seconds):.3f}")
    for subject, folder in [("drawing", args.drawings), ("other", args.others)]:
        pictures = sorted(p for p in folder.iterdir() if p.suffix in {".jpg", ".png"}) if folder else []
        read = [marketgen.read_photo(p) for p in pictures]
        wrong = [f"{r['file']} ({r['subject']} {r['subject_confidence']:.2f})" for r in read if r["subject"] != subject]
        print(f"{subject}: {interval(len(read) - len(wrong), len(read))}", *wrong)


if __name__ == "__main__":
    main()
