# man finds the pages of an installation, and its completions are those of its program
man -w marketgen | grep "^$VENV/"
for page in export assets; do [ "$(man -w "marketgen-$page")" = "$VENV/share/man/man1/marketgen-$page.1" ]; done
man marketgen-export | grep -- --robot-radius > /dev/null
bash -euo pipefail -c 'source <(marketgen completion bash); complete -p marketgen'
marketgen --version | sed -n 1p | grep -x "marketgen [0-9.]*"
