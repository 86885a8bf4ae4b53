# The results store. Included by CMakeLists.txt above.
target_sources(jaywalk_experiment PRIVATE
  results/assessment_writer.cpp
  results/description.cpp
  results/merge.cpp
  results/reader.cpp
  results/store/database.cpp
  results/store/descriptor_vfs.cpp
  results/store/geometry.cpp
  results/store/geopackage.cpp
  results/store/row_writer.cpp
  results/store/schema.cpp
  results/store/store_file.cpp
  results/stored_description.cpp
  results/stored_rows.cpp
  results/writer.cpp)
set_property(SOURCE results/description.cpp results/reader.cpp
             APPEND PROPERTY COMPILE_DEFINITIONS JAYWALK_VERSION="${PROJECT_VERSION}")
target_link_libraries(jaywalk_experiment PRIVATE SQLite::SQLite3)
