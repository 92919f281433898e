// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/fabrication/print_model.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <set>

#include "curveups/bodies/anchors.hpp"
#include "curveups/bodies/tile_print.hpp"
#include "curveups/core/checkpoint.hpp"
#include "curveups/core/errors.hpp"
#include "curveups/core/parallel.hpp"
#include "curveups/core/tolerances.hpp"
#include "curveups/design/pins.hpp"
#include "curveups/design/print_constants.hpp"
#include "curveups/fabrication/supports.hpp"
#include "curveups/geometry/cut_mesh.hpp"

namespace curveups {
namespace {

constexpr double widest_print = 1e4;  // mm: anchors and slabs of wider ones would take hours

// Turns the print over about the x axis, between the bed and its height.
RigidMotion turned_over(double height) {
  RigidMotion motion;
  motion.R = Vec3(1, -1, -1).asDiagonal();
  motion.t = Vec3(0, 0, height);
  return motion;
}

class Builder {
 public:
  Builder(const Design& design, const Division& division) : kind_(support_kind(design.parameters)) {
    model_.division = division;
    static_cast<TileBodies&>(model_) = make_tile_bodies(design);
    model_.name = design.name;
  }

  PrintModel run() {
    checkpoint("building tiles", 0.1);
    const int count = tiles().tile_count();
    model_.piece_of_tile = pieces_of_faces(tiles().topology, tiles().cut);
    model_.piece_count =
        1 + *std::max_element(model_.piece_of_tile.begin(), model_.piece_of_tile.end());
    for (int i = 0; i < count; ++i) {
      model_.flat.push_back(flat_motion(model_.poses, i, p().H_pin + p().H_body));
    }
    make_tiles();
    footprints_.resize(model_.piece_count);
    for (int i = 0; i < count; ++i) {
      checkpoint();
      std::vector<Vec2> seen;
      for (const Vec3& q : model_.tiles[i].points) seen.push_back(q.head<2>());
      PieceFootprint& footprint = footprints_[model_.piece_of_tile[i]];
      footprint.tiles.push_back(convex_hull(seen));
      footprint.rows.push_back(i);
    }
    join_footprints(footprints_, model_.piece_of_tile, tiles(), model_.poses);
    checkpoint("placing anchors", 0.3);
    if (p().anchors) add_anchors();
    checkpoint("building the support", 0.4);
    number_parts();
    if (kind_.add) kind_.add(model_, footprints_);
    const std::vector<int>& part = model_.division.part_of_tile;
    if (!part.empty()) model_.piece_count = *std::max_element(part.begin(), part.end()) + 1;
    bore_joints();
    checkpoint("measuring bodies", 0.9);
    list_features();
    if (front_down()) {
      const RigidMotion turn = turned_over(height());
      for (auto* bodies : printed()) {
        for (PrintBody& body : *bodies) move(body, turn);
      }
      for (RigidMotion& motion : model_.flat) motion = {turn.R * motion.R, turn(motion.t)};
    }
    centre();
    add_actuated();
    return std::move(model_);
  }

 private:
  const Parameters& p() const { return model_.parameters; }
  const TileMesh& tiles() const { return model_.geometry.tiles; }
  bool front_down() const { return p().orientation == "front-down"; }
  double height() const { return 2 * p().H_pin + p().H_body; }
  std::array<std::vector<PrintBody>*, 3> printed() {
    return {&model_.tiles, &model_.supports, &model_.anchors};
  }

  void make_tiles() {
    model_.tiles.resize(tiles().tile_count());
    parallel_for(tiles().tile_count(), [&](int i) {
      PrintBody& tile = model_.tiles[i];
      tile = make_tile_print(tiles(), model_.bumps.body[i], model_.bumps.of_tile[i],
                             model_.q.row(i).data(), i, p().H_pin);
      tile.piece = model_.piece_of_tile[i];
      move(tile, model_.flat[i]);
    });
  }

  void number_parts() {
    const std::vector<int>& part = model_.division.part_of_tile;
    if (part.empty()) return;
    for (PrintBody& tile : model_.tiles) tile.piece = part[tile.tile];
    std::size_t k = 0;
    for (const PieceFootprint& footprint : footprints_) {
      for (const Vec2& anchor : footprint.anchors) {
        model_.anchors[k++].piece = part[nearest_tile(footprint, anchor)];
      }
    }
  }

  void add_anchors() {
    auto centres = place_anchors(footprints_, p());
    const Polygon room = inset(model_.division.region, p().anchor_radius + 0.5 * support_margin);
    for (auto& of_piece : centres) {
      if (model_.division.region.empty()) break;
      of_piece.erase(std::remove_if(of_piece.begin(), of_piece.end(),
                                    [&](const Vec2& c) { return !contains(room, c); }),
                     of_piece.end());
    }
    for (int piece = 0; piece < model_.piece_count; ++piece) {
      footprints_[piece].anchors = centres[piece];
    }
    for (int piece = 0; piece < model_.piece_count; ++piece) {
      checkpoint();
      for (std::size_t k = 0; k < centres[piece].size(); ++k) {
        PrintBody anchor = make_anchor(centres[piece][k], p().anchor_radius, height());
        anchor.name = numbered("Anchor P%d A%03d", piece + 1, static_cast<int>(k) + 1);
        anchor.piece = piece;
        model_.anchors.push_back(std::move(anchor));
      }
    }
  }

  // After the support, which must not fill the holes.
  void bore_joints() {
    model_.joints = plan_joint_holes(model_.geometry, model_.bumps, model_.q, p());
    for (int i = 0; i < tiles().tile_count(); ++i) {
      bore(model_.tiles[i], model_.joints.of_tile[i], model_.joints.radius, tiles().H_body,
           model_.flat[i]);
    }
  }

  // Distance from the pin on the bed to the farthest corner of the face above it.
  double overhang(int tile) const {
    const Side bed = front_down() ? Side::front : Side::back;
    const auto corners = pin_corners(tiles(), tile, bed, model_.q.row(tile).data());
    const Polygon pin(corners.begin(), corners.end());
    const ConvexBody& body = model_.bumps.body[tile];
    double reach = 0;
    for (const BodyFace& face : body.faces) {
      if (face.tag != (front_down() ? body_tag::front : body_tag::back)) continue;
      for (int i : face.loop) reach = std::max(reach, distance(pin, body.points[i].head<2>()));
    }
    return reach;
  }

  void list_features() {
    for (int i = 0; i < tiles().tile_count(); ++i) {
      checkpoint();
      model_.overhang.push_back(overhang(i));
      const TileFeatures f = tile_features(tiles(), model_.bumps.body[i], model_.bumps.of_tile[i],
                                           model_.q.row(i).data(), i);
      ThinFeature thin{model_.tiles[i].name, "front pin", f.front_pin, i};
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
      consider("material beside a dimple", f.hollow_wall);
      if (!model_.joints.of_tile[i].empty()) {
        consider("joint hole", joint_hole);
        consider("wall beside the joint hole", p().p_floor);
      }
      model_.thin.push_back(std::move(thin));
    }
    if (!kind_.narrowest) return;
    ThinFeature narrowest = kind_.narrowest(p());
    for (const PrintBody& body : model_.supports) {
      narrowest.body = body.name;
      model_.thin.push_back(narrowest);
    }
  }

  void centre() {
    for (auto* bodies : printed()) {
      for (const PrintBody& body : *bodies) model_.box.extend(bounding_box(body));
    }
    RigidMotion shift;
    shift.t = -0.5 * (model_.box.min() + model_.box.max());
    shift.t.z() = 0;
    for (auto* bodies : printed()) {
      for (PrintBody& body : *bodies) move(body, shift);
    }
    for (RigidMotion& motion : model_.flat) motion.t += shift.t;
    for (auto& outline : model_.outlines) {  // soluble slabs have their front side up
      for (Polygon& loop : outline) {
        for (Vec2& q : loop) q += shift.t.head<2>();
      }
    }
    model_.box.translate(shift.t);
  }

  void add_actuated() {
    model_.actuated.resize(tiles().tile_count());
    parallel_for(tiles().tile_count(), [&](int i) {
      PrintBody& body = model_.actuated[i];
      body = make_tile_print(tiles(), tile_body(tiles(), model_.geometry.truncation, i), {},
                             model_.q.row(i).data(), i, p().H_pin);
      body.piece = model_.piece_of_tile[i];
      bore(body, model_.joints.of_tile[i], model_.joints.radius, tiles().H_body, {});
      move(body, tiles().frame[i]);
    });
  }

  PrintModel model_;
  SupportKind kind_;
  std::vector<PieceFootprint> footprints_;
};

}  // namespace

std::string numbered(const char* format, int a, int b) {
  char name[48];
  std::snprintf(name, sizeof name, format, a, b);
  return name;
}

PrintModel make_print_model(const Design& design, const Division& division) {
  if (!division.part_of_tile.empty()) {
    if (division.part_of_tile.size() != static_cast<std::size_t>(design.T.rows()) ||
        *std::min_element(division.part_of_tile.begin(), division.part_of_tile.end()) < 0 ||
        *std::max_element(division.part_of_tile.begin(), division.part_of_tile.end()) >=
            design.T.rows()) {
      throw InvalidInput("parts of another number of tiles", "give each tile its part, from 0 on");
    }
  }
  if (!(division.opening >= 0 && division.opening < 10)) {
    throw InvalidInput("an opening between parts that is none", "give 0 to 10 mm");
  }
  for (const Vec2& corner : division.region) {
    if (!(corner.cwiseAbs().maxCoeff() < widest_print && area(division.region) > 0)) {
      throw InvalidInput("a region that is none, or has a corner beyond 10 m",
                         "give its corners counter-clockwise, in mm");
    }
  }
  const Eigen::Map<const Points2> corners(design.T.data(), 3 * design.T.rows(), 2);
  const double width = (corners.colwise().maxCoeff() - corners.colwise().minCoeff()).maxCoeff();
  if (!(width < widest_print)) {
    throw InfeasibleDesign(
        "the layout is " + std::to_string(static_cast<long long>(width / 1000)) + " m wide",
        "bring tiles that lie far away back to the others");
  }
  return Builder(design, division).run();
}

PrintModel only_pieces(const PrintModel& model, const std::map<int, RigidMotion>& motions) {
  if (motions.empty() || motions.begin()->first < 0 ||
      motions.rbegin()->first >= model.piece_count) {
    throw InvalidInput("pieces that are not in the print",
                       "give some of 0 to " + std::to_string(model.piece_count - 1));
  }
  for (const auto& [piece, motion] : motions) {
    if (!(motion.t.cwiseAbs().maxCoeff() < widest_print && motion.R.allFinite())) {
      throw InvalidInput("a place beyond 10 m", "give places in mm");
    }
  }
  PrintModel out = model;
  out.box.setEmpty();
  for (auto* bodies : {&out.tiles, &out.supports, &out.anchors}) {
    bodies->erase(std::remove_if(bodies->begin(), bodies->end(),
                                 [&](const PrintBody& b) { return !motions.count(b.piece); }),
                  bodies->end());
    for (PrintBody& body : *bodies) {
      move(body, motions.at(body.piece));
      body.piece = static_cast<int>(std::distance(motions.begin(), motions.find(body.piece)));
      out.box.extend(bounding_box(body));
    }
  }
  out.piece_count = static_cast<int>(motions.size());
  return out;
}

PrintModel only_tiles(const PrintModel& model, const std::vector<int>& rows) {
  PrintModel out = model;
  out.supports.clear();
  out.anchors.clear();
  out.loose_anchors = 0;
  out.tiles.clear();
  out.box.setEmpty();
  for (const int row : std::set<int>(rows.begin(), rows.end())) {
    out.tiles.push_back(model.tiles[row]);
    out.box.extend(bounding_box(out.tiles.back()));
  }
  return out;
}

PrintModel move_actuated(const PrintModel& model, const std::vector<RigidMotion>& motions) {
  PrintModel out = model;
  for (std::size_t i = 0; i < motions.size(); ++i) move(out.actuated[i], motions[i]);
  return out;
}

GluedAreas glued_areas(const PrintModel& model, Side side) {
  const Parameters& p = model.parameters;
  const bool up = (side == Side::front) == (p.orientation == "front-up");
  const double z = up ? 2 * p.H_pin + p.H_body : 0;
  const auto in_plane = [&](const std::vector<PrintBody>& bodies) {
    double sum = 0;
    for (const PrintBody& body : bodies) {
      for (const PlanarFace& face : body.faces) {
        const BodyLoop& loop = face.outer;
        const double at = loop.circle < 0 ? body.points[loop.points[0]].z()
                                          : body.circles[loop.circle].centre.z();
        if (std::abs(at - z) > tolerance::snap || face.normal.z() * (up ? 1 : -1) < 0.5) continue;
        sum += face_area(body, face);
      }
    }
    return sum;
  };
  return {in_plane(model.tiles), in_plane(model.anchors), in_plane(model.supports)};
}

std::vector<const PrintBody*> PrintModel::bodies(const std::string& kind) const {
  std::vector<const PrintBody*> out;
  const auto append = [&](const char* own, const std::vector<PrintBody>& from) {
    if (kind != own && (kind != "print" || &from == &actuated)) return;
    for (const PrintBody& body : from) out.push_back(&body);
  };
  append("tiles", tiles);
  append("support", supports);
  append("anchors", anchors);
  append("actuated", actuated);
  if (out.empty() && kind != "support" && kind != "anchors") {
    throw InvalidInput("there are no bodies of the kind '" + kind + "'",
                       "give tiles, support, anchors, print or actuated");
  }
  return out;
}

double PrintModel::volume(const std::string& kind) const {
  double sum = 0;
  for (const PrintBody* body : bodies(kind)) sum += curveups::volume(*body);
  return sum;
}

}  // namespace curveups
