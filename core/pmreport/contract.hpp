// The plugin's side of the contract: what an author wrote with mechanism.hpp, as the tables of plugin.h. No author needs to read this.
#pragma once

#include <pmreport/plugin.h>
#include <pmreport/jet.hpp>
#include <pmreport/lanes.hpp>
#include <pmreport/parameter.hpp>
#include <pmreport/partials.hpp>
#include <pmreport/placement.hpp>
#include <pmreport/recorded.hpp>
#include <pmreport/topology.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstdio>
#include <exception>
#include <numbers>
#include <stdexcept>
#include <utility>
#include <vector>

namespace pmreport::contract {

inline void say(pm_text* text, const char* sentence) noexcept {
  if (text != nullptr && text->data != nullptr && text->capacity > 0) std::snprintf(text->data, text->capacity, "%s", sentence);
}

// Runs `f` and turns every exception into a status and a sentence: none may cross.
template <class F>
pm_status guard(pm_text* text, F&& f) noexcept {
  try {
    return f();
  } catch (const std::invalid_argument& e) {
    say(text, e.what());
    return PM_BAD_ARGUMENT;
  } catch (const std::exception& e) {
    say(text, e.what());
    return PM_FAILED;
  } catch (...) {
    say(text, "an exception that is not a std::exception");
    return PM_FAILED;
  }
}

template <class T>
pm_list list(const std::vector<T>& items) {
  return {items.data(), items.size(), sizeof(T)};
}

// A mechanism with all that it declared, in the contract's structs.
template <class M>
struct Instance {
  M mechanism;
  Topology topology;
  Layout layout;
  std::vector<pm_coordinate> coordinates;
  std::vector<pm_body> bodies;
  std::vector<pm_joint> joints;
  std::vector<pm_actuator> actuators;
  std::vector<pm_derived> derived;
  std::vector<pm_constraint> constraints;
  std::vector<pm_inertia> inertias;
  std::vector<pm_shape> shapes;
  std::vector<pm_matrix> matrices;
  std::vector<pm_reading> readings;
  std::vector<pm_element> elements;

  explicit Instance(const Parameters& p) : mechanism(p), topology(mechanism.topology()), layout(topology) {
    const Topology& t = topology;
    for (const auto& c : t.coordinates)
      coordinates.push_back({c.name.c_str(), c.title.c_str(), c.unit.c_str(), c.home, c.box.min, c.box.max});
    for (const auto& b : t.bodies) {
      bodies.push_back({b.name.c_str(), b.slender ? 1 : 0, b.limb});
      pm_inertia i{b.inertia.mass, {}, {}};
      for (int r = 0; r < 3; ++r) {
        i.centre[r] = b.inertia.centre(r);
        for (int c = 0; c < 3; ++c) i.inertia[3 * r + c] = b.inertia.about_centre(r, c);
      }
      inertias.push_back(i);
    }
    for (const auto& j : t.joints) {
      pm_joint o{j.name.c_str(),
                 static_cast<pm_joint_kind>(j.kind),
                 j.a,
                 j.b,
                 {},
                 {},
                 j.stud >= 0         ? j.stud
                 : j.b == t.platform ? j.a
                                     : j.b,
                 {j.from.x(), j.from.y(), j.from.z()}};
      const double free = j.kind == JointKind::prismatic ? 10.0 : std::numbers::pi;
      for (std::size_t k = 0; k < 2; ++k) {
        o.min[k] = k < j.limits.size() ? j.limits[k].min : j.kind == JointKind::spherical ? 0.0 : -free;
        o.max[k] = k < j.limits.size() ? j.limits[k].max : free;
      }
      joints.push_back(o);
    }
    for (const auto& a : t.actuators)
      actuators.push_back({a.name.c_str(), a.title.c_str(), a.unit.c_str(), a.joint, a.stroke.min, a.stroke.max});
    for (const auto& d : t.derived) derived.push_back({d.name.c_str(), d.title.c_str(), d.unit.c_str(), d.dependent ? 1 : 0});
    for (const auto& c : t.constraints) constraints.push_back({c.name.c_str(), c.title.c_str(), c.unit.c_str()});
    for (const auto& s : t.shapes) {
      pm_shape o{s.body, static_cast<pm_shape_kind>(s.kind), {}, {}, s.radius};
      for (int k = 0; k < 3; ++k) o.a[k] = s.a(k), o.b[k] = s.b(k);
      shapes.push_back(o);
    }
    for (const auto& e : t.elements)
      elements.push_back({e.name.c_str(),
                          e.title.c_str(),
                          static_cast<pm_element_kind>(e.kind),
                          e.from,
                          e.to,
                          e.beside,
                          e.actuator,
                          e.material.modulus,
                          e.material.shear_modulus,
                          e.material.expansion,
                          e.section.area,
                          {e.section.bending[0], e.section.bending[1]},
                          e.section.torsion,
                          static_cast<pm_bending>(e.bends),
                          e.buckling_length,
                          e.offset,
                          {e.stiffness[0], e.stiffness[1], e.stiffness[2], e.stiffness[3]}});
    for (const auto& r : t.readings) readings.push_back({r.name.c_str(), r.title.c_str(), r.unit.c_str()});
    for (const auto& m : t.matrices)
      matrices.push_back({m.name.c_str(), m.title.c_str(), static_cast<std::size_t>(m.rows), static_cast<std::size_t>(m.columns),
                          m.relation, static_cast<pm_rates>(m.acts_on), static_cast<pm_rates>(m.gives)});
  }
};

// Reads coordinate i of pose k. Partials are seeded here; every other scalar comes whole from the host.
template <class T>
struct Coordinate {
  static T load(const double* in, std::size_t i, std::size_t count, std::size_t k) {
    return Codec<T>::load(in + i * Codec<T>::components * count + k, count);
  }
};
template <class S, int M>
struct Coordinate<Partials<S, M>> {
  static Partials<S, M> load(const double* in, std::size_t i, std::size_t count, std::size_t k) {
    return Partials<S, M>::variable(Codec<S>::load(in + i * count + k, count), static_cast<int>(i));
  }
};

// The functions of the contract for mechanism M.
template <class M>
struct Functions {
  using Self = Instance<M>;
  static const Self& self(const pm_instance* p) { return *reinterpret_cast<const Self*>(p); }

  static pm_status create(const pm_value* values, std::size_t count, pm_instance** out, pm_text* text) noexcept {
    return guard(text, [&] {
      if (count != std::size(M::parameters)) throw std::invalid_argument("the number of values differs from the number of parameters");
      *out = reinterpret_cast<pm_instance*>(new Self(Parameters(M::parameters, {values, count})));
      return PM_OK;
    });
  }
  static void destroy(pm_instance* p) noexcept { delete reinterpret_cast<Self*>(p); }

  static pm_status topology(const pm_instance* p, pm_topology* out, pm_text* text) noexcept {
    return guard(text, [&] {
      const Self& s = self(p);
      *out = {sizeof(pm_topology), list(s.coordinates), list(s.bodies),      list(s.joints),
              list(s.actuators),   list(s.derived),     s.topology.platform, s.topology.idle};
      return PM_OK;
    });
  }
  template <auto member>
  static pm_status listing(const pm_instance* p, pm_list* out, pm_text* text) noexcept {
    return guard(text, [&] { return *out = list(self(p).*member), PM_OK; });
  }

  // Calls f<T>(k) for every pose: in lanes as far as the poses fill them; the last group reaches back over poses already done.
  template <class Single, class Wide, class F>
  static pm_status sweep(std::size_t count, F&& f) {
    constexpr std::size_t width = Lanes::width;
    if (count >= width && count > 1) {
      for (std::size_t k = 0; k + width <= count; k += width) f.template operator()<Wide>(k);
      if (count % width != 0) f.template operator()<Wide>(count - width);
    } else {
      for (std::size_t k = 0; k < count; ++k) f.template operator()<Single>(k);
    }
    return PM_OK;
  }
  template <class F>
  static pm_status in_order(pm_order order, std::size_t count, F&& f) {
    switch (order) {
      case PM_VALUE:
        return sweep<double, Lanes>(count, f);
      case PM_JET:
        return sweep<Jet<double>, Jet<Lanes>>(count, f);
      case PM_PARTIALS:
        return sweep<Partials<double, M::dof>, Partials<Lanes, M::dof>>(count, f);
      case PM_EXTENDED:
        throw std::invalid_argument("the recording serves extended precision");
      default:
        throw std::invalid_argument("unknown order of scalars");
    }
  }

  static pm_status place(const pm_instance* p, pm_order order, std::size_t count, const double* in, double* out, pm_text* text) noexcept {
    return guard(text, [&] {
      const Self& s = self(p);
      const char* why = nullptr;
      in_order(order, count, [&]<class T>(std::size_t k) {
        typename M::template Coordinates<T> q;
        for (std::size_t i = 0; i < q.size(); ++i) q[i] = Coordinate<T>::load(in, i, count, k);
        Placement<T> at(out + k, count, s.layout);
        s.mechanism.place(q, at);
        why = at.why();
      });
      if (count != 1 || out[0] >= 0) return PM_OK;
      if (std::isnan(out[0])) return say(text, "the reach of the placement is not a number"), PM_SINGULAR;
      say(text, why != nullptr ? why : "out of reach");
      return PM_UNREACHABLE;
    });
  }
  static pm_status jacobian(const pm_instance* p, pm_order order, std::size_t count, const double* in, double* out,
                            pm_text* text) noexcept {
    return guard(text, [&] {
      const Self& s = self(p);
      return in_order(order, count, [&]<class T>(std::size_t k) {
        const Placement<T> at(in + k, count, s.layout);
        const Matrix6<T> g = s.mechanism.jacobian(at);
        for (std::size_t e = 0; e < 36; ++e)
          Codec<T>::store(out + e * Codec<T>::components * count + k, count, g(static_cast<int>(e / 6), static_cast<int>(e % 6)));
      });
    });
  }
};

// The geometry as a list of operations: `place` and `jacobian` on a scalar that writes down what is done with it.
template <class M>
pm_status record(const pm_instance* p, pm_recording* out, pm_text* text) noexcept {
  return guard(text, [&] {
    const Instance<M>& s = Functions<M>::self(p);
    out->count = 0;
    typename M::template Coordinates<Recorded> q;
    for (std::size_t i = 0; i < q.size(); ++i) q[i] = Recorded::input(*out, static_cast<int>(i));
    std::vector<double> numbers(s.layout.size() * Codec<Recorded>::components);
    Placement<Recorded> at(numbers.data(), 1, s.layout);
    s.mechanism.place(q, at);
    const Matrix6<Recorded> g = s.mechanism.jacobian(Placement<Recorded>(std::as_const(numbers).data(), 1, s.layout));
    std::int32_t* output = out->outputs;
    for (std::size_t i = 0; i < s.layout.size(); ++i)
      *output++ = Codec<Recorded>::load(numbers.data() + i * Codec<Recorded>::components, 1).step(*out);
    for (int e = 0; e < 36; ++e) *output++ = g(e / 6, e % 6).step(*out);
    return PM_OK;
  });
}

// Mechanisms whose author brings matrices of the source, or readings.
template <class M>
concept HasMatrices = requires(const M& m, const typename M::template Coordinates<double>& q, const Placement<double>& at) {
  { m.matrices(q, at) } -> std::same_as<std::vector<Eigen::MatrixXd>>;
};
template <class M>
concept HasReadings = requires(const M& m, const typename M::template Coordinates<double>& q, const Placement<double>& at) {
  { m.readings(q, at) } -> std::same_as<std::vector<double>>;
};

template <class M>
struct ClosedForms {
  using Self = Instance<M>;

  // Calls f(mechanism, coordinates, placement) at the pose that the host gives.
  template <class F>
  static auto at_pose(const Self& s, const double* coordinates, const double* placement, F&& f) {
    typename M::template Coordinates<double> q;
    std::copy_n(coordinates, q.size(), q.begin());
    return f(s.mechanism, q, Placement<double>(placement, 1, s.layout));
  }

  static pm_status evaluate(const pm_instance* p, const double* coordinates, const double* placement, double* out, pm_text* text) noexcept {
    return guard(text, [&] {
      const Self& s = Functions<M>::self(p);
      std::vector<Eigen::MatrixXd> all;
      if constexpr (HasMatrices<M>)
        all = at_pose(s, coordinates, placement, [](const M& m, const auto& q, const auto& at) { return m.matrices(q, at); });
      if (all.size() != s.matrices.size()) throw std::logic_error("the number of matrices differs from what the topology declares");
      for (std::size_t i = 0; i < all.size(); ++i) {
        const auto rows = static_cast<Eigen::Index>(s.matrices[i].rows), columns = static_cast<Eigen::Index>(s.matrices[i].columns);
        if (all[i].rows() != rows || all[i].cols() != columns)
          throw std::logic_error("matrix " + s.topology.matrices[i].name + " has another size than the topology declares");
        for (Eigen::Index r = 0; r < rows; ++r)
          for (Eigen::Index c = 0; c < columns; ++c) *out++ = all[i](r, c);
      }
      return PM_OK;
    });
  }

  static pm_status read(const pm_instance* p, const double* coordinates, const double* placement, double* out, pm_text* text) noexcept {
    return guard(text, [&] {
      const Self& s = Functions<M>::self(p);
      std::vector<double> all;
      if constexpr (HasReadings<M>)
        all = at_pose(s, coordinates, placement, [](const M& m, const auto& q, const auto& at) { return m.readings(q, at); });
      if (all.size() != s.readings.size()) throw std::logic_error("the number of readings differs from what the topology declares");
      std::ranges::copy(all, out);
      return PM_OK;
    });
  }

  static constexpr pm_closed_forms table{sizeof(pm_closed_forms), Functions<M>::template listing<&Instance<M>::matrices>, evaluate,
                                         Functions<M>::template listing<&Instance<M>::readings>, read};
};

template <class M>
inline constexpr auto parameter_infos = [] {
  std::array<pm_parameter, std::size(M::parameters)> out{};
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = info(M::parameters[i]);
  return out;
}();

template <class M>
inline constexpr pm_kinematics kinematics{sizeof(pm_kinematics), Functions<M>::topology, Functions<M>::place};
template <class M>
inline constexpr pm_statics statics{sizeof(pm_statics), Functions<M>::template listing<&Instance<M>::constraints>, Functions<M>::jacobian};
template <class M>
inline constexpr pm_dynamics dynamics{sizeof(pm_dynamics), Functions<M>::template listing<&Instance<M>::inertias>};
template <class M>
inline constexpr pm_elasticity elasticity{sizeof(pm_elasticity), Functions<M>::template listing<&Instance<M>::elements>};
template <class M>
inline constexpr pm_appearance appearance{sizeof(pm_appearance), Functions<M>::template listing<&Instance<M>::shapes>};

template <class M>
inline constexpr pm_mechanism mechanism{sizeof(pm_mechanism),
                                        M::name,
                                        M::title,
                                        M::source,
                                        M::dof,
                                        {parameter_infos<M>.data(), parameter_infos<M>.size(), sizeof(pm_parameter)},
                                        Functions<M>::create,
                                        Functions<M>::destroy,
                                        &kinematics<M>,
                                        &statics<M>,
                                        &dynamics<M>,
                                        &appearance<M>,
                                        &ClosedForms<M>::table,
                                        record<M>,
                                        &elasticity<M>};

template <class... M>
inline constexpr std::array<const pm_mechanism*, sizeof...(M)> mechanisms{&mechanism<M>...};

}  // namespace pmreport::contract
