# Every outside library, each as one imported target that modules name under LIBRARIES:
#
#   MuJoCo::MuJoCo  embree::embree  TBB::tbb  Eigen3::Eigen  Cairo::Pango  Zint::Zint
#   nlohmann_json::nlohmann_json  flatbuffers::flatbuffers  CLI11::CLI11  fmt::fmt  spdlog::spdlog  tinyxml2::tinyxml2
#   xsimd::xsimd  squish::squish  TinyGLTF::TinyGLTF  meshoptimizer::meshoptimizer
#   PNG::PNG  JPEG::JPEG  TinyEXR::TinyEXR  SQLite::SQLite3  utf8proc::utf8proc  OpenSSL::Crypto  CURL::libcurl  xxHash::xxhash
#   GTest::gtest  GTest::gtest_main  fcl::fcl (tests)
#
# All come from `tools/setup`: Debian 12 packages, and MuJoCo from PyPI in .venv.

macro(marketgen_find name)
  find_package(${name} ${ARGN} QUIET)
  if(NOT ${name}_FOUND)
    message(FATAL_ERROR "${name} ${ARGN} was not found: run tools/setup")
  endif()
endmacro()

# A library that comes with a pkg-config file, as <name>::<name>.
function(marketgen_find_pkgconfig target)
  string(REGEX REPLACE "[^A-Za-z0-9]" "_" prefix "${target}")
  pkg_check_modules(${prefix} QUIET IMPORTED_TARGET GLOBAL ${ARGN})
  if(NOT ${prefix}_FOUND)
    message(FATAL_ERROR "${ARGN} was not found by pkg-config: run tools/setup")
  endif()
  add_library(${target} ALIAS PkgConfig::${prefix})
endfunction()

marketgen_find(Threads)
marketgen_find(TBB)
marketgen_find(embree 3)
marketgen_find(Eigen3)
marketgen_find(nlohmann_json)
marketgen_find(CLI11)
marketgen_find(fmt)
marketgen_find(spdlog)
marketgen_find(TinyGLTF)
marketgen_find(meshoptimizer)
marketgen_find(PNG)
marketgen_find(JPEG)
marketgen_find(SQLite3)
marketgen_find(tinyxml2)
marketgen_find(OpenSSL COMPONENTS Crypto)
marketgen_find(CURL)
marketgen_find(Zint)
marketgen_find(MuJoCo 4.0.1 EXACT)
marketgen_find(xsimd 8)
add_library(embree::embree ALIAS embree)
# Debian's target also links xtl, which only complex numbers need.
add_library(xsimd::xsimd INTERFACE IMPORTED)
target_include_directories(xsimd::xsimd INTERFACE "${xsimd_INCLUDE_DIRS}")

marketgen_find(PkgConfig)
marketgen_find_pkgconfig(Cairo::Pango cairo pangocairo)
marketgen_find_pkgconfig(utf8proc::utf8proc libutf8proc)
marketgen_find_pkgconfig(xxHash::xxhash libxxhash)

# Debian's libsquish.pc names folders that do not exist.
find_library(MARKETGEN_SQUISH squish)
if(NOT MARKETGEN_SQUISH)
  message(FATAL_ERROR "libsquish was not found: run tools/setup")
endif()
add_library(squish::squish UNKNOWN IMPORTED)
set_target_properties(squish::squish PROPERTIES IMPORTED_LOCATION "${MARKETGEN_SQUISH}")

# Debian's libtinyexr has neither a CMake nor a pkg-config file.
find_library(MARKETGEN_TINYEXR tinyexr)
find_path(MARKETGEN_TINYEXR_INCLUDE tinyexr.h)
if(NOT MARKETGEN_TINYEXR OR NOT MARKETGEN_TINYEXR_INCLUDE)
  message(FATAL_ERROR "libtinyexr was not found: run tools/setup")
endif()
add_library(TinyEXR::TinyEXR UNKNOWN IMPORTED)
set_target_properties(TinyEXR::TinyEXR PROPERTIES
  IMPORTED_LOCATION "${MARKETGEN_TINYEXR}" INTERFACE_INCLUDE_DIRECTORIES "${MARKETGEN_TINYEXR_INCLUDE}")

find_package(FlatBuffers QUIET CONFIG NAMES FlatBuffers Flatbuffers)
if(NOT TARGET flatbuffers::flatbuffers)
  message(FATAL_ERROR "FlatBuffers was not found: run tools/setup")
endif()

if(MARKETGEN_TESTS)
  marketgen_find(GTest)
  # Debian's fcl.pc asks for C++11.
  find_library(MARKETGEN_FCL fcl)
  if(NOT MARKETGEN_FCL)
    message(FATAL_ERROR "libfcl was not found: run tools/setup")
  endif()
  add_library(fcl::fcl UNKNOWN IMPORTED)
  set_target_properties(fcl::fcl PROPERTIES
    IMPORTED_LOCATION "${MARKETGEN_FCL}" INTERFACE_LINK_LIBRARIES "Eigen3::Eigen;ccd")
endif()
