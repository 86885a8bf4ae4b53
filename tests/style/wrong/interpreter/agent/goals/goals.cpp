#include "interpreter/agent/agent.h"
#include "interpreter/agent/cycle/cycle.h"
