"""Python tests run on the build tree: MARKETGEN_BINARY is the program, PYTHONPATH has the module."""

import os
import pathlib
import subprocess

import pytest

import marketgen

ROOT = pathlib.Path(__file__).parents[2]
PROGRAM = os.environ.get("MARKETGEN_BINARY", str(ROOT / "build/release/marketgen"))
PROMPT = "a corner shop with cold drinks, snacks and one checkout"


def run(*arguments):
    """The program's standard output."""
    return subprocess.run([PROGRAM, *map(str, arguments)], check=True, capture_output=True, text=True).stdout


@pytest.fixture(scope="session")
def store(tmp_path_factory):
    return marketgen.generate(PROMPT, tmp_path_factory.mktemp("stores") / "shop", seed=5, size="9x7m")


@pytest.fixture(scope="session")
def renderer(store):
    return store.renderer()


@pytest.fixture
def unmoved(renderer):
    """The renderer with nothing moved and no robots, before and after."""
    yield renderer
    renderer.move()
    renderer.set_robots([])
