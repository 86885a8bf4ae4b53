#pragma once

// The place of a scenario's plane on the Earth, for maps. No computation uses it: tests, measures
// and recordings stay in the plane's own metres.

namespace jaywalk {

struct Anchor {
  /// A projected reference system whose unit is the metre, by its EPSG code: 27700, 32630, …
  int epsg = 0;
  /// The coordinates of the plane's origin.
  double easting_m = 0;
  double northing_m = 0;
  /// The direction of the AV's way (the plane's y), clockwise from the system's north.
  double bearing_deg = 0;

  friend bool operator==(const Anchor&, const Anchor&) = default;
};

}  // namespace jaywalk
