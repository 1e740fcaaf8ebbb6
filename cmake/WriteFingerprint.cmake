# cmake -DOUT=<header> -DNAME=<constant> -DFOLDERS=<a;b> -P WriteFingerprint.cmake
#
# Writes a header whose constant is a hash over the text of every .cpp and .h below the folders. The file is touched
# only when the hash changes.
set(all "")
foreach(folder IN LISTS FOLDERS)
  file(GLOB_RECURSE sources LIST_DIRECTORIES false "${folder}/*.cpp" "${folder}/*.h" "${folder}/*.inc")
  list(SORT sources)
  foreach(source IN LISTS sources)
    file(SHA256 "${source}" hash)
    string(APPEND all "${hash}")
  endforeach()
endforeach()
string(SHA256 hash "${all}")
string(SUBSTRING "${hash}" 0 16 hash)
set(text "// Written by cmake/WriteFingerprint.cmake.\n#pragma once\nnamespace marketgen {\n// Changes whenever the sources change.\ninline constexpr const char* ${NAME} = \"${hash}\";\n}  // namespace marketgen\n")
set(before "")
if(EXISTS "${OUT}")
  file(READ "${OUT}" before)
endif()
if(NOT before STREQUAL text)
  file(WRITE "${OUT}" "${text}")
endif()
