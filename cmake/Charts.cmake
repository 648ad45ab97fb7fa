# The target chart: charts of error against time for three scenes, with Mitsuba 3 if it is installed.
# It takes some minutes and writes the pictures of the README.
set(LAVER_MITSUBA_PYTHON python3 CACHE STRING
  "Python in which Mitsuba 3 is installed, for charts (pip install mitsuba)")
set(mitsuba "env ${LAVER_MITSUBA_PYTHON} tests/bench/mitsuba_peer.py --variant")
set(charts "")
foreach(scene bunny-whitted cornell-two-lights box-glass)
  string(REPLACE -two-lights "" name ${scene})
  set(folder ${CMAKE_BINARY_DIR}/chart/${scene})
  list(APPEND charts
    COMMAND laver chart scenes/${scene}.xml --out ${folder}
      --runs 5 --spp 64 --reference-spp 256
      --peer "Mitsuba 3, llvm_ad_rgb" "${mitsuba} llvm_ad_rgb"
      --peer "Mitsuba 3, scalar_rgb" "${mitsuba} scalar_rgb"
    COMMAND ${CMAKE_COMMAND} -E copy ${folder}/chart.png
      scenes/pictures/chart-${name}.png)
endforeach()
add_custom_target(chart ${charts}
  WORKING_DIRECTORY ${CMAKE_SOURCE_DIR}
  COMMENT "Charting; run nothing else meanwhile" USES_TERMINAL VERBATIM)
add_dependencies(chart laver laver_meshes)
