"""The first task for a learner."""

from .task_env import TaskEnv
from .task_vector import TaskVectorEnv


class CheckoutOneItem(TaskEnv):
    """One light box stands on a counter; the Panda is to bring it onto the unloading area, carried or pushed.

    Checkout Unloading made easy, with the options of a learner (preset="rl"): observations of the true state and actions are
    one row of numbers each, both bounded; an action moves the tool (x, y, z: 1 = 20 mm, 20 times a second) and opens or closes
    the gripper; there is no `stop`. The reward is what a step has brought nearer: the tool to the box, the box to the area, 1 in
    all; when the box lies there by itself for a second, the episode ends (terminated) with success. After 7.5 s it is
    truncated. Other options as those of CheckoutUnloading.

    Which box, where it stands and how it is turned come from the seed: a reset takes 20 ms.
    """

    track = "checkout"
    station = "one-item"
    preset = "rl"


class CheckoutOneItemVector(TaskVectorEnv):
    """Many CheckoutOneItem in one."""

    single = CheckoutOneItem
