// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <fmt/format.h>

#include "env/lane/spline.h"
#include "search/export/exports.h"

namespace jaywalk::search {
namespace {

using lane::Spline;

Point derivative(const Spline::Piece& piece, double t) {
  return {piece.c1.x_m + t * (2 * piece.c2.x_m + 3 * t * piece.c3.x_m),
          piece.c1.y_m + t * (2 * piece.c2.y_m + 3 * t * piece.c3.y_m)};
}

/// By Simpson's rule; the pieces are short and smooth.
double arc_length(const Spline::Piece& piece) {
  constexpr int kSteps = 64;
  const auto speed = [&](int i) {
    const Point d = derivative(piece, piece.length * i / kSteps);
    return std::hypot(d.x_m, d.y_m);
  };
  double sum = speed(0) + speed(kSteps);
  for (int i = 1; i < kSteps; ++i) sum += (i % 2 == 1 ? 4 : 2) * speed(i);
  return sum * piece.length / kSteps / 3;
}

/// The piece in the frame of its beginning, its parameter from 0 to 1.
std::string geometry(const Spline::Piece& piece, double s, double metres) {
  const Point ahead = derivative(piece, 0);
  const double heading = std::atan2(ahead.y_m, ahead.x_m);
  const double c = std::cos(heading);
  const double n = std::sin(heading);
  const auto u = [&](const Point& p, double scale) { return (c * p.x_m + n * p.y_m) * scale; };
  const auto v = [&](const Point& p, double scale) { return (c * p.y_m - n * p.x_m) * scale; };
  const double h = piece.length;
  return fmt::format(
      "      <geometry s=\"{:.9g}\" x=\"{:.9g}\" y=\"{:.9g}\" hdg=\"{:.12g}\" length=\"{:.9g}\">\n"
      "        <paramPoly3 pRange=\"normalized\" aU=\"0\" bU=\"{:.12g}\" cU=\"{:.12g}\" "
      "dU=\"{:.12g}\" aV=\"0\" bV=\"{:.12g}\" cV=\"{:.12g}\" dV=\"{:.12g}\"/>\n"
      "      </geometry>\n",
      s, piece.c0.x_m, piece.c0.y_m, heading, metres, u(piece.c1, h), u(piece.c2, h * h),
      u(piece.c3, h * h * h), v(piece.c1, h), v(piece.c2, h * h), v(piece.c3, h * h * h));
}

std::string driving_lane(int id) {
  return fmt::format(
      "            <lane id=\"{}\" type=\"driving\" level=\"false\">\n"
      "              <width sOffset=\"0\" a=\"{}\" b=\"0\" c=\"0\" d=\"0\"/>\n"
      "              <roadMark sOffset=\"0\" type=\"solid\" weight=\"standard\" color=\"white\" "
      "width=\"0.12\"/>\n"
      "            </lane>\n",
      id, lane::kLaneWidth);
}

}  // namespace

std::string to_opendrive(const lane::Polyline& points, std::string_view name) {
  const Spline spline = *Spline::through(points);
  std::string geometries;
  double s = 0;
  for (const Spline::Piece& piece : spline.pieces()) {
    const double metres = arc_length(piece);
    geometries += geometry(piece, s, metres);
    s += metres;
  }
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<OpenDRIVE>\n"
      "  <header revMajor=\"1\" revMinor=\"6\" name=\"{0}\" version=\"1\"/>\n"
      "  <road name=\"{0}\" length=\"{1:.9g}\" id=\"1\" junction=\"-1\" rule=\"RHT\">\n"
      "    <planView>\n{2}    </planView>\n    <lanes>\n      <laneSection s=\"0\">\n"
      "        <left>\n{3}        </left>\n        <center>\n"
      "            <lane id=\"0\" type=\"none\" level=\"false\">\n"
      "              <roadMark sOffset=\"0\" type=\"broken\" weight=\"standard\" "
      "color=\"yellow\" width=\"0.12\"/>\n            </lane>\n        </center>\n"
      "        <right>\n{4}        </right>\n      </laneSection>\n    </lanes>\n"
      "  </road>\n</OpenDRIVE>\n",
      name, s, geometries, driving_lane(1), driving_lane(-1));
}

}  // namespace jaywalk::search
