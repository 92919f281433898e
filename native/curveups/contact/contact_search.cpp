// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/contact/contact_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "curveups/contact/motion_energy.hpp"
#include "curveups/core/parallel.hpp"
#include "curveups/geometry/convex_polygon.hpp"
#include "curveups/geometry/overlapping_boxes.hpp"

namespace curveups {
namespace {

constexpr double none = std::numeric_limits<double>::infinity();
// Least area of an overlap that counts for its stiffness, over the smaller face: a body on its edge
// does not sink in.
constexpr double least_share = 0.01;
constexpr double beyond = 1e-3;  // mm: a tip this little outside of a face is on it

Eigen::Matrix<double, 3, 2> tangents_of(const Vec3& normal) {
  Eigen::Matrix<double, 3, 2> out;
  out.col(0) = normal.unitOrthogonal();
  out.col(1) = normal.cross(out.col(0));
  return out;
}

struct Separation {
  double distance = -none;
  int face = -1;
};

// Distance of all of `b` in front of a face of `a`.
double separation(const BodySurface& face, const RigidMotion& at_a, const RigidBody& b,
                  const RigidMotion& at_b) {
  const Vec3 normal = at_a.R * face.normal, own = at_b.R.transpose() * normal;
  const double base = normal.dot(at_b.t - at_a.t) - face.offset;
  double least = none;
  for (const BodySurface& other : b.faces) {
    for (const Vec3& p : other.outline) least = std::min(least, own.dot(p) + base);
  }
  return least;
}

// The face of `a` that has `b` furthest in front of it, or the first with more than `far`.
Separation best_face(const RigidBody& a, const RigidMotion& at_a, const RigidBody& b,
                     const RigidMotion& at_b, double far) {
  Separation best;
  for (std::size_t f = 0; f < a.faces.size(); ++f) {
    const double least = separation(a.faces[f], at_a, b, at_b);
    // The first of equal faces.
    if (least > best.distance + 1e-12) best = {least, static_cast<int>(f)};
    if (best.distance > far) break;
  }
  return best;
}

int opposite_face(const RigidBody& body, const RigidMotion& at, const Vec3& normal) {
  int best = -1;
  double least = -0.2;  // nearly edge-on: no face
  for (std::size_t f = 0; f < body.faces.size(); ++f) {
    const double cosine = normal.dot(at.R * body.faces[f].normal);
    if (cosine < least - 1e-12) {
      least = cosine;
      best = static_cast<int>(f);
    }
  }
  return best;
}

class PairSearch {
 public:
  PairSearch(const std::vector<RigidBody>& bodies, const Poses& poses, const SearchOptions& options,
             const std::array<int, 2>& pair)
      : bodies_(bodies), poses_(poses), options_(options), body_(pair) {}

  // Returns no touches where the two are too far apart.
  TouchingPair run(const TouchingPair* before) const {
    TouchingPair out{body_, {-1, -1}, {}};
    const std::array<Separation, 2> best = {best_face(of(0), at(0), of(1), at(1), options_.reach),
                                            best_face(of(1), at(1), of(0), at(0), options_.reach)};
    const int first = best[1].distance > best[0].distance + 1e-9 ? 1 : 0, second = 1 - first;
    if (best[first].distance > options_.reach) return out;
    if (before && still_part(*before, best[first].distance)) {
      out.face = before->face;
    } else {
      out.face[first] = best[first].face;
      const Vec3 normal = at(first).R * of(first).faces[out.face[first]].normal;
      out.face[second] = opposite_face(of(second), at(second), normal);
      if (out.face[second] < 0) return out;
    }
    if (before && before->face == out.face && good(*before)) return *before;

    const BodySurface& reference = of(first).faces[out.face[first]];
    const BodySurface& facing = of(second).faces[out.face[second]];
    take_tips(first, reference, facing, out);
    if (out.touches.empty()) clip_outlines(first, reference, facing, out);
    for (Touch& touch : out.touches) {
      touch.reference = touch.built = touch.tangents.transpose() * seen(touch);
      if (before) inherit(*before, touch);
    }
    return out;
  }

 private:
  const RigidBody& of(int k) const { return bodies_[body_[k]]; }
  const RigidMotion& at(int k) const { return poses_[body_[k]]; }
  Vec3 seen(const Touch& t) const { return seen_from(at(1 - t.of), at(t.of), t.point); }

  // True where corners still are where outlines cross.
  bool good(const TouchingPair& pair) const {
    for (const Touch& touch : pair.touches) {
      const Vec2 along = touch.tangents.transpose() * seen(touch) - touch.built;
      if (along.norm() > options_.keep) return false;
    }
    return !pair.touches.empty();
  }

  // True where the faces that touched part the bodies nearly as well as the best do.
  bool still_part(const TouchingPair& pair, double best) const {
    if (!(options_.face_margin > 0)) return false;
    for (int k = 0; k < 2; ++k) {
      if (separation(of(k).faces[pair.face[k]], at(k), of(1 - k), at(1 - k)) >
          best - options_.face_margin) {
        return true;
      }
    }
    return false;
  }

  void add(int who, const Vec3& point, const BodySurface& face, double stiffness,
           TouchingPair& out) const {
    Touch touch{who,
                point,
                face.normal,
                face.offset,
                tangents_of(face.normal),
                stiffness,
                tangent_ratio * stiffness};
    if (touch.gap(seen(touch)) <= options_.reach) out.touches.push_back(touch);
  }

  void clip_outlines(int first, const BodySurface& reference, const BodySurface& facing,
                     TouchingPair& out) const {
    const int second = 1 - first;
    const Eigen::Matrix<double, 3, 2> flat = tangents_of(reference.normal);
    Polygon own, other;
    for (const Vec3& p : reference.outline) own.push_back(flat.transpose() * p);
    for (const Vec3& p : facing.outline) {
      other.push_back(flat.transpose() * seen_from(at(first), at(second), p));
    }
    std::reverse(other.begin(), other.end());  // the other tile's loop runs backwards
    const Polygon common = intersection(own, other);
    if (common.size() < 3) return;
    const double shared = std::max(area(common), least_share * std::min(area(own), area(other)));
    const double whole = options_.pair_stiffness > 0
                             ? options_.pair_stiffness
                             : reference.stiffness * facing.stiffness /
                                   (reference.stiffness + facing.stiffness) * shared;
    const double stiffness = whole / (2.0 * static_cast<double>(common.size()));
    // The facing plane in the reference's coordinates.
    const Eigen::Matrix3d R = at(first).R.transpose() * at(second).R;
    const Vec3 normal = R * facing.normal;
    const double offset =
        facing.offset + normal.dot(at(first).R.transpose() * (at(second).t - at(first).t));
    for (const Vec2& corner : common) {
      const Vec3 on_reference = flat * corner + reference.offset * reference.normal;
      const Vec3 on_facing = on_reference + (offset - normal.dot(on_reference)) /
                                                normal.dot(reference.normal) * reference.normal;
      add(second, seen_from(at(second), at(first), on_facing), reference, stiffness, out);
      add(first, on_reference, facing, stiffness, out);
    }
  }

  void take_tips(int first, const BodySurface& reference, const BodySurface& facing,
                 TouchingPair& out) const {
    const std::array<const BodySurface*, 2> face = {&reference, &facing};
    for (int k = 0; k < 2; ++k) {
      const int who = k == 0 ? first : 1 - first;
      const BodySurface& on = *face[1 - k];
      const Eigen::Matrix<double, 3, 2> flat = tangents_of(on.normal);
      Polygon outline;
      for (const Vec3& p : on.outline) outline.push_back(flat.transpose() * p);
      for (const Vec3& tip : face[k]->tips) {
        const Vec2 place = flat.transpose() * seen_from(at(1 - who), at(who), tip);
        if (distance(outline, place) <= beyond) add(who, tip, on, face[k]->tip_stiffness, out);
      }
    }
  }

  // Takes friction's history from the nearest point on the same faces, as a force.
  void inherit(const TouchingPair& before, Touch& touch) const {
    const Touch* nearest = nullptr;
    double least = none;
    for (const Touch& old : before.touches) {
      if (old.of != touch.of || old.normal != touch.normal) continue;
      const double d = (old.point - touch.point).squaredNorm();
      if (d < least) {
        least = d;
        nearest = &old;
      }
    }
    if (!nearest) return;
    touch.stretch = nearest->stretch * (nearest->tangent_stiffness / touch.tangent_stiffness);
    touch.cap = nearest->cap;
    touch.slip = nearest->slip;
  }

  const std::vector<RigidBody>& bodies_;
  const Poses& poses_;
  const SearchOptions& options_;
  std::array<int, 2> body_;
};

}  // namespace

std::vector<TouchingPair> find_touching(const std::vector<RigidBody>& bodies, const Poses& poses,
                                        const SearchOptions& options,
                                        const std::vector<TouchingPair>& before) {
  std::vector<int> solid;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (!bodies[i].is_point()) solid.push_back(static_cast<int>(i));
  }
  std::vector<Eigen::AlignedBox3d> boxes(solid.size());
  parallel_for(static_cast<int>(solid.size()), [&](int k) {
    for (const BodySurface& face : bodies[solid[k]].faces) {
      for (const Vec3& p : face.outline) boxes[k].extend(poses[solid[k]](p));
    }
    boxes[k] = grown(boxes[k], 0.5 * options.reach);
  });
  std::vector<std::array<int, 2>> near;
  for (const auto& [k, l] : overlapping_boxes(boxes)) {
    if (bodies[solid[k]].can_touch(bodies[solid[l]])) near.push_back({solid[k], solid[l]});
  }
  std::vector<TouchingPair> pairs(near.size());
  parallel_for(static_cast<int>(near.size()), [&](int k) {
    const auto old = std::lower_bound(
        before.begin(), before.end(), near[k],
        [](const TouchingPair& pair, const std::array<int, 2>& body) { return pair.body < body; });
    const bool known = old != before.end() && old->body == near[k];
    pairs[k] = PairSearch(bodies, poses, options, near[k]).run(known ? &*old : nullptr);
  });
  std::vector<TouchingPair> out;
  for (TouchingPair& pair : pairs) {
    if (!pair.touches.empty()) out.push_back(std::move(pair));
  }
  return out;
}

}  // namespace curveups
