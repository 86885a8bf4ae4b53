#pragma once

// A compiled AgentSpeak program: immutable, shared by every agent that runs it, on any thread.

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "interpreter/support/diagnostics.h"
#include "interpreter/term/value.h"

namespace jaywalk {

class Program;

}  // namespace jaywalk
