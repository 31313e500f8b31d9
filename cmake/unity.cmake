# fiberchain_compile_by_folder(TARGET): where CMAKE_UNITY_BUILD is on (all presets but dev), the sources of a folder are one
# for the compiler, which reads their headers once: half the processor time of a build. By folder, so that a new file touches
# the names of its neighbors only. The preset dev compiles file by file and so holds every file to its own includes.
function(fiberchain_compile_by_folder target)
  get_target_property(sources ${target} SOURCES)
  foreach(source IN LISTS sources)
    if(NOT IS_ABSOLUTE "${source}" AND source MATCHES "[.]cpp$")
      get_filename_component(folder ${source} DIRECTORY)
      string(MAKE_C_IDENTIFIER "of_${folder}" group)
      set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${group})
    endif()
  endforeach()
  set_target_properties(${target} PROPERTIES UNITY_BUILD_MODE GROUP)
endfunction()
