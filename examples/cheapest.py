#!/usr/bin/env python3
"""Prints the best unit price in each category of a store: cheapest.py STORE [MARKETGEN]

Shows how any program reads a store: `marketgen query` prints its tables as JSON.
"""
import json
import subprocess
import sys


def table(program, store, name):
    """One table of the store as a list of dictionaries."""
    answer = subprocess.run([program, "query", store, name, "--format", "json"], check=True, capture_output=True, text=True)
    return json.loads(answer.stdout)


def main():
    store = sys.argv[1]
    program = sys.argv[2] if len(sys.argv) > 2 else "build/release/marketgen"
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
