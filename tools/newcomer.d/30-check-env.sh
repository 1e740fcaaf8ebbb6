# gymnasium's check_env of both tasks
pip install --quiet gymnasium
store=$(a_store)
python - "$store" <<'PYTHON'
import sys, warnings

import gymnasium, marketgen
from gymnasium.utils.env_checker import check_env

for name in ("MarketGen/CheckoutUnloading-v1", "MarketGen/InAisleCollection-v1"):
    env = gymnasium.make(name, store=sys.argv[1])
    check_env(env.unwrapped, skip_render_check=True)
    env.close()
PYTHON
