# ccdfuzz_flags carries what every target needs: the language level, and the floating-point rules
# on which every error bound in this project stands.
add_library(ccdfuzz_flags INTERFACE)
add_library(ccdfuzz::flags ALIAS ccdfuzz_flags)
set_target_properties(ccdfuzz_flags PROPERTIES EXPORT_NAME flags)
target_compile_features(ccdfuzz_flags INTERFACE cxx_std_20)
if(CMAKE_CXX_COMPILER_ID STREQUAL "Clang" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 16)
  message(FATAL_ERROR "clang ${CMAKE_CXX_COMPILER_VERSION} does not know enough of C++20; use clang 16 or newer, "
                      "such as Debian's clang++-19, or gcc 12")
endif()
# clang makes a comparison of doubles of one of bits, unless it hears that a thread may flush subnormals: a host may.
set(ccdfuzz_fp_options -ffp-contract=off)
include(CheckCXXCompilerFlag)
check_cxx_compiler_flag(-fdenormal-fp-math=dynamic CCDFUZZ_HEARS_OF_FLUSHING)
if(CCDFUZZ_HEARS_OF_FLUSHING)
  list(APPEND ccdfuzz_fp_options -fdenormal-fp-math=dynamic)
endif()
# Who uses an installed library compiles with flags of his own.
target_compile_options(ccdfuzz_flags INTERFACE "$<BUILD_INTERFACE:${ccdfuzz_fp_options}>")
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)

add_library(ccdfuzz_warnings INTERFACE)
target_compile_options(ccdfuzz_warnings INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion -Wdouble-promotion
  $<$<BOOL:${CCDFUZZ_WERROR}>:-Werror>
  # GCC 12 sees overlaps and overflows in any "text" + std::string (PR105651), and out of bounds, too,
  # where its header was read beforehand.
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict;-Wno-stringop-overflow>
  $<$<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_LESS:$<CXX_COMPILER_VERSION>,13>>:-Wno-array-bounds>
  $<$<CXX_COMPILER_ID:Clang>:-Wno-gnu-zero-variadic-macro-arguments>)

if(CCDFUZZ_SANITIZE)
  # Without the two checks that stand before every access to a member, and take a fifth of the time to
  # compile: ASan reports what goes through a null pointer.
  add_compile_options(-fsanitize=address,undefined -fno-sanitize=null,alignment
    -fno-sanitize-recover=all -fno-omit-frame-pointer)
  add_link_options(-fsanitize=address,undefined)
endif()
if(CCDFUZZ_FUZZ)
  if(NOT CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
    message(FATAL_ERROR "CCDFUZZ_FUZZ needs clang for libFuzzer, not ${CMAKE_CXX_COMPILER_ID}; "
                        "use the preset: cmake --preset fuzz")
  endif()
  set(ccdfuzz_guidance -fsanitize=fuzzer-no-link)  # what the targets run tells libFuzzer where it is
  add_link_options(-fsanitize=fuzzer-no-link)
endif()
if(CCDFUZZ_COVERAGE)
  add_compile_options(--coverage)
  add_link_options(--coverage)
endif()

# The headers of Eigen, GMP and GoogleTest take most of the time to compile: the files of a target
# go into few translation units. Each file stands alone without it (the dev preset).
set(CMAKE_UNITY_BUILD ${CCDFUZZ_UNITY})
set(CMAKE_UNITY_BUILD_BATCH_SIZE 32)

# And are read once for the libraries, and once for the tests.
if(NOT CCDFUZZ_UNITY)
  set(CMAKE_DISABLE_PRECOMPILE_HEADERS ON)
endif()
set(ccdfuzz_read_once <Eigen/Core> <fmt/format.h> <gmpxx.h> <algorithm> <array> <filesystem> <fstream> <functional>
    <iostream> <map> <memory> <optional> <random> <span> <sstream> <string> <tl/expected.hpp> <vector>)

include(cmake/fp_rules.cmake)

# GCC collects its garbage first at half a gigabyte: a tenth of its time, for half as much memory again.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  add_compile_options($<$<COMPILE_LANGUAGE:CXX>:--param=ggc-min-heapsize=500000>)
endif()

# Of what asks, counts and prints; what takes time is elsewhere. It compiles in half the time, under
# sanitizers in a third.
set(ccdfuzz_quick_to_compile $<IF:$<CONFIG:Release>,-O1,-O0>)

# ccdfuzz_hot_first(TARGET): of an inline function that several rooms compile, the linker takes the first. So the rooms
# that take the time come before all others, however those are compiled.
function(ccdfuzz_hot_first target)
  set(hot numeric bezier case linear checker oracle ccd ccd_certified ccd_rational ccd_witness_trace draw generators)
  list(TRANSFORM hot REPLACE "(.+)" "$<TARGET_FILE:ccdfuzz_\\1>")
  target_link_options(${target} PRIVATE LINKER:--whole-archive ${hot} LINKER:--no-whole-archive)
endfunction()

# ccdfuzz_room(NAME LINES N DEPENDS ...): this folder is a room, ccdfuzz::NAME. Its files include its own
# headers, those of the rooms that DEPENDS names, and what these may include. LINES is its budget: it holds no
# more lines of C++. Of each room a line, "FOLDER NAME N DEPENDS ...", goes into rooms.txt of the build, from
# which tests/build checks both.
function(ccdfuzz_room name)
  cmake_parse_arguments(ARG "" "LINES" "DEPENDS" ${ARGN})
  file(RELATIVE_PATH folder ${PROJECT_SOURCE_DIR} ${CMAKE_CURRENT_SOURCE_DIR})
  list(FILTER ARG_DEPENDS INCLUDE REGEX "^ccdfuzz::")
  list(JOIN ARG_DEPENDS " " below)
  file(APPEND ${PROJECT_BINARY_DIR}/rooms.txt "${folder} ccdfuzz::${name} ${ARG_LINES} ${below}\n")
endfunction()
file(WRITE ${PROJECT_BINARY_DIR}/rooms.txt "")

# ccdfuzz_library(NAME [QUICK|COLD] [APART] LINES N SOURCES ... DEPENDS ...): one library a room, so that the layers
# of the design are also the links of the build. QUICK: it compiles fast, as it is optimised little; no fuzz target runs
# it. COLD: it only calls code that takes time, so a release optimises it little.
# APART: it needs a package that users may lack, and is installed as a component of its own.
function(ccdfuzz_library name)
  cmake_parse_arguments(ARG "QUICK;COLD;APART" "LINES" "SOURCES;DEPENDS" ${ARGN})
  ccdfuzz_room(${name} LINES ${ARG_LINES} DEPENDS ${ARG_DEPENDS})
  if(ARG_SOURCES)
    add_library(ccdfuzz_${name} STATIC ${ARG_SOURCES})
    set(scope PUBLIC)
    target_link_libraries(ccdfuzz_${name} PRIVATE $<BUILD_INTERFACE:ccdfuzz_warnings>)
    if(ARG_QUICK)
      target_compile_options(ccdfuzz_${name} PRIVATE ${ccdfuzz_quick_to_compile})
    else()
      target_compile_options(ccdfuzz_${name} PRIVATE ${ccdfuzz_guidance})
    endif()
    if(ARG_COLD)
      target_compile_options(ccdfuzz_${name} PRIVATE $<$<CONFIG:Release>:-O1>)
    endif()
    # (Compilers take them with the same instruments, clang at any level of optimisation but none. GCC
    # compiles at that which they were read at.)
    if(name STREQUAL "numeric")
      target_precompile_headers(ccdfuzz_numeric PRIVATE ${ccdfuzz_read_once})
    elseif(NOT ARG_QUICK AND NOT (ARG_COLD AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
           AND NOT name MATCHES "^(base|io)$")  # (these have no Eigen)
      target_precompile_headers(ccdfuzz_${name} REUSE_FROM ccdfuzz_numeric)
    endif()
  else()
    add_library(ccdfuzz_${name} INTERFACE)
    set(scope INTERFACE)
  endif()
  add_library(ccdfuzz::${name} ALIAS ccdfuzz_${name})
  set_target_properties(ccdfuzz_${name} PROPERTIES EXPORT_NAME ${name})
  target_include_directories(ccdfuzz_${name} ${scope}
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/src>
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/ccdfuzz>)
  target_link_libraries(ccdfuzz_${name} ${scope} ccdfuzz::flags ${ARG_DEPENDS})
  if(NOT ARG_APART)
    set_property(GLOBAL APPEND PROPERTY CCDFUZZ_LIBRARIES ccdfuzz_${name})
  endif()
endfunction()
