"""What recording costs beside evaluation: one JSON line a figure, as `marketgen bench` has them.

    PYTHONPATH=build/release/python .venv/bin/python bench/python_recording.py [EPISODES [FRAMES]]

The oracle acts the first episode of the file (pool/checkout by itself; cut off after FRAMES control steps, where that is given) three
times: without pictures, with two cameras of 256x256 that are looked through at each step and not kept, and recorded. Processor
seconds of all threads count, which say the same on a busy machine, and the clock's beside them. What builds the store and its
light is not counted.
"""

import functools
import json
import os
import sys
import time

from marketgen import arguments
from marketgen.recording import staging
from marketgen.recording.acting import FPS, Player, Stopwatch, act_out
from marketgen.recording.features import acted
from marketgen.recording.video import Encoder

SIZE = (256, 256)
path = arguments.episodes_path("episodes", sys.argv[1] if len(sys.argv) > 1 else "pool/checkout")
most = int(sys.argv[2]) if len(sys.argv) > 2 else sys.maxsize
text = next(iter(staging.episodes_of(path)))
place = staging.place_of(staging.documents_of([text]), path)


class Cut:
    """A player that stops after `most` steps."""

    def __init__(self, player):
        self.player, self.left = player, most
        self.begin, self.subtask, self.end = player.begin, player.subtask, player.end

    def act(self, seen):
        action = self.player.act(seen)
        self.left -= 1
        if self.left <= 0:
            action[-1] = 1  # stop
        return action


def measured(cameras, record):
    """Frames, processor seconds and the clock's."""
    options = {"cameras": cameras, "quality": "fast", "control_mode": "pd_joint_pos", "realism": "ideal"}
    stages = staging.stages_of(path, place, SIZE, options)
    env = stages.environment(place["track"], place["station"])
    env.reset(seed=0, options={"episode": text})  # builds what is built once
    player = Cut(Player("oracle", env, stages))
    began, computed = time.perf_counter(), time.process_time()
    if record:
        take = act_out(env, text, player, acted(env.robot_names, env.action_names), functools.partial(Encoder, "h264", SIZE, FPS), Stopwatch())
        frames = len(take.numbers["action"])
    else:
        seen, info = env.reset(seed=0, options={"episode": text})
        player.begin(info, seen)
        over, frames = False, 0
        while not over:
            seen, _, terminated, truncated, _ = env.step(player.act(seen))
            over, frames = terminated or truncated, frames + 1
    return frames, time.process_time() - computed, time.perf_counter() - began


rows = {"without_pictures": measured((), False), "with_pictures": measured(None, False), "recorded": measured(None, True)}
assert len({frames for frames, *_ in rows.values()}) == 1
for name, (frames, computed, wall) in rows.items():
    for unit, seconds, place_of_rival in (("ms of processor time a frame", computed, 1), ("ms a frame", wall, 2)):
        line = {"name": f"python_recording_{name}", "value": round(1000 * seconds / frames, 2), "unit": unit, "n": frames}
        line |= {"times_without_pictures": round(seconds / rows["without_pictures"][place_of_rival], 2)}
        line |= {"times_with_pictures": round(seconds / rows["with_pictures"][place_of_rival], 2)}
        print(json.dumps(line | {"machine": f"{os.cpu_count()} cores, load {os.getloadavg()[0]:.1f}"}), flush=True)
