# The floating-point rules are checked, not assumed: fp_probe.cpp fails if the flags that this
# build really uses contract a*b+c, evaluate in extended precision, flush subnormals or allow
# reassociation. The order is that of a target's command line: global flags, those of the build
# type, the directory's options, then what ccdfuzz_flags adds (which therefore wins over a
# -ffp-contract=fast before it). tests/build runs the same probe as a target of this build.
include(CheckCXXSourceRuns)

if(CMAKE_BUILD_TYPE)
  set(ccdfuzz_checked_configs ${CMAKE_BUILD_TYPE})
else()
  set(ccdfuzz_checked_configs ${CMAKE_CONFIGURATION_TYPES})
endif()
get_directory_property(ccdfuzz_directory_options COMPILE_OPTIONS)
get_directory_property(CMAKE_REQUIRED_LINK_OPTIONS LINK_OPTIONS)
file(READ ${CMAKE_CURRENT_LIST_DIR}/fp_probe.cpp ccdfuzz_fp_probe)

foreach(config IN LISTS ccdfuzz_checked_configs)
  string(TOUPPER ${config} config)
  set(CMAKE_REQUIRED_FLAGS "${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${config}}")
  list(JOIN ccdfuzz_directory_options " " options)
  string(APPEND CMAKE_REQUIRED_FLAGS " ${options}")
  list(JOIN ccdfuzz_fp_options " " options)
  string(APPEND CMAKE_REQUIRED_FLAGS " ${options} -std=c++20")
  # The answer is cached, for these flags only.
  string(MD5 key "${CMAKE_REQUIRED_FLAGS} ${ccdfuzz_fp_probe}")
  check_cxx_source_runs("${ccdfuzz_fp_probe}" CCDFUZZ_FP_RULES_HOLD_${key})
  if(NOT CCDFUZZ_FP_RULES_HOLD_${key})
    message(FATAL_ERROR
      "The compiler's flags (${CMAKE_REQUIRED_FLAGS}) break the floating-point rules that ccdfuzz "
      "proves its bounds on: no contraction, no extended precision, no flush to zero, "
      "bits compared as such, no -ffast-math. Remove the offending flag, or take another compiler; cmake/fp_probe.cpp says what is checked.")
  endif()
endforeach()
unset(CMAKE_REQUIRED_FLAGS)
unset(CMAKE_REQUIRED_LINK_OPTIONS)
