// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/fabrication/thumbnail.hpp"

#include <png.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "curveups/core/errors.hpp"
#include "curveups/fabrication/palette.hpp"

namespace curveups {
namespace {

constexpr int pixels = 256;  // each way
constexpr int fine = 3;      // drawn so many times larger, then averaged
constexpr int side = pixels * fine;
constexpr double filled = 0.92;  // of the picture
const Vec3 towards_light = Vec3(-0.35, -0.45, 0.82).normalized();

// Rows: to the right, up, and towards the eye.
Eigen::Matrix3d camera() {
  const double turn = 20 * M_PI / 180, tilt = 50 * M_PI / 180;
  Eigen::Matrix3d out;
  out.row(0) << std::cos(turn), std::sin(turn), 0;
  out.row(1) << -std::sin(turn) * std::cos(tilt), std::cos(turn) * std::cos(tilt), std::sin(tilt);
  out.row(2) = out.row(0).cross(out.row(1));
  return out;
}

struct Canvas {
  std::vector<double> depth = std::vector<double>(side * side, -std::numeric_limits<double>::max());
  std::vector<std::array<std::uint8_t, 4>> colour{side * side, {0, 0, 0, 0}};

  // Corners in pixels, z towards the eye.
  void fill(const std::array<Vec3, 3>& corners, const std::array<std::uint8_t, 4>& paint) {
    const auto& [a, b, c] = corners;
    const double area = (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
    if (area == 0) return;
    const auto [left, right] = std::minmax({a.x(), b.x(), c.x()});
    const auto [bottom, top] = std::minmax({a.y(), b.y(), c.y()});
    for (int y = inside(bottom - 0.5); y <= inside(top); ++y) {
      for (int x = inside(left - 0.5); x <= inside(right); ++x) {
        const double px = x + 0.5 - a.x(), py = y + 0.5 - a.y();
        const double u = (px * (c.y() - a.y()) - py * (c.x() - a.x())) / area;
        const double v = (py * (b.x() - a.x()) - px * (b.y() - a.y())) / area;
        if (u < 0 || v < 0 || u + v > 1) continue;
        const double z = a.z() + u * (b.z() - a.z()) + v * (c.z() - a.z());
        const int at = (side - 1 - y) * side + x;
        if (z <= depth[at]) continue;
        depth[at] = z;
        colour[at] = paint;
      }
    }
  }

  static int inside(double at) {
    return static_cast<int>(std::clamp(std::floor(at), 0.0, side - 1.0));
  }

  std::vector<std::uint8_t> averaged() const {
    std::vector<std::uint8_t> out;
    out.reserve(4 * pixels * pixels);
    for (int y = 0; y < pixels; ++y) {
      for (int x = 0; x < pixels; ++x) {
        std::array<int, 4> sum{};
        for (int k = 0; k < fine * fine; ++k) {
          const auto& one = colour[(y * fine + k / fine) * side + x * fine + k % fine];
          for (int channel = 0; channel < 4; ++channel) sum[channel] += one[channel];
        }
        const int covered = std::max(sum[3] / 255, 1), all = fine * fine;
        for (int channel = 0; channel < 3; ++channel) out.push_back(sum[channel] / covered);
        out.push_back(sum[3] / all);
      }
    }
    return out;
  }
};

std::string png(const std::vector<std::uint8_t>& rgba) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = image.height = pixels;
  image.format = PNG_FORMAT_RGBA;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
  std::string out(size, '\0');
  if (!png_image_write_to_memory(&image, out.data(), &size, 0, rgba.data(), 0, nullptr)) {
    throw SolverFailure(std::string("libpng could not draw a thumbnail (") + image.message + ")",
                        "report this with the design file");
  }
  out.resize(size);
  return out;
}

}  // namespace

std::string draw_thumbnail(const std::vector<BodyMesh>& meshes) {
  const Eigen::Matrix3d seen_by = camera();
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::max()), high = -low;
  for (const BodyMesh& mesh : meshes) {
    for (const auto& triangle : mesh.triangles) {
      for (const int corner : triangle) {
        const Vec3 p = seen_by * mesh.points[corner];
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
      }
    }
  }
  if (!(low.array() <= high.array()).all()) return "";
  const double scale = filled * side / std::max((high - low).head<2>().maxCoeff(), 1e-9);
  const Vec3 shift = Vec3(side, side, 0) / 2 - scale * (low + high) / 2;
  Canvas canvas;
  for (const BodyMesh& mesh : meshes) {
    const Colour plain = body_colour(mesh.kind);
    for (const auto& [i, j, k] : mesh.triangles) {
      const Vec3 &a = mesh.points[i], &b = mesh.points[j], &c = mesh.points[k];
      const Vec3 normal = (b - a).cross(c - a).normalized();  // 0 where it has no area
      const double light = 0.35 + 0.65 * std::abs(normal.dot(towards_light));
      const auto lit = [light](unsigned char value) {
        return static_cast<std::uint8_t>(std::lround(light * value));
      };
      canvas.fill({scale * (seen_by * a) + shift, scale * (seen_by * b) + shift,
                   scale * (seen_by * c) + shift},
                  {lit(plain.red), lit(plain.green), lit(plain.blue), 255});
    }
  }
  return png(canvas.averaged());
}

}  // namespace curveups
