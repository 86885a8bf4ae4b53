// SPDX-License-Identifier: Apache-2.0
#include <boost/program_options.hpp>
#include <boost/spirit/home/x3.hpp>

#include "experiment/test_run/test_run.h"
#include <jaywalk/nothing.h>
