"""Soft actor-critic (Haarnoja et al. 2018) in nothing but NumPy, for the few numbers of a stage: see ppo_pick.py.

    learner = Sac(env.observation_space.shape[0], env.action_space.shape[0], seed=1)
    learner.learn(env, 1000)
    action = learner.act(observation)

Two critics with layers that are normalized (without it what they say of actions not tried yet runs away), an entropy that is held at
minus the number of actions. Networks of this size are learned several times faster so than by a library that is made for large ones.
"""

import numpy as np

DEFAULTS = {
    "width": 128, "batch": 128, "gamma": 0.95, "rate": 5e-4, "tau": 0.01, "updates": 2, "random_steps": 300, "entropy": 0.1, "times": 10.0,
}  # fmt: skip
MAX_LOG_STD, MIN_LOG_STD = 2.0, -10.0


class Adam:
    def __init__(self, weights, rate):
        self.weights, self.rate, self.steps = weights, rate, 0
        self.mean, self.square = np.zeros_like(weights), np.zeros_like(weights)

    def step(self, slope):
        self.steps += 1
        self.mean += 0.1 * (slope - self.mean)
        self.square += 0.001 * (slope * slope - self.square)
        size = self.rate * np.sqrt(1 - 0.999**self.steps) / (1 - 0.9**self.steps)
        self.weights -= np.float32(size) * self.mean / (np.sqrt(self.square) + np.float32(1e-8))


class Nets:
    """So many networks side by side, each of two hidden layers: numbers in (count, batch, inputs) to numbers out. All weights are parts
    of one row."""

    def __init__(self, count, inputs, outputs, width, rng):
        shapes = [(count, a, b) for a, b in ((inputs, width), (1, width), (width, width), (1, width), (width, outputs), (1, outputs))]
        self.weights = np.concatenate([
            rng.uniform(-1, 1, shape).ravel() / np.sqrt(shape[1]) if shape[1] > 1 else np.zeros(count * shape[2]) for shape in shapes
        ]).astype(np.float32)  # fmt: skip
        self.shapes = shapes
        self.parts = self._parts(self.weights)

    def _parts(self, row):
        ends = np.cumsum([np.prod(shape) for shape in self.shapes])
        return [part.reshape(shape) for part, shape in zip(np.split(row, ends[:-1]), self.shapes, strict=True)]

    def forward(self, seen):
        w1, b1, w2, b2, w3, b3 = self.parts
        self.seen, self.layers = seen, []
        for w, b in ((w1, b1), (w2, b2)):
            off = seen @ w + b
            off -= off.mean(-1, keepdims=True)
            share = 1 / np.sqrt((off * off).mean(-1, keepdims=True) + 1e-5)
            normal = off * share
            seen = np.maximum(normal, 0)
            self.layers.append((normal, share, seen))
        return seen @ w3 + b3

    def backward(self, slope):
        """Of what forward() gave last: slopes of the weights in one row, and of what went in."""
        w1, _, w2, _, w3, _ = self.parts
        slopes = []
        for w, b4, (normal, share, out) in ((w3, self.layers[0][2], self.layers[1]), (w2, self.seen, self.layers[0])):
            slopes[:0] = [out.swapaxes(1, 2) @ slope, slope.sum(1, keepdims=True)]
            slope = (slope @ w.swapaxes(1, 2)) * (normal > 0)
            along = (slope * normal).mean(-1, keepdims=True)
            slope = share * (slope - slope.mean(-1, keepdims=True) - normal * along)
        slopes[:0] = [self.seen.swapaxes(1, 2) @ slope, slope.sum(1, keepdims=True)]
        return np.concatenate([part.ravel() for part in slopes]), slope @ w1.swapaxes(1, 2)


class Memory:
    def __init__(self, room, seen, moves):
        self.rows = np.zeros((room, 2 * seen + moves + 2), np.float32)
        self.cuts = np.cumsum([seen, moves, 1, seen])
        self.count = 0

    def add(self, *parts):
        self.rows[self.count % len(self.rows)] = np.concatenate([np.atleast_1d(part) for part in parts])
        self.count += 1

    def draw(self, batch, rng):
        rows = self.rows[rng.integers(min(self.count, len(self.rows)), size=batch)]
        return np.split(rows, self.cuts, axis=1)


class Sac:
    """seen, moves: how many numbers an observation and an action have; `chosen` as in DEFAULTS: `updates` a step, `times` the reward."""

    def __init__(self, seen, moves, *, seed=0, room=100_000, **chosen):
        self.set = {**DEFAULTS, **chosen}
        self.rng = np.random.default_rng(seed)
        self.moves, self.memory, self.steps = moves, Memory(room, seen, moves), 0
        width, rate = self.set["width"], self.set["rate"]
        self.actor = Nets(1, seen, 2 * moves, width, self.rng)
        self.critics, self.behind = (Nets(2, seen + moves, 1, width, self.rng) for _ in range(2))
        self.behind.weights[:] = self.critics.weights
        self.log_alpha = np.full(1, np.log(self.set["entropy"]), np.float32)
        self.of_actor, self.of_critics = Adam(self.actor.weights, rate), Adam(self.critics.weights, rate)
        self.of_alpha = Adam(self.log_alpha, rate)
        self.begun = None

    def act(self, seen):
        """The mean of the policy."""
        return np.tanh(self.actor.forward(np.asarray(seen, np.float32)[None, None])[0, 0, : self.moves])

    def drawn(self, seen):
        """Actions, their log probabilities, and what their slopes need."""
        mean, log_std = np.split(self.actor.forward(seen[None])[0], 2, axis=1)
        free = (log_std > MIN_LOG_STD) & (log_std < MAX_LOG_STD)
        std = np.exp(np.clip(log_std, MIN_LOG_STD, MAX_LOG_STD))
        noise = self.rng.standard_normal(mean.shape, np.float32)
        action = np.tanh(mean + std * noise)
        chance = -0.5 * noise**2 - np.log(std) - 0.919 - np.log(1 - action**2 + 1e-6)
        return action, chance.sum(1, keepdims=True), (noise * std, free)

    def learn(self, env, steps):
        """Takes so many steps, going on where the last call ended."""
        for _ in range(steps):
            if self.begun is None:
                self.begun, _ = env.reset(seed=None if self.steps else int(self.rng.integers(2**31)))
            early = self.steps < self.set["random_steps"]
            action = self.rng.uniform(-1, 1, self.moves) if early else self.drawn(self.begun[None])[0][0]
            seen, reward, terminated, truncated, _ = env.step(action)
            self.memory.add(self.begun, action, self.set["times"] * reward, seen, float(not terminated))
            self.begun = None if terminated or truncated else seen
            self.steps += 1
            for _ in range(0 if early else self.set["updates"]):
                self.update()

    def update(self):
        seen, action, reward, after, goes_on = self.memory.draw(self.set["batch"], self.rng)
        alpha, batch = np.exp(self.log_alpha), len(seen)
        ahead, chance, _ = self.drawn(after)
        worth = self.behind.forward(np.repeat(np.concatenate([after, ahead], 1)[None], 2, 0)).min(0)
        wanted = reward + self.set["gamma"] * goes_on * (worth - alpha * chance)
        said = self.critics.forward(np.repeat(np.concatenate([seen, action], 1)[None], 2, 0))
        self.of_critics.step(self.critics.backward((said - wanted[None]) / batch)[0])

        action, chance, (spread, free) = self.drawn(seen)
        said = self.critics.forward(np.repeat(np.concatenate([seen, action], 1)[None], 2, 0))
        least = (said == said.min(0)).astype(np.float32)
        slope = self.critics.backward(-least / batch)[1].sum(0)[:, -self.moves :] * (1 - action**2) + alpha * 2 * action / batch
        slopes = np.concatenate([slope, (slope * spread - alpha / batch) * free], 1)
        self.of_actor.step(self.actor.backward(slopes[None].astype(np.float32))[0])
        self.of_alpha.step(-np.float32(np.mean(chance) - self.moves)[None])
        self.behind.weights += np.float32(self.set["tau"]) * (self.critics.weights - self.behind.weights)

    def save(self, path):
        """What load() takes: the policy alone."""
        np.savez(path, seen=self.actor.shapes[0][1], moves=self.moves, width=self.set["width"], weights=self.actor.weights)


def load(path):
    """The policy that Sac.save() wrote: a function of an observation."""
    kept = np.load(path)
    learner = Sac(int(kept["seen"]), int(kept["moves"]), room=1, width=int(kept["width"]))
    learner.actor.weights[:] = kept["weights"]
    return learner.act


def main():
    import gymnasium

    import marketgen  # noqa: F401

    env = gymnasium.make("MarketGen/DriveToProduct-v1")
    learner = Sac(env.observation_space.shape[0], env.action_space.shape[0], seed=1)
    learner.learn(env, 400)
    print(f"learned from {learner.steps} steps of DriveToProduct; ppo_pick.py --task goes on until it is solved")


if __name__ == "__main__":
    main()
