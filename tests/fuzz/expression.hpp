// What holds for every text, however mad: it is an expression, or refused with a reason and a place.
#pragma once

#include <core/scenario/expression/expression.hpp>

#include <string>

namespace fuzz {

inline std::string broken_by_expression(const std::string& text) {
  using namespace pmreport::scenario;
  for (const Time time : {Time::allowed, Time::forbidden}) {
    try {
      const Expression e = Expression::parse(text, time);
      (void)e.at(0);
      (void)e.at(0.37);
      (void)pmreport::name_of(e.dimension());
    } catch (const ExpressionError& e) {
      if (e.offset > text.size()) return "a mistake beyond the end of the text";
      if (std::string(e.what()).empty()) return "a refusal without a reason";
    }
  }
  return {};
}

}  // namespace fuzz
