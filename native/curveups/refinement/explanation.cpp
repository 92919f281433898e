// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/refinement/explanation.hpp"

#include <algorithm>
#include <cstdio>

namespace curveups {
namespace {

std::vector<int> with_neighbours(const TileMesh& tiles, const std::array<int, 2>& pair) {
  std::vector<int> near = {pair[0], pair[1]};
  for (int tile : pair) {
    for (int t = 0; t < 3; ++t) {
      const int n = tiles.topology.neighbour(tile, t);
      if (n >= 0) near.push_back(n);
    }
  }
  return near;
}

// With what is short in the words of `reason`.
std::vector<BlockedContact> short_contacts(const std::vector<ContactPoint>& points,
                                           const Judgement& judgement,
                                           const CriticalPairs& critical) {
  std::vector<BlockedContact> out;
  auto add = [&](const std::array<int, 2>& tiles, double force) {
    const auto known = std::find_if(out.begin(), out.end(), [&](const BlockedContact& contact) {
      return contact.tiles == tiles;
    });
    if (known == out.end()) {
      out.push_back({tiles, force, "", "", {}});
    } else {
      known->least_force = std::min(known->least_force, force);
    }
  };
  for (std::size_t p = 0; p < points.size(); ++p) {
    const double force = judgement.normal(static_cast<Eigen::Index>(p)) / judgement.f_min;
    if (points[p].contact >= 0 && force < 1) add(points[p].tile, force);
  }
  std::string what = " has ";
  for (Touching where : touchings) {
    if (!out.empty() || !judgement.is_short_of(where)) continue;
    what = where == Touching::at_tips ? " keeps pushing forces within friction at bumps' tips at "
                                      : " keeps pushing forces within friction at ";
    const int k = static_cast<int>(where);
    for (const std::array<int, 2>& pair : critical[k]) add(pair, judgement.floor[k]);
  }
  for (BlockedContact& contact : out) {
    char share[32];
    std::snprintf(share, sizeof share, "%.2f", contact.least_force);
    contact.reason = "contact " + pair_name(contact.tiles) + what + share + " of f_min";
  }
  return out;
}

}  // namespace

std::vector<BlockedContact> explain_weak_contacts(const TileMesh& tiles,
                                                  const std::vector<ContactPoint>& points,
                                                  const Judgement& judgement,
                                                  const CriticalPairs& critical,
                                                  const std::vector<Obstacle>& obstacles) {
  std::vector<BlockedContact> out = short_contacts(points, judgement, critical);
  for (BlockedContact& contact : out) {
    const std::vector<int> near = with_neighbours(tiles, contact.tiles);
    const auto found =
        std::find_if(obstacles.begin(), obstacles.end(), [&](const Obstacle& obstacle) {
          return std::any_of(obstacle.tiles.begin(), obstacle.tiles.end(), [&](int tile) {
            return std::find(near.begin(), near.end(), tile) != near.end();
          });
        });
    if (found == obstacles.end()) {
      contact.reason += ": no small change of layout, pins or vertices lifts it";
      continue;
    }
    contact.obstacle = found->what;
    contact.held = found->tiles;
    contact.reason +=
        ": held by the " + found->what + " of " + tile_names(found->tiles, found->tiles.size());
  }
  return out;
}

std::vector<std::string> suggest_remedies(const std::vector<BlockedContact>& blocked) {
  std::vector<std::string> out;
  auto any = [&](auto&& is) {
    return std::any_of(blocked.begin(), blocked.end(),
                       [&](const BlockedContact& contact) { return is(contact.obstacle); });
  };
  if (any([](const std::string& what) { return what == "gap"; })) {
    out.push_back("a cut near the tiles named gives gaps room");
  }
  if (any([](const std::string& what) { return !what.empty() && what != "gap"; })) {
    out.push_back("a larger L, thinner tiles (H_body) or a smaller A_pin_min give pins room");
  }
  if (any([](const std::string& what) { return what.empty(); })) {
    out.push_back(
        "another tau, or a smoother target near the tiles named, changes the membranes' "
        "pull there");
  }
  return out;
}

}  // namespace curveups
