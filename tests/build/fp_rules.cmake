# cmake -D SOURCE=… -D WORK=… -D CXX=… -P fp_rules.cmake
# The configure-time check of the floating-point rules: what must be refused is, and with the
# reason; what the build puts right by itself is not.
function(configure flags)
  file(REMOVE_RECURSE ${WORK})
  execute_process(
    COMMAND ${CMAKE_COMMAND} -G Ninja -S ${SOURCE} -B ${WORK} -DCMAKE_CXX_COMPILER=${CXX}
            -DCCDFUZZ_TESTS=OFF -DCCDFUZZ_BENCH=OFF -DCMAKE_BUILD_TYPE=Release ${flags}
    RESULT_VARIABLE status OUTPUT_VARIABLE out ERROR_VARIABLE out)
  set(status ${status} PARENT_SCOPE)
  string(REGEX REPLACE "[ \n]+" " " out "${out}")  # CMake wraps its messages
  set(out "${out}" PARENT_SCOPE)
endfunction()

foreach(bad "-DCMAKE_CXX_FLAGS=-ffast-math" "-DCMAKE_CXX_FLAGS_RELEASE=-O3 -freciprocal-math"
            "-DCMAKE_CXX_FLAGS=-funsafe-math-optimizations")
  configure(${bad})
  if(NOT status OR NOT out MATCHES "break the floating-point rules")
    message(FATAL_ERROR "${bad} was not refused with the reason (${status}):\n${out}")
  endif()
endforeach()

# -ffp-contract=off of the base target stands after these and wins.
foreach(good "-DCMAKE_CXX_FLAGS=" "-DCMAKE_CXX_FLAGS=-march=native -ffp-contract=fast")
  configure(${good})
  if(status)
    message(FATAL_ERROR "${good} was refused:\n${out}")
  endif()
endforeach()
