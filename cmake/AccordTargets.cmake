# What every target of the project is built with. A folder is a target: accord_folder() names it
# after the folder and links it downwards only (docs/architecture.md).

add_library(accord_options INTERFACE)
target_compile_options(accord_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion -Wold-style-cast
  -Wnon-virtual-dtor -Woverloaded-virtual -Wnull-dereference -Werror
  # The same request must give the same bytes on every machine: no fused multiply-add that the
  # source does not ask for, and no relaxed arithmetic anywhere.
  -ffp-contract=off)
target_include_directories(accord_options INTERFACE ${PROJECT_SOURCE_DIR})

# GCC 12 sees null dereferences, stray reads and overlaps in its own library under -O3 and the
# sanitizers.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  target_compile_options(accord_options INTERFACE -Wno-null-dereference -Wno-maybe-uninitialized
                         -Wno-restrict)
endif()
if(ACCORD_ASSERTS)
  target_compile_options(accord_options INTERFACE -UNDEBUG)
endif()
if(ACCORD_SANITIZE)
  target_compile_options(accord_options INTERFACE
    -fsanitize=${ACCORD_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(accord_options INTERFACE -fsanitize=${ACCORD_SANITIZE})
endif()

# accord_folder(NAME SOURCES ... [PUBLIC targets...] [PRIVATE targets...])
function(accord_folder name)
  cmake_parse_arguments(arg "" "" "SOURCES;PUBLIC;PRIVATE" ${ARGN})
  add_library(${name} STATIC ${arg_SOURCES})
  target_link_libraries(${name} PUBLIC accord_options ${arg_PUBLIC} PRIVATE ${arg_PRIVATE})
endfunction()
