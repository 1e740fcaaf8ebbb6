# git clone, from the commit that tools/newcomer stands in !
git clone --quiet --no-local "$NEWCOMER_SOURCE" "$TREE"
git -C "$TREE" checkout --quiet --detach "$(git -C "$NEWCOMER_SOURCE" rev-parse HEAD)"
