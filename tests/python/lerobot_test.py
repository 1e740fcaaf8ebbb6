"""What a checkpoint of LeRobot says of itself; that one acts is shown by tools/check_lerobot, since LeRobot and torch are not installed here."""

import importlib.util
import json

import numpy as np
import pytest

import marketgen
import outside_test
from marketgen.outside.adaptation import Adaptation
from marketgen.outside.lerobot import adapter_of
from marketgen.policy_process import PolicyFailed

CONFIG = {
    "type": "act",
    "input_features": {
        "observation.state": {"type": "STATE", "shape": [16]},
        "observation.images.wrist_camera": {"type": "VISUAL", "shape": [3, 4, 6]},
    },
    "output_features": {"action": {"type": "ACTION", "shape": [9]}},
    "chunk_size": 20,
}


@pytest.fixture
def checkpoint(tmp_path):
    def make(config=CONFIG, **changed):
        folder = tmp_path / "act"
        folder.mkdir()
        (folder / "model.safetensors").write_bytes(b"")
        (folder / "config.json").write_text(config if isinstance(config, str) else json.dumps({**config, **changed}))
        return str(folder)

    return make


def test_a_checkpoint_is_its_own_adapter(checkpoint):
    adapter = adapter_of(checkpoint())
    assert adapter.options() == {"control_mode": "pd_joint_pos", "obs_mode": "rgbd", "cameras": ("wrist_camera",), "width": 6, "height": 4}
    adaptation = Adaptation(adapter, outside_test.task(), outside_test.SEEN)
    told = adaptation.told(outside_test.SEEN)
    assert told["observation.state"].shape == (16,) and told["task"] == "Take it."
    assert told["observation.images.wrist_camera"].shape == (3, 4, 6) and told["observation.images.wrist_camera"].dtype == np.float32
    assert np.allclose(adaptation.actions({"actions": np.arange(9.0)[None]}), [np.arange(9)])


@pytest.mark.parametrize(
    ("answer", "said"),
    [
        (np.full((1, 9), np.nan), "nan for joint1"),
        (np.arange(7.0)[None], "7 numbers"),
        (np.zeros((1, 2, 2, 9)), "(1, 2, 2, 9)"),
        (np.array([["left"] * 9]), "array"),
    ],
)
def test_what_a_checkpoint_answers_is_checked(checkpoint, answer, said):
    """As of a server: its episode fails (outside_test.py)."""
    adaptation = Adaptation(adapter_of(checkpoint()), outside_test.task(), outside_test.SEEN)
    with pytest.raises(PolicyFailed) as failed:
        adaptation.actions({"actions": answer})
    assert failed.value.code == "episode.bad_answer" and said in failed.value.message


@pytest.mark.parametrize(
    ("config", "changed", "code", "where"),
    [
        ("{", {}, "json.syntax", "config.json"),
        ("[]", {}, "json.wrong_type", "config.json:"),
        (CONFIG, {"input_features": {}}, "json.wrong_type", "/input_features"),
        (CONFIG, {"input_features": {"observation.state": {"shape": "16"}}}, "json.wrong_type", "/input_features/observation.state/shape"),
        (CONFIG, {"input_features": {"observation.state": {"shape": [0]}}}, "json.out_of_range", "/shape/0"),
        (CONFIG, {"input_features": {"observation.environment_state": {"shape": [3]}}}, "json.unknown_name", "observation.environment_state"),
        (CONFIG, {"output_features": {"value": {"shape": [1]}}}, "json.missing_field", "/output_features"),
        (
            CONFIG,
            {"input_features": {f"observation.images.{name}": {"shape": [3, side, 8]} for name, side in (("a", 8), ("b", 9))}},
            "json.out_of_range",
            "/input_features",
        ),
    ],
)
def test_what_is_wrong_with_a_checkpoint_is_said(checkpoint, config, changed, code, where):
    with pytest.raises(marketgen.Error) as refused:
        adapter_of(checkpoint(config, **changed))
    assert refused.value.code == code and refused.value.where.endswith(where)


def test_what_is_no_checkpoint(tasks, tmp_path):
    for place in ("nowhere", "."):
        with pytest.raises(marketgen.Error) as refused:
            marketgen.evaluate(tasks, f"lerobot:{tmp_path / place}", tmp_path / "a")
        assert refused.value.code == "input.not_found"


@pytest.mark.skipif(importlib.util.find_spec("lerobot") is not None, reason="LeRobot is installed")
def test_without_lerobot_it_is_said(tasks, tmp_path, checkpoint):
    with pytest.raises(marketgen.Error, match="pip install lerobot") as refused:
        marketgen.evaluate(tasks, f"lerobot:{checkpoint()}", tmp_path / "a")
    assert refused.value.code == "usage.unavailable"
