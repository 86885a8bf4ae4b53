# The replay's page becomes part of the program. Included by CMakeLists.txt above.
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS report/player.html)
file(READ report/player.html JAYWALK_PLAYER_HTML)
configure_file(report/player.html.h.in ${generated}/experiment/report/player.html.h @ONLY)
target_sources(jaywalk_experiment PRIVATE report/player.cpp)
