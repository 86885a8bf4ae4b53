# The report's page becomes part of the program. Included by CMakeLists.txt above.
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS report/page.html)
file(READ report/page.html JAYWALK_PAGE_HTML)
configure_file(report/page.html.h.in ${generated}/experiment/report/page.html.h @ONLY)
target_sources(jaywalk_experiment PRIVATE
  report/axis.cpp
  report/bars.cpp
  report/facts.cpp
  report/html.cpp
  report/page.cpp
  report/plot.cpp
  report/replay_page.cpp
  report/report.cpp
  report/report_data.cpp
  report/road.cpp
  report/sections/agents.cpp
  report/sections/figures.cpp
  report/sections/kills.cpp
  report/sections/metrics.cpp
  report/sections/overview.cpp
  report/sections/places.cpp
  report/sections/replays.cpp
  report/sections/reproduce.cpp
  report/sections/significance.cpp
  report/sections/situations.cpp
  report/sections/verdicts.cpp
  report/side_by_side.cpp
  significance.cpp)
