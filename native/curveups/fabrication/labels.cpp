// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/fabrication/labels.hpp"

#include <algorithm>
#include <cmath>

#include "curveups/core/checkpoint.hpp"
#include "curveups/design/print_margin.hpp"
#include "curveups/fabrication/print_parts.hpp"

namespace curveups {
namespace {

constexpr int corners = 64;        // of an anchor's circle as chords
constexpr double text_rim = 1.0;   // between letters and the edge of the tab, mm
constexpr double tab_gap = 1.0;    // between tab and other anchors, mm: a wall that slabs can have
constexpr double neck_part = 1.0;  // width of the neck between anchor and tab, of the radius

struct Bounds {
  Vec2 low = Vec2::Constant(1e300), high = Vec2::Constant(-1e300);
  void add(const Vec2& p, double reach = 0) {
    low = low.cwiseMin(p - Vec2::Constant(reach));
    high = high.cwiseMax(p + Vec2::Constant(reach));
  }
  void add(const Polygon& polygon) {
    for (const Vec2& p : polygon) add(p);
  }
};

// Whether two convex polygons come nearer to one another than that.
bool nearer(const Polygon& a, const Polygon& b, double than) {
  Bounds of_a, of_b;
  of_a.add(a);
  of_b.add(b);
  const Vec2 between = (of_a.low - of_b.high).cwiseMax(of_b.low - of_a.high);
  if (between.maxCoeff() > than) return false;
  return intersection(a, b).size() >= 3 || least_distance(a, b) < than;
}

// A tab that leaves the anchor in direction u (along an axis).
struct Candidate {
  int anchor;
  Vec2 middle, u;
  Polygon plate, neck;
  long growth;  // of half the perimeter of the box around everything, thousandths of mm
};

Polygon rectangle(const Vec2& a, const Vec2& b) {
  const Vec2 low = a.cwiseMin(b), high = a.cwiseMax(b);
  return {low, Vec2(high.x(), low.y()), high, Vec2(low.x(), high.y())};
}

// u: where the tab leaves the anchor; shift: of the tab aside, along left_of(u).
Candidate make_candidate(int anchor, const Vec2& c, double radius, const Vec2& size, const Vec2& u,
                         int shift) {
  Candidate out{anchor, {}, u, {}, {}, 0};
  const Vec2 half = 0.5 * size + Vec2::Constant(text_rim), side = left_of(u);
  const double neck = 0.5 * neck_part * radius, near = radius + tab_gap;
  const double along = std::abs(half.dot(u)), aside = std::abs(half.dot(side));
  out.middle = c + (near + along) * u + shift * std::max(0.0, aside - neck) * side;
  out.plate = rectangle(out.middle - half, out.middle + half);
  out.neck = rectangle(c - neck * side, c + near * u + neck * side);
  return out;
}

bool is_free(const std::vector<PieceFootprint>& pieces, int piece, const Candidate& candidate,
             const Parameters& p) {
  const double slabs = p.support == "none" ? 0 : p.support_margin;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const bool own = static_cast<int>(i) == piece;
    const double from_tiles = own ? p.anchor_distance : print_margin(p) + slabs;
    for (const Polygon& tile : pieces[i].tiles) {
      if (nearer(tile, candidate.plate, from_tiles)) return false;
      if (own && nearer(tile, candidate.neck, from_tiles - 1e-3)) return false;
    }
    for (std::size_t k = 0; k < pieces[i].anchors.size(); ++k) {
      if (own && static_cast<int>(k) == candidate.anchor) continue;
      const Vec2& c = pieces[i].anchors[k];
      const double gap = own ? tab_gap : 2 * slabs + p.d_gap_min;
      for (const Polygon* part : {&candidate.plate, &candidate.neck}) {
        if (distance(*part, c) < p.anchor_radius + gap - 1e-9) return false;
      }
    }
    for (const Polygon& tab : pieces[i].tab) {
      if (nearer(tab, candidate.plate, 2 * slabs + p.d_gap_min)) return false;
    }
  }
  return true;
}

// Round the anchor from where its circle leaves the neck to where it meets it again.
Polygon circle_but_neck(const Vec2& c, double radius, const Vec2& u) {
  const double half = 0.5 * neck_part * radius, open = std::asin(half / radius);
  Polygon arc;
  for (int k = 0; k <= corners; ++k) {
    const double angle = open + k * (2 * M_PI - 2 * open) / corners;
    arc.push_back(c + radius * (std::cos(angle) * u + std::sin(angle) * left_of(u)));
  }
  return arc;
}

// Circle, neck and tab as one outline: it begins where the circle leaves the neck.
Polygon outline_of_label(const Candidate& candidate, const Vec2& c, double radius) {
  Polygon outline = circle_but_neck(c, radius, candidate.u);
  const Vec2 u = candidate.u, side = left_of(u);
  const double half = 0.5 * neck_part * radius, near = radius + tab_gap;
  // The tab in the frame of u, from the right of the neck round to its left.
  Bounds plate;
  for (const Vec2& p : candidate.plate) plate.add(Vec2(u.dot(p - c), side.dot(p - c)));
  const double low = plate.low.y(), high = plate.high.y(), far = plate.high.x();
  const auto at = [&](double along, double aside) -> Vec2 { return c + along * u + aside * side; };
  if (low < -half - 1e-9) outline.push_back(at(near, -half));
  for (const Vec2& p : {at(near, low), at(far, low), at(far, high), at(near, high)}) {
    outline.push_back(p);
  }
  if (high > half + 1e-9) outline.push_back(at(near, half));
  return outline;
}

std::vector<int> add_points(PrintBody& body, const Polygon& polygon, const Vec2& offset, double z) {
  std::vector<int> loop;
  for (const Vec2& p : polygon) {
    loop.push_back(static_cast<int>(body.points.size()));
    body.points.emplace_back(offset.x() + p.x(), offset.y() + p.y(), z);
  }
  return loop;
}

PlanarFace level_face(std::vector<int> loop, bool up) {
  PlanarFace face;
  face.normal = up ? Vec3(Vec3::UnitZ()) : Vec3(-Vec3::UnitZ());
  face.outer.points = std::move(loop);
  return face;
}

// Sinks one region of the text into the face `top`, about `middle`.
void sink(PrintBody& body, PlanarFace& top, const TextRegion& region, const Vec2& middle, double z,
          double depth) {
  const Vec3 down(0, 0, -depth);
  const std::vector<int> rim = add_points(body, region.outer, middle, z);
  BodyLoop opening;
  opening.points.assign(rim.rbegin(), rim.rend());
  top.inner.push_back(std::move(opening));
  // The pocket's walls look inwards: its rim is walked as the hole of the top face.
  PlanarFace floor = level_face(extrude(body, rim, down, FaceRole::plain), true);
  for (const Polygon& hole : region.holes) {
    const std::vector<int> edge = add_points(body, hole, middle, z);  // clockwise
    BodyLoop foot;
    foot.points = extrude(body, edge, down, FaceRole::plain);
    floor.inner.push_back(std::move(foot));
    body.faces.push_back(level_face({edge.rbegin(), edge.rend()}, true));
  }
  body.faces.push_back(std::move(floor));
}

}  // namespace

std::optional<LabelPlace> place_label(std::vector<PieceFootprint>& pieces, int piece,
                                      const Vec2& text_size, const Parameters& p) {
  Bounds box;
  for (const PieceFootprint& other : pieces) {
    for (const Polygon& tile : other.tiles) box.add(tile);
    for (const Vec2& anchor : other.anchors) box.add(anchor, p.anchor_radius);
    for (const Polygon& tab : other.tab) box.add(tab);
  }
  PieceFootprint& own = pieces[piece];
  std::vector<Candidate> candidates;
  for (std::size_t k = 0; k < own.anchors.size(); ++k) {
    for (const Vec2& u : {Vec2(0, -1), Vec2(0, 1), Vec2(-1, 0), Vec2(1, 0)}) {
      for (int shift : {0, -1, 1}) {
        Candidate candidate = make_candidate(static_cast<int>(k), own.anchors[k], p.anchor_radius,
                                             text_size, u, shift);
        Bounds with = box;
        with.add(candidate.plate);
        candidate.growth = std::lround(1e3 * (with.high - with.low - box.high + box.low).sum());
        candidates.push_back(std::move(candidate));
      }
    }
  }
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Candidate& a, const Candidate& b) { return a.growth < b.growth; });
  for (const Candidate& candidate : candidates) {
    checkpoint();
    if (!is_free(pieces, piece, candidate, p)) continue;
    const Vec2& centre = own.anchors[candidate.anchor];
    own.labelled = candidate.anchor;
    own.tab = {candidate.plate, candidate.neck};
    own.outline = outline_of_label(candidate, centre, p.anchor_radius);
    return LabelPlace{centre, candidate.middle, own.outline};
  }
  return std::nullopt;
}

LabelPlace turned_over(const LabelPlace& place) {
  LabelPlace out = place;
  out.centre.y() *= -1;
  out.middle.y() *= -1;
  for (Vec2& p : out.outline) p.y() *= -1;
  const auto tab = out.outline.begin() + corners + 1;
  std::reverse(out.outline.begin(), tab);
  std::reverse(tab, out.outline.end());
  return out;
}

PrintBody make_labelled_anchor(const LabelPlace& place, double height, double tab_height,
                               const EngravedText& text, double depth) {
  PrintBody body;
  body.kind = BodyKind::anchor;
  const std::vector<int> base = add_points(body, place.outline, Vec2::Zero(), 0);
  body.faces.push_back(level_face({base.rbegin(), base.rend()}, false));
  const std::vector<int> rim = extrude(body, base, Vec3(0, 0, tab_height), FaceRole::plain);
  // The circle's part of the rim, closed by chords across the neck.
  std::vector<int> circle(rim.begin(), rim.begin() + corners + 1);
  const Vec2 from = place.outline[corners] - place.centre, to = place.outline[0] - place.centre;
  const double open = std::acos(std::clamp(from.dot(to) / from.squaredNorm(), -1.0, 1.0));
  const int steps = std::max(2, static_cast<int>(std::lround(open * corners / (2 * M_PI))));
  Polygon across;
  for (int k = 1; k < steps; ++k) {
    across.push_back(PlaneRotation(k * open / steps) * from);
  }
  const std::vector<int> chords = add_points(body, across, place.centre, tab_height);
  circle.insert(circle.end(), chords.begin(), chords.end());
  std::vector<int> shelf(rim.begin() + corners, rim.end());
  shelf.push_back(rim[0]);
  shelf.insert(shelf.end(), chords.rbegin(), chords.rend());
  PlanarFace tab = level_face(std::move(shelf), true);
  for (const TextRegion& region : text.regions) {
    sink(body, tab, region, place.middle, tab_height, depth);
  }
  body.faces.push_back(std::move(tab));
  body.faces.push_back(
      level_face(extrude(body, circle, Vec3(0, 0, height - tab_height), FaceRole::plain), true));
  return body;
}

}  // namespace curveups
