# Tables, charts and pages for people. Included by CMakeLists.txt above.
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS report/page.html report/player/player.html)
file(READ report/page.html JAYWALK_PAGE_HTML)
configure_file(report/page.html.h.in ${generated}/experiment/report/page.html.h @ONLY)
file(READ report/player/player.html JAYWALK_PLAYER_HTML)
configure_file(report/player/player.html.h.in
               ${generated}/experiment/report/player/player.html.h @ONLY)

target_sources(jaywalk_experiment PRIVATE
  report/charts/axis.cpp
  report/charts/bars.cpp
  report/charts/plot.cpp
  report/charts/road.cpp
  report/explanation_json.cpp
  report/facts.cpp
  report/html.cpp
  report/player/player.cpp
  report/player/side_by_side.cpp
  report/policy_map.cpp
  report/report.cpp
  report/sections/agents_section.cpp
  report/sections/avs_section.cpp
  report/sections/figures_section.cpp
  report/sections/kills_section.cpp
  report/sections/learning_section.cpp
  report/sections/metrics_section.cpp
  report/sections/overview_section.cpp
  report/sections/places_section.cpp
  report/sections/replays_section.cpp
  report/sections/reproduce_section.cpp
  report/sections/significance_section.cpp
  report/sections/situations_section.cpp
  report/sections/verdicts_section.cpp
  report/stored_coverage.cpp
  report/tables/kill_table.cpp
  report/tables/situation_coverage.cpp
  report/tables/table.cpp
  report/tables/troubles_text.cpp
  report/tables/verdict_table.cpp)
