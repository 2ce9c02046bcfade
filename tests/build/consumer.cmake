# cmake -D BUILD=… -D SOURCE=… -D WORK=… -D CXX=… -D CONFIG=… -D FLAGS=… -D CASES=… -D EXAMPLES=… -D CLANG=… -P consumer.cmake
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
foreach(written share/man/man1/ccdfuzz.1 share/bash-completion/completions/ccdfuzz)
  file(SIZE ${WORK}/prefix/${written} size)
  if(size LESS 1000)
    message(FATAL_ERROR "${written} was not written")
  endif()
endforeach()
run("configure" ${CMAKE_COMMAND} -G ${GENERATOR} -S ${SOURCE} -B ${WORK}/build
    -DCMAKE_PREFIX_PATH=${WORK}/prefix -DCMAKE_CXX_COMPILER=${CXX} -DCMAKE_BUILD_TYPE=${CONFIG}
    -DCMAKE_CXX_FLAGS=${FLAGS})
run("build" ${CMAKE_COMMAND} --build ${WORK}/build)
execute_process(COMMAND ${WORK}/build/page ${CASES}/tdibm-e-underflow.json RESULT_VARIABLE status OUTPUT_VARIABLE out)
if(status OR NOT out MATCHES ": correct")
  message(FATAL_ERROR "the program of docs/api.md (${status}) says:\n${out}")
endif()

# The checker alone.
run("configure the checker's consumer" ${CMAKE_COMMAND} -G ${GENERATOR} -S ${SOURCE}/../checker_consumer
    -B ${WORK}/checker -DCMAKE_PREFIX_PATH=${WORK}/prefix -DCMAKE_CXX_COMPILER=${CXX}
    -DCMAKE_BUILD_TYPE=${CONFIG} -DCMAKE_CXX_FLAGS=${FLAGS})
run("build the checker's consumer" ${CMAKE_COMMAND} --build ${WORK}/checker)
run("run the checker's consumer" ${WORK}/checker/consumer)
execute_process(COMMAND ldd ${WORK}/checker/consumer RESULT_VARIABLE status OUTPUT_VARIABLE out)
if(status OR out MATCHES "zstd|xxhash|tbb|libz")
  message(FATAL_ERROR "the checker is linked with more than it needs (${status}):\n${out}")
endif()

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

# The example of RapidCheck finds its fault, shows it to people and to the command line, and shows it again.
run("configure the example" ${CMAKE_COMMAND} -G ${GENERATOR} -S ${EXAMPLES}/rapidcheck -B ${WORK}/example
    -DCMAKE_PREFIX_PATH=${WORK}/prefix -DCMAKE_CXX_COMPILER=${CXX} -DCMAKE_BUILD_TYPE=${CONFIG}
    -DCMAKE_CXX_FLAGS=${FLAGS})
run("build the example" ${CMAKE_COMMAND} --build ${WORK}/example)
function(run_example params)
  execute_process(COMMAND ${CMAKE_COMMAND} -E env RC_PARAMS=${params} ${WORK}/example/my_ccd_test ${ARGN}
                  RESULT_VARIABLE status OUTPUT_VARIABLE out ERROR_VARIABLE out)
  foreach(wanted "FAILED  . Mine.MissesNothing[ \n]" "FAILED  . Mine.MissesNothingOfMeshes" "as a case, for ccdfuzz"
          "answered miss. they touch at t = [0-9.]+ .0x")
    if(NOT out MATCHES ${wanted})
      message(FATAL_ERROR "the example (${status}) does not say \"${wanted}\":\n${out}")
    endif()
  endforeach()
  if(out MATCHES "<[?][?][?]>" OR out MATCHES "FAILED  . TdibmC")
    message(FATAL_ERROR "the example shows what it should not:\n${out}")
  endif()
  set(out "${out}" PARENT_SCOPE)
endfunction()
run_example(seed=1)
if(NOT out MATCHES "[0-9]% - .VV")
  message(FATAL_ERROR "the example does not show how many contacts were of each class:\n${out}")
endif()
string(REGEX MATCH "{\"format[^\n]*}" case "${out}")
file(WRITE ${WORK}/example.json "${case}")
run("verify what was found" ${BUILD}/ccdfuzz verify ${WORK}/example.json)
string(LENGTH "${case}" length)
if(length GREATER 600)
  message(FATAL_ERROR "what was found did not shrink: ${case}")
endif()
if(NOT out MATCHES "RC_PARAMS=\"(reproduce=[^\"]*)\"")
  message(FATAL_ERROR "the example does not say how it is shown again:\n${out}")
endif()
run_example(${CMAKE_MATCH_1} --gtest_filter=Mine.*)
if(NOT out MATCHES "after 1 test")
  message(FATAL_ERROR "RC_PARAMS=${CMAKE_MATCH_1} does not show it again:\n${out}")
endif()

# The example of libFuzzer finds its fault from nothing, shows it as a case, and leaves an input for triage.
if(NOT CLANG)
  message(STATUS "no clang: the example of libFuzzer is not built")
  return()
endif()
run("configure the example of libFuzzer" ${CMAKE_COMMAND} -G ${GENERATOR} -S ${EXAMPLES}/libfuzzer
    -B ${WORK}/fuzz -DCMAKE_PREFIX_PATH=${WORK}/prefix -DCMAKE_CXX_COMPILER=${CLANG}
    -DCMAKE_BUILD_TYPE=${CONFIG} -DCMAKE_CXX_FLAGS=${FLAGS})
run("build the example of libFuzzer" ${CMAKE_COMMAND} --build ${WORK}/fuzz)
execute_process(COMMAND ${WORK}/fuzz/my_ccd_fuzz -seed=1 -runs=100000 -artifact_prefix=${WORK}/
                RESULT_VARIABLE status OUTPUT_VARIABLE out ERROR_VARIABLE out)
string(REGEX MATCH "{\"format[^\n]*}" case "${out}")
if(NOT status OR NOT case)
  message(FATAL_ERROR "the example of libFuzzer (${status}) finds nothing:\n${out}")
endif()
file(WRITE ${WORK}/fuzz.json "${case}")
run("verify what libFuzzer found" ${BUILD}/ccdfuzz verify ${WORK}/fuzz.json)
file(GLOB input ${WORK}/crash-*)
execute_process(COMMAND ${BUILD}/ccdfuzz triage ${input} -o ${WORK}/finds --methods tdibm-c --json
                RESULT_VARIABLE status OUTPUT_VARIABLE out ERROR_VARIABLE out)
if(status OR NOT out MATCHES "\"inputs\":1,")
  message(FATAL_ERROR "triage does not read ${input} (${status}):\n${out}")
endif()
