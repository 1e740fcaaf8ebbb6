# kill -9 of an evaluation takes its policy and the policy's children along
store=$(a_store)
[ -s tasks.jsonl ] || marketgen episodes "$store" --track checkout --count 1 --seed 5 -o tasks.jsonl
cat > stuck.py <<'PYTHON'
import os
import subprocess


def act(observation):
    child = subprocess.Popen(["sleep", "1000"])
    with open("pids.part", "w") as out:
        out.write(f"{os.getpid()} {child.pid}")
    os.rename("pids.part", "pids")
    while True:
        pass
PYTHON
rm -f pids
python -c 'import marketgen, stuck; marketgen.evaluate("tasks.jsonl", stuck.act, "stuck", jobs=1)' &
evaluator=$!
for _ in $(seq 600); do [ -e pids ] && break; sleep 0.1; done
kill -9 "$evaluator"
wait "$evaluator" || true
for _ in $(seq 100); do
  left=0
  for pid in $(cat pids); do if [ -d "/proc/$pid" ] && ! grep -q '^State:.Z' "/proc/$pid/status"; then left=1; fi; done
  [ "$left" = 0 ] && break
  sleep 0.1
done
[ "$left" = 0 ] || fail "processes outlived the evaluation: $(cat pids)"
