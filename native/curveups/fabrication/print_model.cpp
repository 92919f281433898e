// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/fabrication/print_model.hpp"

#include <algorithm>
#include <cstdio>
#include <limits>
#include <numeric>

#include "curveups/core/errors.hpp"
#include "curveups/core/parallel.hpp"
#include "curveups/core/tolerances.hpp"
#include "curveups/fabrication/anchors.hpp"
#include "curveups/fabrication/bridges.hpp"
#include "curveups/fabrication/convex_distance.hpp"
#include "curveups/fabrication/slab.hpp"

namespace curveups {
namespace {

constexpr double engraving_stroke = 0.3;  // the least that printers show, mm
constexpr double engraving_rim = 0.3;     // between letters and the edge of the anchor, mm
constexpr double slab_grid = 0.5;         // mm

std::string numbered(const char* format, int a, int b = 0) {
  char name[48];
  std::snprintf(name, sizeof name, format, a, b);
  return name;
}

class Builder {
 public:
  Builder(const Design& design, std::string version) : version_(std::move(version)) {
    model_.name = design.name;
    model_.parameters = design.parameters;
    model_.geometry = make_geometry(design.mesh, design.cuts, design.parameters);
    refuse_tiles_without_back();
    model_.poses = fit_poses(tiles(), design.T);
    model_.q = design.q;
  }

  PrintModel run() {
    const int count = tiles().tile_count();
    model_.bumps = plan_bumps(model_.geometry, model_.poses, p());
    check_pins(tiles(), model_.bumps.body, model_.q);
    find_pieces();
    for (int i = 0; i < count; ++i) {
      model_.flat.push_back(flat_motion(model_.poses, i, p().H_pin + p().H_body));
    }
    model_.tiles = tile_prints(model_.bumps.body, model_.bumps.of_tile);
    footprints_.resize(model_.piece_count);
    for (int i = 0; i < count; ++i) {
      std::vector<Vec2> seen;
      for (const Vec3& q : model_.tiles[i].points) seen.push_back(q.head<2>());
      footprints_[model_.piece_of_tile[i]].tiles.push_back(convex_hull(seen));
    }
    join_footprints();
    if (p().anchors) add_anchors();
    if (p().support == "soluble") add_slabs();
    if (p().support == "breakaway") add_bridges();
    list_features();
    centre();
    return std::move(model_);
  }

 private:
  const Parameters& p() const { return model_.parameters; }
  const TileMesh& tiles() const { return model_.geometry.tiles; }

  void refuse_tiles_without_back() const {
    const std::vector<int> lost = tiles_without_back(tiles());
    if (lost.empty()) return;
    throw InfeasibleDesign(
        "the back face of " + std::to_string(lost.size()) + " tiles vanishes or turns inside out",
        "lower H_body or flatten the folds there", lost);
  }

  void find_pieces() {
    std::vector<char> joined;
    for (std::size_t e = 0; e < tiles().topology.edges.size(); ++e) {
      joined.push_back(!tiles().topology.edges[e].boundary() && !tiles().cut[e]);
    }
    model_.piece_of_tile = face_components(tiles().topology, joined);
    for (int piece : model_.piece_of_tile) {
      model_.piece_count = std::max(model_.piece_count, piece + 1);
    }
  }

  std::vector<PrintBody> tile_prints(const std::vector<ConvexBody>& bodies,
                                     const std::vector<std::vector<WallCap>>& caps) const {
    std::vector<PrintBody> out(bodies.size());
    parallel_ranges(static_cast<int>(bodies.size()), [&](int begin, int end) {
      for (int i = begin; i < end; ++i) {
        out[i] = make_tile_print(tiles(), bodies[i], caps[i], model_.q.row(i).data(), i, p().H_pin);
        out[i].piece = model_.piece_of_tile[i];
        move(out[i], model_.flat[i]);
      }
    });
    return out;
  }

  // The flat front corners of one side of a contact, as its tile runs along it.
  std::array<Vec2, 2> front_edge(const Contact& contact, int s) const {
    const std::array<Vec2, 3> corner =
        place(model_.poses, contact.tile[s], tiles().front[contact.tile[s]]);
    return {corner[contact.side[s]], corner[next3(contact.side[s])]};
  }

  void join_footprints() {
    for (const Contact& contact : tiles().contacts) {
      const auto a = front_edge(contact, 0), b = front_edge(contact, 1);
      const Polygon hull = convex_hull({a[0], a[1], b[0], b[1]});
      if (hull.size() >= 3) {
        footprints_[model_.piece_of_tile[contact.tile[0]]].joints.push_back(hull);
      }
    }
  }

  void add_anchors() {
    const auto centres = place_anchors(footprints_, p());
    const double height = 2 * p().H_pin + p().H_body;
    anchors_of_piece_.resize(model_.piece_count);
    for (int piece = 0; piece < model_.piece_count; ++piece) {
      for (std::size_t k = 0; k < centres[piece].size(); ++k) {
        EngravedText text;
        if (k == 0 && p().engrave) {
          text = engrave_text(model_.name, version_, "P" + std::to_string(piece + 1),
                              p().anchor_radius - engraving_rim, engraving_stroke);
        }
        PrintBody anchor =
            make_anchor(centres[piece][k], p().anchor_radius, height, text, p().engrave_depth);
        anchor.name = numbered("Anchor P%d A%03d", piece + 1, static_cast<int>(k) + 1);
        anchor.piece = piece;
        if (!text.regions.empty()) {
          model_.thin.push_back({anchor.name, "stroke of the engraving", text.stroke});
        }
        anchors_of_piece_[piece].push_back(static_cast<int>(model_.anchors.size()));
        model_.anchors.push_back(std::move(anchor));
      }
    }
  }

  // What the slab surrounds of each tile: everything below its top.
  std::vector<PrintBody> cavities(double top) const {
    const double cut = top - p().H_pin - p().H_body;  // in the tile's frame
    if (cut >= 0) return model_.tiles;
    if (top > p().H_pin + tolerance::snap) {
      std::vector<ConvexBody> bodies = model_.bumps.body;
      std::vector<std::vector<WallCap>> caps(bodies.size());
      for (std::size_t i = 0; i < bodies.size(); ++i) {
        clip(bodies[i], {Vec3::UnitZ(), cut}, body_tag::front);
        for (const WallCap& cap : model_.bumps.of_tile[i]) {
          if (cap.centre.z() < cut) caps[i].push_back(cap);
        }
      }
      return tile_prints(bodies, caps);
    }
    std::vector<PrintBody> pins(model_.tiles.size());  // only the back pins stand in the slab
    for (std::size_t i = 0; i < pins.size(); ++i) {
      PrintBody& pin = pins[i];
      PlanarFace foot, mouth;
      std::vector<int> base;
      const int tile = static_cast<int>(i);
      for (const Vec2& c : place(model_.poses, tile,
                                 pin_corners(tiles(), tile, Side::back, model_.q.row(i).data()))) {
        base.push_back(static_cast<int>(pin.points.size()));
        pin.points.emplace_back(c.x(), c.y(), 0);
      }
      foot.normal = -Vec3::UnitZ();
      foot.outer.points.assign(base.rbegin(), base.rend());
      foot.role = FaceRole::foot;
      mouth.normal = Vec3::UnitZ();
      mouth.outer.points = extrude(pin, base, Vec3(0, 0, top), FaceRole::back_pin);
      mouth.role = FaceRole::front;
      pin.faces.push_back(foot);
      pin.faces.push_back(mouth);
    }
    return pins;
  }

  void add_slabs() {
    const double top = 2 * p().H_pin + p().H_body - p().support_drop;
    const std::vector<PrintBody> cavity = cavities(top);
    for (int piece = 0; piece < model_.piece_count; ++piece) {
      std::vector<PrintBody> inside;
      std::vector<const PrintBody*> anchors;
      std::vector<OutlineShape> shapes;
      const Disc none{Vec2::Zero(), 0};
      const bool anchored = p().anchors && !anchors_of_piece_[piece].empty();
      // Up to the anchors' axes, so that the slab holds them firmly.
      const double reach =
          anchored ? std::max(p().support_margin, p().anchor_distance + p().anchor_radius)
                   : p().support_margin;
      for (const Polygon& tile : footprints_[piece].tiles) shapes.push_back({tile, none, reach});
      for (const Polygon& joint : footprints_[piece].joints) shapes.push_back({joint, none, reach});
      if (anchored) {
        for (int a : anchors_of_piece_[piece]) {
          anchors.push_back(&model_.anchors[a]);
          const Vec3& c = model_.anchors[a].circles[0].centre;
          shapes.push_back({{}, {c.head<2>(), p().anchor_radius}, p().support_margin});
        }
      }
      for (std::size_t i = 0; i < cavity.size(); ++i) {
        if (model_.piece_of_tile[i] == piece) inside.push_back(cavity[i]);
      }
      std::vector<Polygon> loops = outline_of(shapes, std::min(slab_grid, p().support_margin));
      for (std::size_t k = 1; k < loops.size(); ++k) {
        if (area(loops[k]) < 0) continue;
        throw SolverFailure("the support of piece " + std::to_string(piece + 1) + " falls apart",
                            "raise support_margin");
      }
      refuse_strangers(piece, loops[0]);
      PrintBody slab = make_slab(loops, inside, anchors, top);
      slab.name = numbered("Support P%d", piece + 1);
      slab.piece = piece;
      model_.supports.push_back(std::move(slab));
      outer_.push_back(loops[0]);
    }
  }

  // No other piece's tiles or slab may be where this piece's slab is.
  void refuse_strangers(int piece, const Polygon& loop) const {
    auto inside = [&](const Vec2& q) {
      bool in = false;
      for (std::size_t k = 0; k < loop.size(); ++k) {
        const Vec2 &a = loop[k], &b = loop[(k + 1) % loop.size()];
        if ((a.y() > q.y()) == (b.y() > q.y())) continue;
        if (q.x() < a.x() + (q.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x())) in = !in;
      }
      return in;
    };
    auto refuse = [&](int other, const Vec2& where) {
      throw InfeasibleDesign("the support of piece " + std::to_string(piece + 1) +
                                 " runs into piece " + std::to_string(other + 1),
                             "lower anchor_radius, anchor_distance or support_margin, or compute "
                             "the layout again with these",
                             {nearest_tile(piece, where), nearest_tile(other, where)});
    };
    for (int other = 0; other < model_.piece_count; ++other) {
      if (other == piece) continue;
      for (const Polygon& tile : footprints_[other].tiles) {
        for (const Vec2& q : tile) {
          if (inside(q)) refuse(other, q);
        }
      }
    }
    for (std::size_t earlier = 0; earlier < outer_.size(); ++earlier) {
      for (const Vec2& q : outer_[earlier]) {
        if (inside(q)) refuse(static_cast<int>(earlier), q);
      }
    }
  }

  int nearest_tile(int piece, const Vec2& place) const {
    int nearest = -1;
    double least = std::numeric_limits<double>::infinity();
    const std::vector<Polygon>& footprints = footprints_[piece].tiles;  // in the order of tiles
    for (std::size_t tile = 0, k = 0; tile < model_.piece_of_tile.size(); ++tile) {
      if (model_.piece_of_tile[tile] != piece) continue;
      for (const Vec2& corner : footprints[k]) {
        const double distance = (corner - place).norm();
        if (distance < least) nearest = static_cast<int>(tile), least = distance;
      }
      ++k;
    }
    return nearest;
  }

  void add_bridges() {
    const int count = tiles().tile_count();
    std::vector<BridgeObstacle> bodies;
    std::vector<Polygon> hull;
    for (int i = 0; i < count; ++i) {
      BridgeObstacle body{moved(model_.bumps.body[i], model_.flat[i]), {}, {}};
      for (const WallCap& cap : model_.bumps.of_tile[i]) {
        body.ball_centres.push_back(model_.flat[i](cap.centre));
        body.ball_radii.push_back(cap.radius);
      }
      std::vector<Vec2> seen;
      for (const Vec3& q : body.body.points) seen.push_back(q.head<2>());
      hull.push_back(convex_hull(seen));
      bodies.push_back(std::move(body));
    }
    std::vector<BridgeWish> wishes;
    for (const Contact& contact : tiles().contacts) {
      BridgeWish wish{contact.tile[0], contact.tile[1], {}};
      const auto a = front_edge(contact, 0), b = front_edge(contact, 1);
      const Vec2 d = (left_of(a[0] - a[1]).normalized() + left_of(b[1] - b[0]).normalized());
      for (int step = 0; step <= 16; ++step) {  // from the middle outwards, to both sides in turn
        const double s = 0.5 + (step % 2 ? 0.025 : -0.025) * (step + step % 2);
        const Vec2 middle = 0.5 * (a[0] + s * (a[1] - a[0]) + b[1] + s * (b[0] - b[1]));
        wish.sight.push_back({middle, d.normalized()});
      }
      wishes.push_back(std::move(wish));
    }
    for (std::size_t k = 0; k < model_.anchors.size(); ++k)
      add_anchor_wishes(k, bodies, hull, wishes);
    Bridges bridges = make_bridges(bodies, wishes, p().H_pin, p().H_pin + p().H_body, p());
    keep_two_per_anchor(bridges, count);
    std::vector<int> number(model_.piece_count, 0);
    for (std::size_t k = 0; k < bridges.bodies.size(); ++k) {
      PrintBody& bridge = bridges.bodies[k];
      bridge.piece = model_.piece_of_tile[bridges.joined[k][0]];
      bridge.name = numbered("Support P%d B%04d", bridge.piece + 1, ++number[bridge.piece]);
      model_.supports.push_back(std::move(bridge));
    }
    find_loose(bridges, count);
  }

  // Wishes to join anchor k with its nearest tiles.
  void add_anchor_wishes(std::size_t k, std::vector<BridgeObstacle>& bodies,
                         const std::vector<Polygon>& hull, std::vector<BridgeWish>& wishes) const {
    constexpr int corners = 64;
    const PrintBody& anchor = model_.anchors[k];
    const Vec2 c = anchor.circles[0].centre.head<2>();
    const double r = p().anchor_radius, height = anchor.circles[1].centre.z();
    ConvexBody cylinder;
    BodyFace bottom{{}, body_tag::back, {-Vec3::UnitZ(), 0}};
    BodyFace top{{}, body_tag::front, {Vec3::UnitZ(), height}};
    for (int i = 0; i < corners; ++i) {
      const Vec2 e = PlaneRotation(6.283185307179586 * i / corners) * Vec2(r, 0);
      cylinder.points.emplace_back(c.x() + e.x(), c.y() + e.y(), 0);
      cylinder.points.emplace_back(c.x() + e.x(), c.y() + e.y(), height);
      bottom.loop.insert(bottom.loop.begin(), 2 * i);
      top.loop.push_back(2 * i + 1);
    }
    for (int i = 0; i < corners; ++i) {
      const int j = (i + 1) % corners;
      const Vec2 e = PlaneRotation(6.283185307179586 * (i + 0.5) / corners) * Vec2(1, 0);
      const Vec3 n(e.x(), e.y(), 0);
      cylinder.faces.push_back({{2 * i, 2 * j, 2 * j + 1, 2 * i + 1},
                                body_tag::wall,
                                {n, n.dot(cylinder.points[2 * i])}});
    }
    cylinder.faces.push_back(std::move(bottom));
    cylinder.faces.push_back(std::move(top));
    const int self = static_cast<int>(bodies.size());
    bodies.push_back({std::move(cylinder), {}, {}});
    std::vector<std::pair<double, int>> near;
    for (std::size_t i = 0; i < hull.size(); ++i) {
      if (model_.piece_of_tile[i] == anchor.piece) near.emplace_back(distance(hull[i], c), i);
    }
    std::sort(near.begin(), near.end());
    if (near.size() > 8) near.resize(8);
    for (const auto& [gap, tile] : near) {
      BridgeWish wish{tile, self, {}};
      Vec2 centre = Vec2::Zero();
      for (const Vec2& q : hull[tile]) centre += q / static_cast<double>(hull[tile].size());
      for (double s : {0.5, 0.3, 0.7, 0.15, 0.85}) {
        for (std::size_t e = 0; e < hull[tile].size(); ++e) {
          const Vec2 &a = hull[tile][e], &b = hull[tile][(e + 1) % hull[tile].size()];
          const Vec2 target = a + s * (b - a);
          if (wedge(b - a, c - a) >= 0 || (b - a).norm() < p().bridge_width) continue;
          const Vec2 d = (c - target).normalized();
          wish.sight.push_back({0.5 * (target + c - r * d), d});
        }
      }
      wishes.push_back(std::move(wish));
    }
  }

  // Two bridges hold an anchor; the rest would only have to be broken.
  static void keep_two_per_anchor(Bridges& bridges, int tile_count) {
    std::vector<int> held;
    Bridges kept;
    for (std::size_t k = 0; k < bridges.bodies.size(); ++k) {
      const int other = bridges.joined[k][1];
      if (other >= tile_count) {
        held.resize(std::max<std::size_t>(held.size(), other - tile_count + 1), 0);
        if (++held[other - tile_count] > 2) continue;
      }
      kept.bodies.push_back(std::move(bridges.bodies[k]));
      kept.joined.push_back(bridges.joined[k]);
    }
    bridges = std::move(kept);
  }

  void find_loose(const Bridges& bridges, int tile_count) {
    std::vector<int> root(tile_count + model_.anchors.size());
    std::iota(root.begin(), root.end(), 0);
    auto find = [&](int i) {
      while (root[i] != i) i = root[i] = root[root[i]];
      return i;
    };
    for (const auto& [a, b] : bridges.joined) root[find(a)] = find(b);
    std::vector<int> size(root.size(), 0), main(model_.piece_count, -1);
    for (int i = 0; i < tile_count; ++i) ++size[find(i)];
    for (int i = 0; i < tile_count; ++i) {
      int& best = main[model_.piece_of_tile[i]];
      if (best < 0 || size[find(i)] > size[best]) best = find(i);
    }
    for (int i = 0; i < tile_count; ++i) {
      if (find(i) != main[model_.piece_of_tile[i]]) model_.loose_tiles.push_back(i);
    }
    for (std::size_t k = 0; k < model_.anchors.size(); ++k) {
      if (find(tile_count + static_cast<int>(k)) != main[model_.anchors[k].piece]) {
        ++model_.loose_anchors;
      }
    }
  }

  void list_features() {
    for (int i = 0; i < tiles().tile_count(); ++i) {
      const TileFeatures f = tile_features(tiles(), model_.bumps.body[i], model_.bumps.of_tile[i],
                                           model_.q.row(i).data(), i);
      ThinFeature thin{model_.tiles[i].name, "front pin", f.front_pin};
      auto consider = [&](const char* what, double size) {
        if (size < thin.size) {
          thin.what = what;
          thin.size = size;
        }
      };
      consider("back pin", f.back_pin);
      consider("height of the pins", p().H_pin);
      consider("body", f.body);
      if (f.bump > 0) consider("bump", f.bump);
      model_.thin.push_back(std::move(thin));
    }
    for (const PrintBody& body : model_.supports) {
      if (p().support != "breakaway") break;
      const double notch = p().bridge_thickness - 2 * p().bridge_notch;
      model_.thin.push_back({body.name, "notch of the bridge", std::min(notch, p().bridge_width)});
    }
  }

  void centre() {
    for (auto* bodies : {&model_.tiles, &model_.supports, &model_.anchors}) {
      for (const PrintBody& body : *bodies) model_.box.add(bounding_box(body));
    }
    RigidMotion shift;
    shift.t = -0.5 * (model_.box.low + model_.box.high);
    shift.t.z() = 0;
    for (auto* bodies : {&model_.tiles, &model_.supports, &model_.anchors}) {
      for (PrintBody& body : *bodies) move(body, shift);
    }
    for (RigidMotion& motion : model_.flat) motion.t += shift.t;
    model_.box.low += shift.t;
    model_.box.high += shift.t;
  }

  PrintModel model_;
  std::string version_;
  std::vector<PieceFootprint> footprints_;
  std::vector<std::vector<int>> anchors_of_piece_;
  std::vector<Polygon> outer_;
};

}  // namespace

PrintModel make_print_model(const Design& design, const std::string& version) {
  return Builder(design, version).run();
}

std::vector<PrintBody> make_actuated_tiles(const PrintModel& model) {
  const TileMesh& tiles = model.geometry.tiles;
  std::vector<PrintBody> out(tiles.tile_count());
  parallel_ranges(tiles.tile_count(), [&](int begin, int end) {
    for (int i = begin; i < end; ++i) {
      out[i] = make_tile_print(tiles, tile_body(tiles, model.geometry.truncation, i), {},
                               model.q.row(i).data(), i, model.parameters.H_pin);
      out[i].piece = model.piece_of_tile[i];
      move(out[i], actuated_motion(tiles.frame[i]));
    }
  });
  return out;
}

}  // namespace curveups
