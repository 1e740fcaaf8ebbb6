"""Checkout Unloading."""

from .task_env import TaskEnv
from .task_vector import TaskVectorEnv


class CheckoutUnloading(TaskEnv):
    """A Panda behind a checkout counter puts the named products from a basket onto the unloading area.

    store         a Store, its folder, or None for a small shop in the cache folder
    episodes      instead of a store: a file of `marketgen episodes`; a seed picks one of them
    obs_mode      "state": the arm alone; "rgbd": pictures of `cameras` (scene_camera, wrist_camera), too
    control_mode  what the first numbers of an action are, 20 a second; all are in [-1, 1] but those of pd_joint_pos:
                    pd_joint_pos        7 joint angles, rad
                    pd_joint_delta_pos  7, 1 = 0.1 rad from the last target
                    pd_ee_delta_pos     3, 1 = 20 mm along x, y, z of the station (x over the counter, z up)
                    pd_ee_delta_pose    6, and 1 = 0.1 rad about those axes
                  Then the gripper: -1 closed, 1 open. Then `stop`: above 0, the agent says that it has done.
    reward_mode   "sparse": at the end, the share of the goals; "dense": each step from 0 to 1, nearer is more
    width, height, quality  of the pictures
    segmentation  object numbers with the pictures: for training, never for evaluation

    `reset(options={"episode": {...}})` takes a market-episode/1 document (or the number of one in the file), in 20 ms;
    otherwise `seed` draws one from the store's stock, in a second or two.
    Ends when the agent stops (terminated) or the time is over (truncated); judged 2 s later:
    `info` then has success, goal_fraction and the whole `result` (market-result/1). Before, only `instruction` and `time_s`.
    """

    track = "checkout"


class CheckoutUnloadingVector(TaskVectorEnv):
    """Many CheckoutUnloading in one."""

    single = CheckoutUnloading
