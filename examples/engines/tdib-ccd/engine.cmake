# The program of the paper's authors is headers; Debian has the Eigen that they need.
find_package(Eigen3 REQUIRED)
target_compile_features(adapter PRIVATE cxx_std_20)
target_include_directories(adapter PRIVATE ${ENGINE_SOURCE}/core)
target_link_libraries(adapter PRIVATE Eigen3::Eigen)
