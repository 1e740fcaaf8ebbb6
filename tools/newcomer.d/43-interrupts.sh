# Ctrl-C, SIGTERM and SIGHUP end work within seconds; episodes --resume ends as an unbroken run
store=$(a_store)
ends() {  # ends SIGNAL COMMAND...: after two seconds of work; the signal is not ignored, as it would be under nohup
  local signal=$1 status=0 began pid; shift
  env --default-signal="$signal" "$@" > /dev/null 2> ends.err & pid=$!
  sleep 2
  began=$(date +%s%N)
  kill -"$signal" "$pid"
  wait "$pid" || status=$?
  printf '%s: %s ms, status %s\n' "$*" $((($(date +%s%N) - began) / 1000000)) "$status"
  test "$status" = 130
  test $((($(date +%s%N) - began) / 1000000)) -lt 8000
}
ends INT marketgen grasps
ends TERM marketgen assets heaps -o heaps.json
ends HUP marketgen episodes "$store" --count 500 --seed 3 -o hup.jsonl
draw() { marketgen episodes "$store" --count 3 --seed 5 --threads 1 --quiet -o "$@"; }
draw part.jsonl & pid=$!
until [ "$(wc -l < part.jsonl.unfinished 2>/dev/null || echo 0)" -ge 2 ]; do sleep 0.1; done
kill -INT "$pid"
wait "$pid" || test $? = 130
draw part.jsonl --resume
draw whole.jsonl
cmp part.jsonl whole.jsonl
test -z "$(find . -name '.*~mg-*')"
