# marketgen.evaluate() with one worker
store=$(a_store)
[ -s tasks.jsonl ] || marketgen episodes "$store" --track checkout --count 1 --seed 5 -o tasks.jsonl
python - <<'PYTHON'
import marketgen

if __name__ == "__main__":
    scores = marketgen.evaluate("tasks.jsonl", "random", "scores", jobs=1)
    assert scores.summary["strict"]["of"] == 1, scores.summary
PYTHON
