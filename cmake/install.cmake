# Installs the library fiberchain::dem for find_package(fiberchain), its component fiberchain::calibration, and the program
# with its data. `cmake --install --component NAME` installs one of them: dem, calibration, program.
include(CMakePackageConfigHelpers)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/fiberchain)

# fiberchain_install(COMPONENT TARGETS t... HEADERS h...): libraries with their public headers, which are what a user includes
# and what these include. Kernels, storage and files' internals are not among them.
function(fiberchain_install component)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "TARGETS;HEADERS")
  set(headers ${arg_HEADERS})
  set(to_read ${headers})
  while(to_read)
    list(POP_FRONT to_read header)
    file(STRINGS ${PROJECT_SOURCE_DIR}/${header} includes REGEX "^#include \"(dem|reference|compare)/")
    foreach(include IN LISTS includes)
      string(REGEX REPLACE "^#include \"(.*)\".*" "\\1" included "${include}")
      if(NOT included IN_LIST headers)
        list(APPEND headers ${included})
        list(APPEND to_read ${included})
      endif()
    endforeach()
  endwhile()
  set_property(GLOBAL APPEND PROPERTY FIBERCHAIN_PUBLIC_HEADERS ${headers})
  foreach(header IN LISTS headers)
    get_filename_component(room ${header} DIRECTORY)
    install(FILES ${PROJECT_SOURCE_DIR}/${header} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/fiberchain/${room}
      COMPONENT ${component})
  endforeach()
  foreach(target IN LISTS arg_TARGETS)
    string(REPLACE fiberchain_ "" name ${target})
    set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
  endforeach()
  install(TARGETS ${arg_TARGETS} EXPORT fiberchain-${component}-targets COMPONENT ${component})
  install(EXPORT fiberchain-${component}-targets NAMESPACE fiberchain:: DESTINATION ${package_dir} COMPONENT ${component})
endfunction()

fiberchain_install(dem TARGETS fiberchain_dem HEADERS
  dem/analysis/observables.hpp
  dem/chain/arc_chain.hpp
  dem/equilibrium/dynamic_relaxation.hpp
  dem/equilibrium/newton.hpp
  dem/flow/integrate_in_flow.hpp
  dem/insertion/random_insertion.hpp
  dem/material/flat_loss.hpp
  dem/material/merge.hpp
  dem/motion/time_step.hpp
  dem/record/csv.hpp
  dem/run/run_scene.hpp
  dem/run/session.hpp
  dem/scene/build_fiber.hpp
  dem/scene/build_packing.hpp
  dem/scene/read_material.hpp
  dem/trajectory/checkpoint.hpp
  dem/trajectory/h5md.hpp
  dem/vibration/choose.hpp
  dem/vibration/release.hpp)
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/fiberchain-config.cmake.in
  ${PROJECT_BINARY_DIR}/fiberchain-config.cmake INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/fiberchain-config-version.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/fiberchain-config.cmake ${PROJECT_BINARY_DIR}/fiberchain-config-version.cmake
  DESTINATION ${package_dir} COMPONENT dem)

if(FIBERCHAIN_BUILD_PROGRAM)
  fiberchain_install(calibration TARGETS fiberchain_reference fiberchain_calibration HEADERS
    compare/calibration/calibration.hpp
    compare/study/errors.hpp)
  install(TARGETS fiberchain COMPONENT program)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/data/ DESTINATION ${CMAKE_INSTALL_DATADIR}/fiberchain COMPONENT program)
  set(printed ${PROJECT_BINARY_DIR}/share)
  install(FILES ${printed}/fiberchain.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT program)
  install(FILES ${printed}/fiberchain.bash RENAME fiberchain COMPONENT program
    DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
  install(FILES ${printed}/fiberchain.fish COMPONENT program
    DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d)
  install(FILES ${printed}/fiberchain.zsh RENAME _fiberchain COMPONENT program
    DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions)
endif()
