# gymnasium's check_env on every environment as it is, and in a store of one's own
pip install --quiet "gymnasium>=1.1"
store=$(a_store)
python - "$store" <<'PYTHON'
import sys

import gymnasium, marketgen
from gymnasium.utils.env_checker import check_env

for name, options in [
    ("CheckoutOneItem-v1", {}),
    ("CheckoutUnloading-v1", {}),
    ("InAisleCollection-v1", {}),
    ("CheckoutUnloading-v1", {"store": sys.argv[1]}),
]:
    env = gymnasium.make(f"MarketGen/{name}", **options)
    check_env(env.unwrapped, skip_render_check=True)
    env.close()
    print(name, options, "passes")
PYTHON
