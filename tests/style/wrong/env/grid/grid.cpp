#include <yaml-cpp/yaml.h>

#include "experiment/trial/trial.h"
#include "interpreter/mas/mas.h"
