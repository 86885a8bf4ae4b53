#include "interpreter/agent/goals/goals.h"
