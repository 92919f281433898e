// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/contact/process_window.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <functional>

#include "curveups/core/checkpoint.hpp"
#include "curveups/core/parallel.hpp"

namespace curveups {
namespace {

// Lets the tiles settle with one value of a parameter.
using Change = std::function<void(Settling&, double)>;

// From one sample to the next until one fails; then between it and its neighbour, so many times.
WindowEnd walk(const Settling& standing, double from, const std::vector<double>& values,
               int halvings, const Change& change) {
  Settling settling(standing);
  WindowEnd end{from, {}};
  for (double value : values) {
    const Settling::State last = settling.state();
    change(settling, value);
    end.failure = settling.failure();
    if (!end.failure) {
      end.value = value;
      continue;
    }
    double failed = value;
    Settling::State good = last;
    for (int k = 0; k < halvings; ++k) {
      const double middle = 0.5 * (end.value + failed);
      settling.restore(good);
      change(settling, middle);
      if (std::optional<Finding> failure = settling.failure()) {
        failed = middle;
        end.failure = std::move(failure);
      } else {
        end.value = middle;
        good = settling.state();
      }
    }
    break;
  }
  return end;
}

// One parameter: its values from the design's own to either end of what is searched.
struct Axis {
  const char *parameter, *unit;
  std::array<std::vector<double>, 2> values;
  Change change;
  double own = 0;
};

void with_friction(Settling& tiles, double friction) { tiles.settle(tiles.conditions(), friction); }

Change with(void (*set)(Conditions&, double)) {
  return [set](Settling& settling, double value) {
    Conditions conditions;
    set(conditions, value);
    settling.settle(conditions, settling.friction());
  };
}

std::vector<Axis> axes() {
  return {
      {"stretch",
       "%",
       {{{-5, -10, -15, -20}, {5, 10, 15, 20}}},
       with([](Conditions& c, double percent) { c.stretch.setConstant(1 + percent / 100); })},
      {"stretch_y", "%", {{{-5, -10, -20}, {5, 10, 20}}}, with([](Conditions& c, double percent) {
         c.stretch.y() = 1 + percent / 100;
       })},
      {"front_over_back",
       "%",
       {{{-10, -20, -30}, {10, 20, 30}}},
       with([](Conditions& c, double percent) {
         c.pull[percent > 0 ? 0 : 1] = 1 + std::abs(percent) / 100;
       })},
      {"xy_growth",
       "mm",
       // Bumps of 0.1 mm let go of one another, and tiles turn over, where walls shrink by 0.02 mm
       // at once.
       {{{-0.01, -0.02, -0.03, -0.04, -0.05, -0.06, -0.07, -0.08, -0.09, -0.1}, {0.02, 0.05, 0.1}}},
       with([](Conditions& c, double mm) { c.growth = mm; })},
      {"xy_taper",
       "mm",
       {{{-0.02, -0.05, -0.1}, {0.02, 0.05, 0.1}}},
       with([](Conditions& c, double mm) { c.taper = mm; })},
      {"half_shift",
       "mm",
       {{{-0.1, -0.2, -0.4}, {0.1, 0.2, 0.4}}},
       with([](Conditions& c, double mm) { c.half_shift = mm; })},
      {"half_turn",
       "degrees",
       {{{-0.1, -0.2, -0.4}, {0.1, 0.2, 0.4}}},
       with([](Conditions& c, double degrees) { c.half_turn = degrees; })},
  };
}

WindowRange range_of_glue(const LargestGlueLoads& glue) {
  WindowRange out{"glue_strength", "%", "glue", {-50, 50}, {}};
  const GlueLoad& load = glue.shear;
  const double needed = 100 * (load.shear / load.limit - 1);
  out.end = {WindowEnd{std::max(needed, -50.0), {}}, WindowEnd{std::max(needed, 50.0), {}}};
  if (needed > -50) {
    const std::vector<int> tile = {load.tile};
    out.end[0].failure = Finding{"glue_carries",
                                 tile,
                                 {{"side", load.side == Side::front ? "front" : "back"},
                                  {"tile", tile},
                                  {"shear", load.shear}}};
  }
  return out;
}

}  // namespace

WindowEnd holding_friction(const Settling& standing, int halvings) {
  const double mu = standing.friction();
  return walk(standing, mu, {0.8 * mu, 0.6 * mu, 0.4 * mu, 0.2 * mu}, halvings, with_friction);
}

Margin find_margin(const Settling& standing, const Parameters& parameters) {
  Margin out{parameters.margin, parameters.margin_mismatch, parameters.margin_friction, {}, {}};
  if (out.mode == "off") return out;
  if (!standing.holds()) {
    if (standing.is_known()) out.met = false;
    return out;
  }
  std::array<char, 2> fails{};
  parallel_each(2, [&](int s) {
    Settling settling(standing);
    Conditions corner;
    corner.pull[s] = 1 + out.mismatch / 100;
    settling.settle(corner, std::min(out.friction_coefficient, standing.friction()));
    out.failure[s] = settling.failure();
    fails[s] = out.failure[s] && settling.is_known();
  });
  if (fails[0] || fails[1]) {
    out.met = false;
  } else if (!out.failure[0] && !out.failure[1]) {
    out.met = true;
  }
  return out;
}

std::vector<WindowRange> process_window(const Settling& standing, const WindowEnd& lowest_friction,
                                        const LargestGlueLoads& glue) {
  const double mu = standing.friction();
  std::vector<Axis> all = axes();
  all.push_back({"friction_coefficient", "", {{{}, {1.5 * mu, 2 * mu}}}, with_friction, mu});
  std::vector<WindowRange> out;
  for (const Axis& axis : all) {
    out.push_back({axis.parameter, axis.unit, "holds", {}, {}});
    for (int e = 0; e < 2; ++e) {
      out.back().searched[e] = axis.values[e].empty() ? 0.2 * mu : axis.values[e].back();
    }
  }
  const int ends = 2 * static_cast<int>(all.size());
  std::atomic<int> done = 0;
  parallel_each(ends, [&](int k) {
    checkpoint("process window", static_cast<double>(done) / ends);
    const Axis& axis = all[k / 2];
    const std::vector<double>& values = axis.values[k % 2];
    out[k / 2].end[k % 2] = values.empty()
                                ? lowest_friction
                                : walk(standing, axis.own, values, window_halvings, axis.change);
    ++done;
  });
  out.push_back(range_of_glue(glue));
  return out;
}

}  // namespace curveups
