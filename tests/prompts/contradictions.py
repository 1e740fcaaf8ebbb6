#!/usr/bin/env python3
"""Contradictions that a program reports, keeps silent about, or invents.

    python3 contradictions.py --stores DIR FILE.jsonl [...] [--show-even]

Reads the stores that `score.py --stores DIR` left. A contradiction is reported when one entry of report.json's
`conflicts` points to both texts. Of prompts without one, an entry that says that two pieces of the prompt contradict
each other is a false report (what had no room is none). Prompts of even and odd number are told apart."""
import argparse
import json
import pathlib

from judge_words import is_in_conflicts
from prompt_files import is_sealed, read_prompts

SAYS_SO = "contradict each other"


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("files", nargs="+", type=pathlib.Path)
    parser.add_argument("--stores", required=True, type=pathlib.Path)
    parser.add_argument("--show-even", action="store_true", help="what is missed and invented in prompts of even number")
    arguments = parser.parse_args()
    if any(is_sealed(f) for f in arguments.files):
        parser.error("sealed")
    return arguments


def judge(row, entries):
    """(pairs silent, entries that report none of the pairs)"""
    reports = {i: [e for e in entries if all(is_in_conflicts(text, row["prompt"], [e]) for text in pair)]
               for i, pair in enumerate(row["conflicts"])}
    silent = [pair for i, pair in enumerate(row["conflicts"]) if not reports[i]]
    right = [e for of_pair in reports.values() for e in of_pair]
    return silent, [e for e in entries if e not in right and SAYS_SO in e["why"]]


def main():
    arguments = parse_arguments()
    for path in arguments.files:
        for half, remainder in (("even", 0), ("odd", 1)):
            rows = [r for r in read_prompts(path) if int(r["id"].rsplit("-", 1)[1]) % 2 == remainder]
            asked = silent_pairs = agreeing = false = invented = 0
            for row in rows:
                report = arguments.stores / row["id"] / "report.json"
                entries = json.loads(report.read_text(encoding="utf8"))["conflicts"] if report.exists() else []
                silent, others = judge(row, entries)
                asked += len(row["conflicts"])
                silent_pairs += len(silent)
                agreeing += not row["conflicts"]
                false += bool(others) and not row["conflicts"]
                invented += bool(others) and bool(row["conflicts"])
                if arguments.show_even and half == "even" and (silent or others):
                    print(row["id"], "silent:", silent, "invented:", [e["why"] for e in others])
            print(f"{path.name} {half}: reported {asked - silent_pairs} of {asked}, silent {silent_pairs}; "
                  f"false reports in {false} of {agreeing} prompts without one, in {invented} with one")


if __name__ == "__main__":
    main()
