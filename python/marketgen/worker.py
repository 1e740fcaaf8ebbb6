"""Does one job for the marketgen program: a JSON request on standard input, a JSON answer on standard output.

    python worker.py parts            which outside libraries are there: {"coacd": "1.0.14"}
    python worker.py convex_pieces    a closed or open triangle mesh cut into convex pieces by CoACD
    python worker.py film             pictures of a folder as an MP4 file, by PyAV

A job that cannot be done ends with status 1 and one line on standard error.
"""

import fractions
import json
import os
import sys
from importlib import metadata


def parts(_request):
    found = {}
    for name in ("coacd", "av"):
        try:
            found[name] = metadata.version(name)
        except metadata.PackageNotFoundError:
            pass
    return found


def convex_pieces(request):
    """positions: [x, y, z, ...] in metres, triangles: [a, b, c, ...]; answers pieces: [[x, y, z, ...], ...]."""
    import coacd
    import numpy

    coacd.set_log_level("off")
    mesh = coacd.Mesh(
        numpy.asarray(request["positions"], dtype=numpy.float64).reshape(-1, 3),
        numpy.asarray(request["triangles"], dtype=numpy.int32).reshape(-1, 3),
    )
    # decimate bounds the points of a piece by max_ch_vertex; the seed makes the tree search repeatable.
    pieces = coacd.run_coacd(
        mesh,
        threshold=request["threshold"],
        max_convex_hull=request["max_pieces"],
        preprocess_mode="auto",
        decimate=True,
        max_ch_vertex=request["max_points"],
        seed=0,
    )
    # 0.01 mm: below any tolerance of ours, and the same text for the last bits of any machine.
    return {"pieces": [[round(float(v), 5) for v in numpy.asarray(points).ravel()] for points, _ in pieces]}


# Whichever the installed PyAV has, most widely played first.
FILM_CODECS = (("libx264", {"crf": "23", "preset": "medium"}), ("libsvtav1", {"crf": "30"}), ("mpeg4", {"q": "4"}))


def film(request):
    """folder of 000000.png ..., film, pictures, frame_rate; answers codec."""
    import av

    codec, options = next(entry for entry in FILM_CODECS if entry[0] in av.codecs_available)
    rate = round(request["frame_rate"])
    with av.open(request["film"], "w", format="mp4", options={"movflags": "+faststart"}) as movie:
        stream = None
        for number in range(request["pictures"]):
            with av.open(os.path.join(request["folder"], f"{number:06}.png")) as picture:
                frame = next(picture.decode(video=0))
            if stream is None:
                stream = movie.add_stream(codec, rate=rate, options=options)
                stream.width, stream.height, stream.pix_fmt = frame.width, frame.height, "yuv420p"
            frame = frame.reformat(format="yuv420p")
            frame.pts, frame.time_base = number, fractions.Fraction(1, rate)
            movie.mux(stream.encode(frame))
        movie.mux(stream.encode())
    return {"codec": codec}


JOBS = {"parts": parts, "convex_pieces": convex_pieces, "film": film}


def main():
    if len(sys.argv) != 2 or sys.argv[1] not in JOBS:
        print(f"usage: python worker.py {'|'.join(JOBS)}", file=sys.stderr)
        return 2
    # Libraries that print must not spoil the answer.
    answer = os.fdopen(os.dup(1), "w", encoding="utf-8")
    os.dup2(2, 1)
    text = sys.stdin.read()
    try:
        result = JOBS[sys.argv[1]](json.loads(text) if text.strip() else {})
    except Exception as fault:  # whatever it is, the program only needs to know that the job was not done
        print(f"{type(fault).__name__}: {fault}", file=sys.stderr)
        return 1
    with answer:
        json.dump(result, answer, separators=(",", ":"))
    return 0


if __name__ == "__main__":
    sys.exit(main())
