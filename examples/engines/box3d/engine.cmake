# The sources of Box3D that b3TimeOfImpact needs.
foreach(part distance math_functions core)
  target_sources(adapter PRIVATE ${ENGINE_SOURCE}/src/${part}.c)
endforeach()
target_include_directories(adapter PRIVATE ${ENGINE_SOURCE}/include ${ENGINE_SOURCE}/src)
