#!/usr/bin/env bash
# tools/check_layers accepts a tree that keeps to its table, and names the file and line of each kind of violation.
set -euo pipefail
repository=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
tree=$(mktemp -d)
trap 'rm -rf "$tree"' EXIT
cases=0
failures=0

# A small house: base (1) <- scene (8) and motion (9) <- perception and store (11) <- policy (12) <- oracle (13).
make_house() {
  rm -rf "${tree:?}"/*
  mkdir -p "$tree/docs" "$tree"/src/marketgen/{base,scene,motion,perception,store,policy,oracle}
  cat > "$tree/docs/architecture.md" <<'TABLE'
| row | module | its room |
|---|---|---|
| 1 | `base` | results |
| 8 | `scene` | products |
| 9 | `motion` | ways |
| 11 | `perception` | eyes |
| 11 | `store` | the folder |
| 12 | `policy` | hands |
| 13 | `oracle` | knows all |
TABLE
  cd "$tree/src/marketgen"
  echo 'foreach(module base scene motion perception store policy oracle)' > CMakeLists.txt
  echo 'marketgen_module(base LIBRARIES fmt::fmt)' > base/CMakeLists.txt
  echo 'marketgen_module(scene DEPENDS base)' > scene/CMakeLists.txt
  echo 'marketgen_module(motion DEPENDS base)' > motion/CMakeLists.txt
  echo 'marketgen_module(perception DEPENDS base motion)' > perception/CMakeLists.txt
  echo 'marketgen_module(store DEPENDS base scene)  # DEPENDS policy' > store/CMakeLists.txt
  echo 'marketgen_module(policy DEPENDS perception)' > policy/CMakeLists.txt
  echo 'marketgen_module(oracle DEPENDS scene motion)' > oracle/CMakeLists.txt
  printf '#include <vector>\n#include <fmt/format.h>\n' > base/result.h
  printf '#include "base/result.h"\n' > scene/scene.h
  printf '#include "base/result.h"\n' > motion/way.h
  printf '#include "base/result.h"\n#include "motion/way.h"\n' > perception/masks.h
  printf '#include "base/result.h"\n#include "scene/scene.h"\n#include "layers.inc"\n' > store/store.cpp
  printf '#include "perception/masks.h"\n' > policy/grasp.cpp
  printf '#include "scene/scene.h"\n#include "motion/way.h"\n' > oracle/pick.cpp
}

# expect <status> <text the output must hold> <what this case proves>
expect() {
  local output status=0
  cases=$((cases + 1))
  output=$("$repository/tools/check_layers" "$tree" 2>&1) || status=$?
  if [ "$status" = "$1" ] && grep -qF -- "$2" <<< "$output"; then return; fi
  printf 'FAIL: %s\n  expected exit %s and: %s\n  got exit %s and: %s\n' "$3" "$1" "$2" "$status" "$output"
  failures=$((failures + 1))
}

make_house
expect 0 "7 modules keep to" "a tree that keeps to the table passes; the oracle may see the scene"

make_house; printf '\n#include "scene/scene.h"\n' >> base/result.h
expect 1 "src/marketgen/base/result.h:4:" "an include of a larger row is named with its line"

make_house; echo '#include "perception/masks.h"' >> store/store.cpp
expect 1 "src/marketgen/store/store.cpp:4:" "two modules of one row may not include each other"

make_house; echo '#include "scene/scene.h"' >> policy/grasp.cpp
expect 1 "src/marketgen/policy/grasp.cpp:2: policy may not reach scene: policy -> scene (policy/grasp.cpp:2)" "a policy may not see the scene"

make_house; echo '#include "scene/scene.h"' >> perception/masks.h
expect 1 "perception/masks.h:3: perception may not reach scene" "perception may not see the scene"

make_house; echo '#include "scene/scene.h"' >> motion/way.h
echo 'marketgen_module(motion DEPENDS base scene)' > motion/CMakeLists.txt
expect 1 "policy may not reach scene: policy -> perception (policy/grasp.cpp:1), perception -> motion (perception/masks.h:2), motion -> scene (motion/way.h:2)" \
  "a policy may not see the scene through what it includes, though every row is kept to"

make_house; printf 'marketgen_module(motion DEPENDS base\n  LIBRARIES marketgen_scene)\n' > motion/CMakeLists.txt
expect 1 "motion -> scene (motion/CMakeLists.txt:2)" "nor through what is linked, included or not"

make_house; printf 'marketgen_module(motion DEPENDS base)\ntarget_link_libraries(marketgen_motion PUBLIC marketgen_scene)\n' > motion/CMakeLists.txt
expect 1 "motion -> scene (motion/CMakeLists.txt:2)" "nor by another command of CMake"

make_house; printf 'marketgen_module(motion DEPENDS base\n  TEST_LIBRARIES marketgen_scene)\n' > motion/CMakeLists.txt
expect 0 "7 modules keep to" "tests of a blind module may link the truth"

make_house; printf '#include "policy/grasp.h"\n' >> oracle/pick.cpp; touch policy/grasp.h
echo 'marketgen_module(oracle DEPENDS scene motion policy)' > oracle/CMakeLists.txt
expect 0 "7 modules keep to" "who knows the truth may build on who does not"

make_house; echo '#include "../scene/scene.h"' >> perception/masks.h
expect 1 "steps out of its folder" "a relative path does not get around the table"

make_house; echo '#include <scene/scene.h>' >> perception/masks.h
expect 1 "is ours" "angle brackets do not get around the table"

make_house; echo '#include "helpers/strings.h"' >> store/store.cpp
expect 1 "no module helpers" "an include of an unknown module is a violation"

make_house; mkdir util; touch util/strings.h
expect 1 "no row for the module util" "a folder without a row is a violation"

make_house; echo 'marketgen_module(store DEPENDS base)' > store/CMakeLists.txt
expect 1 "DEPENDS lacks scene, which store.cpp:2 includes" "CMake must name what is included"

make_house; echo 'marketgen_module(scene DEPENDS base policy)' > scene/CMakeLists.txt
expect 1 "scene/CMakeLists.txt:1: DEPENDS policy" "CMake may not name a larger row"

make_house; echo 'marketgen_module(store DEPENDS base scene perception)' > store/CMakeLists.txt
expect 1 "may depend only on smaller rows" "CMake may not name the same row"

make_house; printf 'marketgen_module(policy\n  DEPENDS perception\n    base)\n' > policy/CMakeLists.txt
expect 1 "policy/CMakeLists.txt:2: DEPENDS base: no file of policy includes it" "CMake names nothing that is unused"

make_house; rm store/CMakeLists.txt
expect 1 "store/CMakeLists.txt:1: missing" "every module has a CMakeLists.txt"

make_house; echo 'foreach(module scene base motion perception store policy oracle)' > CMakeLists.txt
expect 1 "in its order" "CMake adds the modules in the table's order"

make_house; printf 'namespace marketgen::inner {\n}\n' >> base/result.h
expect 1 "base/result.h:3: namespace marketgen::inner" "base opens namespace marketgen itself"

make_house; printf 'namespace marketgen {\nstruct Basket {};\n}  // namespace marketgen\n' >> store/store.cpp
expect 1 "store/store.cpp:4: namespace marketgen: a file of store opens namespace marketgen::store only" \
  "a module does not write into the namespace of all"

make_house; printf 'namespace marketgen::scene {\nstruct Scene {};\n}\n' >> store/store.cpp
expect 1 "a file of store opens namespace marketgen::store only" "a module does not write into another's namespace"

make_house
printf 'namespace marketgen::scene {\nstruct Scene;\n}\nnamespace marketgen::store {\nnamespace {\n}\n}\n' >> store/store.cpp
expect 0 "modules keep to" "a type of another module is declared ahead in that module's namespace"

make_house; printf 'namespace marketgen::store::parts {\n}\n' >> store/store.cpp
expect 0 "modules keep to" "a namespace within the module's own"

make_house; echo '# Architecture' > "$tree/docs/architecture.md"
expect 1 "no layer table" "a document without the table is an error, not a pass"

cd "$repository"
printf 'check_layers_test: %d of %d cases passed\n' $((cases - failures)) "$cases"
[ "$failures" = 0 ]
