# find_package(ccdfuzz CONFIG) then gives ccdfuzz::NAME for every library, and headers as
# <ccdfuzz/query/query.hpp>.
include(CMakePackageConfigHelpers)

get_property(ccdfuzz_libraries GLOBAL PROPERTY CCDFUZZ_LIBRARIES)
install(TARGETS ccdfuzz_base ${ccdfuzz_libraries} EXPORT ccdfuzz_targets)

foreach(folder src/ generators properties)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/${folder}
          DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/ccdfuzz
          FILES_MATCHING PATTERN "*.hpp" PATTERN "*.h" PATTERN "cli" EXCLUDE)
endforeach()

set(ccdfuzz_config_dir ${CMAKE_INSTALL_LIBDIR}/cmake/ccdfuzz)
install(EXPORT ccdfuzz_targets NAMESPACE ccdfuzz:: DESTINATION ${ccdfuzz_config_dir}
        FILE ccdfuzz-targets.cmake)
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/ccdfuzz-config.cmake.in
  ${PROJECT_BINARY_DIR}/ccdfuzz-config.cmake INSTALL_DESTINATION ${ccdfuzz_config_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/ccdfuzz-config-version.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/ccdfuzz-config.cmake
              ${PROJECT_BINARY_DIR}/ccdfuzz-config-version.cmake
        DESTINATION ${ccdfuzz_config_dir})
