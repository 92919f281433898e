// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/refinement/explanation.hpp"

#include <algorithm>
#include <utility>

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

// With what is short as the kind of `reason`.
std::vector<BlockedContact> short_contacts(const std::vector<ContactPoint>& points,
                                           const Judgement& judgement,
                                           const std::vector<std::array<int, 2>>& critical) {
  std::vector<BlockedContact> out;
  auto add = [&](const std::array<int, 2>& tiles, double force) {
    const auto known = std::find_if(out.begin(), out.end(), [&](const BlockedContact& contact) {
      return contact.tiles == tiles;
    });
    if (known == out.end()) {
      out.push_back({tiles, force, {}, ""});
    } else {
      known->least_force = std::min(known->least_force, force);
    }
  };
  for (std::size_t p = 0; p < points.size(); ++p) {
    const double force = judgement.normal(static_cast<Eigen::Index>(p)) / judgement.f_min;
    if (points[p].contact >= 0 && force < 1) add(points[p].tile, force);
  }
  std::string kind = "weak_contact";
  if (out.empty() && judgement.is_short_of_floor()) {
    kind = "weak_contact.friction";
    for (const std::array<int, 2>& pair : critical) add(pair, judgement.floor);
  }
  for (BlockedContact& contact : out) {
    const Finding::Pairs pair = {contact.tiles};
    contact.reason = {kind, tiles_of(pair), {{"contact", pair}, {"share", contact.least_force}}};
  }
  return out;
}

}  // namespace

std::vector<BlockedContact> explain_weak_contacts(const TileMesh& tiles,
                                                  const std::vector<ContactPoint>& points,
                                                  const Judgement& judgement,
                                                  const std::vector<std::array<int, 2>>& critical,
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
    std::vector<Finding> why = {{"held_by_nothing"}};
    if (found != obstacles.end()) {
      contact.obstacle = found->what;
      why = {{"held_by", {}, {{"obstacle", found->what}, {"at", found->tiles}}}};
    }
    contact.reason.figures["why"] = std::move(why);
  }
  return out;
}

}  // namespace curveups
