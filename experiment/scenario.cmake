#The scenario and the trial : what a comparison runs.Included by CMakeLists.txt beside it.
target_sources(jaywalk_experiment PRIVATE scenario.cpp scenario_presets.cpp scenario_reader
                   .cpp scenario_schema.cpp scenario_yaml.cpp)
    target_link_libraries(jaywalk_experiment PUBLIC jaywalk::env PRIVATE yaml - cpp)
