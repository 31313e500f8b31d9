# Installs the library fiberchain::dem for find_package(fiberchain), and the program with its data.
include(CMakePackageConfigHelpers)

set_target_properties(fiberchain_dem PROPERTIES EXPORT_NAME dem)
install(TARGETS fiberchain_dem EXPORT fiberchain-targets)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/dem DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/fiberchain
  FILES_MATCHING PATTERN "*.hpp")

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/fiberchain)
install(EXPORT fiberchain-targets NAMESPACE fiberchain:: DESTINATION ${package_dir})
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/fiberchain-config.cmake.in
  ${PROJECT_BINARY_DIR}/fiberchain-config.cmake INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/fiberchain-config-version.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/fiberchain-config.cmake ${PROJECT_BINARY_DIR}/fiberchain-config-version.cmake
  DESTINATION ${package_dir})

if(FIBERCHAIN_BUILD_PROGRAM)
  install(TARGETS fiberchain)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/data/ DESTINATION ${CMAKE_INSTALL_DATADIR}/fiberchain)
endif()
