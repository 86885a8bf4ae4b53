// SPDX-License-Identifier: Apache-2.0
#include "interpreter/agent/goals/goals.h"
