#pragma once

#include <cstdint>

namespace jaywalk {

/// Half of the memory that the machine has, or that its group of processes (a container) may have.
[[nodiscard]] std::uint64_t half_of_the_machines_memory();

}  // namespace jaywalk
