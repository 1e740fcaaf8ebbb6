# outputs: no name, a full device, a closed pipe, a link and its mode
store=$(a_store)
refused() { local status=0; "$@" > refused.out 2> refused.err || status=$?; printf '%s: %s\n' "$status" "$(cat refused.err)"; }
refused marketgen query "$store" products -o '' | grep '^2: error\[usage.bad_flag\]'
refused marketgen export "$store" --format glb -o /proc/nowhere/shop.glb | grep '^3: error\[io.cannot_write\]'
refused sh -c 'marketgen query "$1" products > /dev/full' sh "$store" | grep '^3: error\[io.cannot_write\]'
marketgen query "$store" products | head -1 | grep '^id,' || true
mkdir outputs
touch outputs/target.csv
chmod 600 outputs/target.csv
ln -s target.csv outputs/link.csv
marketgen query "$store" products -o outputs/link.csv
test -L outputs/link.csv
test "$(stat -c %a outputs/target.csv)" = 600
test -s outputs/target.csv
test -z "$(find . -name '.*~mg-*')"
