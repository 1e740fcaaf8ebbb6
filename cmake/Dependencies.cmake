# Every outside library, each as one imported target that modules name under LIBRARIES:
#
#   MuJoCo::MuJoCo  embree::embree  TBB::tbb  Eigen3::Eigen  Cairo::Pango  Fontconfig::Fontconfig  Zint::Zint
#   nlohmann_json::nlohmann_json  flatbuffers::flatbuffers  CLI11::CLI11  fmt::fmt  spdlog::spdlog  tinyxml2::tinyxml2
#   xsimd::xsimd  squish::squish  TinyGLTF::TinyGLTF  meshoptimizer::meshoptimizer
#   PNG::PNG  ZLIB::ZLIB  JPEG::JPEG  TinyEXR::TinyEXR  SQLite::SQLite3  utf8proc::utf8proc  OpenSSL::Crypto  CURL::libcurl  xxHash::xxhash
#   boost::beast  polyclipping::polyclipping  OpenCV::Imgproc
#   GTest::gtest  GTest::gtest_main  fcl::fcl (tests)
#
# All come from `tools/setup`: Debian 12 packages, and MuJoCo from PyPI (cmake/FindMuJoCo.cmake). Whatever is missing is named at once, at the
# end, by its Debian package.
set(MARKETGEN_MISSING "")

# Notes `package` as missing unless the condition (or a target's name) holds.
macro(marketgen_need package)
  if(NOT (${ARGN}))
    list(APPEND MARKETGEN_MISSING ${package})
  endif()
endmacro()

macro(marketgen_find package name)
  find_package(${name} ${ARGN} QUIET)
  marketgen_need(${package} ${name}_FOUND)
endmacro()

# A library that comes with a pkg-config file, as <name>::<name>.
function(marketgen_find_pkgconfig package target)
  if(NOT PkgConfig_FOUND)
    return()
  endif()
  string(REGEX REPLACE "[^A-Za-z0-9]" "_" prefix "${target}")
  pkg_check_modules(${prefix} QUIET IMPORTED_TARGET GLOBAL ${ARGN})
  marketgen_need(${package} ${prefix}_FOUND)
  set(MARKETGEN_MISSING "${MARKETGEN_MISSING}" PARENT_SCOPE)
  if(${prefix}_FOUND)
    add_library(${target} ALIAS PkgConfig::${prefix})
  endif()
endfunction()

marketgen_find("a C library with threads" Threads)
marketgen_find(libtbb-dev TBB)
marketgen_find(libembree-dev embree 3)
marketgen_find(libeigen3-dev Eigen3)
marketgen_find(nlohmann-json3-dev nlohmann_json)
marketgen_find(libcli11-dev CLI11)
marketgen_find(libfmt-dev fmt)
marketgen_find(libspdlog-dev spdlog)
marketgen_find(libtinygltf-dev TinyGLTF)
marketgen_find(libmeshoptimizer-dev meshoptimizer)
marketgen_find(libpng-dev PNG)
marketgen_find(zlib1g-dev ZLIB)
marketgen_find(libjpeg62-turbo-dev JPEG)
marketgen_find(libsqlite3-dev SQLite3)
marketgen_find(libtinyxml2-dev tinyxml2)
marketgen_find(libssl-dev OpenSSL COMPONENTS Crypto)
marketgen_find(libcurl4-openssl-dev CURL)
marketgen_find(libzint-dev Zint)
marketgen_find(libboost-dev Boost 1.74)
marketgen_find(MuJoCo MuJoCo 4.0.1 EXACT)
marketgen_find(libxsimd-dev xsimd 8)
if(embree_FOUND)
  add_library(embree::embree ALIAS embree)
endif()
# Headers alone: Beast, Asio and what they include.
add_library(boost::beast INTERFACE IMPORTED)
target_include_directories(boost::beast SYSTEM INTERFACE "${Boost_INCLUDE_DIRS}")
target_link_libraries(boost::beast INTERFACE Threads::Threads)
# Debian's target also links xtl, which only complex numbers need.
add_library(xsimd::xsimd INTERFACE IMPORTED)
target_include_directories(xsimd::xsimd INTERFACE "${xsimd_INCLUDE_DIRS}")

marketgen_find(pkg-config PkgConfig)
marketgen_find_pkgconfig(libpango1.0-dev Cairo::Pango cairo pangocairo pangoft2)
marketgen_find_pkgconfig(libfontconfig-dev Fontconfig::Fontconfig fontconfig)
marketgen_find_pkgconfig(libutf8proc-dev utf8proc::utf8proc libutf8proc)
marketgen_find_pkgconfig(libxxhash-dev xxHash::xxhash libxxhash)

marketgen_find_pkgconfig(libpolyclipping-dev polyclipping::polyclipping polyclipping)

# Debian's OpenCV asks, as one package, for every module; the program needs two.
find_library(MARKETGEN_OPENCV_CORE opencv_core)
find_library(MARKETGEN_OPENCV_IMGPROC opencv_imgproc)
find_path(MARKETGEN_OPENCV_INCLUDE opencv2/imgproc.hpp PATH_SUFFIXES opencv4)
marketgen_need(libopencv-imgproc-dev MARKETGEN_OPENCV_CORE AND MARKETGEN_OPENCV_IMGPROC AND MARKETGEN_OPENCV_INCLUDE)
add_library(OpenCV::Imgproc UNKNOWN IMPORTED)
set_target_properties(OpenCV::Imgproc PROPERTIES
  IMPORTED_LOCATION "${MARKETGEN_OPENCV_IMGPROC}" INTERFACE_INCLUDE_DIRECTORIES "${MARKETGEN_OPENCV_INCLUDE}"
  INTERFACE_LINK_LIBRARIES "${MARKETGEN_OPENCV_CORE}")

# Debian's libsquish.pc names folders that do not exist.
find_library(MARKETGEN_SQUISH squish)
find_path(MARKETGEN_SQUISH_INCLUDE squish.h)
marketgen_need(libsquish-dev MARKETGEN_SQUISH AND MARKETGEN_SQUISH_INCLUDE)
add_library(squish::squish UNKNOWN IMPORTED)
set_target_properties(squish::squish PROPERTIES IMPORTED_LOCATION "${MARKETGEN_SQUISH}")

# Debian's libtinyexr has neither a CMake nor a pkg-config file.
find_library(MARKETGEN_TINYEXR tinyexr)
find_path(MARKETGEN_TINYEXR_INCLUDE tinyexr.h)
marketgen_need(libtinyexr-dev MARKETGEN_TINYEXR AND MARKETGEN_TINYEXR_INCLUDE)
add_library(TinyEXR::TinyEXR UNKNOWN IMPORTED)
set_target_properties(TinyEXR::TinyEXR PROPERTIES
  IMPORTED_LOCATION "${MARKETGEN_TINYEXR}" INTERFACE_INCLUDE_DIRECTORIES "${MARKETGEN_TINYEXR_INCLUDE}")

find_package(FlatBuffers QUIET CONFIG NAMES FlatBuffers Flatbuffers)
marketgen_need(libflatbuffers-dev TARGET flatbuffers::flatbuffers)

# Fonts of labels: the program reads them here, an installation gets copies (src/marketgen/assets/print/fonts.cpp).
set(MARKETGEN_FONTS DEJAVU LATO OPEN_SANS)
function(marketgen_find_fonts family package file)
  find_path(MARKETGEN_FONTS_${family} ${file} NO_DEFAULT_PATH
    PATHS /usr/share/fonts/truetype /usr/share/fonts /usr/local/share/fonts PATH_SUFFIXES ${ARGN})
  marketgen_need(${package} MARKETGEN_FONTS_${family})
  set(MARKETGEN_MISSING "${MARKETGEN_MISSING}" PARENT_SCOPE)
endfunction()
marketgen_find_fonts(DEJAVU fonts-dejavu-core DejaVuSans.ttf dejavu)
marketgen_find_fonts(LATO fonts-lato Lato-Regular.ttf lato)
marketgen_find_fonts(OPEN_SANS fonts-open-sans OpenSans-Regular.ttf open-sans)

if(MARKETGEN_TESTS)
  marketgen_find(libgtest-dev GTest)
  # Debian's fcl.pc asks for C++11.
  find_library(MARKETGEN_FCL fcl)
  marketgen_need(libfcl-dev MARKETGEN_FCL)
  add_library(fcl::fcl UNKNOWN IMPORTED)
  set_target_properties(fcl::fcl PROPERTIES
    IMPORTED_LOCATION "${MARKETGEN_FCL}" INTERFACE_LINK_LIBRARIES "Eigen3::Eigen;ccd")
endif()

if(MARKETGEN_MISSING)
  list(JOIN MARKETGEN_MISSING " " missing)
  set(help "`tools/setup build`, as root on Debian 12, installs everything that building needs; elsewhere it lists it.")
  if(MARKETGEN_TESTS)
    string(REPLACE "build`" "test`" help "${help}")
  endif()
  if("MuJoCo" IN_LIST MARKETGEN_MISSING)
    string(APPEND help "\nMuJoCo 4.0.1 is PyPI's mujoco-core, for Python 3.11 and later. pip brings it by itself; otherwise tools/setup puts it "
      "into .venv, or MUJOCO_DIR names it.")
  endif()
  message(FATAL_ERROR "MarketGen cannot be built here, these are missing: ${missing}\n${help}")
endif()
