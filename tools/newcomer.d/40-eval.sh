# an evaluation with one worker
store=$(a_store)
marketgen episodes "$store" --track checkout --count 1 --seed 5 -o tasks.jsonl
marketgen eval --episodes tasks.jsonl --policy random --jobs 1 -o results
test "$(wc -l < results/results.jsonl)" = 1
test -s results/summary.json
