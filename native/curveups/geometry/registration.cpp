// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/geometry/registration.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <utility>
#include <vector>

#include "curveups/core/checkpoint.hpp"
#include "curveups/core/parallel.hpp"
#include "curveups/geometry/closest_points.hpp"

namespace curveups {
namespace {

constexpr double tukey = 4.685;     // times the noise: 95 % efficiency for normal noise
constexpr double alike = 3;         // standard errors by which mean losses of equal poses differ
constexpr double contrast = 4;      // times the least loss, with which a pose is dropped
constexpr int first_turns = 900;    // rotations some 25 degrees apart
constexpr int jittered_turns = 40;  // around each pose that remains
constexpr int marker_rounds = 10;   // of the noise and the pose that follows from it
constexpr int marker_steps = 10;    // of a round
constexpr double singular = 1e-14;  // ratio of eigenvalues below which a direction is free
constexpr double pi = 3.14159265358979323846;

// Scanned points are relative to their middle: x -> turn x + shift.
struct Pose {
  Eigen::Quaterniond turn;
  Vec3 shift;
  Vec3 operator()(const Vec3& x) const { return turn * x + shift; }
};

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// Standard deviation of normal noise along a normal, from absolute values.
double noise_of(const std::vector<double>& distances) { return 1.4826 * median(distances) + 1e-9; }

// Normal equations of a Gauss-Newton step: a turn about the surface's axes and a shift, in mm.
// Residuals have the weights of Tukey's loss.
class PoseStep {
 public:
  PoseStep(const Pose& pose, double loss_scale) : pose_(pose), loss_scale_(loss_scale) {}

  // Distances of a scanned point from a place, along each of these directions.
  template <int Count>
  void add(const Vec3& point, const Vec3& place,
           const Eigen::Matrix<double, Count, 3>& directions) {
    const Vec3 arm = pose_.turn * point;
    const Eigen::Matrix<double, Count, 1> residual = directions * (arm + pose_.shift - place);
    const double inside = 1 - residual.squaredNorm() / (loss_scale_ * loss_scale_);
    if (inside <= 0) return;
    Eigen::Matrix<double, Count, 6> rows;
    for (int k = 0; k < Count; ++k) {
      const Vec3 direction = directions.row(k);
      rows.row(k) << arm.cross(direction).transpose(), direction.transpose();
    }
    matrix_ += inside * inside * rows.transpose() * rows;
    gradient_ += inside * inside * rows.transpose() * residual;
  }

  Pose taken() const {
    // Directions that the points leave free stay.
    Matrix damped = matrix_;
    damped.diagonal() = 1.0001 * damped.diagonal().cwiseMax(1e-6);
    const Vector step = damped.ldlt().solve(-gradient_);
    const Vec3 turn = step.head<3>();
    return {(Eigen::AngleAxisd(turn.norm(), turn.normalized()) * pose_.turn).normalized(),
            pose_.shift + step.tail<3>()};
  }

  // Fills in noise and deviations of a registration, for this noise of a residual.
  void describe(double noise, Registration& out) const {
    out.noise = noise;
    const Eigen::SelfAdjointEigenSolver<Matrix> eigen(matrix_);
    const Vector& values = eigen.eigenvalues();
    Vector deviation = Vector::Constant(std::numeric_limits<double>::quiet_NaN());
    if (values[0] > singular * values[5]) {
      const Vector inverse = values.cwiseInverse();
      deviation = noise * (eigen.eigenvectors().cwiseAbs2() * inverse).cwiseSqrt();
    }
    out.rotation_deviation = deviation.head<3>();
    out.translation_deviation = deviation.tail<3>();
  }

 private:
  using Matrix = Eigen::Matrix<double, 6, 6>;
  using Vector = Eigen::Matrix<double, 6, 1>;

  Pose pose_;
  double loss_scale_;
  Matrix matrix_ = Matrix::Zero();
  Vector gradient_ = Vector::Zero();
};

Vec3 middle_of(const Points3& points) {
  Vec3 middle;
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<double> values(points.rows());
    for (Eigen::Index i = 0; i < points.rows(); ++i) values[i] = points(i, axis);
    middle[axis] = median(values);
  }
  return middle;
}

RigidMotion motion_of(const Pose& pose, const Vec3& middle) {
  const Eigen::Matrix3d R = pose.turn.toRotationMatrix();
  return {R, pose.shift - R * middle};
}

class ScanRegistration {
 public:
  ScanRegistration(const Points3& points, const TriangleMesh& surface, double tile)
      : mesh_(surface), surface_(surface), tile_(tile), middle_(middle_of(points)) {
    std::vector<int> order(points.rows());
    for (int i = 0; i < points.rows(); ++i) order[i] = i;
    std::shuffle(order.begin(), order.end(), random_);
    for (int i : order) points_.push_back(points.row(i).transpose() - middle_);
    for (const Vec3& p : points_) radius_ = std::max(radius_, p.norm());
  }

  Registration run() {
    // Points, steps and poses that remain.
    struct Level {
      int points, steps, remaining;
    };
    constexpr Level levels[] = {{150, 2, 100}, {600, 4, 12}, {3000, 20, 12}};
    checkpoint("registering the scan", 0);
    std::vector<Pose> poses = best(starts(), 150, 8, 60, tile_ / 4);
    poses = jittered(poses);
    double done = 0.3;
    for (const Level& level : levels) {
      checkpoint_at(done);
      poses = best(poses, level.points, level.steps, level.remaining, tile_ / 10);
      done += 0.2;
    }
    Registration out;
    out.other_turns = count_others(poses);
    checkpoint_at(0.9);
    const Pose pose = refined(poses.front(), 20000, 30, 0, 1e-4);
    out.pose = motion_of(pose, middle_);
    const std::vector<ClosestPoint> nearest = closest(pose, 20000);
    const double noise = noise_of(distances(nearest));
    out.loss_scale = tukey * noise;
    step_of(pose, nearest, out.loss_scale).describe(noise, out);
    return out;
  }

 private:
  int count(int most) const { return std::min(most, static_cast<int>(points_.size())); }

  // Rotations spread evenly over SO(3) (M. Alexa, "Super-Fibonacci spirals", 2022), with the
  // middles of scan and surface on one another.
  std::vector<Pose> starts() const {
    Vec3 middle = Vec3::Zero();
    double area = 0;
    for (Eigen::Index f = 0; f < mesh_.F.rows(); ++f) {
      const Vec3 a = mesh_.V.row(mesh_.F(f, 0)), b = mesh_.V.row(mesh_.F(f, 1)),
                 c = mesh_.V.row(mesh_.F(f, 2));
      const double doubled = (b - a).cross(c - a).norm();
      middle += doubled * (a + b + c) / 3;
      area += doubled;
    }
    std::vector<Pose> out;
    for (int i = 0; i < first_turns; ++i) {
      const double s = (i + 0.5) / first_turns, alpha = 2 * pi * (i + 0.5) / std::sqrt(2.0),
                   beta = 2 * pi * (i + 0.5) / 1.533751168755204288;
      const double r = std::sqrt(s), R = std::sqrt(1 - s);
      out.push_back({Eigen::Quaterniond(R * std::cos(beta), r * std::sin(alpha),
                                        r * std::cos(alpha), R * std::sin(beta)),
                     middle / area});
    }
    return out;
  }

  // Each pose, and others turned by two tiles at most: a smooth shape lets a scan slide.
  std::vector<Pose> jittered(const std::vector<Pose>& poses) {
    const double most = std::min(0.25, tile_ / radius_);
    std::uniform_real_distribution<double> angle(-most, most);
    std::vector<Pose> out = poses;
    for (const Pose& pose : poses) {
      for (int k = 1; k < jittered_turns; ++k) {
        const Vec3 turn(angle(random_), angle(random_), angle(random_));
        out.push_back({Eigen::AngleAxisd(turn.norm(), turn.normalized()) * pose.turn, pose.shift});
      }
    }
    return out;
  }

  std::vector<ClosestPoint> closest(const Pose& pose, int most) const {
    std::vector<ClosestPoint> out(count(most));
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = surface_(pose(points_[i]));
    return out;
  }

  static std::vector<double> distances(const std::vector<ClosestPoint>& nearest) {
    std::vector<double> out;
    for (const ClosestPoint& point : nearest) out.push_back(point.distance);
    return out;
  }

  PoseStep step_of(const Pose& pose, const std::vector<ClosestPoint>& nearest,
                   double loss_scale) const {
    PoseStep step(pose, loss_scale);
    for (std::size_t i = 0; i < nearest.size(); ++i) {
      const auto& [foot, face, distance] = nearest[i];
      const Vec3 normal =
          distance > 1e-9 ? Vec3((pose(points_[i]) - foot) / distance) : surface_.normal(face);
      step.add<1>(points_[i], foot, normal.transpose());
    }
    return step;
  }

  // Iterated closest points, until a step moves the pose by less than `arrived` mm. least: mm
  // within which points count in any case.
  Pose refined(Pose pose, int most, int steps, double least, double arrived) const {
    for (int step = 0; step < steps; ++step) {
      checkpoint();
      const std::vector<ClosestPoint> nearest = closest(pose, most);
      const double scale = std::max(tukey * noise_of(distances(nearest)), least);
      const Pose before = pose;
      pose = step_of(pose, nearest, scale).taken();
      if (apart(before, pose) < arrived) break;
    }
    return pose;
  }

  // Upper bound of the distance between the scan's points under two poses, mm.
  double apart(const Pose& a, const Pose& b) const {
    return (a.shift - b.shift).norm() + radius_ * a.turn.angularDistance(b.turn);
  }

  double loss(const Pose& pose, int most, double scale) const {
    double sum = 0;
    for (double d : distances(closest(pose, most))) sum += std::pow(std::min(d, scale), 2);
    return sum / count(most);
  }

  // Refined poses with the least loss, `scale` mm apart, the best first.
  std::vector<Pose> best(std::vector<Pose> poses, int most, int steps, int remaining,
                         double scale) const {
    std::vector<std::pair<double, int>> order(poses.size());
    parallel_each(static_cast<int>(poses.size()), [&](int i) {
      poses[i] = refined(poses[i], most, steps, scale, 0.01);
      order[i] = {loss(poses[i], most, scale), i};
    });
    std::sort(order.begin(), order.end());
    std::vector<Pose> out;
    for (const auto& [value, i] : order) {
      if (static_cast<int>(out.size()) == remaining || value > contrast * order[0].first + 1e-9) {
        break;
      }
      const bool is_new = std::all_of(out.begin(), out.end(), [&, k = i](const Pose& other) {
        return apart(other, poses[k]) > scale;
      });
      if (is_new) out.push_back(poses[i]);
    }
    return out;
  }

  // Number of poses whose mean loss is that of the first but for noise, and which take tiles to
  // other tiles.
  int count_others(const std::vector<Pose>& poses) const {
    constexpr int most = 3000;
    const std::vector<double> least = distances(closest(poses.front(), most));
    const double scale = tukey * noise_of(least);
    std::vector<Pose> different = {poses.front()};
    for (const Pose& pose : poses) {
      const std::vector<double> own = distances(closest(pose, most));
      double sum = 0, squares = 0;
      for (std::size_t i = 0; i < own.size(); ++i) {
        const double worse =
            std::pow(std::min(own[i], scale), 2) - std::pow(std::min(least[i], scale), 2);
        sum += worse;
        squares += worse * worse;
      }
      const double n = static_cast<double>(own.size()), mean = sum / n;
      const double error = std::sqrt(std::max(0.0, squares / n - mean * mean) / n);
      if (mean <= alike * error && takes_tiles_elsewhere(pose, different)) {
        different.push_back(pose);
      }
    }
    return static_cast<int>(different.size()) - 1;
  }

  bool takes_tiles_elsewhere(const Pose& pose, const std::vector<Pose>& others) const {
    return std::all_of(others.begin(), others.end(), [&](const Pose& other) {
      const Eigen::Quaterniond turn = pose.turn * other.turn.conjugate();
      for (Eigen::Index v = 0; v < mesh_.V.rows(); ++v) {
        const Vec3 place = mesh_.V.row(v);
        if ((turn * (place - other.shift) + pose.shift - place).norm() > tile_ / 2) return true;
      }
      return false;
    });
  }

  const TriangleMesh& mesh_;
  ClosestPoints surface_;
  double tile_;
  Vec3 middle_;
  double radius_ = 0;
  std::vector<Vec3> points_;  // in a random order
  std::mt19937 random_{0};
};

}  // namespace

Registration register_markers(const Points3& points, const Points3& targets) {
  const Vec3 middle = middle_of(points);
  const Points3 centred = points.rowwise() - middle.transpose();
  const Eigen::Matrix4d start = Eigen::umeyama(centred.transpose(), targets.transpose(), false);
  Pose pose{Eigen::Quaterniond(start.topLeftCorner<3, 3>()), start.topRightCorner<3, 1>()};
  Registration out;
  auto step_of = [&](const Pose& at) {
    PoseStep step(at, out.loss_scale);
    for (Eigen::Index i = 0; i < points.rows(); ++i) {
      step.add<3>(centred.row(i), targets.row(i), Eigen::Matrix3d::Identity());
    }
    return step;
  };
  for (int round = 0; round < marker_rounds; ++round) {
    std::vector<double> distances;
    for (Eigen::Index i = 0; i < points.rows(); ++i) {
      distances.push_back((pose(centred.row(i)) - targets.row(i).transpose()).norm());
    }
    const double noise = median(distances) / 1.538 + 1e-9;  // noise of a coordinate, in space
    out.loss_scale = tukey * noise;
    for (int step = 0; step < marker_steps; ++step) pose = step_of(pose).taken();
    step_of(pose).describe(noise, out);
  }
  out.pose = motion_of(pose, middle);
  return out;
}

Registration register_scan(const Points3& points, const TriangleMesh& surface, double tile) {
  return ScanRegistration(points, surface, tile).run();
}

}  // namespace curveups
