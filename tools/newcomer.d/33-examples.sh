# the examples without arguments, a notebook's class, a store that shows itself
pip install --quiet "gymnasium>=1.1"
for example in first_store cheapest many_cameras moving_product train_loop; do
  python "$TREE/examples/$example.py" > "example-$example.txt" || fail "$example"
done
store=$(a_store)
marketgen episodes "$store" --track checkout --count 1 -o one.jsonl --quiet
python - "$store" <<'PYTHON'
import sys

import numpy as np, marketgen


class Mine:
    def act(self, seen):
        action = np.zeros(9, np.float32)
        action[-1] = 1
        return action


scores = marketgen.evaluate("one.jsonl", Mine, "mine", jobs=1)
assert scores.results[0].get("detail", "") == "", scores.results
assert "products" in marketgen.open_store(sys.argv[1])._repr_html_()
PYTHON
