"""Checkout Unloading."""

from .task_env import TaskEnv
from .task_vector import TaskVectorEnv


class CheckoutUnloading(TaskEnv):
    """A Panda behind a checkout counter puts the named products from a basket onto the unloading area.

    store         a Store or its folder; None: episodes of the pool that comes with the program
    episodes      instead of a store: a file of `marketgen episodes`; a seed picks one of them
    preset        "rl": obs_mode="state", control_mode="pd_ee_delta_pos", reward_mode="shaped", stop_action=False, flat=True;
                  options beside it count before it
    obs_mode      "state": the truth, too (item poses, goal: group `privileged`); "state_robot": the arm alone;
                  "rgbd": pictures of `cameras` (scene_camera, wrist_camera); "pointcloud": `points` of what these see
    control_mode  what the first numbers of an action are, 20 a second; all are in [-1, 1] but those of pd_joint_pos:
                    pd_joint_pos        7 joint angles, rad
                    pd_joint_delta_pos  7, 1 = 0.1 rad from the last target
                    pd_ee_delta_pos     3, 1 = 20 mm along x, y, z of the station (x over the counter, z up)
                    pd_ee_delta_pose    6, and 1 = 0.1 rad about those axes; where the arm does not reach, the tool goes as
                                        near as it can: info["tool_cut_m"] and ["tool_cut_rad"] say how far off that is
                  Then the gripper: -1 closed, 1 open. Then `stop`: above 0, the agent says that it has done.
    reward_mode   "sparse": at the end, the share of the goals; "dense": each step from 0 to 1, nearer is more; "shaped": what
                  each step has brought nearer, 1 in all
    stop_action   False: actions have no `stop`; the episode ends when all goals are met
    flat          True: an observation is one row of numbers (of "state" and "state_robot")
    split         of a store: what drawn episodes are shown to be, "planned" (by itself), "certified", "paper" or "all"
    tools         "gripper" or "suction": the arm ends in a cup on a tube. Its number sucks up to 0 and lets go above;
                  `agent.sealed` is 1 when it has sealed
    width, height, quality  of the pictures
    segmentation  object numbers with the pictures and points: for training, never for evaluation

    All is in one frame, that of the station: origin at the robot's base on the counter's top, X over the counter, Z up, metres.
    `reset(options={"episode": {...}})` takes a market-episode/1 document (or the number of one in the file), in 20 ms;
    otherwise `seed` picks one, or draws one from the store's stock, in a second or two.
    Ends when the agent stops (terminated) or the time is over (truncated); judged 2 s later:
    `info` then has success, goal_fraction and the whole `result` (market-result/1). Before, only `instruction`, `time_s` and, in
    pd_ee_*, the tool's cuts;
    that of a reset also, with segmentation or obs_mode="state", `products`: SKUs by their numbers in segmentation.
    """

    track = "checkout"


class CheckoutUnloadingVector(TaskVectorEnv):
    """Many CheckoutUnloading in one."""

    single = CheckoutUnloading
