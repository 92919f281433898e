// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/fabrication/print_model.hpp"

#include <algorithm>

#include "curveups/bodies/tile_print.hpp"
#include "curveups/core/checkpoint.hpp"
#include "curveups/core/errors.hpp"
#include "curveups/core/parallel.hpp"
#include "curveups/fabrication/anchors.hpp"
#include "curveups/fabrication/bridges.hpp"
#include "curveups/fabrication/print_parts.hpp"
#include "curveups/fabrication/supports.hpp"

namespace curveups {
namespace {

constexpr double widest_print = 1e4;  // mm; anchors and slabs of wider ones would be endless work

constexpr double engraving_stroke = 0.3;  // the least that printers show, mm
constexpr double engraving_rim = 0.3;     // between letters and the edge of the anchor, mm

class Builder {
 public:
  Builder(const Design& design, std::string version) : version_(std::move(version)) {
    static_cast<TileBodies&>(model_) = make_tile_bodies(design);
    model_.name = design.name;
  }

  PrintModel run() {
    checkpoint("building tiles", 0.1);
    const int count = tiles().tile_count();
    find_pieces();
    for (int i = 0; i < count; ++i) {
      model_.flat.push_back(flat_motion(model_.poses, i, p().H_pin + p().H_body));
    }
    model_.tiles = flat_tiles(model_, model_.bumps.body, model_.bumps.of_tile);
    footprints_.resize(model_.piece_count);
    for (int i = 0; i < count; ++i) {
      checkpoint();
      std::vector<Vec2> seen;
      for (const Vec3& q : model_.tiles[i].points) seen.push_back(q.head<2>());
      footprints_[model_.piece_of_tile[i]].tiles.push_back(convex_hull(seen));
    }
    join_footprints();
    checkpoint("placing anchors", 0.3);
    if (p().anchors) add_anchors();
    checkpoint("building the support", 0.4);
    add_support(model_, footprints_);
    checkpoint("measuring bodies", 0.9);
    list_features();
    centre();
    add_actuated();
    return std::move(model_);
  }

 private:
  const Parameters& p() const { return model_.parameters; }
  const TileMesh& tiles() const { return model_.geometry.tiles; }

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

  void join_footprints() {
    for (const Contact& contact : tiles().contacts) {
      const auto a = front_edge(model_, contact, 0), b = front_edge(model_, contact, 1);
      const Polygon hull = convex_hull({a[0], a[1], b[0], b[1]});
      if (hull.size() >= 3) {
        footprints_[model_.piece_of_tile[contact.tile[0]]].joints.push_back(hull);
      }
    }
  }

  void add_anchors() {
    const auto centres = place_anchors(footprints_, p());
    const double height = 2 * p().H_pin + p().H_body;
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
        model_.anchors.push_back(std::move(anchor));
      }
    }
  }

  void list_features() {
    for (int i = 0; i < tiles().tile_count(); ++i) {
      checkpoint();
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
    if (p().support != "breakaway") return;
    const double neck = std::min(bridge_neck(p()), p().bridge_width);
    for (const PrintBody& bridge : model_.supports) {
      model_.thin.push_back({bridge.name, "notch of the bridge", neck});
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

  void add_actuated() {
    model_.actuated.resize(tiles().tile_count());
    parallel_ranges(tiles().tile_count(), [&](int begin, int end) {
      for (int i = begin; i < end; ++i) {
        PrintBody& body = model_.actuated[i];
        body = make_tile_print(tiles(), tile_body(tiles(), model_.geometry.truncation, i), {},
                               model_.q.row(i).data(), i, p().H_pin);
        body.piece = model_.piece_of_tile[i];
        move(body, actuated_motion(tiles().frame[i]));
      }
    });
  }

  PrintModel model_;
  std::string version_;
  std::vector<PieceFootprint> footprints_;
};

}  // namespace

PrintModel make_print_model(const Design& design, const std::string& version) {
  const Eigen::Map<const Points2> corners(design.T.data(), 3 * design.T.rows(), 2);
  const double width = (corners.colwise().maxCoeff() - corners.colwise().minCoeff()).maxCoeff();
  if (!(width < widest_print)) {
    throw InfeasibleDesign(
        "the layout is " + std::to_string(static_cast<long long>(width / 1000)) + " m wide",
        "bring tiles that lie far away back to the others");
  }
  return Builder(design, version).run();
}

std::vector<const PrintBody*> PrintModel::bodies(const std::string& kind) const {
  std::vector<const PrintBody*> out;
  const auto append = [&](const char* one, const std::vector<PrintBody>& from) {
    if (kind != one && (kind != "print" || &from == &actuated)) return;
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
