"""How each stage is done by rule, from the numbers that it shows: what a learner is measured beside, or learns from.

    policy = of(env)
    action = policy(observation)
"""

import math

import numpy as np


def driven(named):
    """To the corner ahead; at the end of the way a turn to the product."""
    bearing = math.atan2(named["corner_sin"], named["corner_cos"])
    if named["way"] < 0.02:
        turn = math.atan2(named["stand_sin"], named["stand_cos"])
        return np.array([0.0, np.clip(2 * turn, -0.5, 0.5)])
    ahead = math.cos(bearing) > 0.9
    return np.array([min(0.5, 3 * named["way"]) if ahead else 0.0, np.clip(1.5 * bearing, -0.6, 0.6)])


def picked(named):
    """Beside first, then ahead until the product is between the fingers, closed, and straight back."""
    ahead, aside = named["ahead"] * 0.12, named["aside"] * 0.12
    if named["held"] or named["last_opening"] < 0:
        return np.array([-1.0 if named["held"] else 0.0, 0, -1.0])
    before = abs(aside) < 0.003
    on = (ahead if before else ahead - 0.1) / 0.032
    return np.clip([on, aside / 0.016, -1.0 if before and ahead < 0.006 else 1.0], -1, 1)


def placed(named):
    """High over the basket, down into it, open, up again."""
    to = np.array([named["box_to_basket_x"], named["box_to_basket_y"]]) * 0.4
    over, height = named["outside"] <= 0, named["height"] * 0.3
    if named["last_opening"] > 0.5 or (over and height < 0.045):
        return np.array([0, 0, 0.3 if named["opening"] > 0.9 else 0, 1.0])
    return np.append(np.clip([*to / 0.05, ((0.02 if over else 0.2) - height) / 0.05], -1, 1), -1.0)


def opened(named):
    """Across, then on to the bar until it is between the fingers, closed, and straight out of the leaf's plane."""
    ahead, across = -0.1 * named["to_bar_out"], 0.1 * named["to_bar_along"]
    if named["held"] or (abs(across) < 0.008 and ahead < -0.003):
        return np.array([named["held"], 0, -1.0])
    on = -(ahead + 0.0045) / 0.004 if abs(across) < 0.01 else (0.03 - ahead) / 0.02
    return np.clip([on, across / 0.024, 1.0], -1, 1)


SCRIPTS = {"DriveToProduct": driven, "PickFromShelf": picked, "PlaceInBasket": placed, "OpenCooler": opened}


def of(env):
    """The policy of an environment of a stage."""
    script, sees = SCRIPTS[type(env.unwrapped).__name__], env.unwrapped.sees
    return lambda seen: script(dict(zip(sees, map(float, seen), strict=True)))


def main():
    import gymnasium

    import marketgen  # noqa: F401

    for name in SCRIPTS:
        env = gymnasium.make(f"MarketGen/{name}-v1")
        policy, (seen, _), steps, over = of(env), env.reset(seed=1), 0, False
        while not over:
            seen, _, terminated, truncated, info = env.step(policy(seen))
            steps, over = steps + 1, terminated or truncated
        print(f"{name}: {'done' if info['is_success'] else 'not done'} in {steps} steps")


if __name__ == "__main__":
    main()
