// The keys below `world` of a scenario that all worlds have. The world itself reads the others
// (env/world/world_section.h).

#include <array>

#include "experiment/scenario/scenario_layer.h"

namespace jaywalk {
namespace {

// Ranges of the keys: generous, but small enough that products of them do not overflow.
constexpr IntegerRange kEpsg{1024, 32767};
constexpr NumberRange kOnEarth{-1e8, 1e8};
constexpr NumberRange kBearing{-360, 360};

class WorldReader : LayerPart {
 public:
  WorldReader(const std::string& folder, ScenarioDraft& draft, Diagnostics& diagnostics)
      : LayerPart(folder, draft, diagnostics) {}

  void read(const ConfigNode& node, const std::string& path) {
    const std::array common{
        // Read before, since the other keys depend on it.
        ConfigKey{"environment", [](const ConfigNode&, const std::string&) {}},
        ConfigKey{"anchor", [this](const ConfigNode& value,
                                   const std::string& key) { read_anchor(value, key); }},
    };
    draft_.world->read(node, path, context_, common);
  }

 private:
  void read_anchor(const ConfigNode& node, const std::string& path) {
    Anchor anchor = draft_.scenario.anchor.value_or(Anchor{});
    read_keys(node, path,
              {
                  {"epsg", integer(anchor.epsg, kEpsg)},
                  {"easting", number(anchor.easting_m, kOnEarth)},
                  {"northing", number(anchor.northing_m, kOnEarth)},
                  {"bearing", number(anchor.bearing_deg, kBearing)},
              });
    draft_.scenario.anchor = anchor;
    constexpr int kDegrees = 4326;
    if (anchor.epsg == 0) {
      reader_.error(node.origin, "an anchor without 'epsg', the code of its reference system");
    } else if (anchor.epsg == kDegrees) {
      reader_.error(node.origin, "expected a reference system in metres, found one in degrees",
                    "a UTM zone is epsg: 32601 to 32660, Great Britain's grid 27700");
    }
  }
};

}  // namespace

void read_world(const ConfigNode& node, const std::string& path, const std::string& folder,
                ScenarioDraft& draft, Diagnostics& diagnostics) {
  WorldReader(folder, draft, diagnostics).read(node, path);
}

}  // namespace jaywalk
