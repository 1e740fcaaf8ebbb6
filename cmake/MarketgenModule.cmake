# marketgen_module(<name> [DEPENDS module...] [LIBRARIES target...] [TEST_LIBRARIES target...])
#
# One room of the house: called once, from src/marketgen/<name>/CMakeLists.txt.
#   DEPENDS         other modules; only from a smaller row of docs/architecture.md (tools/check_layers looks)
#   LIBRARIES       outside libraries, by the names in cmake/Dependencies.cmake
#   TEST_LIBRARIES  what only tests/unit/<name> needs: outside libraries, or marketgen_<module>
#
# Makes the static library marketgen_<name> of every .cpp in the folder and below (an INTERFACE library when there is none).
# Includes read `#include "<module>/<header>.h"`.
include_guard(GLOBAL)

function(marketgen_module name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "DEPENDS;LIBRARIES;TEST_LIBRARIES")
  if(arg_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "marketgen_module(${name}): what is ${arg_UNPARSED_ARGUMENTS}?")
  endif()

  set(target marketgen_${name})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/*.cpp")
  if(sources)
    add_library(${target} STATIC ${sources})
    set(visibility PUBLIC)
  else()
    add_library(${target} INTERFACE)
    set(visibility INTERFACE)
  endif()
  target_include_directories(${target} ${visibility} "${PROJECT_SOURCE_DIR}/src/marketgen")
  target_include_directories(${target} SYSTEM ${visibility} "${MARKETGEN_GENERATED_DIR}")

  foreach(dependency IN LISTS arg_DEPENDS)
    if(TARGET marketgen_${dependency})
      target_link_libraries(${target} ${visibility} marketgen_${dependency})
    else()
      message(WARNING "module ${name} depends on ${dependency}, which has no CMakeLists.txt or stands in a later row")
    endif()
  endforeach()
  target_link_libraries(${target} ${visibility} ${arg_LIBRARIES})

  set_property(TARGET ${target} PROPERTY MARKETGEN_TEST_LIBRARIES "${arg_TEST_LIBRARIES}")
  set_property(GLOBAL APPEND PROPERTY MARKETGEN_BUILT_MODULES ${name})
endfunction()

# marketgen_fingerprint(MODULE NAME FOLDERS...): a header MODULE/NAME_fingerprint.h with a hash over the sources of those modules,
# or of a "module/file" without its ending, for what MODULE keeps on disk between runs: a program that would make it otherwise finds nothing of it.
function(marketgen_fingerprint module name)
  set(folders ${ARGN})
  list(TRANSFORM folders PREPEND "${PROJECT_SOURCE_DIR}/src/marketgen/")
  set(header "${MARKETGEN_GENERATED_DIR}/${module}/${name}_fingerprint.h")
  add_custom_target(marketgen_${name}_fingerprint
    COMMAND "${CMAKE_COMMAND}" "-DOUT=${header}" -DNAME=${name}_fingerprint "-DFOLDERS=${folders}"
      -P "${PROJECT_SOURCE_DIR}/cmake/WriteFingerprint.cmake"
    BYPRODUCTS "${header}" VERBATIM)
  add_dependencies(marketgen_${module} marketgen_${name}_fingerprint)
endfunction()

# The library targets of every module in the tree.
function(marketgen_all_modules out)
  get_property(modules GLOBAL PROPERTY MARKETGEN_BUILT_MODULES)
  list(TRANSFORM modules PREPEND marketgen_)
  set(${out} ${modules} PARENT_SCOPE)
endfunction()

# Lets an executable find MuJoCo's library: a copy lies in the binary folder, beside the program.
function(marketgen_bundle_mujoco target)
  if(NOT TARGET marketgen_mujoco_copy)
    get_target_property(library MuJoCo::MuJoCo IMPORTED_LOCATION)
    add_custom_target(marketgen_mujoco_copy
      COMMAND "${CMAKE_COMMAND}" -E copy_if_different "${library}" "${PROJECT_BINARY_DIR}"
      COMMENT "Copying MuJoCo beside the program" VERBATIM)
  endif()
  add_dependencies(${target} marketgen_mujoco_copy)
  set_target_properties(${target} PROPERTIES
    BUILD_WITH_INSTALL_RPATH ON
    INSTALL_RPATH "$ORIGIN;$ORIGIN/../lib;$ORIGIN/..")
endfunction()
