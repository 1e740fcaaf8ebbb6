"""The documentation holds: every link and path leads somewhere, every command and flag exists, every Python block runs.

A Python block runs in an empty folder, after the blocks of the same page before it. One that cannot has a line before its fence:

    <!-- not run: REASON -->

and shows up among the skipped tests with that reason.
"""

import functools
import json
import os
import pathlib
import re
import shlex
import subprocess
import sys

import pytest

import marketgen
from conftest import PROGRAM, ROOT
from page_blocks import blocks_of, prose_of

PAGES = sorted([*ROOT.glob("*.md"), *(ROOT / "docs").rglob("*.md"), *(ROOT / "examples").rglob("*.md")])
SOURCES = [
    path
    for folder in ("src", "apps", "python", "examples", "tools", "tests", "bench", "fuzz", "cmake", "schemas")
    for path in sorted((ROOT / folder).rglob("*"))
    if path.is_file() and path.suffix in {".h", ".cpp", ".inc", ".py", ".sh", ".cmake", ".txt", ".fbs", ".pyi", ""}
    and "node_modules" not in path.parts
]
TUTORIALS = ROOT / "docs/tutorials"
COMMANDS_IN_PYTHON = [ROOT / "python/marketgen/record.py", ROOT / "python/marketgen/evaluate.py", ROOT / "python/marketgen/model_server.py"]


def text_of(path):
    return path.read_text(encoding="utf-8", errors="replace")


def name_of(path):
    return path.relative_to(ROOT).as_posix()


def slug(heading):
    """The anchor that GitHub gives a heading."""
    plain = re.sub(r"[`*]", "", heading.strip().lower())
    return re.sub(r"[^\w\- ]", "", plain).replace(" ", "-")


def anchors(page):
    return {slug(line.lstrip("#")) for line in prose_of(page).splitlines() if line.startswith("#")}


# ---- Lists ----


def test_every_kind_of_shop_is_listed():
    rows = json.loads(text_of(ROOT / "data/profiles.json"))
    listed = re.findall(r"^\| `([a-z-]+)` \| (.+?) \|", text_of(ROOT / "docs/prompts.md").split("## Kinds of shop")[1].split("\n## ")[0], re.M)
    assert listed == [(row["id"], row["name"]) for row in rows]
    assert "discounter" in dict(listed)  # by this name alone, as nothing of it is of one country


# ---- Links and paths ----


@pytest.mark.parametrize("page", PAGES, ids=name_of)
def test_links_lead_somewhere(page):
    dead = []
    for target in re.findall(r"\]\(([^)\s]+)\)", prose_of(page)):
        if re.match(r"[a-z]+:", target):
            continue
        file, _, anchor = target.partition("#")
        there = (page.parent / file).resolve() if file else page
        if not there.exists() or (anchor and there.suffix == ".md" and anchor.lower() not in anchors(there)):
            dead.append(target)
    assert not dead, f"{name_of(page)} links to what is not there: {dead}"


def exists(path, beside):
    """As readers write paths: from the root, within src/marketgen, or from beside the page."""
    return any((base / path).exists() for base in (ROOT, ROOT / "src/marketgen", beside))


@pytest.mark.parametrize("page", PAGES, ids=name_of)
def test_paths_in_pages_exist(page):
    tops = {entry.name for entry in ROOT.iterdir() if entry.is_dir()} | {entry.name for entry in (ROOT / "src/marketgen").iterdir()}
    tops -= {"build", "out"}
    dead = []
    for code in re.findall(r"`([^`\n]+)`", prose_of(page)):
        for path in re.findall(r"(?<![\w/.$~<-])[\w.-]+(?:/[\w.-]+)+/?", code):
            if path.split("/")[0] in tops and not exists(path, page.parent):
                dead.append(path)
    assert not dead, f"{name_of(page)} names what is not there: {dead}"


def test_pictures_are_small():
    pictures = [p for p in (ROOT / "docs").rglob("*") if p.suffix in {".png", ".jpg", ".webp"}]
    assert len(pictures) > 30
    large = {name_of(picture): picture.stat().st_size for picture in pictures if picture.stat().st_size > 300_000}
    assert not large, "write them with tools/web_picture"


# Pages that exports write beside what they export.
WRITTEN_PAGES = {"LICENCES.md", "shop_assets/LICENCES.md"}


def test_pages_that_sources_name_exist():
    dead = []
    for source in SOURCES:
        if source.name in {pathlib.Path(__file__).name, "check_layers_test.sh", "tutorials_test.sh"}:
            continue
        for page in re.findall(r"(?<![\w/.$<{-])[\w-]+(?:/[\w-]+)*\.md\b", text_of(source)):
            if page not in WRITTEN_PAGES and not exists(page, source.parent) and not (ROOT / "docs" / page).exists():
                dead.append(f"{name_of(source)}: {page}")
    assert not dead, f"pages that are not there: {dead}"


# ---- Commands ----


@functools.cache
def help_of(*command):
    done = subprocess.run([PROGRAM, *command, "--help"], capture_output=True, text=True)
    return done.stdout if done.returncode == 0 else ""


@functools.cache
def subcommands(*command):
    _, _, listed = help_of(*command).partition("Subcommands:\n")
    listed = listed.partition("\n\n")[0]
    return frozenset(re.findall(r"^  ([a-z][\w-]*)", listed, re.M))


def flags_in(text):
    return set(re.findall(r"(?<![\w-])(--[a-z][a-z0-9-]*)", text))


def command_lines(text):
    """What follows the program's name on each line that calls it, lines joined that a backslash continues."""
    for line in re.sub(r"\\\n\s*", " ", text).splitlines():
        for found in re.finditer(r"(?:^|[\s`(/])marketgen ((?:[a-z]|\")[^`|]*)", line):
            yield found.group(1).split(" #")[0]


def mistakes_in(line):
    try:
        words = shlex.split(line)
    except ValueError:
        words = line.split()
    command = []
    while words and words[0] in subcommands(*command):
        command.append(words.pop(0))
    if not command:
        return []  # prose: "marketgen is", "marketgen with"
    known = flags_in(help_of(*command))
    return [f"marketgen {' '.join(command)} {flag}" for flag in flags_in(line) if flag not in known]


def code_of(page):
    """What a reader would type: fenced and indented blocks, and code within lines."""
    blocks = [block.body for block in blocks_of(page) if block.language in {"", "sh", "console", "bash"}]
    rest = prose_of(page)
    return "\n".join([*blocks, *re.findall(r"^    \S.*(?:\n    .*)*", rest, re.M), *re.findall(r"`([^`\n]+)`", rest)])


def test_the_program_lists_its_commands():
    assert {"generate", "render", "export", "assets", "episodes", "eval"} <= subcommands()
    assert "--where" in flags_in(help_of("query"))
    assert mistakes_in("query shop products --were x=1") == ["marketgen query --were"]


@pytest.mark.parametrize("page", [page for page in PAGES if "marketgen " in text_of(page)], ids=name_of)
def test_commands_in_pages_exist(page):
    wrong = [mistake for line in command_lines(code_of(page)) for mistake in mistakes_in(line)]
    for line in re.findall(r"^\s*(?:build/release/)?marketgen +([a-z][\w-]*)", code_of(page), re.M):
        if line not in subcommands():
            wrong.append(f"marketgen {line}")
    assert not wrong, f"{name_of(page)} shows what does not exist: {wrong}"


@functools.cache
def known_flags():
    """Of every command and of every script of ours."""
    flags = set()
    for command in subcommands():
        flags |= flags_in(help_of(command))
        for inner in subcommands(command):
            flags |= flags_in(help_of(command, inner))
    for script in [*(ROOT / "tools").iterdir(), *(ROOT / "examples").glob("*.py"), *COMMANDS_IN_PYTHON, ROOT / "Makefile", ROOT / "CMakePresets.json", *ROOT.glob("bench/**/*")]:
        if script.is_file():
            flags |= flags_in(text_of(script))
    return flags


# Of other programs: CMake, ctest, GoogleTest, pip, pipx, build, git, Docker, LeRobot, ROS 2, exporters of SAM.
OTHERS_FLAGS = {"--preset", "--build", "--target", "--gtest", "--no-build-isolation", "--depth", "--python", "--size-prefixed", "--raw-binary"} | {
    "--checkpoint",
    "--dataset",
    "--env",
    "--eval",
    "--no-docker",
    "--render",
    "--ros-args",
    "--params-file",
    "--install",
    "--model-type",
    "--prefix",
    "--rm",
    "--sdist",
    "--spec",
    "--user",
}


@pytest.mark.parametrize("page", PAGES, ids=name_of)
def test_flags_in_pages_exist(page):
    if name_of(page) in {"CHANGELOG.md", "THIRD_PARTY.md"}:
        pytest.skip("says what was, and what others have")
    wrong = flags_in(code_of(page)) - known_flags() - OTHERS_FLAGS
    assert not wrong, f"{name_of(page)} names flags that nothing has: {sorted(wrong)}"


def test_commands_in_help_and_errors_exist():
    """The examples under --help, and the remedies that messages name."""
    wrong = []
    for command in subcommands():
        for text in [help_of(command), *(help_of(command, inner) for inner in subcommands(command))]:
            wrong += [mistake for line in command_lines(text) for mistake in mistakes_in(line)]
    for source in SOURCES:
        if source.suffix in {".cpp", ".py"} and source.parts[len(ROOT.parts)] in {"src", "apps", "python"}:
            joined = re.sub(r'"\s*\n\s*"', "", text_of(source))  # C++ texts that go on in the next line
            for quoted in re.findall(r"(?:run|with|by|make a store with):? `?marketgen ([^\"`]+)", joined):
                wrong += mistakes_in(quoted)
    assert not wrong, wrong


# ---- Python ----


def python_blocks(page):
    """Of pages whose blocks are run one after the other; tutorials are run as a reader does: tools/check_tutorials."""
    return [] if TUTORIALS in page.parents else [block for block in blocks_of(page) if block.language == "python"]


PYTHON_PAGES = [page for page in PAGES if python_blocks(page)]


def test_python_blocks_are_found():
    assert {"README.md", "docs/python.md"} <= {name_of(page) for page in PYTHON_PAGES}


@pytest.mark.parametrize("page", PYTHON_PAGES, ids=name_of)
def test_python_blocks_run(page, tmp_path):
    blocks = [(block.body, block.line) for block in python_blocks(page) if "not run" not in block.marks]
    if not blocks:
        pytest.skip("each of its blocks says why it is not run")
    # Each block keeps its line number, so that a traceback points into the page.
    program = "".join(f"exec(compile({chr(10) * (line - 1) + body!r}, {name_of(page)!r}, 'exec'), globals())\n" for body, line in blocks)
    environment = {**os.environ, "PYTHONPATH": str(pathlib.Path(marketgen.__file__).resolve().parents[1])}
    done = subprocess.run([sys.executable, "-c", program], cwd=tmp_path, env=environment, capture_output=True, text=True, timeout=300)
    assert done.returncode == 0, done.stdout[-2000:] + done.stderr[-4000:]


@pytest.mark.parametrize(
    ("page", "line", "reason"),
    [(page, block.line, block.marks["not run"]) for page in PYTHON_PAGES for block in python_blocks(page) if "not run" in block.marks],
    ids=lambda value: name_of(value) if isinstance(value, pathlib.Path) else None,
)
def test_blocks_that_are_not_run_say_why(page, line, reason):
    assert len(reason) > 10, f"{name_of(page)}:{line}"
    pytest.skip(reason)
