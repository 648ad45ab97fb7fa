# The target chart: speed against accuracy of two scenes. It takes some minutes and makes the
# pictures of the README.
set(LAVER_CHART_OPTIONS --runs 5 --spp 64 --reference-spp 256)
set(charts "")
foreach(scene bunny-whitted cornell-two-lights)
  string(REPLACE -two-lights "" name ${scene})
  set(folder ${CMAKE_BINARY_DIR}/chart/${scene})
  list(APPEND charts
    COMMAND laver chart ${CMAKE_SOURCE_DIR}/scenes/${scene}.xml --out ${folder} ${LAVER_CHART_OPTIONS}
    COMMAND ${CMAKE_COMMAND} -E copy ${folder}/chart.png
      ${CMAKE_SOURCE_DIR}/scenes/pictures/chart-${name}.png)
endforeach()
add_custom_target(chart ${charts}
  COMMENT "Charting; leave the machine alone" USES_TERMINAL VERBATIM)
add_dependencies(chart laver laver_meshes)
