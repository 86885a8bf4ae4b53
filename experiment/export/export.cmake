# Stored tests as files for other programs. Included by CMakeLists.txt above.
target_sources(jaywalk_experiment PRIVATE
  export/courses.cpp
  export/exporter.cpp
  export/observations.cpp
  export/opendrive.cpp
  export/openscenario.cpp
  export/openscenario_text.cpp
  export/playback.cpp
  export/postgis.cpp
  export/program.cpp
  export/road_plan.cpp
  export/traces.cpp
  export/validate.cpp
  trace_file.cpp)

# With sanitizers GCC 12 warns of std::regex's own code (GCC bug 105562).
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND JAYWALK_SANITIZERS)
  set_source_files_properties(export/validate.cpp PROPERTIES COMPILE_OPTIONS -Wno-maybe-uninitialized)
endif()
