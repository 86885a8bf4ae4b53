// SPDX-License-Identifier: Apache-2.0
#include "search/suts/suts.h"

#include <array>

namespace jaywalk::search {

std::span<const SutKind> sut_kinds() {
  static const std::array kinds = {
#define JAYWALK_SUT(identifier, name, summary) SutKind{name, summary, sut::identifier::read},
#include "search/suts.def"
#undef JAYWALK_SUT
  };
  return kinds;
}

KeyReader number_into(double& target, const ConfigReader& reader, NumberRange range,
                      double factor) {
  return [&target, &reader, range, factor](const ConfigNode& value, const std::string&) {
    if (const auto read = reader.number(value, range)) target = *read * factor;
  };
}

std::vector<ConfigKey> parameter_keys(std::span<const NumberParameter> parameters,
                                      const ConfigReader& reader, std::vector<double>& values) {
  std::vector<ConfigKey> keys;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const NumberRange range{parameters[i].least, parameters[i].most};
    keys.push_back({parameters[i].name, number_into(values[i], reader, range)});
  }
  return keys;
}

}  // namespace jaywalk::search
