# Runs fibers that come in two batches, and looks at the trajectory by mdanalysis.py with Debian's Python.
file(REMOVE_RECURSE ${WORK_DIR})
file(MAKE_DIRECTORY ${WORK_DIR})
file(WRITE ${WORK_DIR}/s.yaml "scene: packing
fibers:
  - {diameter: 2 mm, aspect_ratio: 6, youngs_modulus: 2.6 MPa, poisson_ratio: 0.3, density: 1000 kg/m^3, count: 12}
filling: {region: {z: [1 mm, 30 mm]}, velocity: [0, 0, -1], seed: 3, batches: {number: 2, interval: 2 ms}}
walls: {box: {x: 24 mm, y: 22 mm, lid: open}}
gravity: [0, 0, -9.81]
contacts: {restitution: 0.5, friction: 0.3}
duration: 4 ms
output: {samples: 2, frames: 4, checkpoints: 0, contacts: true}
")
execute_process(COMMAND ${PROGRAM} run s.yaml --out . --jobs 1 WORKING_DIRECTORY ${WORK_DIR}
  RESULT_VARIABLE status OUTPUT_QUIET ERROR_VARIABLE errors)
if(status)
  message(FATAL_ERROR "the run ended with ${status}: ${errors}")
endif()
execute_process(COMMAND /usr/bin/python3 ${SOURCE_DIR}/mdanalysis.py s WORKING_DIRECTORY ${WORK_DIR}
  RESULT_VARIABLE status OUTPUT_VARIABLE said ERROR_VARIABLE errors)
message("${said}")
if(status EQUAL 77 OR status MATCHES "No such file")
  message("skipped: MDAnalysis cannot be tried")
elseif(status)
  message(FATAL_ERROR "${errors}")
endif()
