// The automated vehicle: its body and its speed; how it drives is read as in any world.

#include "env/config/ranges.h"
#include "env/crossing/section/draft.h"
#include "env/vehicle/section.h"

namespace jaywalk {
namespace {

class AvReader : VehicleSection {
 public:
  AvReader(const SectionContext& context, CrossingDraft& draft)
      : VehicleSection(context), draft_(draft) {}

  void read_av(const ConfigNode& node, const std::string& path) {
    AvParameters& av = draft_.world.av;
    if (node.find("speed") != nullptr && node.find("speed_mps") != nullptr) {
      reader_.error(node.origin, "give either 'speed' or 'speed_mps'");
    }
    std::vector<ConfigKey> keys{
        {"length", integer(av.length, kCells)},
        {"rows", interval(av.rows, kRows)},
        {"start", integer(av.start, kCellsFromAnywhere)},
        {"stopping_distance", integer(av.stopping_distance, {0, kCells.most})},
        {"carry_over", choice<bool>(av.carry_over, {{"true", true}, {"false", false}})},
    };
    add_keys(av.vehicle, av.twin, keys);
    keys.push_back({"speed", [&](const ConfigNode& value, const std::string& key) {
                      speed(av.speed, kSpeed, "speed_mps")(value, key);
                      draft_.speed_mps.reset();
                    }});
    keys.push_back({"speed_mps", speed(draft_.speed_mps, kSpeed, "speed_mps")});
    read_keys(node, path, keys);
  }

 private:
  CrossingDraft& draft_;
};

}  // namespace

void read_av(const ConfigNode& node, const std::string& path, const SectionContext& context,
             CrossingDraft& draft) {
  AvReader(context, draft).read_av(node, path);
}

}  // namespace jaywalk
