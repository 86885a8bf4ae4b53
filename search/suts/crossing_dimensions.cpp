#include "search/suts/crossing_dimensions.h"

#include <optional>
#include <string>
#include <utility>

namespace jaywalk::search {
namespace {

class DimensionReader {
  static constexpr NumberRange kAnyNumber{-1e6, 1e6};

 public:
  DimensionReader(const ConfigReader& reader, std::vector<CrossingDimension>& dimensions)
      : reader_(reader), dimensions_(dimensions) {}

  /// A map from the scenario's keys, dotted or as maps within maps, to their values.
  void read(const ConfigNode& node, const std::string& above = {}) {
    if (node.kind != ConfigNode::Kind::map) {
      reader_.unexpected(node, "keys of the scenario and their ranges");
      return;
    }
    for (const ConfigEntry& entry : node.entries) {
      const std::string key = above + entry.key;
      const ConfigNode& value = entry.value;
      const bool is_inner = value.kind == ConfigNode::Kind::map && value.find("whole") == nullptr;
      if (is_inner && !value.entries.empty()) {
        read(value, key + '.');
      } else if (auto dimension = read_range(value)) {
        dimension->key = key;
        // Another layer may have given it in the other form.
        std::erase_if(dimensions_, [&](const CrossingDimension& each) { return each.key == key; });
        dimensions_.push_back(std::move(*dimension));
      }
    }
  }

 private:
  /// `[from, to]`, `{whole: [from, to], step: 2}`, `[forward, back]`, `[1, 2, 4]` or `[2]`.
  std::optional<CrossingDimension> read_range(const ConfigNode& node) {
    if (node.find("whole") != nullptr) return read_whole(node);
    const bool is_list = node.kind == ConfigNode::Kind::list && !node.items.empty();
    if (is_list && (node.items.size() != 2 || !parse_number(node.items.front().text))) {
      return read_words(node);
    }
    CrossingDimension dimension;
    const auto numbers = reader_.number_pair(node, kAnyNumber);
    if (!numbers) return std::nullopt;
    dimension.from = (*numbers)[0];
    dimension.to = (*numbers)[1];
    return dimension;
  }

  std::optional<CrossingDimension> read_words(const ConfigNode& node) {
    CrossingDimension dimension{.kind = CrossingDimension::Kind::word};
    for (const ConfigNode& item : node.items) {
      const auto word = reader_.text(item, "a word");
      if (!word) return std::nullopt;
      dimension.words.push_back(*word);
    }
    return dimension;
  }

  std::optional<CrossingDimension> read_whole(const ConfigNode& node) {
    CrossingDimension dimension{.kind = CrossingDimension::Kind::whole};
    bool well = false;
    const std::vector<ConfigKey> keys{
        {"whole",
         [&](const ConfigNode& value, const std::string&) {
           const auto numbers = reader_.number_pair(value, kAnyNumber);
           if (!numbers) return;
           dimension.from = (*numbers)[0];
           dimension.to = (*numbers)[1];
           well = true;
         }},
        {"step",
         [&](const ConfigNode& value, const std::string&) {
           if (const auto step = reader_.integer(value, {1, 1'000'000})) {
             dimension.step = static_cast<int>(*step);
           }
         }},
    };
    reader_.read_map(node, "parameters", keys);
    if (!well) return std::nullopt;
    return dimension;
  }

  const ConfigReader& reader_;
  std::vector<CrossingDimension>& dimensions_;
};

}  // namespace

void read_dimensions(const ConfigNode& node, const ConfigReader& reader,
                     std::vector<CrossingDimension>& dimensions) {
  DimensionReader(reader, dimensions).read(node);
}

}  // namespace jaywalk::search
