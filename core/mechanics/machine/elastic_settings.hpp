// What a scenario says of the parts that give way, beside what the mechanism declares.
#pragma once

#include <core/linear/types.hpp>
#include <pmreport/topology.hpp>

#include <optional>
#include <string>
#include <vector>

namespace pmreport::mechanics {

struct ElasticSettings {
  std::vector<Element> added;      // one of a name that is declared takes its place
  std::vector<std::string> rigid;  // names of those that do not give
  std::vector<ElementKind> rigid_kinds;
  std::optional<Bending> bends;      // of all beams
  std::optional<Material> material;  // of all beams and rails that the mechanism declares
  std::vector<double> drives;        // stiffness by actuator, as long as these or empty; NaN: as declared [N/m], [N m/rad]
  // Compliances: of the platform between its joints and the reference point, in its axes about that point; of what the base stands on, in
  // base axes about the origin. Translations and rotations by forces and moments. Zero: rigid.
  linear::Matrix6d platform = linear::Matrix6d::Zero(), base = linear::Matrix6d::Zero();
  double warmer = 0;                                    // of all beams and rails, than when they were measured [K]
  std::vector<std::pair<std::string, double>> misfits;  // by the name of the element: how much longer it is than it should be [m], [rad]
};

// The elements of a mechanism under these settings, those that are rigid left out. The topology has those that it declares.
std::vector<Element> elements_under(const ElasticSettings& settings, const Topology& declared);

// What is wrong with an element of a mechanism: a sentence that names it, or nothing.
std::string fault_of(const Element& element, const Topology& topology);

// What loads a beam, from its root on: joints and the bodies between them, joint k before body k. Empty: no chain of bodies leads from one
// joint to the other without base and platform.
struct BeamPath {
  std::vector<int> joints, bodies;  // one joint more than bodies
};
BeamPath path_of(const Topology& topology, int from, int to);

}  // namespace pmreport::mechanics
