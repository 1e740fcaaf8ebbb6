"""The `marketgen` command of an installed wheel: the C++ program inside the package."""

import os
import pathlib
import sys


def main():
    program = pathlib.Path(__file__).parent / "bin" / "marketgen"
    if not program.exists():
        sys.exit("marketgen: the program is not in this package; in a source tree it is build/release/marketgen")
    # Its helper processes use this environment's packages, activated or not.
    os.environ.setdefault("MARKETGEN_PYTHON", sys.executable)
    os.execv(program, [str(program), *sys.argv[1:]])
