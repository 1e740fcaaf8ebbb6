# gymnasium's check_env at the counter
pip install --quiet "gymnasium>=1.1"
store=$(a_store)
python - "$store" <<'PYTHON'
import sys

import gymnasium, marketgen
from gymnasium.utils.env_checker import check_env

env = gymnasium.make("MarketGen/CheckoutUnloading-v1", store=sys.argv[1])
check_env(env.unwrapped, skip_render_check=True)
env.close()
PYTHON
