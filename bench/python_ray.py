"""What Ray costs an episode: one JSON line a figure, as `marketgen bench` has them. Ray lies in build/ray-venv (tests/tools/ray_test.sh).

    RAY_worker_niceness=0 PYTHONPATH=build/release/python build/ray-venv/bin/python bench/python_ray.py [EPISODES [PART [ROUNDS]]]

The first EPISODES of the pool at the counter, by `oracle-plain`, ROUNDS times: by marketgen.evaluate(jobs=WORKERS), and by
marketgen.ray.evaluate(workers=WORKERS) in parts of PART, in turn, each in a process that starts with nothing. Processor time is that of
this process and of all that it begot, Ray's own among them. What a run takes that only starts Ray and its actors, and ends them, is
stated apart and taken off. Ray's processes also compute while nothing is to be done, by the clock: on a busy machine, where the same
episodes last longer, that is a larger share of them, so it is measured, too (`ray_idle_cpu`).
"""

import json
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile
import threading
import time
import uuid

import marketgen

WORKERS, POLICY, MARK, LOOK_UP_S, IDLE_S = 2, "oracle-plain", "MARKETGEN_BENCH", 0.05, 30
TICK_S = 1 / os.sysconf("SC_CLK_TCK")
RUNS = {
    "alone": "marketgen.evaluate(file, policy, folder, jobs=int(workers))",
    "ray": "ray.init('local', num_cpus=int(workers), log_to_driver=False, include_dashboard=False)\n"
    "marketgen.ray.evaluate(file, policy, folder, part=int(part), workers=int(workers))",
    "start": "ray.init('local', num_cpus=int(workers), log_to_driver=False, include_dashboard=False)\n"
    "actors = [ray.remote(num_cpus=1)(Worker).remote() for _ in range(int(workers))]\n"
    "ray.get([actor.__ray_ready__.remote() for actor in actors])",
}
RUNS["idle"] = f"{RUNS['start']}; import time; time.sleep({IDLE_S})"
HEAD = """import sys, marketgen
file, folder, policy, part, workers, way = sys.argv[1:]
if way != "alone":
    import marketgen.ray, ray
    from marketgen.scaling.crew import Worker
"""
KINDS = {"ray::Worker": "actors", "serve_episodes": "episodes", "bench_of_ray": "caller"}  # the rest is Ray's own


class Meter:
    """Processor time of all processes with a mark in their environment, by kind; of each what it had used when it was last seen."""

    def __init__(self, mark):
        self._mark, self._ended = f"{MARK}={mark}".encode(), threading.Event()
        self._ours, self._used_s = {}, {}
        self._thread = threading.Thread(target=self._watch)

    def __enter__(self):
        self._thread.start()
        return self

    def __exit__(self, *_):
        self._ended.set()
        self._thread.join()

    def by_kind(self):
        kinds = dict.fromkeys([*KINDS.values(), "ray"], 0.0)
        for kind, used_s in self._used_s.values():
            kinds[kind] += used_s
        return kinds

    def _watch(self):
        while not self._ended.wait(LOOK_UP_S):
            for place in pathlib.Path("/proc").iterdir():
                if place.name.isdecimal():
                    self._look_at(place)

    def _look_at(self, place):
        try:
            fields = (place / "stat").read_text().rpartition(")")[2].split()
            one = place.name, fields[19]  # with when it began: process ids come again
            if one not in self._ours:
                self._ours[one] = self._mark in (place / "environ").read_bytes().split(b"\0")
            if self._ours[one]:
                words = (place / "cmdline").read_bytes().decode()
                kind = next((kind for word, kind in KINDS.items() if word in words), "ray")
                if not words:  # it has ended, and nobody has waited for it yet
                    kind = self._used_s[one][0]
                self._used_s[one] = kind, (int(fields[11]) + int(fields[12])) * TICK_S
        except (OSError, KeyError):  # it has ended
            return


def measured(way, file, part):
    """(seconds by the clock, processor seconds by kind)."""
    mark = uuid.uuid4().hex
    with tempfile.TemporaryDirectory() as folder:
        program = f"{HEAD}# bench_of_ray\n{RUNS[way]}"
        words = [sys.executable, "-c", program, file, f"{folder}/results", POLICY, str(part), str(WORKERS), way]
        began = time.perf_counter()
        with Meter(mark) as meter:
            subprocess.run(words, env={**os.environ, MARK: mark}, check=True, stderr=subprocess.DEVNULL)
        return time.perf_counter() - began, meter.by_kind()


def first_of_pool(count, file):
    header, *rows = pathlib.Path(marketgen._core.find_episode_file("pool/checkout")).read_text().splitlines()
    lines = [json.dumps(json.loads(header) | {"episodes": count}), *rows[:count]]
    file.write_text("".join(line + "\n" for line in lines))
    return str(file)


def say(name, values, unit):
    line = {"name": name, "value": round(statistics.median(values), 3), "low": round(min(values), 3), "high": round(max(values), 3)}
    print(json.dumps({**line, "unit": unit, "n": len(values), "machine": f"{os.cpu_count()} cores, load {os.getloadavg()[0]:.1f}"}), flush=True)


def main(episodes=24, part=10, rounds=3):
    taken = {way: [] for way in RUNS}
    with tempfile.TemporaryDirectory() as folder:
        file = first_of_pool(episodes, pathlib.Path(folder) / "tasks.jsonl")
        for number in range(rounds):
            for way in list(RUNS)[:: 1 if number % 2 == 0 else -1]:
                taken[way].append(measured(way, file, part))
                print(way, f"{taken[way][-1][0]:.1f} s", {kind: round(used_s, 2) for kind, used_s in taken[way][-1][1].items()}, file=sys.stderr, flush=True)
    wall_s = {way: [wall for wall, _ in runs] for way, runs in taken.items()}
    cpu_s = {way: [sum(kinds.values()) for _, kinds in runs] for way, runs in taken.items()}
    say("ray_start_s", wall_s["start"], "s")
    say("ray_start_cpu_s", cpu_s["start"], "s")
    say("ray_idle_cpu", [(idle - start) / IDLE_S for idle, start in zip(cpu_s["idle"], cpu_s["start"], strict=True)], "of a core")
    say("episode_alone_cpu_s", [used_s / episodes for used_s in cpu_s["alone"]], "s")
    for name, spent in (("ray_share_cpu", cpu_s), ("ray_share_wall", wall_s)):
        start_s = statistics.median(spent["start"])
        say(name, [(ray - start_s) / alone - 1 for ray, alone in zip(spent["ray"], spent["alone"], strict=True)], "of an episode")


if __name__ == "__main__":
    main(*map(int, sys.argv[1:]))
