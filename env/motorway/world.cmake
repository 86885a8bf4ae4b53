# The motorway. Included by CMakeLists.txt above.
target_sources(jaywalk_env PRIVATE
  motorway/motorway.cpp
  motorway/motorway_section.cpp
  motorway/world.cpp)
