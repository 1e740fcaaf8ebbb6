# evaluations under faults: a pipe, an id that is there twice, an edited episode, two runs in one folder
store=$(a_store)
marketgen episodes "$store" --track checkout --count 2 --seed 5 --quiet -o pair.jsonl
sed -i 's/"limit_s": *[0-9.]*/"limit_s": 2/' pair.jsonl
marketgen eval --episodes - --policy random --jobs 1 --quiet -o piped < pair.jsonl
{ cat pair.jsonl; tail -n 1 pair.jsonl; } | sed '1s/"episodes": *2/"episodes": 3/' > twice.jsonl
if marketgen eval --episodes twice.jsonl --policy random --quiet -o twice 2> twice.txt; then fail "an id that is there twice went through"; fi
grep -q 'episode.duplicate_id. twice.jsonl:4' twice.txt
sed -i '$s/"limit_s": *2/"limit_s": 3/' pair.jsonl
marketgen eval --episodes pair.jsonl --policy random --jobs 1 --quiet -o piped --resume 2> edited.txt
grep -q '1 of 2 results .* changed since' edited.txt
flock "$WORK/piped/.lock" sh -c '! marketgen eval --episodes pair.jsonl --policy random -o piped --resume 2> locked.txt'
grep -q io.in_use locked.txt
