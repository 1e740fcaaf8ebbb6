# environments from the pool: each begins at once, sixteen in seconds, copies go on alike
pip install --quiet "gymnasium>=1.1"
python - <<'PYTHON'
import copy
import time

import gymnasium, marketgen
from gymnasium.utils.env_checker import check_env

for name in ("CheckoutUnloading", "CheckoutOneItem", "InAisleCollection"):
    began = time.time()
    env = gymnasium.make(f"MarketGen/{name}-v1")
    env.reset(seed=1)
    print(name, f"{time.time() - began:.2f} s")
    if name != "InAisleCollection":  # takes minutes there: 31-check-env-aisle.sh
        check_env(env.unwrapped, skip_render_check=True)
began = time.time()
gymnasium.make_vec("MarketGen/CheckoutUnloading-v1", num_envs=16).reset(seed=1)
print("sixteen:", f"{time.time() - began:.2f} s")
env = gymnasium.make("MarketGen/CheckoutOneItem-v1")
env.reset(seed=1)
other = copy.deepcopy(env)
action = env.action_space.sample()
assert (env.step(action)[0] == other.step(action)[0]).all()
PYTHON
