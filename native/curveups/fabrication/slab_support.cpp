// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <limits>

#include "curveups/bodies/outline.hpp"
#include "curveups/core/checkpoint.hpp"
#include "curveups/core/errors.hpp"
#include "curveups/core/tolerances.hpp"
#include "curveups/fabrication/print_parts.hpp"
#include "curveups/fabrication/slab.hpp"
#include "curveups/fabrication/supports.hpp"

namespace curveups {
namespace {

constexpr double slab_deviation = 0.1;  // of the chords of the outline's arcs, mm

// What stands in the slab from its underside to its top, upright.
PrintBody prism_cavity(const Polygon& outline, double top) {
  PrintBody body;
  PlanarFace foot, mouth;
  std::vector<int> base;
  for (const Vec2& c : outline) {
    base.push_back(static_cast<int>(body.points.size()));
    body.points.emplace_back(c.x(), c.y(), 0);
  }
  foot.normal = -Vec3::UnitZ();
  foot.outer.points.assign(base.rbegin(), base.rend());
  foot.role = FaceRole::foot;
  mouth.normal = Vec3::UnitZ();
  mouth.outer.points = extrude(body, base, Vec3(0, 0, top), FaceRole::back_pin);
  mouth.role = FaceRole::front;
  body.faces.push_back(foot);
  body.faces.push_back(mouth);
  return body;
}

// What the slab surrounds of each tile: everything below its top.
std::vector<PrintBody> cavities(const PrintModel& model, double top) {
  const Parameters& p = model.parameters;
  const TileMesh& tiles = model.geometry.tiles;
  const double cut = top - p.H_pin - p.H_body;  // in the tile's frame
  if (cut >= 0) return model.tiles;
  if (top > p.H_pin + tolerance::snap) {
    std::vector<ConvexBody> bodies = model.bumps.body;
    std::vector<std::vector<WallCap>> caps(bodies.size());
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      clip(bodies[i], {Vec3::UnitZ(), cut}, body_tag::front);
      for (const WallCap& cap : model.bumps.of_tile[i]) {
        if (cap.centre.z() < cut) caps[i].push_back(cap);
      }
    }
    return flat_tiles(model, bodies, caps);
  }
  std::vector<PrintBody> pins;  // only the back pins stand in the slab
  for (int tile = 0; tile < tiles.tile_count(); ++tile) {
    const auto pin =
        place(model.poses, tile, pin_corners(tiles, tile, Side::back, model.q.row(tile).data()));
    pins.push_back(prism_cavity({pin.begin(), pin.end()}, top));
  }
  return pins;
}

int nearest_tile(const PrintModel& model, const PieceFootprint& footprint, int piece,
                 const Vec2& place) {
  int nearest = -1;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t tile = 0, k = 0; tile < model.piece_of_tile.size(); ++tile) {
    if (model.piece_of_tile[tile] != piece) continue;
    for (const Vec2& corner : footprint.tiles[k]) {
      const double distance = (corner - place).norm();
      if (distance < least) nearest = static_cast<int>(tile), least = distance;
    }
    ++k;
  }
  return nearest;
}

// No other piece's tiles or slab (`outer`, of the pieces before) may be where this piece's slab is.
void refuse_strangers(const PrintModel& model, int piece, const Polygon& loop,
                      const std::vector<PieceFootprint>& footprints,
                      const std::vector<Polygon>& outer) {
  auto refuse = [&](int other, const Vec2& where) {
    throw InfeasibleDesign("the support of piece " + std::to_string(piece + 1) +
                               " runs into piece " + std::to_string(other + 1),
                           "lower anchor_radius, anchor_distance or support_margin, or compute "
                           "the layout again with these",
                           {nearest_tile(model, footprints[piece], piece, where),
                            nearest_tile(model, footprints[other], other, where)});
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

void leave_loose(PrintModel& model, int piece) {
  for (std::size_t tile = 0; tile < model.piece_of_tile.size(); ++tile) {
    if (model.piece_of_tile[tile] == piece) model.loose_tiles.push_back(static_cast<int>(tile));
  }
}

void add_slabs(PrintModel& model, const std::vector<PieceFootprint>& footprints) {
  const Parameters& p = model.parameters;
  std::vector<Polygon> outer;
  const double top = 2 * p.H_pin + p.H_body - p.support_drop;
  const std::vector<PrintBody> cavity = cavities(model, top);
  for (int piece = 0; piece < model.piece_count; ++piece) {
    std::vector<PrintBody> inside;
    std::vector<Disc> anchors;
    std::vector<OutlineShape> shapes;
    const Disc none{Vec2::Zero(), 0};
    const PieceFootprint& footprint = footprints[piece];
    // Up to the anchors' axes, so that the slab holds them firmly.
    const double reach = footprint.anchors.empty()
                             ? p.support_margin
                             : std::max(p.support_margin, p.anchor_distance + p.anchor_radius);
    for (const Polygon& tile : footprint.tiles) shapes.push_back({tile, none, reach});
    for (const Polygon& joint : footprint.joints) shapes.push_back({joint, none, reach});
    for (const Polygon& tab : footprint.tab) shapes.push_back({tab, none, p.support_margin});
    for (std::size_t k = 0; k < footprint.anchors.size(); ++k) {
      shapes.push_back({{}, {footprint.anchors[k], p.anchor_radius}, p.support_margin});
      if (static_cast<int>(k) == footprint.labelled) {
        inside.push_back(prism_cavity(footprint.outline, top));
      } else {
        anchors.push_back({footprint.anchors[k], p.anchor_radius});
      }
    }
    for (std::size_t i = 0; i < cavity.size(); ++i) {
      if (model.piece_of_tile[i] == piece) inside.push_back(cavity[i]);
    }
    std::vector<Polygon> loops =
        outline_of(shapes, std::min(slab_deviation, 0.1 * p.support_margin));
    for (std::size_t k = 1; k < loops.size(); ++k) {
      if (area(loops[k]) < 0) continue;
      throw SolverFailure("the support of piece " + std::to_string(piece + 1) + " falls apart",
                          "raise support_margin");
    }
    checkpoint("building the support", 0.6);
    refuse_strangers(model, piece, loops[0], footprints, outer);
    outer.push_back(loops[0]);
    try {
      PrintBody slab = make_slab(loops, inside, anchors, top);
      slab.name = numbered("Support P%d", piece + 1);
      slab.piece = piece;
      model.supports.push_back(std::move(slab));
    } catch (const TopologyError&) {  // a layout whose bodies run into one another
      leave_loose(model, piece);
      model.loose_anchors += static_cast<int>(footprint.anchors.size());
    }
  }
  std::sort(model.loose_tiles.begin(), model.loose_tiles.end());
}

}  // namespace

SupportKind slabs() {
  return {"slab", "support (soluble)", "dissolve the slab and let the tiles dry", true, add_slabs};
}

}  // namespace curveups
