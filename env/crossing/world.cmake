# The crossing. Included by CMakeLists.txt above.
target_sources(jaywalk_env PRIVATE
  crossing/av.cpp
  crossing/crossing.cpp
  crossing/layout.cpp
  crossing/parameters.cpp
  crossing/perceive.cpp
  crossing/road_user.cpp
  crossing/section/actors_section.cpp
  crossing/section/crossing_presets.cpp
  crossing/section/road_section.cpp
  crossing/section/crossing_section.cpp
  crossing/simulated_drive.cpp
  crossing/spawn.cpp
  crossing/vocabulary.cpp
  crossing/world.cpp)
