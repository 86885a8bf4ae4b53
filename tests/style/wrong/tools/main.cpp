#include <boost/spirit/home/x3.hpp>
#include <boost/program_options.hpp>
#include "experiment/trial.h"
