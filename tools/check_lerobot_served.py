"""A policy of examples/imitate.py or clone.py through other doors; run by tools/check_lerobot.

    check_lerobot_served.py --args.policy PATH --host H --port P          a model server of vla-eval, until it is ended
    check_lerobot_served.py compare RESULTS SERVED [VLA_RESULTS]          what marketgen.evaluate found of it in process (RESULTS) and by
                                                                          openpi's protocol (SERVED), and what vla-eval found
"""

import json
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "examples"))


def rows_of(results):
    lines = (pathlib.Path(results) / "results.jsonl").read_text().splitlines()
    return {row["episode"]: row for row in map(json.loads, lines)}


def compare(results, served, *vla_results):
    alone, by_openpi = rows_of(results), rows_of(served)
    solved = f"{sum(row['success_strict'] for row in alone.values())} of {len(alone)} solved"
    for episode, row in alone.items():
        other = by_openpi[episode]
        for name in ("success_strict", "failure", "steps", "path_m", "side_effects"):
            assert other[name] == row[name], (episode, name, row[name], other[name])
    print(f"openpi's protocol leads to what marketgen.evaluate finds: {solved}")
    for folder in vla_results:
        [file] = pathlib.Path(folder).glob("*_aggregate.json")
        by_vla = {task["task"]: task["episodes"][0]["metrics"]["success"] for task in json.loads(file.read_text())["tasks"]}
        assert by_vla == {episode: row["success_strict"] for episode, row in alone.items()}, (by_vla, alone)
        print(f"vla-eval finds what marketgen.evaluate does: {solved}")


def serve():
    from serve_policy import policy_of
    from vla_eval.model_servers.predict import PredictModelServer
    from vla_eval.model_servers.serve import run_server
    from vla_eval.specs import IMAGE_RGB, LANGUAGE, DimSpec

    class Policy(PredictModelServer):
        def __init__(self, policy: str):
            self._policy = policy_of(pathlib.Path(policy))
            super().__init__(chunk_size=self._policy.steps)

        def get_action_spec(self):
            moves = self._policy.action["space"] == "tool_moves"
            return {"action": DimSpec("action", 5 if moves else 9, "pd_ee_delta_pos" if moves else "pd_joint_pos")}

        def get_observation_spec(self):
            state = DimSpec("state", self._policy.numbers, "marketgen_state")
            return {self._policy.camera: IMAGE_RGB, "state": state, "language": LANGUAGE}

        def predict(self, obs, ctx):
            seen = {f"observation.images.{name}": picture for name, picture in obs["images"].items()}
            return {"actions": self._policy.actions(seen | {"observation.state": obs["state"], "task": obs["task_description"]})}

    return run_server(Policy)


if __name__ == "__main__":
    sys.exit(compare(*sys.argv[2:]) if sys.argv[1] == "compare" else serve())
