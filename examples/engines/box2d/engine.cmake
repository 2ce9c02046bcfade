# The sources of Box2D v3 that b2TimeOfImpact needs.
foreach(part distance math_functions core hull geometry)
  target_sources(adapter PRIVATE ${ENGINE_SOURCE}/src/${part}.c)
endforeach()
target_include_directories(adapter PRIVATE ${ENGINE_SOURCE}/include ${ENGINE_SOURCE}/src)
