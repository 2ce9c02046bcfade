# find_package(ccdfuzz CONFIG) then gives ccdfuzz::NAME for every library, and headers as
# <ccdfuzz/case/query.hpp>.
include(CMakePackageConfigHelpers)

get_property(ccdfuzz_libraries GLOBAL PROPERTY CCDFUZZ_LIBRARIES)
install(TARGETS ccdfuzz_flags ${ccdfuzz_libraries} EXPORT ccdfuzz_targets)

# The public interface: reading and writing cases, asking methods and the oracle, judging, checking. These
# may be compiled with any flags, -ffast-math too: none includes numeric/ieee_arithmetic.hpp, as all headers
# with arithmetic that an error bound speaks of do. (tests/build/consumer compiles each by itself.)
set(ccdfuzz_public_headers
  bezier/patch.hpp bezier/shape.hpp bezier/turn.hpp
  case/search_options.hpp
  certify/checker/check_box.hpp certify/checker/check_case.hpp certify/checker/check_linear.hpp
  certify/checker/check_plane.hpp certify/checker/check_tree.hpp certify/checker/check_truth.hpp
  certify/checker/check_witness.hpp certify/checker/work_done.hpp certify/checker/work.hpp
  certify/oracle/complete_truth.hpp certify/oracle/oracle.hpp
  method/domain.hpp method/features.hpp
  method/method.hpp
  numeric/dyadic.hpp numeric/exact_scalars.hpp numeric/fraction.hpp numeric/rational.hpp numeric/vec3.hpp base/double_parts.hpp base/enum_names.hpp base/result.hpp base/stopwatch.hpp base/time_limit.hpp base/verify.hpp
  case/answer.hpp case/body_kind.hpp case/case.hpp case/certificate.hpp
  case/checked_case.hpp case/judge.hpp case/outcome.hpp case/query.hpp case/taxonomy.hpp
  files/case_files.hpp files/case_json.hpp files/check_file.hpp files/query_csv.hpp
  io/descriptor.hpp io/input_bytes.hpp io/line_reader.hpp io/output_file.hpp)
foreach(header IN LISTS ccdfuzz_public_headers)
  cmake_path(GET header PARENT_PATH folder)
  install(FILES ${PROJECT_SOURCE_DIR}/src/${header} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/ccdfuzz/${folder})
endforeach()

set(ccdfuzz_config_dir ${CMAKE_INSTALL_LIBDIR}/cmake/ccdfuzz)
install(EXPORT ccdfuzz_targets NAMESPACE ccdfuzz:: DESTINATION ${ccdfuzz_config_dir}
        FILE ccdfuzz-targets.cmake)
# <ccdfuzz/mutate.hpp>, for libFuzzer, and what <ccdfuzz/rapidcheck.hpp> includes besides.
foreach(header fuzz/mutator/case_bytes.hpp generators/contact.hpp generators/draw_contact.hpp
        generators/generate.hpp generators/draw/draw.hpp generators/draw/random.hpp)
  cmake_path(GET header PARENT_PATH folder)
  install(FILES ${PROJECT_SOURCE_DIR}/${header} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/ccdfuzz/${folder})
endforeach()
install(FILES ${PROJECT_SOURCE_DIR}/fuzz/mutator/mutate.hpp DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/ccdfuzz)

# <ccdfuzz/rapidcheck.hpp> and ccdfuzz::rapidcheck, where there is RapidCheck.
if(TARGET ccdfuzz_rapidcheck)
  install(FILES ${PROJECT_SOURCE_DIR}/generators/rc/rapidcheck.hpp DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/ccdfuzz)
  install(TARGETS ccdfuzz_rapidcheck EXPORT ccdfuzz_rapidcheck_targets)
  install(EXPORT ccdfuzz_rapidcheck_targets NAMESPACE ccdfuzz:: DESTINATION ${ccdfuzz_config_dir}
          FILE ccdfuzz-rapidcheck-targets.cmake)
endif()
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/ccdfuzz-config.cmake.in
  ${PROJECT_BINARY_DIR}/ccdfuzz-config.cmake INSTALL_DESTINATION ${ccdfuzz_config_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/ccdfuzz-config-version.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/ccdfuzz-config.cmake
              ${PROJECT_BINARY_DIR}/ccdfuzz-config-version.cmake
        DESTINATION ${ccdfuzz_config_dir})
