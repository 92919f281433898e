// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/numerics/nested_dissection.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "curveups/core/checkpoint.hpp"

namespace curveups {
namespace {

constexpr int least_divided = 120;  // vertices: least degree orders fewer as well
// That are tried, in the plane in which vertices spread most. More save a tenth to a fifth of the
// operations; those of so many vertices, which have few unknowns each, are not worth as much time.
constexpr int directions = 4, most_in_all_directions = 40000;
// Share of the vertices that belongs to each half beforehand: a separator may lie anywhere in
// between. Straight across the middle it would be a fifth larger on a mesh. In a wider band than
// some rows of vertices it is no smaller, and takes longer to find.
constexpr double given_share = 0.4, widest_band = 60;

using Vertices = std::vector<int>;

class Dissection {
 public:
  Dissection(const std::vector<std::vector<int>>& above, const Places& places)
      : places_(places),
        tried_(above.size() > most_in_all_directions ? 1 : directions),
        along_(above.size(), 0.0),
        neighbours_(above.size()),
        part_(above.size(), -1),
        side_(above.size(), nowhere),
        before_(above.size()),
        after_(above.size()),
        reached_(2 * above.size(), 0) {
    for (std::size_t v = 0; v < above.size(); ++v) {
      for (int u : above[v]) {
        neighbours_[v].push_back(u);
        neighbours_[u].push_back(static_cast<int>(v));
      }
    }
    Vertices all(above.size());
    std::iota(all.begin(), all.end(), 0);
    divide(all);
  }

  std::vector<int> part() && { return std::move(part_); }

 private:
  struct Division {
    Vertices low, high, separator;
    // What the separator fills in below it grows with both.
    double cost() const {
      return static_cast<double>(separator.size()) *
             static_cast<double>(std::max(low.size(), high.size()));
    }
  };
  enum Side : char { nowhere, given_low, between, given_high };
  // Of a path through a vertex: where it starts or ends; or that there is none.
  static constexpr int outside = -1, unused = -2;

  void divide(const Vertices& vertices) {
    if (static_cast<int>(vertices.size()) > least_divided) {
      const auto [first, second] = longest_axes(vertices);
      Division best;
      for (int k = 0; k < tried_; ++k) {
        checkpoint();
        const double angle = M_PI * k / tried_;
        Division tried = divide_along(vertices, std::cos(angle) * first + std::sin(angle) * second);
        if (k == 0 || tried.cost() < best.cost()) best = std::move(tried);
      }
      divide(best.low);
      divide(best.high);
      number(best.separator);
    } else {
      number(vertices);
    }
  }

  void number(const Vertices& vertices) {
    if (vertices.empty()) return;
    for (int v : vertices) part_[v] = parts_;
    ++parts_;
  }

  std::pair<Eigen::VectorXd, Eigen::VectorXd> longest_axes(const Vertices& vertices) const {
    const Places own = places_(vertices, Eigen::seqN(0, places_.cols()));
    const Places centred = own.rowwise() - own.colwise().mean();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> axes(centred.transpose() * centred);
    return {axes.eigenvectors().rightCols<1>(), axes.eigenvectors().rightCols<2>().col(0)};
  }

  Division divide_along(const Vertices& vertices, const Eigen::VectorXd& direction) {
    std::vector<std::pair<double, int>> along;
    for (int v : vertices) along.emplace_back(along_[v] = places_.row(v).dot(direction), v);
    // Straight on first: paths get in one another's way less.
    for (int v : vertices) {
      std::sort(neighbours_[v].begin(), neighbours_[v].end(),
                [&](int a, int b) { return std::pair(-along_[a], a) < std::pair(-along_[b], b); });
    }
    const auto count = static_cast<double>(along.size());
    const double share = std::max(given_share, 0.5 - 0.5 * widest_band / std::sqrt(count));
    const auto given = static_cast<std::ptrdiff_t>(share * count);
    std::nth_element(along.begin(), along.begin() + given, along.end());
    std::nth_element(along.begin() + given, along.end() - given, along.end());
    for (auto at = along.begin(); at != along.end(); ++at) {
      side_[at->second] = at - along.begin() < given  ? given_low
                          : along.end() - at <= given ? given_high
                                                      : between;
    }
    Division out = separate(vertices);
    for (int v : vertices) side_[v] = nowhere;
    return out;
  }

  // The fewest vertices that all paths from the lower to the higher given ones go through. There
  // are as many as there are paths without a common vertex (Menger), which are found one after
  // another, each along unused vertices and back along parts of others that it then replaces (L.
  // Ford, D. Fulkerson, 1956).
  Division separate(const Vertices& vertices) {
    Vertices starts;
    for (int v : vertices) {
      before_[v] = after_[v] = unused;
      const auto farther = [&](int u) { return side_[u] == between || side_[u] == given_high; };
      const Vertices& next = neighbours_[v];
      if (side_[v] == given_low && std::any_of(next.begin(), next.end(), farther)) {
        starts.push_back(v);
      }
    }
    // What a search has reached without success leads nowhere for the others of the same round.
    bool found = true;
    while (found) {
      checkpoint();
      found = false;
      ++round_;
      for (int v : starts) {
        if (before_[v] != outside) found = add_path(v) || found;
      }
    }
    // The last round reached what there is without going through the separator, which it entered.
    Division out;
    for (int v : vertices) {
      if (!reached(leaving(v)) && (reached(entering(v)) || before_[v] == outside)) {
        out.separator.push_back(v);
      } else if (reached(leaving(v)) || side_[v] == given_low) {
        out.low.push_back(v);
      } else {
        out.high.push_back(v);
      }
    }
    return out;
  }

  // A search goes from entering a vertex to leaving it, unless a path goes through it: then it may
  // only go back along that path.
  static int entering(int v) { return 2 * v; }
  static int leaving(int v) { return 2 * v + 1; }
  bool reached(int state) const { return reached_[state] == round_; }

  bool add_path(int start) {
    std::vector<std::pair<int, std::size_t>> stack;  // states, and how many ways on were tried
    const auto go = [&](int state) {
      if (reached(state)) return false;
      reached_[state] = round_;
      stack.emplace_back(state, 0);
      return true;
    };
    go(entering(start));
    while (!stack.empty()) {
      const int state = stack.back().first, v = state / 2;
      std::size_t& way = stack.back().second;
      if (state == leaving(v) && side_[v] == given_high) {
        take(stack);
        return true;
      }
      bool on = false;
      if (state == entering(v)) {
        if (way++ == 0) {
          on = after_[v] == unused ? go(leaving(v)) : before_[v] >= 0 && go(leaving(before_[v]));
        }
      } else {
        if (way == 0 && after_[v] != unused) on = go(entering(v));
        while (!on && way < neighbours_[v].size()) {
          const int u = neighbours_[v][way++];
          on = side_[u] != nowhere && go(entering(u));
        }
      }
      if (!on) stack.pop_back();
    }
    return false;
  }

  // What the search went back along is no part of a path any more, what it went forward along is.
  void take(const std::vector<std::pair<int, std::size_t>>& states) {
    const auto each_step = [&](int parity, const auto& act) {
      for (std::size_t k = 1; k < states.size(); ++k) {
        const int from = states[k - 1].first, to = states[k].first;
        if (from / 2 != to / 2 && from % 2 == parity) act(from / 2, to / 2);
      }
    };
    each_step(0, [&](int v, int u) { before_[v] = after_[u] = unused; });
    before_[states.front().first / 2] = outside;
    each_step(1, [&](int v, int u) {
      after_[v] = u;
      before_[u] = v;
    });
    after_[states.back().first / 2] = outside;
  }

  const Places& places_;
  const int tried_;            // directions
  std::vector<double> along_;  // the direction last tried
  std::vector<Vertices> neighbours_;
  std::vector<int> part_;
  std::vector<Side> side_;
  Vertices before_, after_;   // on the path through a vertex
  std::vector<int> reached_;  // by state, in which round last
  int parts_ = 0, round_ = 0;
};

}  // namespace

std::vector<int> dissected_parts(const std::vector<std::vector<int>>& above, const Places& places) {
  return Dissection(above, places).part();
}

}  // namespace curveups
