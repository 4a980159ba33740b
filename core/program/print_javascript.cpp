#include <core/program/print_javascript.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>
#include <vector>

namespace pmreport::program {

namespace {

// How tightly an expression holds together, as JavaScript ranks them: `a * b + c` needs no parentheses.
enum Tightness { choice, disjunction, conjunction, comparison, sum, product, sign, whole };

struct Expression {
  std::string text;
  Tightness tightness = whole;
  int depth = 0;  // of what stands inside one another
};

// Deeper expressions are cut by a name: parsers recurse.
constexpr int deepest = 24;
// A constant of no more characters than this is no longer than a name.
constexpr std::size_t short_constant = 4;

class Printer {
 public:
  explicit Printer(const Program& program) : program_(program), steps_(program.steps()), uses_(steps_.size()), printed_(steps_.size()) {
    for (const int o : program.outputs()) ++uses_[resolved(o)];
    for (std::size_t i = steps_.size(); i-- > 0;) {
      if (uses_[i] == 0) continue;
      const Step& s = steps_[i];
      const int operands[] = {s.a, s.b, s.c};
      for (int k = 0; k < operands_of(s.operation); ++k) uses_[resolved(operands[k])] += times_written(s.operation);
    }
  }

  std::string print() {
    for (std::size_t i = 0; i < steps_.size(); ++i)
      if (uses_[i] > 0 && !passes_on(steps_[i].operation)) printed_[i] = named(i, expression(steps_[i]));
    std::string out = "(x,y)=>{\n";
    if (!names_.empty()) out += "const " + names_ + ";\n";
    const std::span<const int> outputs = program_.outputs();
    for (std::size_t o = 0; o < outputs.size(); ++o) out += fmt::format("y[{}]={};\n", o, printed_[resolved(outputs[o])].text);
    out += "}";
    return needs_hypot_ ? "(hypot=>" + out + ")(" + javascript_hypot() + ")" : out;
  }

 private:
  static bool passes_on(Operation o) { return o == Operation::settled || o == Operation::uncut; }
  // What has these operands once in the program may have them twice in its text.
  static int times_written(Operation o) { return o == Operation::square || o == Operation::min || o == Operation::max ? 2 : 1; }

  // The step whose number this one is: of numbers the last operand of `settled` and `uncut` is passed on, whatever the others are.
  std::size_t resolved(int i) const {
    for (;;) {
      const Step& s = steps_[static_cast<std::size_t>(i)];
      if (!passes_on(s.operation)) return static_cast<std::size_t>(i);
      i = s.operation == Operation::settled ? s.b : s.c;
    }
  }
  const Expression& operand(int i) const { return printed_[resolved(i)]; }

  // An input always gets a name, so that outputs may take its place.
  Expression named(std::size_t i, Expression x) {
    const Operation o = steps_[i].operation;
    const bool shared = uses_[i] > 1 && (o != Operation::constant || x.text.size() > short_constant);
    if (o != Operation::input && !shared && x.depth < deepest) return x;
    const std::string name = fmt::format("v{}", count_++);
    names_ += fmt::format("{}{}={}", names_.empty() ? "" : ",\n", name, x.text);
    return {name, whole, 0};
  }

  // An operand inside an expression that holds its operands so tightly. A minus never meets another sign.
  std::string inside(const Expression& x, int least) const { return x.tightness < least ? "(" + x.text + ")" : x.text; }
  std::string behind(const Expression& x, int least) const {
    return x.text.front() == '-' && x.tightness >= least ? "(" + x.text + ")" : inside(x, least);
  }

  // Operations of one rank are taken from the left.
  Expression binary(const Step& s, const char* sign, Tightness tightness) const {
    const Expression &a = operand(s.a), &b = operand(s.b);
    return {inside(a, tightness) + sign + behind(b, tightness + 1), tightness, 1 + std::max(a.depth, b.depth)};
  }
  Expression call(const Step& s, std::string_view function) const {
    const Expression& a = operand(s.a);
    if (operands_of(s.operation) == 1) return {fmt::format("{}({})", function, a.text), whole, 1 + a.depth};
    const Expression& b = operand(s.b);
    return {fmt::format("{}({},{})", function, a.text, b.text), whole, 1 + std::max(a.depth, b.depth)};
  }
  static Expression chosen(const std::string& mask, const Expression& a, const Expression& b, int depth) {
    const auto branch = [](const Expression& x) { return x.tightness == choice ? "(" + x.text + ")" : x.text; };
    return {mask + "?" + branch(a) + ":" + branch(b), choice, 1 + std::max({depth, a.depth, b.depth})};
  }

  Expression expression(const Step& s) {
    switch (s.operation) {
      case Operation::constant: {
        std::string digits = fmt::format("{}", s.constant);  // as few as tell it from all others
        const bool negative = digits.front() == '-';
        return {std::move(digits), negative ? sign : whole};
      }
      case Operation::input:
        return {fmt::format("x[{}]", s.a)};
      case Operation::add:
        return binary(s, "+", sum);
      case Operation::subtract:
        return binary(s, "-", sum);
      case Operation::multiply:
        return binary(s, "*", product);
      case Operation::divide:
        return binary(s, "/", product);
      case Operation::square: {
        const Expression& a = operand(s.a);
        return {inside(a, sign) + "*" + behind(a, sign), product, 1 + a.depth};
      }
      case Operation::negate: {
        const Expression& a = operand(s.a);
        return {"-" + behind(a, sign), sign, 1 + a.depth};
      }
      case Operation::hypot:
        needs_hypot_ = true;
        return call(s, "hypot");
      case Operation::min:
      case Operation::max: {  // as smaller and larger choose, of numbers that do not compare the second or the first
        const Expression &a = operand(s.a), &b = operand(s.b);
        const std::string mask = inside(a, sum) + "<" + inside(b, sum);
        return s.operation == Operation::min ? chosen(mask, a, b, 1) : chosen(mask, b, a, 1);
      }
      case Operation::choose: {
        const Expression& mask = operand(s.a);
        return chosen(inside(mask, disjunction), operand(s.b), operand(s.c), mask.depth);
      }
      case Operation::less:
        return binary(s, "<", comparison);
      case Operation::both:
        return binary(s, "&&", conjunction);
      case Operation::either:
        return binary(s, "||", disjunction);
      case Operation::opposite: {
        const Expression& a = operand(s.a);
        return {"!" + inside(a, sign), sign, 1 + a.depth};
      }
      case Operation::settled:
      case Operation::uncut:
        return {};  // stand nowhere
      default:      // sqrt, sin, cos, tan, asin, acos, abs, atan2
        return call(s, fmt::format("Math.{}", name_of(s.operation)));
    }
  }

  const Program& program_;
  std::span<const Step> steps_;
  std::vector<int> uses_;
  std::vector<Expression> printed_;
  std::string names_;
  int count_ = 0;
  bool needs_hypot_ = false;
};

}  // namespace

std::string print_javascript(const Program& program) { return Printer(program).print(); }

// With h near the root of a^2 + b^2, Newton's step h + (a^2 + b^2 - h^2) / 2 h is off by little more than its rounding when the bracket is
// exact: each square is a double and what it was rounded by (Veltkamp's halves, Dekker's product), and the large parts cancel. Numbers
// whose squares leave the range are scaled by a power of two before and after.
std::string javascript_hypot() {
  return R"(((a,b)=>{
a=Math.abs(a);b=Math.abs(b);
if(a<b)[a,b]=[b,a];
if(!(a<Infinity&&b<Infinity))return a===Infinity||b===Infinity?Infinity:NaN;
if(b<=a*2**-54)return a+b;
const scale=a>2**500?2**-600:b<2**-450?2**600:1;
a*=scale;b*=scale;
const rest=(v,vv)=>{const t=134217729*v,h=t-(t-v),l=v-h;return h*h-vv+2*h*l+l*l};
const h=Math.sqrt(a*a+b*b),aa=a*a,bb=b*b,hh=h*h;
return(h+(aa-hh+bb+(rest(a,aa)-rest(h,hh)+rest(b,bb)))/(2*h))/scale;
}))";
}

}  // namespace pmreport::program
