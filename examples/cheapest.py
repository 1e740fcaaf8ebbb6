#!/usr/bin/env python3
"""Prints the best unit price in each category of a store.

    python examples/cheapest.py [STORE [MARKETGEN]]

Shows how any program reads a store: `marketgen query` prints its tables as JSON. Without a store it has one made from the plan
beside it, into out/examples.
"""
import json
import pathlib
import shutil
import subprocess
import sys

HERE = pathlib.Path(__file__).parent


def table(program, store, name):
    """One table of the store as a list of dictionaries."""
    answer = subprocess.run([program, "query", store, name, "--format", "json"], check=True, capture_output=True, text=True)
    return json.loads(answer.stdout)


def corner_shop(program):
    """The folder of a store of examples/corner-shop.json."""
    folder = pathlib.Path("out/examples/corner-shop")
    if not folder.exists():
        plan = HERE / "corner-shop.json"
        subprocess.run([program, "generate", "--plan", plan, "-o", folder, "--no-previews", "--quiet"], check=True)
    return folder


def main():
    built = HERE.parent / "build/release/marketgen"
    program = sys.argv[2] if len(sys.argv) > 2 else shutil.which("marketgen") or built
    store = sys.argv[1] if len(sys.argv) > 1 else corner_shop(program)
    category = {row["sku"]: row["category"] for row in table(program, store, "products")}
    best = {}
    for row in table(program, store, "prices"):
        key = (category.get(row["sku"], "out of stock"), row["per"])
        if key not in best or row["unit_price"] < best[key]["unit_price"]:
            best[key] = row
    for (name, unit), row in sorted(best.items()):
        print(f"{name:<16} {row['unit_price']:8.2f} €/{unit:<6} {row['name']}")


if __name__ == "__main__":
    main()
