#!/usr/bin/env bash
# The prompts with their wishes are what tests/prompts/SPEC.md says, and their judge judges made-up stores right. How well the program meets them
# is measured by tests/prompts/score.py (minutes), not here.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../prompts"

export PYTHONDONTWRITEBYTECODE=1
python3 check.py  # says no word of a prompt: nobody may read the sealed file yet
python3 -m unittest -q test_judge 2>&1 | tail -1 | grep -q '^OK' || { python3 -m unittest test_judge; exit 1; }
printf 'prompts_test: passed\n'
