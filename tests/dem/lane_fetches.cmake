# The loops over rows fetch what comes next. A compiler may drop fetches as code without effect, and nothing but the time of
# large scenes tells.
foreach(object IN LISTS OBJECTS)
  if(NOT object MATCHES "kernels_(avx2|avx512)\\.dir/.*(packing|contacts|segments)\\.cpp")
    continue()
  endif()
  execute_process(COMMAND ${OBJDUMP} -d ${object} OUTPUT_VARIABLE code COMMAND_ERROR_IS_FATAL ANY)
  if(NOT code MATCHES "prefetch")
    message(FATAL_ERROR "${object} fetches nothing ahead")
  endif()
endforeach()
