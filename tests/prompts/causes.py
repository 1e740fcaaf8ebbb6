"""Why were wishes missed? For people who mend the program; has no part in judging.

    python3 causes.py FILE.jsonl table.jsonl STORES        (table and stores of score.py --out --stores)

Compares each missed wish with what the program says it understood in those words:
  error            no store was made
  not understood   no requirement of that kind from those words; `listed` when half of the wish's content
                   words are in its list of unparsed words, else `silent`
  not built        understood, and the program itself says that the store does not have it
  built otherwise  understood, and the program says that the store has it: another reading of the
                   words (a number or zone lost), or another measure than the judge's"""
import collections
import json
import pathlib
import sys

from prompt_files import is_sealed, read_prompts
from judge_words import places_of, share_of_words_reported, span_in_characters

SAME = {"zone": {"zone_present", "zone_count"}, "no_zone": {"zone_absent"}, "only_zones": {"zone_absent"}, "fixture": {"fixture_count"},
        "no_fixture": {"fixture_count", "fixture_absent"}, "runs": {"fixture_count"}, "aisles": {"aisle_count"}, "checkouts": {"fixture_count", "zone_absent"},
        "product": {"product_present", "product_absent"}}


def overlapping(requirements, wish, prompt):
    """Rows (requirement, result) whose words overlap those of the wish."""
    places = places_of(wish["text"], prompt)
    found = []
    for requirement, result in requirements:
        first, last = span_in_characters(requirement["span"], prompt)
        if any(first < end and last > start for start, end in places):
            found.append((requirement, result))
    return found


def cause_of(line, prompt, folder):
    if not (folder / "report.json").exists():
        return "error", line["why"][:60]
    report = json.loads((folder / "report.json").read_text(encoding="utf8"))
    manifest = json.loads((folder / "store.json").read_text(encoding="utf8"))
    rows = list(zip(manifest["requirements"], report["requirements"]))
    wanted = SAME.get(line["kind"], {line["kind"]})
    mine = [row for row in overlapping(rows, line, prompt) if row[0]["kind"] in wanted]
    if mine:
        built = all(result["met"] for _, result in mine)
        return "built otherwise" if built else "not built", "; ".join(result["why"] for _, result in mine)[:90]
    listed = share_of_words_reported(line["text"], prompt, report["unparsed"]) >= 0.5
    return "not understood (" + ("listed" if listed else "silent") + ")", ""


def main():
    file, table, stores = map(pathlib.Path, sys.argv[1:4])
    if is_sealed(file) or is_sealed(table):
        sys.exit("sealed")
    prompts = {r["id"]: r["prompt"] for r in read_prompts(file)}
    counts, rows = collections.Counter(), []
    for line in map(json.loads, table.read_text(encoding="utf8").splitlines()):
        if line["group"] != "wish" or line["met"]:
            continue
        cause, said = cause_of(line, prompts[line["id"]], stores / line["id"])
        counts[cause, line["kind"]] += 1
        rows.append((cause, line["kind"], line["id"], line["text"], line["why"], said))
    for cause in sorted({c for c, _ in counts}):
        kinds = {k: n for (c, k), n in counts.items() if c == cause}
        print(f"{cause}: {sum(kinds.values())}   " + ", ".join(f"{k} {n}" for k, n in sorted(kinds.items(), key=lambda i: -i[1])))
    for row in sorted(rows):
        print(" | ".join(row))


if __name__ == "__main__":
    main()
