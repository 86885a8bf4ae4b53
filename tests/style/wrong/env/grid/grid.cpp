#include <yaml-cpp/yaml.h>

#include "env/tram/tram.h"
#include "experiment/trial/trial.h"
#include "interpreter/mas/mas.h"
