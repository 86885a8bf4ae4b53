#include "experiment/export/opendrive.h"

#include <numbers>

#include <fmt/format.h>

namespace jaywalk {
namespace {

std::string lane(int id, const Band& band, double cell_m) {
  return fmt::format(
      "            <lane id=\"{}\" type=\"{}\" level=\"false\">\n"
      "              <width sOffset=\"0\" a=\"{:.4f}\" b=\"0\" c=\"0\" d=\"0\"/>\n"
      "              <roadMark sOffset=\"0\" type=\"solid\" weight=\"standard\" color=\"white\" "
      "width=\"0.12\"/>\n"
      "            </lane>\n",
      id, band.kind == BandKind::lane ? "driving" : "sidewalk", band.rows * cell_m);
}

/// How many bands, from the left, lie on the left of the reference line.
std::size_t bands_on_the_left(const std::vector<Band>& bands) {
  for (std::size_t i = bands.size(); i > 0; --i) {
    const Band& band = bands[i - 1];
    if (band.kind == BandKind::lane && band.direction == Direction::forward) return i;
  }
  return 0;
}

}  // namespace

std::string to_opendrive(const CrossingParameters& parameters) {
  const std::vector<Band>& bands = parameters.bands;
  const std::size_t left = bands_on_the_left(bands);
  const double cell = parameters.cell_m;
  double reference_x = 0;
  for (std::size_t i = 0; i < left; ++i) reference_x += bands[i].rows * cell;

  // From left to right: the ids fall from the outermost left lane to the outermost right one.
  std::string left_lanes;
  for (std::size_t i = 0; i < left; ++i) {
    left_lanes += lane(static_cast<int>(left - i), bands[i], cell);
  }
  std::string right_lanes;
  for (std::size_t i = left; i < bands.size(); ++i) {
    right_lanes += lane(-static_cast<int>(i - left + 1), bands[i], cell);
  }
  const auto side = [](std::string_view name, const std::string& lanes) {
    if (lanes.empty()) return std::string();
    return fmt::format("          <{0}>\n{1}          </{0}>\n", name, lanes);
  };
  const double length = parameters.length * cell;
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<OpenDRIVE>\n"
      "  <header revMajor=\"1\" revMinor=\"6\" name=\"jaywalk crossing\" version=\"1\" "
      "north=\"{0:.4f}\" south=\"0\" east=\"{1:.4f}\" west=\"0\"/>\n"
      "  <road name=\"road\" length=\"{0:.4f}\" id=\"1\" junction=\"-1\" rule=\"LHT\">\n"
      "    <planView>\n"
      "      <geometry s=\"0\" x=\"{2:.4f}\" y=\"0\" hdg=\"{3:.12f}\" length=\"{0:.4f}\">"
      "<line/></geometry>\n"
      "    </planView>\n"
      "    <lanes>\n"
      "      <laneSection s=\"0\">\n"
      "{4}"
      "          <center>\n"
      "            <lane id=\"0\" type=\"none\" level=\"false\">\n"
      "              <roadMark sOffset=\"0\" type=\"broken\" weight=\"standard\" color=\"white\" "
      "width=\"0.12\"/>\n"
      "            </lane>\n"
      "          </center>\n"
      "{5}"
      "      </laneSection>\n"
      "    </lanes>\n"
      "  </road>\n"
      "</OpenDRIVE>\n",
      length, grid(parameters).rows * cell, reference_x, std::numbers::pi / 2,
      side("left", left_lanes), side("right", right_lanes));
}

}  // namespace jaywalk
