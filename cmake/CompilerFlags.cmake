# How every translation unit of ours is compiled, and what it is linked with.

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)  # clang-tidy and editors read it

# The same bits on every machine, in every build type and for any compiler: one instruction set, and no
# contraction of a*b+c into one rounding. -ffast-math would break both.
add_compile_options(-march=x86-64-v3 -ffp-contract=off)
if(CMAKE_CXX_FLAGS MATCHES "-ffast-math|-Ofast")
  message(FATAL_ERROR "-ffast-math makes results depend on the compiler; take it out of CMAKE_CXX_FLAGS")
endif()

# The libraries end up in Python's module, too. What nobody outside sees is called directly all the same.
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_CXX_VISIBILITY_PRESET hidden)
set(CMAKE_VISIBILITY_INLINES_HIDDEN ON)

# Sign conversions are left out: Eigen, Embree and FlatBuffers mix signed and unsigned sizes in every signature.
add_compile_options(-Wall -Wextra -Wpedantic -Wconversion -Wno-sign-conversion)
# In a unity build the constants of one file are global to the next: a local of the same name hides nothing.
if(CMAKE_UNITY_BUILD AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  add_compile_options(-Wshadow=local)
elseif(NOT CMAKE_UNITY_BUILD)
  add_compile_options(-Wshadow)
endif()
# g++ 12 sees uninitialised members in every std::optional that it inlines (GCC bug 80635).
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  add_compile_options(-Wno-maybe-uninitialized)
  # Its garbage collector costs a tenth of the time of compiling; without it g++ takes a quarter more memory.
  add_compile_options("SHELL:--param ggc-min-heapsize=3000000" "SHELL:--param ggc-min-expand=1000")
endif()
if(MARKETGEN_WERROR)
  add_compile_options(-Werror)
endif()

if(MARKETGEN_SANITIZE)
  list(JOIN MARKETGEN_SANITIZE "," sanitizers)
  add_compile_options(-fsanitize=${sanitizers} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  add_link_options(-fsanitize=${sanitizers})
endif()
if(MARKETGEN_FUZZ)
  if(NOT CMAKE_CXX_COMPILER_ID MATCHES "Clang")
    message(FATAL_ERROR "MARKETGEN_FUZZ needs clang's libFuzzer: use `cmake --preset asan`")
  endif()
  add_compile_options(-fsanitize=fuzzer-no-link)
endif()

# A compiler takes up to 1.7 GB for one translation unit of many files: no more at a time than there is memory for.
cmake_host_system_information(RESULT memory_mb QUERY TOTAL_PHYSICAL_MEMORY)
math(EXPR compilers "${memory_mb} / 1800")
if(compilers LESS 1)
  set(compilers 1)
endif()
set_property(GLOBAL APPEND PROPERTY JOB_POOLS compilers=${compilers})
set(CMAKE_JOB_POOL_COMPILE compilers)

find_program(MARKETGEN_CCACHE ccache)
if(MARKETGEN_CCACHE)  # build folders of one tree (release, a wheel) share what they compile
  set(CMAKE_CXX_COMPILER_LAUNCHER
      "${CMAKE_COMMAND};-E;env;CCACHE_BASEDIR=${PROJECT_SOURCE_DIR};${MARKETGEN_CCACHE}")
endif()

include(CheckLinkerFlag)
check_linker_flag(CXX "-fuse-ld=mold" MARKETGEN_HAS_MOLD)
if(MARKETGEN_HAS_MOLD)
  add_link_options(-fuse-ld=mold)
endif()
