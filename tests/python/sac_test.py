"""examples/sac.py: its slopes are those of what it computes, it learns what is easy, and it takes every stage as it is."""

import pathlib
import sys

import gymnasium
import numpy as np
import pytest
from gymnasium import spaces

import marketgen  # noqa: F401  (registers the environments)

sys.path.insert(0, str(pathlib.Path(__file__).parents[2] / "examples"))
import sac

STAGES = ("DriveToProduct", "PickFromShelf", "PlaceInBasket", "OpenCooler")


class ToThePoint(gymnasium.Env):
    """A point in a square is to go to its middle."""

    observation_space, action_space = spaces.Box(-1, 1, (2,), np.float32), spaces.Box(-1, 1, (2,), np.float32)

    def reset(self, *, seed=None, options=None):
        super().reset(seed=seed)
        self.at, self.steps = self.np_random.uniform(-1, 1, 2), 0
        return self.at.astype(np.float32), {}

    def step(self, action):
        before = np.abs(self.at).sum()
        self.at, self.steps = np.clip(self.at + 0.2 * action, -1, 1), self.steps + 1
        return self.at.astype(np.float32), float(before - np.abs(self.at).sum()), False, self.steps == 15, {}


def test_slopes_are_those_of_differences():
    rng = np.random.default_rng(0)
    nets = sac.Nets(2, 5, 3, 8, rng)
    nets.weights = nets.weights.astype(np.float64)
    nets.parts = nets._parts(nets.weights)
    seen, slope = rng.normal(size=(2, 4, 5)), rng.normal(size=(2, 4, 3))

    def value():
        return float((nets.forward(seen) * slope).sum())

    def by_difference(row, place, step=1e-6):
        was = row[place]
        row[place] = was + step
        more = value()
        row[place] = was - step
        less = value()
        row[place] = was
        return (more - less) / (2 * step)

    value()
    of_weights, of_seen = nets.backward(slope)
    assert np.allclose(of_weights, [by_difference(nets.weights, place) for place in range(len(nets.weights))], atol=1e-6)
    assert np.allclose(of_seen.ravel(), [by_difference(seen.reshape(-1), place) for place in range(seen.size)], atol=1e-6)


def test_it_learns_to_go_to_a_point():
    env, learner = ToThePoint(), sac.Sac(2, 2, seed=1, width=32)

    def left():
        far = []
        for seed in range(20):
            seen, over = env.reset(seed=seed)[0], False
            while not over:
                seen, _, _, over, _ = env.step(learner.act(seen))
            far.append(np.abs(env.at).sum())
        return np.mean(far)

    assert left() > 1
    learner.learn(ToThePoint(), 2000)
    assert left() < 0.05


@pytest.mark.parametrize("name", STAGES)
def test_it_learns_from_every_stage_and_again_alike(name, tmp_path):
    rows = []
    for seed in (1, 1, 2):
        env = gymnasium.make(f"MarketGen/{name}-v1")
        [seen], [moves] = env.observation_space.shape, env.action_space.shape
        learner = sac.Sac(seen, moves, seed=seed, random_steps=12, batch=16, width=16)
        before = learner.actor.weights.copy()
        learner.learn(env, 16)
        assert learner.steps == 16 and np.isfinite(learner.actor.weights).all()
        assert np.abs(learner.actor.weights - before).max() > 1e-4
        rows.append(learner.act(env.reset(seed=9)[0]))
        assert (np.abs(rows[-1]) <= 1).all()
    assert np.array_equal(rows[0], rows[1]) and not np.array_equal(rows[0], rows[2])
    learner.save(tmp_path / "policy.npz")
    assert np.array_equal(sac.load(tmp_path / "policy.npz")(env.reset(seed=9)[0]), rows[2])
