# cmake --build DIR --target docs: pages of README files, public headers and the module's docstrings, by doxygen. Only where
# that is installed, and part of nothing else.
find_program(FIBERCHAIN_DOXYGEN doxygen)
find_program(FIBERCHAIN_DOCS_PYTHON python3 PATHS /usr/bin NO_DEFAULT_PATH)
get_property(public_headers GLOBAL PROPERTY FIBERCHAIN_PUBLIC_HEADERS)
list(SORT public_headers)
list(REMOVE_DUPLICATES public_headers)
list(JOIN public_headers "\n" public_headers)
file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/public-headers.txt CONTENT "${public_headers}\n")
if(FIBERCHAIN_DOXYGEN AND FIBERCHAIN_DOCS_PYTHON)
  add_custom_target(docs VERBATIM COMMAND ${FIBERCHAIN_DOCS_PYTHON} -B ${CMAKE_CURRENT_LIST_DIR}/docs.py
    ${PROJECT_SOURCE_DIR} ${PROJECT_BINARY_DIR}/docs ${FIBERCHAIN_DOXYGEN} ${PROJECT_BINARY_DIR}/public-headers.txt)
endif()
