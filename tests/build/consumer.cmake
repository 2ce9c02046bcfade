# cmake -D BUILD=… -D SOURCE=… -D WORK=… -D CXX=… -D CONFIG=… -D FLAGS=… -D CASES=… -P consumer.cmake
# Installs the build into WORK, and configures, builds and runs the consumer project against it.
file(REMOVE_RECURSE ${WORK})
file(MAKE_DIRECTORY ${WORK})
function(run what)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE out ERROR_VARIABLE out)
  if(status)
    message(FATAL_ERROR "${what} failed (${status}):\n${out}")
  endif()
endfunction()

run("install" ${CMAKE_COMMAND} --install ${BUILD} --config ${CONFIG} --prefix ${WORK}/prefix)
run("configure" ${CMAKE_COMMAND} -G ${GENERATOR} -S ${SOURCE} -B ${WORK}/build
    -DCMAKE_PREFIX_PATH=${WORK}/prefix -DCMAKE_CXX_COMPILER=${CXX} -DCMAKE_BUILD_TYPE=${CONFIG}
    -DCMAKE_CXX_FLAGS=${FLAGS})
run("build" ${CMAKE_COMMAND} --build ${WORK}/build)
run("run" ${WORK}/build/consumer)

# Answers do not depend on the flags of who asks.
foreach(program answers answers_fast_math)
  execute_process(COMMAND ${WORK}/build/${program} ${CASES} RESULT_VARIABLE status OUTPUT_VARIABLE ${program}
                  ERROR_VARIABLE error)
  if(status OR NOT ${program})
    message(FATAL_ERROR "${program} failed (${status}):\n${error}")
  endif()
endforeach()
if(NOT answers STREQUAL answers_fast_math)
  file(WRITE ${WORK}/answers.txt "${answers}")
  file(WRITE ${WORK}/answers_fast_math.txt "${answers_fast_math}")
  message(FATAL_ERROR "built with -ffast-math the same program is told otherwise: compare ${WORK}/answers*.txt")
endif()
