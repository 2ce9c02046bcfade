# Everything comes from Debian's packages; script/setup installs them by name.
find_package(Threads REQUIRED)
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(nlohmann_json 3.11 REQUIRED)
find_package(fmt 9 REQUIRED)
# Fuzzing engines bring a C++ library of their own, with which Debian's binaries do not go.
if(CCDFUZZ_FUZZ_ENGINE)
  set(CCDFUZZ_FMT fmt::fmt-header-only)
  # Where a target runs, there may be none of the libraries: they go into it. (A value from outside does
  # not last: project() sets it anew.)
  set(CMAKE_FIND_LIBRARY_SUFFIXES .a)
else()
  set(CCDFUZZ_FMT fmt::fmt)
endif()
find_package(CLI11 2.1 REQUIRED)
find_package(TBB REQUIRED)
find_package(tl-expected REQUIRED)
find_package(ZLIB REQUIRED)

find_package(PkgConfig REQUIRED)
pkg_check_modules(GMPXX REQUIRED IMPORTED_TARGET gmpxx)
pkg_check_modules(ZSTD REQUIRED IMPORTED_TARGET libzstd)
pkg_check_modules(XXHASH REQUIRED IMPORTED_TARGET libxxhash)

if(CCDFUZZ_TESTS)
  find_package(GTest REQUIRED)
  find_package(rapidcheck CONFIG REQUIRED)
elseif(NOT CCDFUZZ_FUZZ_ENGINE)
  find_package(rapidcheck CONFIG QUIET)  # for ccdfuzz::rapidcheck
endif()
if(CCDFUZZ_BENCH)
  find_package(benchmark REQUIRED)
endif()
