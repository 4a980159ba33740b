#include <core/scan/meaning.hpp>

namespace pmreport::scan {

std::uint64_t meaning_of(const program::Program& p) {
  chunks::Meaning m;
  m << p.inputs() << p.steps().size() << p.outputs().size();
  for (const program::Step& s : p.steps()) m << s.operation << s.a << s.b << s.c << s.constant;
  for (const int o : p.outputs()) m << o;
  return m.value();
}

std::uint64_t meaning_of(const PoseSet& set, const Scan& scan) {
  chunks::Meaning m;
  const auto add = [&m](const auto& list) {
    m << list.size();
    for (const auto& x : list) m << x;
  };
  m << meaning_of(set.margins) << set.late.size << set.late.every;
  add(set.rounding);
  add(scan.at);
  m << scan.points.size();
  for (const Axis& a : scan.points) m << a.input << a.from << a.to << a.count;
  add(scan.turned);
  m << scan.orientations.size();
  for (const auto& o : scan.orientations) add(o);
  return m.value();
}

}  // namespace pmreport::scan
