"""A model of others acts: asked for some steps at a time, of which it is asked anew when they are executed."""

from __future__ import annotations

from collections import deque
from typing import Any, Protocol

import numpy as np

from ..policy_process import asked
from .adaptation import Adaptation
from .adapters import Adapter


class Model(Protocol):
    """Where the answers come from: a server, or a checkpoint in this process."""

    def begin(self) -> None:
        """Before each episode. Raises Error episode.no_policy when it cannot be had at all, which ends a run."""

    def infer(self, told: dict[str, Any]) -> Any:
        """Its answer to an observation, as Adaptation.actions() takes it. Raises PolicyFailed."""

    def close(self) -> None:
        """It is not asked any more, or the episode broke off: what comes late must not be taken for a later answer."""


class ModelActs:
    """A Policy as evaluate() asks it."""

    def __init__(self, adapter: Adapter, model: Model):
        self._adapter, self._model = adapter, model
        self._adaptation: Adaptation | None = None
        self._steps: deque[np.ndarray] = deque()

    def begin(self, task: dict[str, Any], observation: dict[str, Any]) -> None:
        self._steps.clear()
        self._adaptation = Adaptation(self._adapter, task, observation)
        self._model.begin()

    def act(self, observation: dict[str, Any]) -> np.ndarray:
        assert self._adaptation is not None
        if not self._steps:
            answer = self._model.infer(self._adaptation.told(observation))
            self._steps.extend(self._adaptation.actions(answer))
        return self._adaptation.executed(self._steps.popleft(), observation)

    def close(self) -> None:
        self._model.close()


class ModelPlayer:
    """Who acts in an evaluation (_Runner), in its process: what fails is a PolicyFailed, what ends the run an Error."""

    def __init__(self, acting: ModelActs):
        self._acting = acting

    def ask(self, method: str, *arguments: Any) -> Any:
        return asked(self._acting, method, *arguments)

    def close(self) -> None:
        self._acting.close()
