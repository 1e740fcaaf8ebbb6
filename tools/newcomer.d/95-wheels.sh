# wheels for every Python that is here, each in a bare root
cd "$TREE"
tools/setup build
tools/wheels --check -o "$WORK/wheels"
