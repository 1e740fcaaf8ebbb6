#!/usr/bin/env bash
# The Python files ask nothing of the standard library that Python 3.10 lacks: Unpack and Self are for type checkers alone.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
.venv/bin/python - <<'PYTHON'
import ast
import pathlib

LATER = {  # of modules that 3.10 has; and modules that it has not
    "typing": {"Unpack", "Self", "Required", "NotRequired", "Never", "assert_never", "assert_type", "LiteralString", "override", "TypeVarTuple"},
    "enum": {"StrEnum", "verify"},
    "datetime": {"UTC"},
    "contextlib": {"chdir"},
    "itertools": {"batched"},
}
NOT_THERE = {"tomllib"}


def for_checkers(tree):
    """The imports under `if TYPE_CHECKING:`."""
    blocks = (n for n in ast.walk(tree) if isinstance(n, ast.If) and isinstance(n.test, ast.Name) and n.test.id == "TYPE_CHECKING")
    return {id(inner) for block in blocks for inner in ast.walk(block)}


faults = []
files = sorted([*pathlib.Path("python").rglob("*.py"), *pathlib.Path("examples").rglob("*.py")])
assert len(files) > 10, files
for file in files:
    tree = ast.parse(file.read_text(encoding="utf-8"), feature_version=(3, 10))
    unread = for_checkers(tree)
    for node in ast.walk(tree):
        if id(node) in unread:
            continue
        if isinstance(node, ast.ImportFrom):
            late = {alias.name for alias in node.names} & LATER.get(node.module or "", set())
            faults += [f"{file}:{node.lineno}: {node.module}.{name}" for name in sorted(late)]
            if node.module in NOT_THERE:
                faults.append(f"{file}:{node.lineno}: {node.module}")
        if isinstance(node, ast.Import):
            faults += [f"{file}:{node.lineno}: {alias.name}" for alias in node.names if alias.name in NOT_THERE]
if faults:
    raise SystemExit("python_310_test: FAIL: not in Python 3.10:\n  " + "\n  ".join(faults))
PYTHON
printf 'python_310_test: passed\n'
