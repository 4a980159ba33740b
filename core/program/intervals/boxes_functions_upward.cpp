#include <core/program/intervals/boxes_block.hpp>
#include <core/program/intervals/interval_ends.hpp>

namespace pmreport::program {

namespace {

template <class F>
void each(const BoxInstruction& i, const BoxRegisters& r, std::size_t boxes, F&& f) {
  double* target = r.at(i.target);
  const double *a = r.at(i.a), *b = r.at(i.b);
  for (std::size_t k = 0; k < boxes; ++k) {
    const Ends x = f(Ends{a[k], a[r.pitch + k]}, Ends{b[k], b[r.pitch + k]});
    target[k] = x.negative_low;
    target[r.pitch + k] = x.high;
  }
}

}  // namespace

void run_function(const BoxInstruction& i, const BoxRegisters& r, std::size_t boxes) {
  switch (i.operation) {
    case Operation::tan:
      return each(i, r, boxes, [](const Ends& a, const Ends&) { return ends::tan(a); });
    case Operation::asin:
      return each(i, r, boxes, [](const Ends& a, const Ends&) { return ends::asin(a); });
    case Operation::acos:
      return each(i, r, boxes, [](const Ends& a, const Ends&) { return ends::acos(a); });
    case Operation::atan2:
      return each(i, r, boxes, [](const Ends& a, const Ends& b) { return ends::atan2(a, b); });
    default:  // the others are run_block's
      return;
  }
}

}  // namespace pmreport::program
