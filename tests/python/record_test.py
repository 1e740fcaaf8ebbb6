"""A recorded dataset is what LeRobot's format v3.0 says, holds what happened, and survives being killed.

It is read here by pyarrow, PyAV and json alone, by the format's description; nothing of the writer's is used for that.
"""

import json
import os
import pathlib
import signal
import subprocess
import sys

import av
import gymnasium
import numpy as np
import pyarrow.parquet
import pytest

import marketgen

CHECKOUT = "MarketGen/CheckoutUnloading-v1"
CAMERAS = ("scene_camera", "wrist_camera")
SIZE = (64, 64)
FPS = 20
SHORT_S = (1.0, 1.2, 2.0)  # limits of three episodes: 20, 24 and 40 frames
PACKAGE = str(pathlib.Path(marketgen.__file__).resolve().parents[1])


def sways(observation):
    """An arm that sways: what it does follows from what it sees."""
    action = observation["agent"]["qpos"][:9].copy()
    action[:7] += 0.05 * np.sin(8 * action[:7] + observation["sensor_data"]["scene_camera"]["rgb"].mean() / 50)
    return np.concatenate([action[:7], [0.5, -1]]).astype(np.float64) + 1e-9  # what float32 cannot say, it rounds


class Reader:
    """A dataset by its files."""

    def __init__(self, root):
        self.root = pathlib.Path(root)
        self.info = json.loads((self.root / "meta/info.json").read_text())
        self.stats = json.loads((self.root / "meta/stats.json").read_text())
        rows = [pyarrow.parquet.read_table(path) for path in sorted(self.root.glob("meta/episodes/*/*.parquet"))]
        self.episodes = pyarrow.concat_tables(rows).to_pylist()
        tables = [pyarrow.parquet.read_table(path) for path in sorted(self.root.glob("data/*/*.parquet"))]
        self.frames = pyarrow.concat_tables(tables)
        self.tasks = pyarrow.parquet.read_table(self.root / "meta/tasks.parquet")
        self.subtasks = pyarrow.parquet.read_table(self.root / "meta/subtasks.parquet")

    def column(self, name):
        return np.array(self.frames[name].to_pylist())

    def of_episode(self, number, name):
        row = self.episodes[number]
        return self.column(name)[row["dataset_from_index"] : row["dataset_to_index"]]

    def subtask_names(self):
        """Of each frame."""
        name_of = dict(zip(self.subtasks["subtask_index"].to_pylist(), self.subtasks["subtask"].to_pylist(), strict=True))
        return np.array([name_of[i] for i in self.column("subtask_index")])

    def video(self, number, camera):
        """(seconds from the episode's begin, picture) of each of its frames."""
        key, row = f"observation.images.{camera}", self.episodes[number]
        path = self.root / self.info["video_path"].format(
            video_key=key, chunk_index=row[f"videos/{key}/chunk_index"], file_index=row[f"videos/{key}/file_index"]
        )
        begin, end = row[f"videos/{key}/from_timestamp"], row[f"videos/{key}/to_timestamp"]
        with av.open(str(path)) as container:
            stream = container.streams.video[0]
            shown = [(float(frame.pts * stream.time_base), frame.to_ndarray(format="rgb24")) for frame in container.decode(stream)]
        half = 0.5 / FPS
        return [(at - begin, picture) for at, picture in shown if begin - half < at < end - half]


def psnr(a, b):
    error = np.mean((a.astype(np.float64) - b) ** 2)
    return 10 * np.log10(255**2 / max(error, 1e-9))


def pool_and(file, change):
    """A file of what `change` makes of the pool's baskets."""
    pool = pathlib.Path(marketgen._core.find_episode_file("pool/checkout"))
    header, *lines = map(json.loads, pool.read_text().splitlines())
    episodes = change(lines)
    rows = [header | {"episodes": len(episodes)}, *episodes]
    file.write_text("".join(json.dumps(row) + "\n" for row in rows))
    return file


def with_one_goal(episode):
    """Of a basket: what its oracle fetches first, and no more."""
    [first, *_] = episode["certificate"]["witness"]
    goals = [goal for goal in episode["goals"] if goal["sku"] == first["sku"]]
    return episode | {"goals": goals, "certificate": episode["certificate"] | {"witness": [first]}}


@pytest.fixture(scope="module")
def short_file(tmp_path_factory):
    """Three baskets of the pool, with a second or two for each; the last has the first one's instruction."""
    file = tmp_path_factory.mktemp("episodes") / "short.jsonl"

    def change(episodes):
        some = [episode | {"limit_s": limit_s} for episode, limit_s in zip(episodes, SHORT_S, strict=False)]
        return [*some[:-1], some[-1] | {"instruction": some[0]["instruction"]}]

    return pool_and(file, change)


@pytest.fixture(scope="module")
def recorded(short_file, tmp_path_factory):
    folder = tmp_path_factory.mktemp("datasets") / "demonstrations"
    made = marketgen.record(short_file, folder, sways, size=SIZE)
    return folder, made


@pytest.fixture(scope="module")
def happened(short_file):
    """What the environment shows of the first episode: (state, action, rgb by camera) a frame."""
    env = gymnasium.make(
        CHECKOUT, episodes=short_file, obs_mode="rgbd", control_mode="pd_joint_pos", width=SIZE[0], height=SIZE[1], max_episode_steps=None
    )
    seen, _ = env.reset(options={"episode": 0})
    frames, over = [], False
    while not over:
        agent, extra = seen["agent"], seen["extra"]
        state = [agent["qpos"], agent["qvel"], extra["tcp_pose"].ravel(), extra["base_pose"], agent["external_force"], agent["stopped"]]
        action = np.float32(sways(seen))
        frames.append((np.concatenate(state), action, {name: seen["sensor_data"][name]["rgb"] for name in CAMERAS}))
        seen, _, terminated, truncated, _ = env.step(action)
        over = terminated or truncated
    return frames


def test_its_layout_is_the_formats(recorded):
    folder, made = recorded
    data = Reader(folder)
    info = data.info
    frames = [round(limit_s * FPS) for limit_s in SHORT_S]
    assert info["codebase_version"] == "v3.0" and info["fps"] == FPS and info["robot_type"] == "panda"
    assert (info["total_episodes"], info["total_frames"], info["total_tasks"]) == (3, sum(frames), len(data.tasks))
    assert info["splits"] == {"train": "0:3"} and info["chunks_size"] == 1000
    assert made.frames == sum(frames) and made.episodes == made.tried == 3 and made.folder == str(folder)
    assert [row["length"] for row in data.episodes] == frames
    assert [row["dataset_to_index"] for row in data.episodes] == np.cumsum(frames).tolist()
    numbers = {name: feature for name, feature in info["features"].items() if feature["dtype"] != "video"}
    assert set(data.frames.column_names) == set(numbers)  # no column of pictures
    assert data.frames["observation.state"].type == pyarrow.list_(pyarrow.float32(), len(numbers["observation.state"]["names"]))
    for camera in CAMERAS:
        feature = info["features"][f"observation.images.{camera}"]
        assert feature["dtype"] == "video" and feature["shape"] == [64, 64, 3] and feature["info"]["video.codec"] == "h264"
    assert sorted(path.name for path in folder.iterdir()) == ["README.md", "data", "meta", "strip.png", "videos"]
    assert not folder.with_name(folder.name + ".unfinished").exists()


def test_tasks_are_what_pandas_reads_as_an_index(recorded):
    data = Reader(recorded[0])
    told = json.loads(data.tasks.schema.metadata[b"pandas"])
    assert told["index_columns"] == ["task"]
    for number, row in enumerate(data.episodes):
        [task] = row["tasks"]
        assert {data.tasks["task"].to_pylist()[i] for i in data.of_episode(number, "task_index")} == {task}


def test_subtasks_are_what_pandas_reads_as_an_index(recorded):
    data = Reader(recorded[0])
    assert json.loads(data.subtasks.schema.metadata[b"pandas"])["index_columns"] == ["subtask"]
    assert data.subtasks["subtask_index"].to_pylist() == list(range(len(marketgen.policies.SUBTASKS)))
    assert data.info["features"]["subtask_index"] == {"dtype": "int64", "shape": [1], "names": None}
    assert set(data.subtask_names()) == {"none"}  # a function cannot say it


class Swinging:
    """Says what it is at."""

    name = "swings"

    def __init__(self, said=("reach", "drive", None)):
        self.said, self.acted = said, 0

    def act(self, observation):
        self.acted += 1
        return sways(observation)

    def subtask(self):
        return self.said[self.acted % len(self.said)]


def test_a_policy_in_python_says_what_it_does(short_file, tmp_path):
    marketgen.record(short_file, tmp_path / "said", Swinging(), size=(16, 16), count=1)
    data = Reader(tmp_path / "said")
    said = [("drive", "none", "reach")[i % 3] for i in range(data.info["total_frames"])]
    assert data.subtask_names().tolist() == said
    with pytest.raises(marketgen.Error, match=r"'graps'; there are none, drive") as caught:
        marketgen.record(short_file, tmp_path / "none", Swinging(["graps"]), size=(16, 16))
    assert caught.value.code == "episode.policy_failed"


def test_frames_are_what_happened(recorded, happened):
    data = Reader(recorded[0])
    assert np.array_equal(data.of_episode(0, "observation.state"), np.array([frame[0] for frame in happened]))
    assert np.array_equal(data.of_episode(0, "action"), np.array([frame[1] for frame in happened]))
    names = data.info["features"]["observation.state"]["names"]
    assert len(names) == len(set(names)) and names[0] == "qpos.joint1" and "tcp_pose.tool_qw" in names
    assert data.info["features"]["action"]["names"][-2:] == ["tool_opening", "stop"]
    assert data.column("index").tolist() == list(range(data.info["total_frames"]))
    for number, row in enumerate(data.episodes):
        frames = np.arange(row["length"])
        assert np.array_equal(data.of_episode(number, "frame_index"), frames)
        assert np.allclose(data.of_episode(number, "timestamp"), frames / FPS, atol=1e-6)
        assert data.of_episode(number, "next.done").tolist() == [False] * (row["length"] - 1) + [True]
        assert not row["success"] and not data.of_episode(number, "next.success").any()
        assert row["failure"] and row["goal_fraction"] == 0 and row["seed"] > 0 and row["episode_id"].startswith("checkout/")


def test_videos_show_what_the_cameras_saw(recorded, happened):
    data = Reader(recorded[0])
    for camera in CAMERAS:
        for number, row in enumerate(data.episodes):
            video = data.video(number, camera)
            assert np.allclose([at for at, _ in video], np.arange(row["length"]) / FPS, atol=1e-6), (camera, number)
        shown = [picture for _, picture in data.video(0, camera)]
        assert min(psnr(frame[2][camera], picture) for frame, picture in zip(happened, shown, strict=True)) >= 38, camera


def test_statistics_are_numpys(recorded, happened):
    data = Reader(recorded[0])
    quantiles = {"q01": 0.01, "q10": 0.1, "q50": 0.5, "q90": 0.9, "q99": 0.99}
    for name in data.frames.column_names:
        rows = data.column(name).astype(np.float64).reshape(data.frames.num_rows, -1)
        wanted = {"min": rows.min(0), "max": rows.max(0), "mean": rows.mean(0), "std": rows.std(0), "count": [len(rows)]}
        wanted |= {key: np.quantile(rows, q, axis=0) for key, q in quantiles.items()}
        assert data.stats[name].keys() == wanted.keys()
        for key, value in wanted.items():
            assert np.allclose(data.stats[name][key], value, rtol=1e-9, atol=1e-12), (name, key)
    for camera in CAMERAS:
        pixels = np.array([frame[2][camera] for frame in happened]).reshape(-1, 3) / 255
        told = {key: data.episodes[0][f"stats/observation.images.{camera}/{key}"] for key in (*quantiles, "mean", "std", "max")}
        assert np.shape(told["mean"]) == (3, 1, 1)
        assert np.allclose(np.ravel(told["mean"]), pixels.mean(0)) and np.allclose(np.ravel(told["std"]), pixels.std(0))
        assert np.allclose(np.ravel(told["max"]), pixels.max(0))
        for key, q in quantiles.items():
            assert np.allclose(np.ravel(told[key]), np.quantile(pixels, q, axis=0)), key


def test_actions_lead_to_the_same_states(recorded, short_file, tmp_path):
    folder, made = recorded
    assert marketgen.replay_check(folder, short_file) == made.frames
    other = tmp_path / "other"
    copy_with(folder, other, lambda table: table.set_column(0, "action", change_one(table["action"])))
    with pytest.raises(marketgen.Error, match=r"frame 6: observation\.state is not as the dataset has it") as caught:
        marketgen.replay_check(other, short_file)
    assert caught.value.code == "episode.not_repeated"


def change_one(column):
    rows = np.array(column.to_pylist(), np.float32)
    rows[5, 0] += 1e-3
    return pyarrow.FixedSizeListArray.from_arrays(pyarrow.array(rows.ravel()), rows.shape[1])


def copy_with(folder, other, change):
    """A copy of the dataset's numbers, changed."""
    for path in [*folder.glob("meta/**/*.*"), *folder.glob("data/**/*.parquet")]:
        target = other / path.relative_to(folder)
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_bytes(path.read_bytes())
    [data] = other.glob("data/*/*.parquet")
    pyarrow.parquet.write_table(change(pyarrow.parquet.read_table(data)), data)


def contents(folder):
    return {path.relative_to(folder).as_posix(): path.read_bytes() for path in folder.rglob("*") if path.is_file()}


class Killed:
    """Sways, and dies without a word at the 25th picture: in the middle of the second episode."""

    name = "sways"

    def __init__(self):
        self.acted = 0

    def act(self, observation):
        self.acted += 1
        if self.acted == 25:
            os.kill(os.getpid(), signal.SIGKILL)
        return sways(observation)


def test_a_killed_recording_goes_on_to_the_same_bytes(recorded, short_file, tmp_path):
    whole, _ = recorded
    folder = tmp_path / whole.name
    program = f"import marketgen, record_test; marketgen.record({str(short_file)!r}, {str(folder)!r}, record_test.Killed(), size={SIZE})"
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join([PACKAGE, str(pathlib.Path(__file__).parent)])}
    done = subprocess.run([sys.executable, "-c", program], env=environment, capture_output=True, text=True, timeout=120)
    assert done.returncode == -signal.SIGKILL, done.stderr
    unfinished = tmp_path / f"{whole.name}.unfinished"
    assert not folder.exists() and (unfinished / "000000/episode.json").exists() and not (unfinished / "000001").exists()
    with pytest.raises(marketgen.Error, match="resume=True"):
        marketgen.record(short_file, folder, sways, size=SIZE)
    with pytest.raises(marketgen.Error, match="size"):
        marketgen.record(short_file, folder, sways, size=(32, 32), resume=True)
    made = marketgen.record(short_file, folder, sways, size=SIZE, resume=True)
    assert made.acted_now == 2 and made.tried == 3
    assert contents(folder) == contents(whole)


def test_going_on_with_what_is_done_changes_nothing(recorded, short_file):
    """As a recording that was killed when its dataset was in place, but what it was made of not yet taken away."""
    folder, made = recorded
    left, before = folder.with_name(folder.name + ".unfinished"), contents(folder)
    left.mkdir()
    (left / "recording.json").write_text("{}")
    again = marketgen.record(short_file, folder, sways, size=SIZE, resume=True)
    assert (again.episodes, again.succeeded, again.tried, again.frames) == (made.episodes, made.succeeded, made.tried, made.frames)
    assert again.acted_now == 0 and contents(folder) == before and not left.exists()
    with pytest.raises(marketgen.Error, match="not of this recording") as caught:
        marketgen.record(short_file, folder, sways, size=SIZE, count=1, resume=True)
    assert caught.value.code == "store.exists" and contents(folder) == before


def test_the_oracle_demonstrates_and_failures_are_left_out(tmp_path):
    """One whole episode, which it solves, before one that ends too soon."""
    file = pool_and(tmp_path / "two.jsonl", lambda episodes: [episodes[1] | {"limit_s": 1}, with_one_goal(episodes[0])])
    [_, first] = map(json.loads, file.read_text().splitlines()[1:])
    said = []
    made = marketgen.record(
        file, tmp_path / "oracle", size=SIZE, cameras=["wrist_camera"], success_only=True, progress=lambda *told: said.append(told)
    )
    assert (made.episodes, made.succeeded, made.tried, made.acted_now) == (1, 1, 2, 2)
    assert made.episodes_an_hour > 0 and made.times_as_long > 1 and [done for done, *_ in said] == [0, 1, 2]
    data = Reader(tmp_path / "oracle")
    [row] = data.episodes
    assert row["success"] and row["goal_fraction"] == 1 and row["episode_id"] == first["id"]
    assert data.column("next.success").tolist() == [False] * (row["length"] - 1) + [True]
    assert data.column("next.reward").sum() == 1 and len(data.video(0, "wrist_camera")) == row["length"]
    assert data.column("observation.state").std(0)[:7].min() > 0.01
    assert not (tmp_path / "oracle/videos/observation.images.scene_camera").exists()
    card = (tmp_path / "oracle" / "README.md").read_text()
    assert "| episodes | 1, 1 of them successful |" in card and "reached all goals in 1 of 2" in card and "strip.png" in card
    assert marketgen.replay_check(tmp_path / "oracle", file) == row["length"]
    subtasks_are_what_physics_did(data)
    assert "| sub-tasks | none " in card and "grasp " in card


def subtasks_are_what_physics_did(data):
    """Of one item that the oracle took out of its basket, or of several."""
    names, state = data.subtask_names(), data.column("observation.state")
    told = data.info["features"]["observation.state"]["names"]
    opening, height = state[:, told.index("qpos.tool_opening")], state[:, told.index("tcp_pose.tool_z")]
    begins = [0, *(np.flatnonzero(names[1:] != names[:-1]) + 1), len(names) - 1]
    stretches = list(zip(names[begins[:-1]], begins, begins[1:], strict=False))  # each ends where the next one begins
    assert [name for name, *_ in stretches[:5]] == ["reach", "grasp", "lift", "place", "retreat"]
    assert {name for name, *_ in stretches} <= {"reach", "grasp", "lift", "place", "retreat", "none"}
    for name, begin, end in stretches:
        by = opening[end] - opening[begin]
        if name == "grasp":
            assert by < -3e-3, "the fingers close"
        elif name == "lift":
            assert height[end] > height[begin] + 0.04 and abs(by) < 2e-3, "what they hold comes up"
        elif name == "place":
            assert by > 3e-3 and height[end] < height[begin : end + 1].max() - 0.01, "it goes down and is let go"
        elif name == "retreat":
            assert height[end] > height[begin] and by > -2e-3, "the open hand goes up"


def test_many_files_when_they_are_full(short_file, tmp_path, monkeypatch):
    """With limits that one episode fills, each stands in files of its own, from their begin on."""
    from marketgen.recording import dataset

    monkeypatch.setattr(dataset, "MEGABYTE", 20)
    monkeypatch.setattr(dataset, "CHUNK_FILES", 2)
    monkeypatch.setattr(dataset, "ROWS_AT_ONCE", 1)
    marketgen.record(short_file, tmp_path / "many", sways, size=SIZE, cameras=["scene_camera"])
    data = Reader(tmp_path / "many")
    key = "videos/observation.images.scene_camera"
    for kind in ("data", key, "meta/episodes"):
        places = [(row[f"{kind}/chunk_index"], row[f"{kind}/file_index"]) for row in data.episodes]
        assert places == [(0, 0), (0, 1), (1, 0)], kind
    assert [row[f"{key}/from_timestamp"] for row in data.episodes] == [0, 0, 0]
    assert [len(data.video(number, "scene_camera")) for number in range(3)] == [row["length"] for row in data.episodes]
    assert data.column("index").tolist() == list(range(data.info["total_frames"]))


def door(*words):
    command = [sys.executable, "-m", "marketgen.record", *map(str, words)]
    return subprocess.run(command, env={**os.environ, "PYTHONPATH": PACKAGE}, capture_output=True, text=True, timeout=120)


def test_the_command_records_numbers_alone_and_checks_them(short_file, tmp_path):
    folder = tmp_path / "numbers"
    done = door(short_file, "-o", folder, "--policy", "stop", "--cameras", "none", "--shard", "2/2")
    assert done.returncode == 0 and "1 episodes, 0 of them successful" in done.stdout and "an hour" in done.stdout, done.stderr
    data = Reader(folder)
    assert data.info["video_path"] is None and data.episodes[0]["failure"] and not (folder / "videos").exists()
    done = door(short_file, "--check", folder)
    assert done.returncode == 0 and "bit for bit" in done.stdout, done.stderr
    done = door(short_file, "-o", folder)
    assert done.returncode == 2 and "error[store.exists]" in done.stderr


def test_randomized_worlds_are_others_and_come_again(short_file, tmp_path):
    """Domain randomisation: the same file and seed, other masses, friction and places in each episode, and again the same ones."""
    folder, plain = tmp_path / "randomized", tmp_path / "plain"
    marketgen.record(short_file, folder, "random", realism="randomized", cameras=())
    marketgen.record(short_file, plain, "random", cameras=())
    assert json.loads((folder / "meta/marketgen.json").read_text())["realism"] == "randomized"
    ends = [{row["episode_id"]: row["state_hash"] for row in Reader(root).episodes} for root in (folder, plain)]
    assert ends[0].keys() == ends[1].keys() and all(ends[0][name] != ends[1][name] for name in ends[0])
    assert marketgen.replay_check(folder, short_file) == sum(row["length"] for row in Reader(folder).episodes)


@pytest.mark.parametrize(
    ("argument", "value"),
    [
        ("episodes", 3),
        ("folder", 3),
        ("policy", 3),
        ("policy", "oracel"),
        ("cameras", ["head_camera"]),
        ("cameras", "scene_camera"),
        ("size", (65, 64)),
        ("size", 64),
        ("quality", "ultra"),
        ("control_mode", "torque"),
        ("realism", "standart"),
        ("codec", "vp9"),
        ("success_only", "yes"),
        ("count", -1),
        ("shard", "3/2"),
        ("resume", "yes"),
        ("progress", 3),
    ],
    ids=str,
)
def test_bad_arguments_are_named_and_leave_nothing(short_file, tmp_path, argument, value):
    given = {"episodes": short_file, "folder": tmp_path / "none", "size": SIZE, argument: value}
    with pytest.raises(marketgen.Error) as caught:
        marketgen.record(**given)
    assert argument in str(caught.value), caught.value
    assert list(tmp_path.iterdir()) == []


def test_the_oracle_refuses_modes_of_the_tool(short_file, tmp_path):
    with pytest.raises(marketgen.Error, match="pd_joint_pos"):
        marketgen.record(short_file, tmp_path / "none", control_mode="pd_ee_delta_pose")


def test_what_a_policy_raises_is_raised(short_file, tmp_path):
    def fails(observation):
        raise KeyError("where is it?")

    with pytest.raises(marketgen.Error, match="where is it") as caught:
        marketgen.record(short_file, tmp_path / "none", fails, size=SIZE)
    assert caught.value.code == "episode.policy_failed" and list(tmp_path.iterdir()) == []


def test_a_folder_that_cannot_be_written_is_said(short_file, tmp_path):
    (tmp_path / "file").write_text("")
    with pytest.raises(marketgen.Error, match="file") as caught:
        marketgen.record(short_file, tmp_path / "file" / "dataset", sways, size=SIZE)
    assert caught.value.code == "io.cannot_write"


def test_two_do_not_record_into_one_folder(short_file, tmp_path):
    import fcntl

    unfinished = tmp_path / "one.unfinished"
    unfinished.mkdir()
    with open(unfinished / ".lock", "w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        with pytest.raises(marketgen.Error) as caught:
            marketgen.record(short_file, tmp_path / "one", sways, size=SIZE)
    assert caught.value.code == "io.in_use"


def test_what_is_not_installed_is_named(short_file, tmp_path, monkeypatch):
    import importlib.util

    found = importlib.util.find_spec
    monkeypatch.setattr(importlib.util, "find_spec", lambda name: None if name == "pyarrow" else found(name))
    with pytest.raises(marketgen.Error, match=r"pip install 'marketgen\[lerobot\]'") as caught:
        marketgen.record(short_file, tmp_path / "none", sways)
    assert caught.value.code == "usage.unavailable" and caught.value.where == "pyarrow"
    with pytest.raises(marketgen.Error, match=r"marketgen\[lerobot\]"):
        marketgen.replay_check(tmp_path / "none", short_file)


def test_nothing_of_that_is_needed_before():
    program = "import sys; sys.modules |= dict.fromkeys(('pyarrow', 'av', 'gymnasium')); import marketgen, marketgen.record as door; door.main(['--help'])"
    done = subprocess.run([sys.executable, "-c", program], env={**os.environ, "PYTHONPATH": PACKAGE}, capture_output=True, text=True, timeout=60)
    assert done.returncode == 0 and "LeRobot" in done.stdout, done.stderr


def test_importing_the_module_leaves_the_function_callable():
    program = "import marketgen.record; marketgen.record('nowhere.jsonl', 'dataset')"
    ended = subprocess.run([sys.executable, "-c", program], env={**os.environ, "PYTHONPATH": PACKAGE}, capture_output=True, text=True, timeout=60)
    assert "input.not_found nowhere.jsonl" in ended.stderr, ended.stderr
