# Run at every build: writes OUTPUT from TEMPLATE with the commit SOURCE stands at now, and only if that
# changed. Without git, or in a tree that is not the repository's top (an unpacked archive), it is "unknown".
set(FIBERCHAIN_COMMIT unknown)
find_program(GIT git)
if(GIT)
  # The owner of the tree may be another user (a container, CI): trust this one tree.
  set(git ${GIT} -c safe.directory=${SOURCE} -C ${SOURCE})
  execute_process(COMMAND ${git} rev-parse --show-toplevel
    OUTPUT_VARIABLE top OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  file(REAL_PATH ${SOURCE} source)
  if(top STREQUAL source)
    execute_process(COMMAND ${git} describe --always --dirty --abbrev=40 --exclude=*
      RESULT_VARIABLE failed OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
    if(NOT failed AND commit)
      set(FIBERCHAIN_COMMIT ${commit})
    endif()
  endif()
endif()
string(STRIP "${FLAGS}" FIBERCHAIN_FLAGS)
string(REGEX REPLACE "  +" " " FIBERCHAIN_FLAGS "${FIBERCHAIN_FLAGS}")
configure_file(${TEMPLATE} ${OUTPUT} @ONLY)
