"""An environment's page: what it is sent is where the world's things are."""

import base64
import copy
import json
import os
import socket
import struct
import urllib.parse
import urllib.request

import gymnasium
import numpy as np
import pytest

import marketgen

NAME = "MarketGen/CheckoutUnloading-v1"
TEXT, BINARY = 1, 2
ARRAYS = {"f32": np.float32, "i16": np.int16, "u32": np.uint32}


@pytest.fixture
def env(store):
    made = gymnasium.make(NAME, store=store).unwrapped
    made.reset(seed=3)
    return made


def answer(view, path):
    origin = view.address.split("?")[0]
    with urllib.request.urlopen(origin + path, timeout=60) as got:
        return got.read(), got.headers


class Looker:
    """A page's websocket."""

    def __init__(self, view):
        place = urllib.parse.urlsplit(view.address)
        self._socket = socket.create_connection((place.hostname, place.port), timeout=60)
        key = base64.b64encode(os.urandom(16)).decode()
        head = [
            "GET /api/stores/0/drive/socket HTTP/1.1", f"Host: {place.netloc}", f"Origin: http://{place.netloc}",
            "Upgrade: websocket", "Connection: Upgrade", "Sec-WebSocket-Version: 13", f"Sec-WebSocket-Key: {key}", "", "",
        ]
        self._socket.sendall("\r\n".join(head).encode())
        self._stream = self._socket.makefile("rb")
        assert b" 101 " in self._stream.readline()
        while self._stream.readline().strip():
            pass

    def close(self):
        self._stream.close()
        self._socket.close()

    def frame(self):
        first, length = self._stream.read(2)
        if length == 126:
            length = struct.unpack(">H", self._stream.read(2))[0]
        elif length == 127:
            length = struct.unpack(">Q", self._stream.read(8))[0]
        return first & 15, self._stream.read(length)

    def moment(self, step):
        """The message of that step: its head, and the poses as 4 x 4."""
        while True:
            kind, data = self.frame()
            if kind != BINARY:
                continue
            head_bytes = struct.unpack_from("<I", data, 4)[0]
            head = json.loads(data[8 : 8 + head_bytes])
            if head["step"] != step:
                continue
            arrays = {}
            for name, section in head["sections"].items():
                kind = np.dtype(ARRAYS[section["type"]])
                count = section["count"] * section["components"]
                arrays[name] = np.frombuffer(data, kind, count, 8 + head_bytes + section["offset"]).reshape(section["count"], section["components"])
            return head, poses_of(arrays["position"], arrays["rotation"][:, [3, 0, 1, 2]] / 32767)


def poses_of(positions, quaternions):
    """Of rows x, y, z and w, x, y, z."""
    w, x, y, z = np.asarray(quaternions, float).T
    poses = np.zeros((len(positions), 4, 4))
    poses[:, 0] = np.stack([1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y), positions[:, 0]], 1)
    poses[:, 1] = np.stack([2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x), positions[:, 1]], 1)
    poses[:, 2] = np.stack([2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y), positions[:, 2]], 1)
    poses[:, 3, 3] = 1
    return poses


def test_the_page_is_that_of_the_episode(env, store):
    with env.show(height=480) as view:
        page, headers = answer(view, "")
        assert b"<html" in page and "http://localhost:*" in headers["Content-Security-Policy"]
        assert f"<iframe src='{view.address.replace('&', '&amp;')}'" in view._repr_html_() and "height:480px" in view._repr_html_()
        told = json.loads(answer(view, "api/stores/0/drive")[0])
        assert (told["phase"], told["watched"]) == ("driving", True)
        assert told["episode"]["id"] == env.episode["id"] and told["episode"]["instruction"] == env.episode["instruction"]
        assert answer(view, "api/stores/0/drive/robot.bin")[0]
        env.reset(seed=4)
        again = json.loads(answer(view, "api/stores/0/drive")[0])
        assert again["episode"]["id"] == env.episode["id"] != told["episode"]["id"]
        assert again["generation"] > told["generation"]
    assert view.closed
    env.step(np.zeros(env.action_space.shape, np.float32))  # nobody looks on


def test_what_is_sent_is_where_things_are(env):
    with env.show() as view:
        looker = Looker(view)
        first_of_tool = next(i for i, name in enumerate(env.robot_names) if name.startswith("tcp_pose"))
        action = np.zeros(env.action_space.shape, np.float32)
        action[0], action[-1] = 1, -1
        tools, places, from_bodies = [], [], []
        for steps in (0, 12):
            for _ in range(steps):
                env.step(action)
            head, poses = looker.moment(steps)
            base, things = poses[0], poses[head["bodies"] :]
            assert len(things) == head["things"]
            items = np.array([item["pose"] for item in env.items()])
            placed = base @ poses_of(items[:, :3], items[:, 3:])
            near = np.linalg.norm(things[:, None, :3, 3] - placed[None, :, :3, 3], axis=2).min(axis=0)
            assert near.max() < 0.003  # metres: turns are sent as 16 bits
            tool = env.robot_numbers()[first_of_tool : first_of_tool + 3].astype(float)
            in_base = (np.linalg.inv(base) @ poses[: head["bodies"]])[:, :3, 3]
            tools.append(tool)
            places.append(in_base)
            from_bodies.append(np.linalg.norm(in_base - tool, axis=1))
        # The tool has moved, and the link that carries it with it.
        assert np.linalg.norm(tools[1] - tools[0]) > 0.02
        apart = np.abs(from_bodies[1] - from_bodies[0])
        apart[from_bodies[0] > 0.3] = np.inf
        carrier = apart.argmin()
        assert apart[carrier] < 0.001
        assert np.linalg.norm(places[1][carrier] - places[0][carrier]) > 0.01
        looker.close()


def test_nobody_drives_there(env):
    with env.show() as view:
        request = urllib.request.Request(
            view.address.split("?")[0] + "api/stores/0/drive/begin", b"{}", {"Content-Type": "application/json"}
        )
        with pytest.raises(urllib.error.HTTPError) as caught:
            urllib.request.urlopen(request, timeout=60)
        assert caught.value.code in (403, 405)
        looker = Looker(view)
        seat = next(json.loads(data) for kind, data in iter(looker.frame, None) if kind == TEXT)
        assert (seat["kind"], seat["drives"], seat["taken"]) == ("you", False, True)
        looker.close()


def test_what_cannot_be_shown_is_said(store, checkout_file, tmp_path):
    env = gymnasium.make(NAME, store=store).unwrapped
    with pytest.raises(marketgen.Error) as caught:
        env.show()
    assert caught.value.code == "episode.bad_action"
    of_file = gymnasium.make(NAME, episodes=checkout_file).unwrapped
    of_file.reset(seed=0)
    with pytest.raises(marketgen.Error) as caught:
        of_file.show()
    assert (caught.value.code, caught.value.where) == ("usage.bad_flag", "store")
    with of_file.show(store=store.folder) as view:
        assert json.loads(answer(view, "api/stores/0/drive")[0])["episode"]["id"] == of_file.episode["id"]
    other = marketgen.generate("a kiosk with snacks", tmp_path / "kiosk", seed=2, size="5x5m")
    with pytest.raises(marketgen.Error) as caught:
        of_file.show(store=other)
    assert caught.value.code == "episode.other_store"


def test_a_view_goes_with_its_environment_and_not_with_copies(env):
    with env.show() as view:
        other = copy.copy(env)
        before = json.loads(answer(view, "api/stores/0/drive")[0])["generation"]
        other.step(np.zeros(env.action_space.shape, np.float32))
        assert json.loads(answer(view, "api/stores/0/drive")[0])["generation"] == before
        state = env.get_state()
        env.step(np.zeros(env.action_space.shape, np.float32))
        env.set_state(state)
        assert json.loads(answer(view, "api/stores/0/drive")[0])["generation"] == before + 1
    with env.show() as one:
        with env.show() as two:
            assert one.closed and not two.closed
