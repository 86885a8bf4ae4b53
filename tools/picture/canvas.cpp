// SPDX-License-Identifier: Apache-2.0
#include "tools/picture/canvas.h"

#include <cstring>
#include <numbers>

namespace jaywalk::picture {

Canvas::Canvas(int width, int height, Colour background)
    : surface_(cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height)),
      context_(cairo_create(surface_.get())) {
  cairo_select_font_face(context_.get(), "sans-serif", CAIRO_FONT_SLANT_NORMAL,
                         CAIRO_FONT_WEIGHT_NORMAL);
  use(background);
  cairo_paint(context_.get());
}

void Canvas::use(Colour colour) {
  cairo_set_source_rgba(context_.get(), colour.red, colour.green, colour.blue, colour.alpha);
}

void Canvas::rectangle(Place corner, double width, double height, Colour colour) {
  use(colour);
  cairo_rectangle(context_.get(), corner.x, corner.y, width, height);
  cairo_fill(context_.get());
}

void Canvas::box(Place middle, double length, double width, double heading_rad, Colour colour) {
  cairo_t* const context = context_.get();
  cairo_save(context);
  cairo_translate(context, middle.x, middle.y);
  cairo_rotate(context, heading_rad);
  rectangle({-length / 2, -width / 2}, length, width, colour);
  // The windscreen, a little behind the front.
  rectangle({length * 0.28, -width / 2 + 1}, length * 0.1, width - 2, {1, 1, 1, 0.6});
  cairo_restore(context);
}

void Canvas::disc(Place middle, double radius, Colour colour) {
  use(colour);
  cairo_arc(context_.get(), middle.x, middle.y, radius, 0, 2 * std::numbers::pi);
  cairo_fill(context_.get());
}

void Canvas::ring(Place middle, double radius, double width, Colour colour) {
  use(colour);
  cairo_set_line_width(context_.get(), width);
  cairo_arc(context_.get(), middle.x, middle.y, radius, 0, 2 * std::numbers::pi);
  cairo_stroke(context_.get());
}

void Canvas::line(Place from, Place to, double width, Colour colour, double dash) {
  use(colour);
  cairo_set_line_width(context_.get(), width);
  cairo_set_dash(context_.get(), &dash, dash > 0 ? 1 : 0, 0);
  cairo_move_to(context_.get(), from.x, from.y);
  cairo_line_to(context_.get(), to.x, to.y);
  cairo_stroke(context_.get());
  cairo_set_dash(context_.get(), nullptr, 0, 0);
}

void Canvas::text(Place at, std::string_view text, double size, Colour colour, TextAlign align) {
  cairo_t* const context = context_.get();
  const std::string copy(text);
  use(colour);
  cairo_set_font_size(context, size);
  cairo_text_extents_t extents{};
  cairo_text_extents(context, copy.c_str(), &extents);
  const double shift = align == TextAlign::left     ? 0
                       : align == TextAlign::centre ? extents.x_advance / 2
                                                    : extents.x_advance;
  cairo_move_to(context, at.x - shift, at.y);
  cairo_show_text(context, copy.c_str());
}

Image Canvas::image() const {
  cairo_surface_flush(surface_.get());
  Image image{.width = cairo_image_surface_get_width(surface_.get()),
              .height = cairo_image_surface_get_height(surface_.get()),
              .pixels = {}};
  const unsigned char* const bytes = cairo_image_surface_get_data(surface_.get());
  if (bytes == nullptr) return {};
  const auto stride = static_cast<std::size_t>(cairo_image_surface_get_stride(surface_.get()));
  const auto width = static_cast<std::size_t>(image.width);
  image.pixels.resize(width * static_cast<std::size_t>(image.height));
  for (std::size_t row = 0; row < static_cast<std::size_t>(image.height); ++row) {
    std::memcpy(&image.pixels[row * width], bytes + row * stride, width * sizeof(std::uint32_t));
  }
  for (std::uint32_t& pixel : image.pixels) pixel &= 0xFFFFFFU;  // the rest is undefined
  return image;
}

std::string Canvas::png() const {
  std::string bytes;
  const auto append = [](void* target, const unsigned char* data, unsigned length) {
    static_cast<std::string*>(target)->append(data, data + length);
    return CAIRO_STATUS_SUCCESS;
  };
  const auto status = cairo_surface_write_to_png_stream(surface_.get(), append, &bytes);
  return status == CAIRO_STATUS_SUCCESS ? bytes : std::string();
}

}  // namespace jaywalk::picture
