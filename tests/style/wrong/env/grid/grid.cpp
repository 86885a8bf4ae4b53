// SPDX-License-Identifier: Apache-2.0
#include <yaml-cpp/yaml.h>

#include "env/tram/tram.h"
#include "experiment/test_run/test_run.h"
#include "interpreter/mas/mas.h"
