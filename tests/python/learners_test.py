"""Scripts for learners run on the environments as they are: CleanRL's, and Gymnasium's wrappers."""

import sys
import types

import gymnasium as gym
import numpy as np
import pytest

import marketgen  # noqa: F401  registers the environments

FIRST, COUNTER, AISLE = "CheckoutOneItem", "CheckoutUnloading", "InAisleCollection"
STAGES = ("DriveToProduct", "PickFromShelf", "PlaceInBasket", "OpenCooler")


def named(task):
    return f"MarketGen/{task}-v1"


def make_env(env_id, idx, capture_video, run_name, gamma):
    """The wrappers of CleanRL's ppo_continuous_action.py, in its order; TransformObservation asks for the space since Gymnasium 1.0."""

    def thunk():
        if capture_video and idx == 0:
            env = gym.make(env_id, render_mode="rgb_array")
            env = gym.wrappers.RecordVideo(env, f"videos/{run_name}")
        else:
            env = gym.make(env_id)
        env = gym.wrappers.FlattenObservation(env)
        env = gym.wrappers.RecordEpisodeStatistics(env)
        env = gym.wrappers.ClipAction(env)
        env = gym.wrappers.NormalizeObservation(env)
        env = gym.wrappers.TransformObservation(env, lambda obs: np.clip(obs, -10, 10), env.observation_space)
        env = gym.wrappers.NormalizeReward(env, gamma=gamma)
        env = gym.wrappers.TransformReward(env, lambda reward: np.clip(reward, -10, 10))
        return env

    return thunk


@pytest.mark.parametrize("task", [FIRST, *(pytest.param(stage, marks=pytest.mark.slow) for stage in STAGES)])
def test_a_rollout_of_cleanrl(task):
    envs = gym.vector.SyncVectorEnv([make_env(named(task), i, False, "run", 0.99) for i in range(2)])
    assert isinstance(envs.single_action_space, gym.spaces.Box), "only continuous action space is supported"
    rng = np.random.default_rng(1)
    seen, _ = envs.reset(seed=1)
    returns = []
    for _ in range(160):
        action = rng.normal(size=envs.action_space.shape).astype(np.float32)
        seen, reward, terminations, truncations, infos = envs.step(action)
        assert np.isfinite(seen).all() and np.isfinite(reward).all()
        returns += list(infos["episode"]["r"][infos["_episode"]]) if "episode" in infos else []
    assert len(returns) >= 2, "episodes ended, and the wrapper counted them"


@pytest.mark.parametrize("task", [COUNTER, AISLE])
def test_the_whole_tasks_become_one_row(task):
    env = gym.wrappers.FlattenObservation(gym.make(named(task)))
    seen, _ = env.reset(seed=1)
    assert seen.ndim == 1 and env.observation_space.contains(seen)
    assert env.step(env.action_space.sample())[0].shape == seen.shape


@pytest.mark.parametrize(("task", "options"), [(FIRST, {}), (COUNTER, {"stop_action": False}), ("DriveToProduct", {})])
def test_videos_of_episodes(task, options, tmp_path, monkeypatch):
    """RecordVideo's own frames; what makes a file of them is MoviePy, which may not be installed."""
    films = []

    class Clip:
        def __init__(self, frames, fps):
            self.frames, self.fps = frames, fps

        def write_videofile(self, path, logger=None):
            films.append((path, self.fps, np.array(self.frames)))

    for name in ("moviepy", "moviepy.video", "moviepy.video.io", "moviepy.video.io.ImageSequenceClip"):
        monkeypatch.setitem(sys.modules, name, types.ModuleType(name))
    sys.modules["moviepy.video.io.ImageSequenceClip"].ImageSequenceClip = Clip
    env = gym.make(named(task), **options, render_mode="rgb_array", render_size=(64, 48))
    env = gym.wrappers.RecordVideo(env, str(tmp_path / "films"), episode_trigger=lambda _: True, video_length=4, disable_logger=True)
    env.action_space.seed(1)
    env.reset(seed=1)
    for _ in range(6):
        env.step(env.action_space.sample())
    env.close()
    [(path, fps, frames)] = films
    assert path.endswith(".mp4") and fps == env.metadata["render_fps"]
    assert frames.shape == (5, 48, 64, 3), "the reset's and one of each step"
    assert frames.std() > 10
    assert any((frame != frames[0]).any() for frame in frames[1:]), "something moves"


def test_a_film_by_moviepy(tmp_path):
    pytest.importorskip("moviepy")
    env = gym.make(named(FIRST), render_mode="rgb_array", render_size=(64, 48))
    env = gym.wrappers.RecordVideo(env, str(tmp_path / "films"), video_length=4, disable_logger=True)
    env.action_space.seed(1)
    env.reset(seed=1)
    for _ in range(6):
        env.step(env.action_space.sample())
    env.close()
    [film] = tmp_path.glob("films/*.mp4")
    assert film.stat().st_size > 1000


@pytest.mark.parametrize("task", [FIRST, *STAGES])
def test_stable_baselines_has_no_complaint_and_learns(task, recwarn):
    sb3 = pytest.importorskip("stable_baselines3")
    from stable_baselines3.common.env_checker import check_env
    from stable_baselines3.common.env_util import make_vec_env

    check_env(gym.make(named(task)).unwrapped)
    assert not [str(each.message) for each in recwarn if "stable_baselines3" in each.filename]
    model = sb3.PPO("MlpPolicy", make_vec_env(named(task), n_envs=2, seed=1), n_steps=32, batch_size=32, device="cpu", seed=1)
    assert model.learn(64).num_timesteps == 64
