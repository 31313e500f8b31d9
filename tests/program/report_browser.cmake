# Opens a page of `fiberchain report` in headless chromium in frames 400, 760 and 1200 pixels wide: nothing on the console, every
# figure drawn, the packing painted, nothing wider than the frame, nothing loaded. Debian's chromium refuses windows narrower than 500
# pixels: hence frames.
find_program(CHROMIUM NAMES chromium chromium-browser google-chrome)
if(NOT CHROMIUM)
  message("skipped: chromium is not installed")
  return()
endif()
file(REMOVE_RECURSE ${WORK_DIR})
file(MAKE_DIRECTORY ${WORK_DIR})
file(WRITE ${WORK_DIR}/fibers.yaml "scene: packing
fibers:
  - {diameter: 2 mm, aspect_ratio: 6, youngs_modulus: 2.6 MPa, poisson_ratio: 0.3, density: 1000 kg/m^3, count: 12}
filling: {region: {z: [1 mm, 30 mm]}, velocity: [0, 0, -1], seed: 3}
walls: {box: {x: 24 mm, y: 22 mm, lid: open}}
gravity: [0, 0, -9.81]
duration: 4 ms
output: {samples: 0, frames: 4, checkpoints: 0}
")
foreach(command "run;fibers.yaml;--jobs;1;--no-figures" "validate;--part;beams,static" "report;--from;results")
  execute_process(COMMAND ${PROGRAM} ${command} --out results WORKING_DIRECTORY ${WORK_DIR}
    RESULT_VARIABLE status OUTPUT_QUIET ERROR_VARIABLE errors)
  if(status)
    message(FATAL_ERROR "${command} ended with ${status}: ${errors}")
  endif()
endforeach()

# The page with what looks at it behind it.
file(COPY_FILE ${WORK_DIR}/results/report.html ${WORK_DIR}/probed.html)
file(READ ${SOURCE_DIR}/report_probe.html probe)
file(APPEND ${WORK_DIR}/probed.html "${probe}")
file(COPY ${SOURCE_DIR}/report_frames.html DESTINATION ${WORK_DIR})
execute_process(COMMAND ${CHROMIUM} --headless --no-sandbox --disable-gpu --user-data-dir=${WORK_DIR}/profile --window-size=2500,800
    --enable-logging=stderr --virtual-time-budget=5000 --dump-dom file://${WORK_DIR}/report_frames.html
  WORKING_DIRECTORY ${WORK_DIR} RESULT_VARIABLE status OUTPUT_VARIABLE found ERROR_VARIABLE console TIMEOUT 240)
string(REGEX MATCHALL "seen [^\n<]*" seen "${found}")
string(REGEX MATCHALL "[^\n]*CONSOLE[^\n]*" said "${console}")
message("${seen}\n${said}")
if(status)
  message(FATAL_ERROR "chromium ended with ${status}: ${console}")
endif()

# "listening" proves that the console is heard.
list(LENGTH said lines)
if(NOT lines EQUAL 1 OR NOT said MATCHES "listening")
  message(FATAL_ERROR "on the console: ${said}")
endif()
list(LENGTH seen frames)
if(NOT frames EQUAL 3)
  message(FATAL_ERROR "${frames} of 3 frames told what they see")
endif()
foreach(width 400 760 1200)
  if(NOT "${seen}" MATCHES
      "seen width ${width}, overflow 0, figures [1-9][0-9]+, broken 0, painted yes, turned yes, narrowed yes, loaded 0")
    message(FATAL_ERROR "at ${width} pixels: ${seen}")
  endif()
endforeach()
