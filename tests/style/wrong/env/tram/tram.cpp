#include "env/tram/tram.h"
