#include "interpreter/agent/agent.h"
