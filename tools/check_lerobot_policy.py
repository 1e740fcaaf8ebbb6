"""A checkpoint that takes and says what a dataset has, as lerobot-train makes it of the dataset: an ACT whose weights are drawn and have learned
nothing. Run by tools/check_lerobot in LeRobot's environment.

    python tools/check_lerobot_policy.py DATASET CHECKPOINT
"""

import pathlib
import sys

import torch
from lerobot.configs.types import FeatureType
from lerobot.datasets.lerobot_dataset import LeRobotDatasetMetadata
from lerobot.policies.act.configuration_act import ACTConfig
from lerobot.policies.act.modeling_act import ACTPolicy
from lerobot.policies.factory import make_pre_post_processors

try:
    from lerobot.datasets.utils import dataset_to_policy_features
except ImportError:  # LeRobot from 0.5 on
    from lerobot.utils.feature_utils import dataset_to_policy_features

CHUNK, EXECUTED = 20, 10


def main():
    root, checkpoint = map(pathlib.Path, sys.argv[1:])
    meta = LeRobotDatasetMetadata("marketgen/check", root=root)
    features = dataset_to_policy_features(meta.features)
    said = {name: feature for name, feature in features.items() if feature.type is FeatureType.ACTION}
    torch.manual_seed(1)
    config = ACTConfig(
        input_features={name: feature for name, feature in features.items() if name not in said},
        output_features=said,
        chunk_size=CHUNK, n_action_steps=EXECUTED, pretrained_backbone_weights=None, device="cpu",
        dim_model=64, n_heads=2, dim_feedforward=128, n_encoder_layers=1, use_vae=False,
    )
    for part in (ACTPolicy(config), *make_pre_post_processors(config, dataset_stats=meta.stats)):
        part.save_pretrained(checkpoint)


if __name__ == "__main__":
    main()
