// SPDX-License-Identifier: Apache-2.0
#pragma once

// Drawing with cairo: owners of its objects, and the few shapes that pictures need. Coordinates are
// pixels from the upper left corner.

#include <cairo/cairo.h>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace jaywalk::picture {

/// Red, green and blue from 0 to 1.
struct Colour {
  double red = 0;
  double green = 0;
  double blue = 0;
  double alpha = 1;
};

/// Pixels row by row, each 0xRRGGBB.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::uint32_t> pixels;
};

struct Place {
  double x = 0;
  double y = 0;
};

enum class TextAlign { left, centre, right };

class Canvas {
 public:
  Canvas(int width, int height, Colour background);

  void rectangle(Place corner, double width, double height, Colour colour);
  /// A box around its middle, turned clockwise by `heading_rad`, `length` along its heading; its
  /// front is marked.
  void box(Place middle, double length, double width, double heading_rad, Colour colour);
  void disc(Place middle, double radius, Colour colour);
  void ring(Place middle, double radius, double width, Colour colour);
  void line(Place from, Place to, double width, Colour colour, double dash = 0);
  /// `at`: the left, middle or right end of the base line.
  void text(Place at, std::string_view text, double size, Colour colour,
            TextAlign align = TextAlign::left);

  [[nodiscard]] Image image() const;
  /// The file's bytes; empty if there is no memory for them.
  [[nodiscard]] std::string png() const;

 private:
  void use(Colour colour);

  struct Destroy {
    void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
    void operator()(cairo_t* context) const { cairo_destroy(context); }
  };
  std::unique_ptr<cairo_surface_t, Destroy> surface_;
  std::unique_ptr<cairo_t, Destroy> context_;
};

}  // namespace jaywalk::picture
