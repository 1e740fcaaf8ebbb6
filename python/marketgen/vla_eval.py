"""MarketGen's episodes as a benchmark of vla-eval (https://pypi.org/project/vla-eval).

    benchmarks:
      - benchmark: "marketgen.vla_eval:MarketGenBenchmark"
        params: {episodes: pool/checkout}

run by `vla-eval run -c FILE --no-docker --render cpu`; docs/remote.md has the whole of it.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, ClassVar

import numpy as np
from vla_eval.benchmarks.base import StepBenchmark, StepResult
from vla_eval.specs import IMAGE_RGB, LANGUAGE, DimSpec
from vla_eval.types import Action, EpisodeResult, Observation, Task

from . import arguments
from .as_recorded import AsRecorded, Seen
from .errors import Error


class MarketGenBenchmark(StepBenchmark):
    """Each episode of a file is a task; vla-eval's `tasks` takes its ids or its track, `max_tasks` the first so many.

    Parameters as those of record(), in which a model's dataset was recorded. A server is sent `images` by camera (height, width, 3,
    bytes), `state` (observation.state of datasets) and `task_description`; it answers `actions`, those of the control mode.
    """

    render_backends: ClassVar[frozenset[str]] = frozenset({"cpu"})

    @classmethod
    def configure_render(cls, mode: str) -> dict[str, str]:
        return {}  # pictures are drawn on the CPU, whatever the machine has

    def __init__(
        self,
        episodes: str = "pool/checkout",
        cameras: Sequence[str] | None = None,
        size: Sequence[int] = (256, 256),
        quality: str = "fast",
        control_mode: str = "pd_joint_pos",
        realism: str = "ideal",
    ):
        super().__init__()
        wanted = arguments.a_size("size", size)
        self._episodes = AsRecorded(
            episodes, cameras=cameras, size=wanted, quality=quality, control_mode=control_mode, realism=realism
        )
        self._control_mode = control_mode

    def get_tasks(self) -> list[Task]:
        return [{"name": name, "suite": self._episodes.track, "number": number} for number, name in enumerate(self._episodes.episodes)]

    def reset(self, task: Task) -> Seen:
        seen = self._episodes.begin(task["number"])
        self._filmed(seen)
        return seen

    def step(self, action: Action) -> StepResult:
        said = action.get("actions", action.get("action"))
        if said is None:
            raise Error("episode.bad_action", "actions", f"the server's answer has none; it has {', '.join(action) or 'nothing'}")
        seen, reward, terminated, truncated = self._episodes.step(np.ravel(said))
        done = terminated or truncated
        outcome = self._episodes.outcome
        self._filmed(seen)
        self._recorder.record_step(reward=reward, done=done, success=outcome is not None and outcome.success)
        return StepResult(obs=seen, reward=reward, done=done, info={})

    def _filmed(self, seen: Seen) -> None:
        if seen.pictures:
            self._recorder.record_video(next(iter(seen.pictures.values())))

    def make_obs(self, raw_obs: Seen, task: Task) -> Observation:
        return {"images": raw_obs.pictures, "state": raw_obs.state, "task_description": self._episodes.instruction}

    def get_step_result(self, step_result: StepResult) -> EpisodeResult:
        """Of an episode that `max_steps` of the configuration cut short: no success."""
        outcome = self._episodes.outcome
        if outcome is None:
            return {"success": False, "goal_fraction": 0.0, "spl": 0.0, "failure_reason": "not judged: max_steps came before the end"}
        return {
            "success": outcome.success,
            "goal_fraction": outcome.goal_fraction,
            "spl": outcome.spl,
            "failure_reason": outcome.failure_reason,
        }

    def get_metric_keys(self) -> dict[str, str]:
        return {"success": "mean", "goal_fraction": "mean", "spl": "mean"}

    def get_metadata(self) -> dict[str, Any]:
        return {"max_steps": self._episodes.max_steps, "max_episodes_per_task": 1}

    def get_action_spec(self) -> dict[str, DimSpec]:
        names = self._episodes.action_names
        return {"action": DimSpec("action", len(names), self._control_mode, description=", ".join(names))}

    def get_observation_spec(self) -> dict[str, DimSpec]:
        names = self._episodes.robot_names
        state = DimSpec("state", len(names), "marketgen_state", description=", ".join(names))
        return {**{camera: IMAGE_RGB for camera in self._episodes.cameras}, "state": state, "language": LANGUAGE}
