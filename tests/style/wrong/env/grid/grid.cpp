#include "interpreter/mas/mas.h"
#include <yaml-cpp/yaml.h>
#include "experiment/trial.h"
