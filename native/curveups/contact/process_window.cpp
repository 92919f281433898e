// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/contact/process_window.hpp"

#include <atomic>
#include <cmath>

#include "curveups/core/checkpoint.hpp"
#include "curveups/core/parallel.hpp"

namespace curveups {
namespace {

constexpr int halvings = 2;

using Fails = std::function<std::optional<Finding>(double value)>;

WindowEnd search(double own, const std::vector<double>& values, const Fails& fails) {
  WindowEnd end{own, {}};
  for (double value : values) {
    end.failure = fails(value);
    if (!end.failure) {
      end.value = value;
      continue;
    }
    double failed = value;
    for (int k = 0; k < halvings; ++k) {
      const double middle = 0.5 * (end.value + failed);
      if (std::optional<Finding> failure = fails(middle)) {
        failed = middle;
        end.failure = std::move(failure);
      } else {
        end.value = middle;
      }
    }
    break;
  }
  return end;
}

}  // namespace

std::vector<WindowRange> process_window(double mu, const WindowSample& sample) {
  std::vector<WindowRange> out = {{"front_over_back", "%", {-30, 30}, {}},
                                  {"friction_coefficient", "", {0.2 * mu, 2 * mu}, {}}};
  const Fails with_mismatch = [&](double percent) {
    std::array<double, 2> pull = {1, 1};
    pull[percent > 0 ? 0 : 1] += std::abs(percent) / 100;
    return sample(pull, mu);
  };
  const Fails with_friction = [&](double friction) { return sample({1, 1}, friction); };
  struct Search {
    WindowEnd& end;
    double own;
    std::vector<double> values;  // from the design's own to the end
    const Fails& fails;
  };
  const std::vector<Search> searches = {
      {out[0].end[0], 0, {-10, -20, -30}, with_mismatch},
      {out[0].end[1], 0, {10, 20, 30}, with_mismatch},
      {out[1].end[0], mu, {0.8 * mu, 0.6 * mu, 0.4 * mu, 0.2 * mu}, with_friction},
      {out[1].end[1], mu, {1.5 * mu, 2 * mu}, with_friction}};
  const int count = static_cast<int>(searches.size());
  std::atomic<int> done = 0;
  parallel_each(count, [&](int k) {
    checkpoint("process window", static_cast<double>(done) / count);
    searches[k].end = search(searches[k].own, searches[k].values, searches[k].fails);
    ++done;
  });
  return out;
}

}  // namespace curveups
