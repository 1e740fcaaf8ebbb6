"""Demonstrations as a LeRobot dataset v3.0 (docs/demonstrations.md).

    marketgen.record("tasks.jsonl", "unloading", policy="oracle", success_only=True)

recorder.py does it: acting.py acts an episode out, parts.py keeps it, dataset.py makes the dataset of them, card.py its README.md.
drives.py plays what people drove. replaying.py shows that the actions kept lead to the states kept.
"""

from .recorder import Recording, record, record_drives
from .replaying import replay_check

__all__ = ["Recording", "record", "record_drives", "replay_check"]
