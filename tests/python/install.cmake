# Installs the module into a directory of its own, and imports it from there.
file(REMOVE_RECURSE ${WORK_DIR})
execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD_DIR} --prefix ${WORK_DIR} --component python
  RESULT_VARIABLE status OUTPUT_QUIET ERROR_VARIABLE errors)
if(status)
  message(FATAL_ERROR "not installed: ${errors}")
endif()
execute_process(COMMAND ${CMAKE_COMMAND} -E env PYTHONPATH=${WORK_DIR}/${PYTHON_DIR} ${PYTHON} -B -c
  "import fiberchain as fc; assert fc.__file__.startswith('${WORK_DIR}'), fc.__file__; assert 'spruce' in fc.materials()"
  RESULT_VARIABLE status ERROR_VARIABLE errors WORKING_DIRECTORY ${WORK_DIR})
if(status)
  message(FATAL_ERROR "not imported: ${errors}")
endif()
