// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/actuation/path_end.hpp"

#include <algorithm>
#include <map>

namespace curveups {

PathEnd describe_end(const ContactWorld& world, const TileMesh& tiles, const TriangleMesh& surface,
                     double friction, const ActuationPath& path) {
  PathEnd end;
  end.friction_coefficient = friction;
  end.at_rest = path.at_rest;
  end.steps = path.steps;
  end.iterations = path.iterations;
  end.factorizations = path.factorizations;
  end.energy = world.energy();
  end.scan = describe_scan(scan_distances(surface, ClosestPoints(tiles.mesh)), surface, tiles.mesh);
  std::map<std::array<int, 2>, double> contacts, others;
  for (const Contact& contact : tiles.contacts) contacts[contact.tile] = 0;
  for (const TouchForce& force : world.forces()) {
    const auto contact = contacts.find(force.body);
    if (contact != contacts.end()) {
      contact->second += force.push;
    } else if (force.push > 0 && force.body[1] < tiles.tile_count()) {
      others[force.body] += force.push;
    }
  }
  for (const auto& [pair, push] : contacts) {
    if (push == 0) end.open_contacts.push_back(pair);
    end.push += push / static_cast<double>(contacts.size());
  }
  for (const auto& [pair, push] : others) end.wedged.push_back(pair);
  std::stable_sort(end.wedged.begin(), end.wedged.end(),
                   [&](const auto& a, const auto& b) { return others.at(a) > others.at(b); });
  return end;
}

}  // namespace curveups
