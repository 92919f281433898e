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
  struct Axis {
    const char *parameter, *unit;
    double own;
    std::array<std::vector<double>, 2> values;  // from the design's own to either end
    Fails fails;
  };
  const std::vector<Axis> axes = {
      {"front_over_back",
       "%",
       0,
       {{{-10, -20, -30}, {10, 20, 30}}},
       [&](double percent) {
         std::array<double, 2> pull = {1, 1};
         pull[percent > 0 ? 0 : 1] += std::abs(percent) / 100;
         return sample(pull, mu);
       }},
      {"friction_coefficient",
       "",
       mu,
       {{{0.8 * mu, 0.6 * mu, 0.4 * mu, 0.2 * mu}, {1.5 * mu, 2 * mu}}},
       [&](double friction) {
         return sample({1, 1}, friction);
       }},
  };
  std::vector<WindowRange> out;
  for (const Axis& axis : axes) {
    out.push_back({axis.parameter, axis.unit, {axis.values[0].back(), axis.values[1].back()}, {}});
  }
  const int ends = 2 * static_cast<int>(axes.size());
  std::atomic<int> done = 0;
  parallel_each(ends, [&](int k) {
    checkpoint("process window", static_cast<double>(done) / ends);
    const Axis& axis = axes[k / 2];
    out[k / 2].end[k % 2] = search(axis.own, axis.values[k % 2], axis.fails);
    ++done;
  });
  return out;
}

}  // namespace curveups
