"""Copies every shared library that a wheel needs into it, with its licence: what tools/wheels does after a build.

    python tools/repair_wheel.py WHEEL FOLDER      prints the file it wrote

auditwheel leaves out what a desktop has (X11, GLib, zlib, expat): a bare machine has none of these. So its list of libraries that are left
out is cut down to glibc's own and the compiler's.
"""

import base64
import csv
import hashlib
import io
import json
import pathlib
import subprocess
import sys
import tempfile
import zipfile

from auditwheel import policy
from auditwheel.libc import Libc
from auditwheel.main import main as auditwheel

# What every Linux with glibc and a C++ program (apt is one) has, and what must be the process's own.
LEFT_OUT = {
    "ld-linux-x86-64.so.2", "libc.so.6", "libm.so.6", "libdl.so.2", "libpthread.so.0", "librt.so.1", "libutil.so.1",
    "libresolv.so.2", "libnsl.so.1", "libanl.so.1", "libgcc_s.so.1", "libstdc++.so.6",
}  # fmt: skip
PLATFORM = "manylinux_2_36_x86_64"  # Debian 12's glibc
# Fonts, and libraries that have no file of their own in the wheel.
COMPILED_IN = {
    "fonts-dejavu-core", "fonts-lato", "fonts-open-sans",
    "libboost1.74-dev", "libeigen3-dev", "nlohmann-json3-dev", "libcli11-dev", "libxsimd-dev", "libflatbuffers-dev",
}  # fmt: skip
MOST_BYTES = 120_000_000


def narrowed_policy(folder: pathlib.Path) -> pathlib.Path:
    rows = json.loads(policy._POLICY_JSON_MAP[Libc.GLIBC].read_text())
    for row in rows:
        row["lib_whitelist"] = [name for name in row["lib_whitelist"] if name in LEFT_OUT]
    file = folder / "policy.json"
    file.write_text(json.dumps(rows))
    return file


def licences(wheel: pathlib.Path) -> dict[str, bytes]:
    """The copyright file of each Debian package of which something is in the wheel, and MuJoCo's licences."""
    with zipfile.ZipFile(wheel) as archive:
        names = [pathlib.PurePath(n).name for n in archive.namelist() if ".libs/" in n]
    wanted = {name.split("-")[0] if "-" not in name else name.rsplit("-", 1)[0] for name in names}
    packages = set(COMPILED_IN)
    for line in subprocess.run(["dpkg-query", "-S", "*.so*"], capture_output=True, text=True).stdout.splitlines():
        owner, _, path = line.partition(": ")
        if pathlib.PurePath(path).name.split(".so")[0] in wanted and "/lib/x86_64-linux-gnu/" in path:
            packages.add(owner.split(":")[0])
    found = {}
    for package in sorted(packages):
        file = pathlib.Path("/usr/share/doc") / package / "copyright"
        if file.exists() and (package in COMPILED_IN or not package.endswith("-dev")):
            found[package] = file.read_bytes()
    mujoco = sorted(pathlib.Path(".venv/lib").glob("python3*/site-packages/mujoco_core-*.dist-info/licenses/*"))
    if not mujoco:
        raise SystemExit("repair_wheel: MuJoCo's licences are not in .venv; run tools/setup build")
    return found | {f"mujoco/{file.name}": file.read_bytes() for file in mujoco}


def add_files(wheel: pathlib.Path, files: dict[str, bytes]) -> None:
    """Appends files to the wheel's dist-info, with their rows in RECORD."""
    with zipfile.ZipFile(wheel) as archive:
        members = {info.filename: (info, archive.read(info)) for info in archive.infolist()}
    (record,) = [name for name in members if name.endswith(".dist-info/RECORD")]
    folder = record.rpartition("/")[0]
    rows = [row for row in csv.reader(io.StringIO(members[record][1].decode())) if row]
    for name, content in files.items():
        path = f"{folder}/licenses/third-party/{name}"
        digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
        rows.insert(0, [path, f"sha256={digest}", str(len(content))])
        members[path] = (zipfile.ZipInfo(path, date_time=(1980, 1, 1, 0, 0, 0)), content)
    text = io.StringIO()
    csv.writer(text, lineterminator="\n").writerows(rows)
    members[record] = (members[record][0], text.getvalue().encode())
    with zipfile.ZipFile(wheel, "w", zipfile.ZIP_DEFLATED, compresslevel=9) as archive:
        for info, content in members.values():
            info.compress_type = zipfile.ZIP_DEFLATED
            if not info.external_attr:
                info.external_attr = 0o644 << 16
            archive.writestr(info, content)


def main() -> int:
    source, target = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)
        policy._POLICY_JSON_MAP[Libc.GLIBC] = narrowed_policy(folder)
        sys.argv = ["auditwheel", "repair", "--only-plat", "--plat", PLATFORM, "-w", str(folder / "out"), str(source)]
        status = auditwheel()
        if status:
            return status
        (repaired,) = (folder / "out").glob("*.whl")
        add_files(repaired, licences(repaired))
        if repaired.stat().st_size > MOST_BYTES:
            print(f"repair_wheel: {repaired.stat().st_size} bytes; expected at most {MOST_BYTES}", file=sys.stderr)
            return 1
        written = target / repaired.name
        written.write_bytes(repaired.read_bytes())
    print(written)
    return 0


if __name__ == "__main__":
    sys.exit(main())
