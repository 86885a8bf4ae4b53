# Stored tests as files for other programs. Included by CMakeLists.txt above.
target_sources(jaywalk_experiment PRIVATE
  export/exporter.cpp
  export/observations.cpp
  export/opendrive.cpp
  export/openscenario.cpp
  export/postgis.cpp
  export/program.cpp
  export/validate.cpp)
