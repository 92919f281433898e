// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <limits>
#include <set>

#include "curveups/bodies/outline.hpp"
#include "curveups/core/checkpoint.hpp"
#include "curveups/core/errors.hpp"
#include "curveups/core/sort_unique.hpp"
#include "curveups/design/print_constants.hpp"
#include "curveups/fabrication/slab.hpp"
#include "curveups/fabrication/supports.hpp"

namespace curveups {
namespace {

constexpr double support_drop = 0.3;  // mm from the front pin tops and their glue down to the slab
constexpr double slab_deviation = 0.1;  // of the chords of the outline's arcs, mm

// Least distance of a corner of one of two convex polygons from the other.
double least_distance(const Polygon& a, const Polygon& b) {
  double least = std::numeric_limits<double>::infinity();
  for (const Vec2& q : a) least = std::min(least, distance(b, q));
  for (const Vec2& q : b) least = std::min(least, distance(a, q));
  return least;
}

// Throws InfeasibleDesign where the slab (`loop`) meets another piece's tiles, or the slab of an
// earlier piece (`outer`).
void refuse_strangers(const PrintModel& model, int piece, const Polygon& loop,
                      const std::vector<PieceFootprint>& footprints,
                      const std::vector<Polygon>& outer) {
  auto refuse = [&](int other, const Vec2& where) {
    throw InfeasibleDesign(
        "the support of piece " + std::to_string(piece + 1) + " runs into piece " +
            std::to_string(other + 1),
        "lower anchor_radius, or compute the layout again",
        {nearest_tile(footprints[piece], where), nearest_tile(footprints[other], where)});
  };
  for (int other = 0; other < model.piece_count; ++other) {
    if (other == piece) continue;
    for (const Polygon& tile : footprints[other].tiles) {
      for (const Vec2& q : tile) {
        if (contains(loop, q)) refuse(other, q);
      }
    }
  }
  for (std::size_t earlier = 0; earlier < outer.size(); ++earlier) {
    for (const Vec2& q : outer[earlier]) {
      if (contains(loop, q)) refuse(static_cast<int>(earlier), q);
    }
  }
}

struct SlabContent {
  std::vector<OutlineShape> shapes;  // shapes whose union is the slab's outline
  std::vector<PrintBody> inside;
  std::vector<Vec2> bores;  // axes of the anchors in the slab
};

// Content of a piece's slab, or of a part's. has(tile): whether a tile belongs to the part. Anchors
// belong to the nearest tile.
template <class Has>
SlabContent content_of(const PrintModel& model, const PieceFootprint& footprint, const Has& has) {
  const Parameters& p = model.parameters;
  SlabContent out;
  // To the anchors' axes, so that the slab holds them firmly.
  const double reach = footprint.anchors.empty()
                           ? support_margin
                           : std::max(support_margin, anchor_distance + p.anchor_radius);
  for (std::size_t k = 0; k < footprint.tiles.size(); ++k) {
    if (has(footprint.rows[k])) out.shapes.push_back({footprint.tiles[k], reach});
  }
  for (std::size_t k = 0; k < footprint.joints.size(); ++k) {
    const auto& [a, b] = footprint.joined[k];
    if (has(a) && has(b)) out.shapes.push_back({footprint.joints[k], reach});
  }
  for (const Vec2& anchor : footprint.anchors) {
    if (!has(nearest_tile(footprint, anchor))) continue;
    out.shapes.push_back({{anchor}, support_margin + p.anchor_radius});
    out.bores.push_back(anchor);
  }
  for (int row : footprint.rows) {
    if (has(row)) out.inside.push_back(model.tiles[row]);
  }
  return out;
}

// Shapes that a part's outline leaves to the other parts of its piece: their tiles with half of the
// gap to its own, and their anchors.
template <class Has>
std::vector<OutlineShape> others_of(const PrintModel& model, const PieceFootprint& footprint,
                                    const Has& has) {
  const Parameters& p = model.parameters;
  std::vector<OutlineShape> out;
  for (std::size_t k = 0; k < footprint.tiles.size(); ++k) {
    if (has(footprint.rows[k])) continue;
    const Polygon& tile = footprint.tiles[k];
    double gap = 2 * support_margin;
    for (std::size_t i = 0; i < footprint.tiles.size(); ++i) {
      const Polygon& own = footprint.tiles[i];
      if (!has(footprint.rows[i])) continue;
      const double far = (own[0] - tile[0]).norm() - width(own) - width(tile);
      if (far < 4 * gap) gap = std::min(gap, least_distance(own, tile));
    }
    out.push_back({tile, 0.5 * gap});
  }
  std::vector<Vec2> own;
  for (const Vec2& anchor : footprint.anchors) {
    if (has(nearest_tile(footprint, anchor))) own.push_back(anchor);
  }
  for (const Vec2& anchor : footprint.anchors) {
    if (has(nearest_tile(footprint, anchor))) continue;
    double gap = 2 * std::min(support_margin, 0.5 * anchor_distance);
    for (const Vec2& other : own) {
      gap = std::min(gap, (other - anchor).norm() - 2 * p.anchor_radius);
    }
    out.push_back({{anchor}, 0.5 * gap + p.anchor_radius});
  }
  return out;
}

void add_slabs(PrintModel& model, const std::vector<PieceFootprint>& footprints) {
  const Parameters& p = model.parameters;
  const Division& division = model.division;
  std::vector<Polygon> outer;
  const double top = 2 * p.H_pin + p.H_body - std::min(support_drop, 0.5 * p.H_pin);
  for (int piece = 0; piece < model.piece_count; ++piece) {
    const PieceFootprint& footprint = footprints[piece];
    std::set<int> parts{piece};
    if (!division.part_of_tile.empty()) {
      parts.clear();
      for (int row : footprint.rows) parts.insert(division.part_of_tile[row]);
    }
    std::vector<Polygon> before;  // outlines of earlier parts of this piece
    for (const int part : parts) {
      const auto has = [&](int row) {
        return parts.size() == 1 || division.part_of_tile[row] == part;
      };
      const SlabContent content = content_of(model, footprint, has);
      std::vector<Polygon> loops = outline_of(content.shapes, slab_deviation);
      if (parts.size() > 1) {
        const std::vector<OutlineShape> others = others_of(model, footprint, has);
        loops = outline_without(loops, {}, outline_of(others, slab_deviation), 0, slab_deviation);
        // Chords of the opening's arcs leave nine tenths of it.
        const double of_opening = division.opening > 0 ? 0.1 * division.opening : slab_deviation;
        loops = outline_without(loops, {}, before, division.opening,
                                std::min(slab_deviation, of_opening));
        before.insert(before.end(), loops.begin(), loops.end());
      }
      if (!division.region.empty()) {
        loops = outline_without(loops, division.region, {}, 0, slab_deviation);
      }
      bool whole = !loops.empty();
      for (std::size_t k = 1; k < loops.size(); ++k) whole = whole && area(loops[k]) < 0;
      if (!whole) {
        throw SolverFailure("the support of piece " + std::to_string(piece + 1) + " falls apart",
                            "compute the layout again, or set support to breakaway");
      }
      for (std::size_t k = 0; k < footprint.tiles.size(); ++k) {  // beyond a neck that was cut off
        if (!has(footprint.rows[k]) || contains(loops[0], footprint.tiles[k][0])) continue;
        model.loose_tiles.push_back(footprint.rows[k]);
      }
      checkpoint("building the support", 0.6);
      if (parts.size() == 1) refuse_strangers(model, piece, loops[0], footprints, outer);
      outer.push_back(loops[0]);
      try {
        PrintBody slab = make_slab(loops, content.inside, content.bores, p.anchor_radius, top);
        slab.name = numbered("Support P%d", part + 1);
        slab.piece = part;
        model.supports.push_back(std::move(slab));
        model.outlines.push_back(std::move(loops));
      } catch (const TopologyError&) {  // bodies of the layout run into one another
        model.loose_tiles.insert(model.loose_tiles.end(), footprint.rows.begin(),
                                 footprint.rows.end());
        model.loose_anchors += static_cast<int>(content.bores.size());
      }
    }
  }
  std::vector<int>& loose = model.loose_tiles;
  sort_unique(loose);
}

}  // namespace

SupportKind slabs() {
  return {"slab", "support (soluble)", "dissolve the slab and let the tiles dry", true, add_slabs};
}

}  // namespace curveups
