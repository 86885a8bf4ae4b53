// Every header that is installed, and the libraries of worlds and experiments.
#include <env/environments.h>
#include <experiment/compare/measures/measures.h>
#include <experiment/scenario/scenario.h>
#include <iostream>

#include "all_headers.h"

int main() {
  const auto scenario = jaywalk::read_scenario(JAYWALK_DATA_DIR "/scenarios/paper.yaml");
  if (!scenario) {
    std::cerr << scenario.diagnostics().render();
    return 2;
  }
  std::cout << jaywalk::environments().front().name << ": " << scenario.value().behaviours.size()
            << " behaviours, measured by " << jaywalk::find_measure("accuracy")->name
            << " and others\n";
}
