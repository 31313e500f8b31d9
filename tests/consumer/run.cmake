# Installs the build, configures and builds the consumer against it alone, and runs it.
foreach(variable BUILD_DIR SOURCE_DIR WORK_DIR GENERATOR COMPILER)
  if(NOT DEFINED ${variable})
    message(FATAL_ERROR "${variable} is not set")
  endif()
endforeach()

function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status)
  if(status)
    message(FATAL_ERROR "failed (${status}): ${ARGN}")
  endif()
endfunction()

file(REMOVE_RECURSE ${WORK_DIR})
run(${CMAKE_COMMAND} --install ${BUILD_DIR} --prefix ${WORK_DIR}/prefix)
run(${CMAKE_COMMAND} -S ${SOURCE_DIR} -B ${WORK_DIR}/build -G ${GENERATOR} -DCMAKE_CXX_COMPILER=${COMPILER}
  -DCMAKE_PREFIX_PATH=${WORK_DIR}/prefix)
run(${CMAKE_COMMAND} --build ${WORK_DIR}/build)
run(${WORK_DIR}/build/main ${SOURCE_DIR}/packing.yaml ${WORK_DIR}/main)
run(${WORK_DIR}/build/readme ${SOURCE_DIR}/packing.yaml ${WORK_DIR}/readme)

# The installed program finds its installed data, wherever the prefix is.
run(${WORK_DIR}/prefix/bin/fiberchain --version)
