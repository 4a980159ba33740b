// What the keys of sections read with: where they stand, and the values that more than one kind reads.
#pragma once

#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <core/scenario/section/section_part.hpp>
#include <core/text/text.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace pmreport::scenario {

// What is known when a section is read.
struct Reading {
  const Reader& reader;
  const std::optional<TimeSpan>& span;  // of the motion; nothing when it is not known, empty when there is none
  const MechanismPart& mechanism;
  const Measurable* measurable = nullptr;  // what can be named of all sections; for late keys alone
  const Origin* origin = nullptr;          // of the scenario; never null
};

// The name of a section among several of its kind: it becomes part of file names and of quantities. What cannot is told.
std::string read_section_name(const Value& value, const Reader& reader);
// A time that must lie within the motion; told when it does not, or when there is no motion.
std::optional<double> read_time(const Value& value, const std::optional<TimeSpan>& span, const Reader& reader);
// The items of a list of one to `most`; what is wrong is reported.
std::vector<Value> items_of(const Entry& entry, std::size_t most, const Reader& reader);
// Index of a coordinate; -1: there is none of that name.
int index_of(const Topology& topology, const std::string& name);
// A pose by its coordinates; those left out stay at home. Nothing, told, when it is none. The mechanism's topology must be known.
std::optional<Eigen::VectorXd> read_pose(const Value& value, const std::string& where, const MechanismPart& mechanism,
                                         const Reader& reader);
// Those of a list of one to `most`; an empty one where one is wrong, and none where the mechanism is not known.
std::vector<Eigen::VectorXd> read_poses(const Entry& entry, std::size_t most, const Reading& reading);

// The scenario in a file beside this one, as the text in `value` names it. Nothing where it cannot be read; what is wrong with it is told
// with its own lines. A scenario that is read for another one reads no further ones, so that two may name each other.
std::shared_ptr<const Loaded> read_other_scenario(const Value& value, const Origin& origin, const Reader& reader);

// Adds what `list` does not have yet; else tells.
template <class T>
void add_once(std::vector<T>& list, const T& x, const Value& item, const Reader& reader) {
  if (std::find(list.begin(), list.end(), x) != list.end())
    reader.diagnostics().add(item.place, fmt::format("{} is given twice", in_quotes(item.text)), "remove one of the two");
  else
    list.push_back(x);
}

}  // namespace pmreport::scenario
