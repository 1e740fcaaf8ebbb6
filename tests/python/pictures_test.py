"""Pictures from Python: planes, cameras, annotations, batches, moved things; judged by NumPy and Pillow."""

import json
import os
import pathlib
import signal
import subprocess
import sys
import time

import numpy as np
import pytest
from PIL import Image

import marketgen
from conftest import run


def picture(renderer, camera, **options):
    return renderer.render(camera, quality="fast", **options)


def test_planes_have_shapes_and_are_the_programs(store, renderer, tmp_path):
    camera = store.camera("aisle", 96, 64)
    frame = picture(renderer, camera)
    assert frame.rgb.shape == (64, 96, 3) and frame.rgb.dtype == np.uint8
    assert frame.depth.shape == (64, 96) and frame.depth.dtype == np.float32
    assert frame.instance.dtype == np.uint32 and frame.matter.dtype == np.uint8
    assert np.allclose(np.linalg.norm(frame.normals[frame.depth > 0], axis=-1), 1, atol=1e-3)
    assert frame.radiance is None
    run("render", store.folder, "--camera", "aisle", "--size", "96x64", "--quality", "fast", "-o", tmp_path / "a.png",
        "--depth", tmp_path / "a.npy", "--quiet")
    frame.save(str(tmp_path / "b.png"))
    assert np.array_equal(np.asarray(Image.open(tmp_path / "a.png")), frame.rgb)
    assert np.array_equal(np.asarray(Image.open(tmp_path / "b.png")), frame.rgb)
    assert np.array_equal(np.load(tmp_path / "a.npy"), frame.depth)


def test_planes_outlive_their_frame(store, renderer):
    rgb = picture(renderer, store.camera("aisle", 64, 48)).rgb
    kept = rgb.copy()
    for _ in range(3):
        picture(renderer, store.camera("entrance", 64, 48))
    assert np.array_equal(rgb, kept)


def test_path_mode_has_radiance(store, renderer):
    frame = renderer.render(store.camera("aisle", 48, 32), mode="path", samples=2, denoise="none")
    assert frame.radiance.shape == (32, 48, 3) and np.isfinite(frame.radiance).all()


def test_cameras_agree_with_numpy(store):
    camera = marketgen.Camera.look_at((3, 1, 1.5), (3, 4, 1.0), fov_deg=60, width=64, height=48)
    focal = 24 / np.tan(np.radians(30))
    assert np.allclose(camera.intrinsic_cv, [[focal, 0, 31.5], [0, focal, 23.5], [0, 0, 1]])
    ahead = np.array([0, 3, -0.5]) / np.hypot(3, 0.5)
    assert np.allclose(camera.extrinsic_cv[2, :3], ahead)
    assert np.allclose(camera.extrinsic_cv @ [3, 1, 1.5, 1], [0, 0, 0, 1])
    flip = np.diag([1, -1, -1, 1])
    assert np.allclose(camera.cam2world_gl, np.linalg.inv(camera.extrinsic_cv) @ flip)
    again = marketgen.camera_from_dict(marketgen.camera_to_dict(camera))
    assert np.allclose(again.extrinsic_cv, camera.extrinsic_cv)
    assert np.allclose(again.intrinsic_cv, camera.intrinsic_cv)


def test_annotations_are_the_programs_and_fit_the_planes(store, renderer, tmp_path):
    camera = store.camera("aisle", 160, 120)
    frame = picture(renderer, camera)
    annotations = renderer.annotate(frame, camera)
    run("render", store.folder, "--camera", "aisle", "--size", "160x120", "--quality", "fast", "-o", tmp_path / "a.png",
        "--annotations", tmp_path / "a.json", "--quiet")
    assert annotations == json.loads((tmp_path / "a.json").read_text())
    rows = store.query("products")
    places = {row["id"]: (row["x_m"], row["y_m"], row["z_m"]) for row in rows}
    products = [thing for thing in annotations["objects"] if thing["kind"] == "product"]
    assert len(products) > 20
    for thing in products:
        mask = frame.instance == thing["id"]
        assert mask.sum() == thing["pixels"]
        ys, xs = np.nonzero(mask)
        assert thing["box_px"] == [xs.min(), ys.min(), xs.max() + 1, ys.max() + 1]
        seen = camera.extrinsic_cv @ [*places[thing["name"]], 1]
        assert np.allclose(seen[:3], thing["camera_from_object"]["position_m"], atol=2e-3)


def test_moved_products_are_drawn_and_annotated_where_they_are(store, unmoved):
    camera = marketgen.Camera.look_at((4.5, 1.0, 1.2), (4.5, 1.6, 1.0), width=120, height=90)
    before = picture(unmoved, camera)
    unmoved.move({0: (4.5, 1.6, 1.0, 1, 0, 0, 0)})
    after = picture(unmoved, camera)
    row = store.query("products")[0]
    thing = next(t for t in unmoved.annotate(after, camera)["objects"] if t["name"] == row["id"])
    assert not (before.instance == thing["id"]).any()
    middle = after.instance[30:60, 45:75] == thing["id"]
    assert middle.any()
    expected = camera.extrinsic_cv @ [4.5, 1.6, 1.0, 1]
    assert np.allclose(thing["camera_from_object"]["position_m"], expected[:3], atol=1e-4)
    unmoved.move()
    assert np.array_equal(picture(unmoved, camera).rgb, before.rgb)


def test_robots_stand_in_pictures(store, unmoved):
    camera = store.camera("aisle", 96, 64)
    before = picture(unmoved, camera)
    at = camera.cam2world_gl[:3, 3] - 2.0 * camera.cam2world_gl[:3, 2]
    unmoved.set_robots([f"realman-rm65@{at[0]:.2f},{at[1]:.2f}"])
    with_robot = picture(unmoved, camera)
    assert (with_robot.instance != before.instance).mean() > 0.02
    names = {t["name"] for t in unmoved.annotate(with_robot, camera)["objects"] if t["kind"] == "actor"}
    assert names == {"realman-rm65"}
    with pytest.raises(marketgen.Error) as caught:
        unmoved.set_robots(["realman-rm66@4,3"])
    assert caught.value.code == "robot.unknown"


def test_people_stand_in_pictures(store, unmoved):
    camera = store.camera("top", 192, 128)
    before = picture(unmoved, camera)
    unmoved.set_people(3, 12.5)
    seen = picture(unmoved, camera)
    assert (seen.instance != before.instance).any()
    found = [t for t in unmoved.annotate(seen, camera)["objects"] if t["kind"] == "actor"]
    assert {t["name"] for t in found} <= {"person", "person-2", "person-3"} and found
    assert {t["category"] for t in found} == {"person"}
    unmoved.set_people(3, 12.5)
    assert np.array_equal(picture(unmoved, camera).rgb, seen.rgb)
    with pytest.raises(marketgen.Error) as caught:  # a shop of 9 x 7 m
        unmoved.set_people(200)
    assert caught.value.code == "people.no_room"
    unmoved.set_people(0)
    assert np.array_equal(picture(unmoved, camera).rgb, before.rgb)


def test_batches_are_single_pictures(store, renderer):
    cameras = [store.camera(name, 64, 48) for name in ("aisle", "entrance", "aisle")]
    rgb = np.zeros((3, 48, 64, 3), np.uint8)
    depth = np.zeros((3, 48, 64), np.float32)
    marketgen.render_batch([(renderer, camera) for camera in cameras], rgb=rgb, depth=depth)
    for i, camera in enumerate(cameras):
        alone = picture(renderer, camera)
        assert np.array_equal(rgb[i], alone.rgb)
        assert np.array_equal(depth[i], alone.depth)


def test_batches_refuse_wrong_memory(store, renderer):
    shots = [(renderer, store.camera("aisle", 64, 48))]
    with pytest.raises(marketgen.Error) as caught:
        marketgen.render_batch(shots, rgb=np.zeros((1, 48, 60, 3), np.uint8))
    assert caught.value.code == "camera.bad_size"
    with pytest.raises(marketgen.Error, match="rgb.*uint8"):
        marketgen.render_batch(shots, rgb=np.zeros((1, 48, 64, 3), np.float32))
    with pytest.raises(marketgen.Error, match="contiguous"):  # not contiguous: a copy would be filled
        marketgen.render_batch(shots, rgb=np.zeros((1, 48, 128, 3), np.uint8)[:, :, ::2])


def test_noise_is_seeded(store, renderer):
    camera = store.camera("aisle", 96, 64)
    frame = picture(renderer, camera)
    noisy = renderer.with_noise(frame, camera, seed=3)
    assert np.array_equal(noisy.depth, renderer.with_noise(frame, camera, seed=3).depth, equal_nan=True)
    assert not np.array_equal(noisy.depth, renderer.with_noise(frame, camera, seed=4).depth)
    assert not np.array_equal(noisy.rgb, frame.rgb)


@pytest.mark.parametrize(
    ("code", "make"),
    [
        ("camera.degenerate", lambda: marketgen.Camera.look_at((1, 1, 1), (1, 1, 1))),
        ("camera.degenerate", lambda: marketgen.Camera.look_at((float("nan"), 1, 1), (2, 1, 1))),
        ("camera.bad_size", lambda: marketgen.Camera.look_at((1, 1, 1), (2, 1, 1), width=0)),
        ("camera.bad_size", lambda: marketgen.Camera.look_at((1, 1, 1), (2, 1, 1), width=32768, height=32768)),
        ("json.missing_field", lambda: marketgen.camera_from_dict({"width": 64})),
    ],
)
def test_bad_cameras_are_said(code, make):
    with pytest.raises(marketgen.Error) as caught:
        make()
    assert caught.value.code == code


def test_unknown_names_and_bad_moves_are_said(store, unmoved):
    camera = store.camera("aisle", 64, 48)
    with pytest.raises(marketgen.Error, match="fast, balanced, best"):
        unmoved.render(camera, quality="ultra")
    with pytest.raises(marketgen.Error) as caught:
        unmoved.move({10**8: (0, 0, 0, 1, 0, 0, 0)})
    assert caught.value.code == "render.bad_move"


def test_ctrl_c_ends_a_long_picture(store):
    program = (
        "import marketgen, sys\n"
        f"store = marketgen.open_store({store.folder!r})\n"
        "renderer = store.renderer()\n"
        "print('drawing', flush=True)\n"
        "try:\n"
        "    renderer.render(store.camera('aisle', 1280, 720), mode='path', samples=5000)\n"
        "except KeyboardInterrupt:\n"
        "    print('interrupted', flush=True)\n"
        "print(renderer.render(store.camera('aisle', 32, 24)).rgb.mean() > 0)\n"
    )
    child = subprocess.Popen([sys.executable, "-c", program], stdout=subprocess.PIPE, text=True)
    assert child.stdout.readline() == "drawing\n"
    time.sleep(1.0)
    child.send_signal(signal.SIGINT)
    said, _ = child.communicate(timeout=60)
    assert said == "interrupted\nTrue\n"
    assert child.returncode == 0
