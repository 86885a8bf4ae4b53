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

void read_parameters(const ConfigNode& node, const std::string& path, const ConfigReader& reader,
                     std::span<const NumberParameter> parameters, std::vector<double>& values) {
  std::vector<ConfigKey> keys;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    keys.push_back({parameters[i].name, [&, i](const ConfigNode& value, const std::string&) {
                      const NumberRange range{parameters[i].least, parameters[i].most};
                      if (const auto number = reader.number(value, range)) values[i] = *number;
                    }});
  }
  reader.read_map(node, path, keys);
}

}  // namespace jaywalk::search
