// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "curveups/bodies/outline.hpp"

namespace curveups {
namespace {

OutlineShape disc(double x, double y, double radius, double offset) {
  return {{Vec2(x, y)}, radius + offset};
}

double length(const Polygon& loop) {
  double sum = 0;
  for (std::size_t k = 0; k < loop.size(); ++k) {
    sum += (loop[(k + 1) % loop.size()] - loop[k]).norm();
  }
  return sum;
}

// How far p is outside the exact boundary.
double excess(const std::vector<OutlineShape>& shapes, const Vec2& p) {
  double least = 1e300;
  for (const OutlineShape& shape : shapes) {
    const double d =
        shape.polygon.size() == 1 ? (p - shape.polygon[0]).norm() : distance(shape.polygon, p);
    least = std::min(least, d - shape.offset);
  }
  return least;
}

void expect_on_boundary(const std::vector<OutlineShape>& shapes, const std::vector<Polygon>& loops,
                        double deviation) {
  for (const Polygon& loop : loops) {
    for (std::size_t k = 0; k < loop.size(); ++k) {
      for (double s : {0.0, 0.25, 0.5, 0.75}) {
        const double e = excess(shapes, loop[k] + s * (loop[(k + 1) % loop.size()] - loop[k]));
        EXPECT_GT(e, -deviation - 1e-4);  // a chord within its arc
        EXPECT_LT(e, 1e-4);
      }
    }
  }
}

TEST(Outline, OfADiscAndOfASquareHasTheAreaOfTheGrownShape) {
  for (double deviation : {0.1, 0.05}) {
    const std::vector<OutlineShape> round{disc(3, -2, 4, 2)};
    std::vector<Polygon> loops = outline_of(round, deviation);
    ASSERT_EQ(loops.size(), 1u);
    EXPECT_NEAR(area(loops[0]), M_PI * 36, deviation * length(loops[0]));
    expect_on_boundary(round, loops, deviation);
    const std::vector<OutlineShape> square{{{{0, 0}, {10, 0}, {10, 10}, {0, 10}}, 3}};
    loops = outline_of(square, deviation);
    ASSERT_EQ(loops.size(), 1u);
    EXPECT_NEAR(area(loops[0]), 100 + 4 * 30 + M_PI * 9, deviation * length(loops[0]));
    expect_on_boundary(square, loops, deviation);
  }
}

TEST(Outline, HasHolesAndSeveralOuterLoops) {
  std::vector<OutlineShape> ring;
  for (int k = 0; k < 24; ++k) {
    const double a = 2 * M_PI * k / 24;
    ring.push_back(disc(20 * std::cos(a), 20 * std::sin(a), 2, 1.5));
  }
  std::vector<Polygon> loops = outline_of(ring, 0.05);
  ASSERT_EQ(loops.size(), 2u);
  EXPECT_GT(area(loops[0]), 0);
  EXPECT_LT(area(loops[1]), 0);
  EXPECT_NEAR(area(loops[0]) + area(loops[1]), M_PI * (23.2 * 23.2 - 16.8 * 16.8), 40);
  expect_on_boundary(ring, loops, 0.05);
  ring.push_back(disc(60, 0, 1, 1));
  loops = outline_of(ring, 0.05);
  ASSERT_EQ(loops.size(), 3u);
  int holes = 0;
  for (const Polygon& loop : loops) holes += area(loop) < 0;
  EXPECT_EQ(holes, 1);
  for (const Polygon& loop : loops) EXPECT_LE(std::abs(area(loop)), area(loops[0]));
}

TEST(Outline, KeepsItsDistanceFromAnyLayout) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(-30, 30), size(1, 6);
  for (int run = 0; run < 10; ++run) {
    std::vector<OutlineShape> shapes;
    for (int k = 0; k < 25; ++k) {
      const Vec2 c(place(random), place(random));
      if (k % 3 == 0) {
        shapes.push_back(disc(c.x(), c.y(), size(random), 1.0));
        continue;
      }
      std::vector<Vec2> corners;
      for (int i = 0; i < 4; ++i) corners.emplace_back(c.x() + size(random), c.y() + size(random));
      shapes.push_back({convex_hull(corners), 2.0});
    }
    const std::vector<Polygon> loops = outline_of(shapes, 0.05);
    ASSERT_FALSE(loops.empty());
    expect_on_boundary(shapes, loops, 0.05);
  }
}

// Single precision, as in an STL, takes every corner less than 1e-5 mm away here.
TEST(Outline, HasNoCornersThatRoundingTurnsOver) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(-60, 60), radius(1, 6);
  for (int run = 0; run < 20; ++run) {
    std::vector<OutlineShape> shapes;
    for (int k = 0; k < 200; ++k)
      shapes.push_back(disc(place(random), place(random), radius(random), 5));
    for (const Polygon& loop : outline_of(shapes, 0.05)) {
      for (std::size_t k = 0; k < loop.size(); ++k) {
        const Vec2 &a = loop[k], &b = loop[(k + 1) % loop.size()], &c = loop[(k + 2) % loop.size()];
        EXPECT_GT((b - a).norm(), 0.9e-4);
        EXPECT_GT(std::abs(wedge(b - a, c - a)) / (c - a).norm(), 0.9e-4);
      }
    }
  }
}

TEST(Outline, OfThousandsOfShapesIsThatOfAllOfThem) {
  // Squares of 3, turned, every 4 mm, but for one hole that stays open and many that close.
  std::vector<OutlineShape> shapes;
  const int side = 60;
  const auto left_out = [&](int i, int j) {
    return (std::abs(i - 30) < 4 && std::abs(j - 29) < 4) || (i % 7 == 3 && j % 5 == 2);
  };
  for (int i = 0; i < side; ++i) {
    for (int j = 0; j < side; ++j) {
      if (left_out(i, j)) continue;
      const double a = 0.3 * ((3 * i + 5 * j) % 7), r = 1.5 * std::sqrt(2);
      Polygon square;
      for (int k = 0; k < 4; ++k) {
        square.emplace_back(4 * i + r * std::cos(a + k * M_PI / 2),
                            4 * j + r * std::sin(a + k * M_PI / 2));
      }
      shapes.push_back({square, 4.0});
    }
  }
  ASSERT_GT(shapes.size(), 3000u);
  const std::vector<Polygon> loops = outline_of(shapes, 0.05);
  ASSERT_EQ(loops.size(), 2u);
  EXPECT_GT(area(loops[0]), 0);
  EXPECT_LT(area(loops[1]), 0);
  expect_on_boundary(shapes, loops, 0.05);
}

}  // namespace
}  // namespace curveups
