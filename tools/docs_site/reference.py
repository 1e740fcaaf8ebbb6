#!/usr/bin/env python3
"""Writes the page of the Python reference: every public name with its signature and what it says of itself.

    tools/docs_site/reference.py FILE

A name of marketgen.__all__ that stands in no group below, and one of a group that is no longer public, ends it with an error.
"""

import inspect
import pathlib
import re
import sys

sys.path.insert(0, "build/release/python")
import marketgen

GROUPS = {
    "Stores": ["generate", "open_store", "Store", "View"],
    "Pictures": ["Renderer", "Camera", "Frame", "render_batch", "camera_from_dict", "camera_to_dict"],
    "Evaluation": ["evaluate", "Evaluation", "Policy", "policies", "merge", "leaderboard", "tables", "read_motion", "write_episodes"],
    "Demonstrations": ["record", "record_drives", "Recording", "replay_check"],
    "Photos": ["read_photo"],
    "Errors": ["Error", "StoreWarning", "IsolationWarning"],
}
UNSHOWN = {"__version__"}
ROW = re.compile(r"(\*{0,2}\w[\w, *./]*?)\s{2,}(\S.*)")  # "folder    to make; left out: ..."


def escaped(text):
    """Markup and tables' bars as they stand; what is between backquotes stays code."""
    parts = re.split(r"(`[^`]*`)", text)
    plain = "".join(part if part.startswith("`") else re.sub(r"([*_<>|\[\]])", r"\\\1", part) for part in parts)
    return re.sub(r"\bdocs/(\w+\.md)", r"[\1](\1)", plain)


def markdown(doc):
    """A docstring's paragraphs, its rows of arguments as a table, what it shows indented as code."""
    made = []
    for block in re.split(r"\n\s*\n", inspect.cleandoc(doc)):
        lines = block.split("\n")
        rows, paragraph = [], []
        if lines[0].startswith("    "):
            made.append("```python\n" + inspect.cleandoc(block) + "\n```")
            continue
        for line in lines:
            row = ROW.fullmatch(line)
            if row:
                rows.append([row[1], row[2]])
            elif rows and line.startswith(" "):
                rows[-1][1] += " " + line.strip()
            else:
                (paragraph if not rows else rows[-1]).append(line.strip())
        if paragraph:
            made.append(escaped(" ".join(paragraph)))
        if rows:
            table = [f"| `{name}` | {escaped(' '.join(texts))} |" for name, *texts in rows]
            made.append("\n".join(["| name | is |", "|---|---|", *table]))
    return "\n\n".join(made)


def described(name, value):
    """(signature, docstring); of C++ functions the docstring begins with the signature."""
    doc = inspect.getdoc(value) or ""
    try:
        return f"{name}{inspect.signature(value)}", doc
    except (TypeError, ValueError):
        lines = doc.split("\n")
        signatures = [line for line in lines if line.startswith(f"{name}(")]
        return "\n".join(signatures), "\n".join(line for line in lines if line not in signatures)


def wrapped(signature):
    """One argument a line where it is long."""
    unquoted = re.sub(r"""(: |-> )(['"])(.*?)\2(?=[,)= ]|$)""", r"\1\3", signature)  # annotations are texts
    unquoted = re.sub(r"\((self|cls)(, |\))", lambda found: "(" + ")" * (found[2] == ")"), unquoted)
    short = re.sub(r"marketgen\._core\.|collections\.abc\.|typing\.", "", unquoted)
    if len(short) <= 110 or "\n" in short:
        return short
    head, rest = short.split("(", 1)
    body, tail = rest.rsplit(")", 1)
    depth, arguments, at = 0, [], 0
    for i, letter in enumerate(body):
        depth += (letter in "([{") - (letter in ")]}")
        if letter == "," and depth == 0:
            arguments.append(body[at:i].strip())
            at = i + 1
    arguments.append(body[at:].strip())
    return head + "(\n    " + ",\n    ".join(arguments) + ",\n)" + tail


def entry(level, name, value):
    signature, doc = described(name.split(".")[-1], value)
    if "_core." in signature or "_View" in signature:
        signature = ""  # functions make it, not users
    code = f"\n```python\n{wrapped(signature)}\n```\n" if signature else ""
    return f"\n{'#' * level} `{name}`\n{code}\n{markdown(doc)}\n"


def members(owner, value):
    """Public methods and properties with words of their own, in the order in which they are written."""
    for name, member in vars(value).items():
        target = member.__func__ if isinstance(member, (classmethod, staticmethod)) else member
        told = inspect.getdoc(target) if callable(target) or isinstance(target, property) else None
        if not name.startswith("_") and told:
            yield entry(4, f"{owner}.{name}", target)


def page():
    listed = [name for names in GROUPS.values() for name in names]
    public = set(marketgen.__all__) - UNSHOWN
    if set(listed) != public:
        sys.exit(f"reference: {sorted(public - set(listed))} in no group, {sorted(set(listed) - public)} not public")
    text = "# Python reference\n\nEvery public name of `marketgen`; [Python](python.md) says how they work together.\n"
    for title, names in GROUPS.items():
        text += f"\n## {title}\n"
        for name in names:
            value = getattr(marketgen, name)
            if inspect.ismodule(value):
                text += f"\n### `{name}`\n\n{markdown(inspect.getdoc(value) or '')}\n"
                shown = [(n, v) for n, v in vars(value).items() if inspect.isfunction(v) and v.__module__ == value.__name__]
                text += "".join(entry(4, f"{name}.{n}", v) for n, v in shown if not n.startswith("_"))
                continue
            text += entry(3, name, value)
            if inspect.isclass(value):
                text += "".join(members(name, value))
    return text


pathlib.Path(sys.argv[1]).write_text(page())
