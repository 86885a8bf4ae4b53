# Many tests: behaviours beside each other, their measures, kills and published figures. Included by CMakeLists.txt above.
# The paper's figures become part of the program.
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS compare/published/paper_figures.csv)
file(READ compare/published/paper_figures.csv JAYWALK_PAPER_FIGURES)
configure_file(compare/published/paper_figures.h.in
               ${generated}/experiment/compare/published/paper_figures.h @ONLY)

# Their digests say whether a behaviour is the one whose results were published.
set(agents ${PROJECT_SOURCE_DIR}/agents/crossing)
file(GLOB programs CONFIGURE_DEPENDS RELATIVE ${agents} ${agents}/*.asl ${agents}/shared/*.asl)
set(JAYWALK_PUBLISHED_PROGRAMS "")
foreach(program ${programs})
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${agents}/${program})
  file(SHA256 ${agents}/${program} digest)
  string(APPEND JAYWALK_PUBLISHED_PROGRAMS "${program} ${digest}\n")
endforeach()
configure_file(compare/published/published_programs.h.in
               ${generated}/experiment/compare/published/published_programs.h @ONLY)

target_sources(jaywalk_experiment PRIVATE
  compare/avs/av_ranking.cpp
  compare/carry_over.cpp
  compare/comparison.cpp
  compare/experiment.cpp
  compare/feedback.cpp
  compare/first_tests.cpp
  compare/test_assessment.cpp
  compare/kills/kills.cpp
  compare/kills/kills_file.cpp
  compare/kills/predictors.cpp
  compare/kills/team.cpp
  compare/measures/distribution.cpp
  compare/measures/measures.cpp
  compare/measures/significance.cpp
  compare/measures/statistics.cpp
  compare/per_test.cpp
  compare/published/agreement.cpp
  compare/published/published.cpp
  compare/published/published_rows.cpp
  compare/situation_table.cpp
  compare/summary.cpp
  compare/troubles.cpp
  compare/failure_condition.cpp)
