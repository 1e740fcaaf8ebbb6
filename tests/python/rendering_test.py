"""Pictures of environments for people: their size and camera are arguments, and Gymnasium's recorders get what they expect."""

import gymnasium
import numpy as np
import pytest
from gymnasium.wrappers import RenderCollection

import marketgen
from conftest import same

NAME = "MarketGen/CheckoutUnloading-v1"


@pytest.fixture
def options(checkout_file):
    return {"episodes": checkout_file, "render_mode": "rgb_array"}


def acted(env):
    action = np.zeros(env.action_space.shape, np.float32)
    action[..., 0], action[..., -1] = 1, -1
    return env.step(action)


def test_size_and_camera_are_arguments(options):
    usual = gymnasium.make(NAME, **options)
    usual.reset(options={"episode": 0})
    assert usual.render().shape == (480, 640, 3) and usual.render().dtype == np.uint8
    pictures = {}
    for camera in ("film_camera", "scene_camera", "wrist_camera"):
        env = gymnasium.make(NAME, render_size=(96, 64), render_camera=camera, **options)
        env.reset(options={"episode": 0})
        pictures[camera] = env.render()
        assert pictures[camera].shape == (64, 96, 3) and pictures[camera].std() > 5
    assert not same(pictures["scene_camera"], pictures["wrist_camera"])


def test_nothing_is_drawn_without_a_mode(checkout_file):
    env = gymnasium.make(NAME, episodes=checkout_file, disable_env_checker=True)
    env.reset(options={"episode": 0})
    assert env.unwrapped.render() is None


def test_a_recorder_gets_a_picture_a_step(options):
    env = RenderCollection(gymnasium.make(NAME, render_size=(64, 48), **options), reset_clean=False)
    env.reset(options={"episode": 0})
    for _ in range(3):
        acted(env)
    film = env.render()
    assert len(film) == 4 and {picture.shape for picture in film} == {(48, 64, 3)}
    assert not same(film[0], film[-1]), "the arm has moved"
    assert env.metadata["render_fps"] == 20


def test_gymnasiums_own_list_of_pictures(checkout_file):
    env = gymnasium.make(NAME, episodes=checkout_file, render_mode="rgb_array_list", render_size=(32, 24))
    env.reset(options={"episode": 0})
    acted(env)
    assert [picture.shape for picture in env.render()] == [(24, 32, 3)] * 2


def test_many_are_drawn_as_each_alone(options):
    many = marketgen.make_vec("CheckoutUnloading-v1", 2, render_size=(48, 32), **options)
    assert isinstance(many, marketgen.environments.CheckoutUnloadingVector) and many.num_envs == 2
    many.reset(seed=3)
    pictures = many.render()
    assert [picture.shape for picture in pictures] == [(32, 48, 3)] * 2
    alone = gymnasium.make(NAME, render_size=(48, 32), **options)
    alone.reset(seed=4)
    assert same(pictures[1], alone.render())


def test_a_window_is_refused_with_the_way(checkout_file):
    with pytest.raises(marketgen.Error, match="no window.*rgb_array") as caught:
        marketgen.environments.CheckoutUnloading(episodes=checkout_file, render_mode="human")
    assert caught.value.where == "render_mode"
