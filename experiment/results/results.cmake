# The results store. Included by CMakeLists.txt beside its folder.
target_sources(jaywalk_experiment PRIVATE
  results/assessment_spool.cpp
  results/assessment_writer.cpp
  results/database.cpp
  results/description.cpp
  results/descriptor_vfs.cpp
  results/excerpt.cpp
  results/extend.cpp
  results/geometry.cpp
  results/merge.cpp
  results/new_file.cpp
  results/placement.cpp
  results/reader.cpp
  results/row_writer.cpp
  results/schema.cpp
  results/sha256.cpp
  results/store_file.cpp
  results/store_tables.cpp
  results/stored_description.cpp
  results/stored_rows.cpp
  results/test_record.cpp
  results/writer.cpp
  stored_coverage.cpp)
set_property(SOURCE results/description.cpp results/reader.cpp
             APPEND PROPERTY COMPILE_DEFINITIONS JAYWALK_VERSION="${PROJECT_VERSION}")
target_link_libraries(jaywalk_experiment PRIVATE SQLite::SQLite3 PkgConfig::libmd)
