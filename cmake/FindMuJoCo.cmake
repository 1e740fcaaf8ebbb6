# MuJoCo: from $MUJOCO_DIR (the folder that holds include/ and libmujoco.so.<version>, as in the wheel, or under lib/, as in MuJoCo's
# own archives), from the PyPI wheel `mujoco-core` in the environment that pip builds in, or from that in .venv of tools/setup.
# The wheel has headers and a versioned library, but no config file.
#
# Defines the imported target MuJoCo::MuJoCo and MuJoCo_VERSION.
file(GLOB _mujoco_wheels "${PROJECT_SOURCE_DIR}/.venv/lib/python3*/site-packages/mujoco")
set(_mujoco_roots "$ENV{MUJOCO_DIR}")
if(SKBUILD)
  execute_process(  # finds it without importing it
    COMMAND "${Python_EXECUTABLE}" -c "import importlib.util as u; print(*u.find_spec('mujoco').submodule_search_locations)"
    OUTPUT_VARIABLE _mujoco_built_with OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  list(APPEND _mujoco_roots "${_mujoco_built_with}")
endif()
list(APPEND _mujoco_roots ${_mujoco_wheels})

set(MuJoCo_LIBRARY "")
set(MuJoCo_INCLUDE_DIR "")
foreach(_root IN LISTS _mujoco_roots)
  file(GLOB _libraries "${_root}/libmujoco.so.*" "${_root}/lib/libmujoco.so.*")
  if(_libraries AND EXISTS "${_root}/include/mujoco/mujoco.h")
    list(GET _libraries 0 MuJoCo_LIBRARY)
    set(MuJoCo_INCLUDE_DIR "${_root}/include")
    break()
  endif()
endforeach()

if(MuJoCo_LIBRARY)
  string(REGEX REPLACE ".*libmujoco\\.so\\." "" MuJoCo_VERSION "${MuJoCo_LIBRARY}")
endif()

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(MuJoCo
  REQUIRED_VARS MuJoCo_LIBRARY MuJoCo_INCLUDE_DIR
  VERSION_VAR MuJoCo_VERSION)

if(MuJoCo_FOUND AND NOT TARGET MuJoCo::MuJoCo)
  get_filename_component(_mujoco_soname "${MuJoCo_LIBRARY}" NAME)
  add_library(MuJoCo::MuJoCo SHARED IMPORTED)
  set_target_properties(MuJoCo::MuJoCo PROPERTIES
    IMPORTED_LOCATION "${MuJoCo_LIBRARY}"
    IMPORTED_SONAME "${_mujoco_soname}"
    INTERFACE_INCLUDE_DIRECTORIES "${MuJoCo_INCLUDE_DIR}")
endif()
