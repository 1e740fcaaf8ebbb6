"""In-Aisle Item Collection."""

from .task_env import TaskEnv
from .task_vector import TaskVectorEnv


class InAisleCollection(TaskEnv):
    """A dual-arm Realman with a lift drives through a stocked store and fetches the named products into its basket.

    Options as those of CheckoutUnloading, and so is the end; the camera is head_camera, by
    `cameras` also left_wrist_camera and right_wrist_camera. An action is, 20 a second:
                    pd_joint_pos        17 joints: lift (m), 7 of the left arm, 7 of the right, head pan and tilt (rad)
                    pd_joint_delta_pos  17, 1 = 7.5 mm of the lift, 0.1 rad of the others, from the last target
                    pd_ee_delta_pos     3 of the left tool, 3 of the right: 1 = 20 mm along x, y, z of the base (x ahead);
                                        then lift, head pan and tilt as in pd_joint_delta_pos
                    pd_ee_delta_pose    the same with 6 of each tool: 1 = 0.1 rad about those axes
                  Then the left and the right gripper: -1 closed, 1 open. Then speed and turn rate of the base as shares of
                  the most (1.5 m/s ahead, turning left). Then `stop`. `action_names` says it number by number.

    split         of a store: what drawn episodes are shown to be, "planned" (by itself), "certified", "paper" or "all"
    tools         "gripper" (one on each arm) or "suction": the right arm ends in a cup. Its number sucks up to 0 and lets go
                  above; `agent.sealed` is 1 for each tool that has sealed

    `extra.base_pose` is the base's place by its own reckoning: x, y, heading in the store's frame.
    The `info` of a reset also has what the agent knows beforehand: `map`, the store's market-layout/1 (room, zones,
    fixtures, aisles; no products), and `categories`, where products of each goal's category stand on average.
    Drawing an episode from a seed plans a way to fetch every goal, which takes many seconds; a file of episodes, or
    `reset(options={"episode": {...}})`, takes about half a second.
    """

    track = "aisle"


class InAisleCollectionVector(TaskVectorEnv):
    """Many InAisleCollection in one. They share the store and its renderer."""

    single = InAisleCollection
