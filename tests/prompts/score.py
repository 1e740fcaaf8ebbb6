"""Scores a program on prompts: generates each store, judges every wish on the finished store.

    python3 score.py --program PATH FILE.jsonl [...] [--out table.jsonl] [--show-misses] [--totals-only]
                     [--stores DIR [--reuse]]

The result does not depend on the order of words in a wish's fields or of lines, and is the same each time
(but for the times). Prompts of unread.jsonl.gz are sealed: only totals are printed of it."""
import argparse
import json
import pathlib
import re
import statistics
import subprocess
import tempfile

from judge import judge, judge_cannot, judge_conflict
from prompt_files import SEALED, is_sealed, read_prompts
from store_facts import read_store

LIMIT_S = 600


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("files", nargs="+", type=pathlib.Path)
    parser.add_argument("--program", required=True)
    parser.add_argument("--out", type=pathlib.Path, help="one JSON line for each wish")
    parser.add_argument("--seed", type=int, default=1, help="of generate; several show how much of a difference is chance")
    parser.add_argument("--show-misses", action="store_true")
    parser.add_argument("--totals-only", action="store_true", help="no words of prompts or wishes")
    parser.add_argument("--stores", type=pathlib.Path, help="keep the finished stores here")
    parser.add_argument("--reuse", action="store_true", help="judge stores that are in --stores already")
    arguments = parser.parse_args()
    sealed = any(is_sealed(f) for f in arguments.files)
    if sealed and arguments.show_misses:
        parser.error(f"{SEALED} is sealed: its misses are not shown")
    if sealed and arguments.stores:
        parser.error(f"{SEALED} is sealed: its stores, which hold the prompts, are not kept")
    arguments.totals_only = arguments.totals_only or sealed
    return arguments


def generate(program, prompt, folder, seed):
    """The error's text, or None when the store is there. Its output is never printed."""
    words = folder.parent / (folder.name + ".txt")
    words.write_text(prompt, encoding="utf8")
    command = [program, "generate", "--prompt-file", str(words), "-o", str(folder), "--no-previews", "--quiet", "--seed", str(seed)]
    try:
        done = subprocess.run(command, capture_output=True, text=True, errors="replace", timeout=LIMIT_S)
    except subprocess.TimeoutExpired:
        return f"error[timeout] not finished in {LIMIT_S} s"
    finally:
        words.unlink()
    if done.returncode == 0 and (folder / "layout.json").exists():
        return None
    return (done.stderr.strip() or f"exit status {done.returncode}").splitlines()[-1]


def facts_of(row, arguments, scratch):
    """(facts, None) or (None, error)"""
    folder = (arguments.stores or scratch) / row["id"]
    if not (arguments.reuse and (folder / "layout.json").exists()):
        error = generate(arguments.program, row["prompt"], folder, arguments.seed)
        if error:
            return None, error
    try:
        return read_store(folder), None
    except (OSError, ValueError, KeyError, IndexError) as error:
        return None, f"error[unreadable] {type(error).__name__} {error}"


def score_prompt(row, arguments, scratch):
    facts, error = facts_of(row, arguments, scratch)
    said = facts or {"unparsed": [], "conflicts": [{"message": error}]}  # what a refusal says counts as said
    lines = []
    for number, wish in enumerate(row["wishes"]):
        met, why = judge(wish, facts) if facts else (False, error)
        lines.append({"id": row["id"], "number": number, "group": "wish", "kind": wish["kind"],
                      "strength": wish.get("strength", "must"), "text": wish["text"], "wish": wish, "met": met, "why": why})
    for number, pair in enumerate(row["conflicts"]):
        met, why = judge_conflict(pair, row["prompt"], said)
        lines.append({"id": row["id"], "number": number, "group": "conflict", "kind": "conflict", "text": pair, "met": met, "why": why})
    for number, text in enumerate(row["cannot"]):
        met, why = judge_cannot(text, row["prompt"], said)
        lines.append({"id": row["id"], "number": number, "group": "cannot", "kind": "cannot", "text": text, "met": met, "why": why})
    return {"id": row["id"], "error": error, "planning_s": facts["planning_s"] if facts else None, "lines": lines}


def wilson(met, asked, z=1.959964):
    if asked == 0:
        return 0.0, 1.0
    share, w = met / asked, z * z / asked
    middle, half = share + w / 2, z * (share * (1 - share) / asked + w / asked / 4) ** 0.5
    return max(0.0, (middle - half) / (1 + w)), min(1.0, (middle + half) / (1 + w))


def told(name, met, asked):
    low, high = wilson(met, asked)
    share = f"{met / asked:6.1%}  95 % {low:.1%} to {high:.1%}" if asked else "     -"
    return f"{name:<20}{met:5d} /{asked:5d}  {share}"


def tally(lines, **wanted):
    mine = [line for line in lines if all(line.get(k) == v for k, v in wanted.items())]
    return sum(line["met"] for line in mine), len(mine)


def print_table(results):
    lines = [line for result in results for line in result["lines"]]
    wishes = [line for line in lines if line["group"] == "wish"]
    for kind in sorted({line["kind"] for line in wishes}):
        print(told(kind, *tally(wishes, kind=kind)))
    print(told("ALL WISHES", *tally(wishes)))
    print(told("  must", *tally(wishes, strength="must")))
    print(told("  prefer", *tally(wishes, strength="prefer")))
    print(told("prompts all met", *whole_prompts(results)))
    reported, conflicts = tally(lines, group="conflict")
    print(told("conflicts reported", reported, conflicts))
    print(f"{'silent conflicts':<20}{conflicts - reported:5d}")
    print(told("cannot reported", *tally(lines, group="cannot")))
    print(f"{'not judged':<20}{sum(line['why'].startswith('not judged') for line in wishes):5d}")
    print_errors_and_times(results)


def whole_prompts(results):
    """Prompts of which every wish, conflict and `cannot` is met."""
    return sum(all(line["met"] for line in r["lines"]) and not r["error"] for r in results), len(results)


def print_errors_and_times(results):
    codes = {}
    for result in results:
        if result["error"]:
            code = re.match(r"error\[[\w.]+\]", result["error"])
            code = code.group() if code else "error"
            codes[code] = codes.get(code, 0) + 1
    print(f"{'generation errors':<20}{sum(codes.values()):5d}  {', '.join(f'{c} {n}' for c, n in sorted(codes.items()))}")
    times = [r["planning_s"] for r in results if r["planning_s"] is not None]
    if times:
        print(f"{'planning time':<20} median {statistics.median(times):.2f} s, worst {max(times):.2f} s (plan, repair, layout)")


def print_misses(results):
    for result in results:
        for line in result["lines"]:
            if not line["met"]:
                print(f"{line['id']} {line['kind']}: {line['text']!r}: {line['why']}")


def write_lines(path, results, totals_only):
    hidden = ("text", "wish", "why") if totals_only else ()
    with open(path, "w", encoding="utf8") as file:
        for result in results:
            for line in result["lines"]:
                file.write(json.dumps({k: v for k, v in line.items() if k not in hidden}, ensure_ascii=False) + "\n")


def main():
    arguments = parse_arguments()
    every = []
    for path in arguments.files:
        rows = read_prompts(path)
        results = []
        for row in sorted(rows, key=lambda r: r["id"]):
            with tempfile.TemporaryDirectory(prefix="score-") as scratch:
                results.append(score_prompt(row, arguments, pathlib.Path(scratch)))
        print(f"== {path.name}: {len(rows)} prompts")
        print_table(results)
        every += results
    if len(arguments.files) > 1:
        print("== together")
        print_table(every)
    if arguments.show_misses and not arguments.totals_only:
        print_misses(every)
    if arguments.out:
        write_lines(arguments.out, every, arguments.totals_only)


if __name__ == "__main__":
    main()
