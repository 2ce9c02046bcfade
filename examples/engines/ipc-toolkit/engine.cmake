# The additive CCD of ipc-toolkit, with the distances that it measures; Debian has what they need.
set(made ${CMAKE_CURRENT_BINARY_DIR}/include)
# Debian's spdlog is built with Debian's fmt, and has no copy of it.
file(WRITE ${made}/spdlog/fmt/bundled/ranges.h "#include <fmt/ranges.h>\n")
find_package(Eigen3 REQUIRED)
find_package(spdlog REQUIRED)
foreach(part ccd/additive_ccd distance/distance_type distance/edge_edge distance/line_line
        distance/point_edge distance/point_line distance/point_plane distance/point_point
        distance/point_triangle geometry/normal utils/logger)
  target_sources(adapter PRIVATE ${ENGINE_SOURCE}/src/ipc/${part}.cpp)
endforeach()
target_include_directories(adapter PRIVATE ${made} ${ENGINE_SOURCE}/src)
target_link_libraries(adapter PRIVATE Eigen3::Eigen spdlog::spdlog)
# Its tests are of Catch2 version 3; Debian 12 has version 2, whose header brings main along.
file(WRITE ${made}/catch2/catch_test_macros.hpp "#define CATCH_CONFIG_MAIN\n#include <catch2/catch.hpp>\n")
