#include <yaml-cpp/yaml.h>

#include "experiment/trial.h"
#include "interpreter/mas/mas.h"
