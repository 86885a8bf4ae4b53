#include <boost/program_options.hpp>
#include <boost/spirit/home/x3.hpp>

#include "experiment/trial/trial.h"
