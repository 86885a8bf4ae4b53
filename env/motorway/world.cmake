# The motorway. Included by CMakeLists.txt above.
target_sources(jaywalk_env PRIVATE
  motorway/motorway.cpp
  motorway/parameters.cpp
  motorway/section.cpp
  motorway/vocabulary.cpp
  motorway/world.cpp)
