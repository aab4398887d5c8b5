// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QString>
#include <cstdint>
#include <variant>
#include <vector>

#ifndef Q_MOC_RUN
#include <agrid_map/AddTag.h>
#include <agrid_map/RemoveTag.h>
#include <agrid_map/SetDoor.h>
#include <agrid_map/TopologicalGraph.h>
#endif

namespace agrid_map_rviz {

/// An area, a door or an object of the graph.
struct Place {
  std::uint8_t type = 0;  ///< agrid_map::Tag::AREA, DOOR or OBJECT; 0: none
  std::uint32_t id = 0;
};
inline bool operator==(const Place& a, const Place& b) { return a.type == b.type && a.id == b.id; }

/// The thing of that id in a list of the graph; nullptr: there is none.
template <typename Thing>
const Thing* find(const std::vector<Thing>& things, std::uint32_t id) {
  for (const Thing& thing : things) {
    if (thing.id == id) return &thing;
  }
  return nullptr;
}

/// A request to one of the node's services that change what is known.
using Change = std::variant<agrid_map::AddTag::Request, agrid_map::RemoveTag::Request,
                            agrid_map::SetDoor::Request>;

/// What a place is called; empty: the graph does not have it.
QString nameOf(const agrid_map::TopologicalGraph& graph, const Place& place);

/// A tag given by a person, at a point of a frame.
agrid_map::AddTag::Request tagAt(std::uint8_t type, const std::string& frame, double x, double y);

/// A tag for a door from jamb to jamb: its middle, width and direction.
agrid_map::AddTag::Request doorBetween(const std::string& frame, const geometry_msgs::Point& a,
                                       const geometry_msgs::Point& b);

/// The changes that give a place another name or another category, and leave it where it is.
Change rename(const Place& place, const std::string& name);
Change setCategory(const Place& place, const std::string& category);
Change setDoorState(std::uint32_t door, std::uint8_t state);
Change removal(const Place& place);

/// Takes away every door between two areas, which joins them; empty: there is none.
std::vector<Change> joining(const agrid_map::TopologicalGraph& graph, std::uint32_t area_a,
                            std::uint32_t area_b);

/// What takes a change back, in the order to be called.
/// @param before  the graph that was in use when the change was asked for
/// @param id      what add_tag answered; unused for other changes
std::vector<Change> inverseOf(const agrid_map::TopologicalGraph& before, const Change& change,
                              std::uint32_t id);

}  // namespace agrid_map_rviz
