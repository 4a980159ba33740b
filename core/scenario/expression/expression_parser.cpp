#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <core/scenario/expression/expression.hpp>
#include <core/text/text.hpp>
#include <numbers>
#include <optional>

namespace pmreport::scenario {
namespace {

constexpr std::size_t longest_text = 2000;  // [bytes]
constexpr int deepest_nest = 100;           // nested parentheses, signs and powers: the parser recurses
constexpr int largest_exponent = 20;        // of a dimension; far beyond any physical one

enum class Angles { none, any, taken, given };  // of a function: plain numbers only; any dimension; takes an angle; gives one

struct Function {
  std::string_view name;
  Operation operation;
  int arguments;
  Angles angles;
};
constexpr Function functions[] = {
    {"sin", Operation::sin, 1, Angles::taken},   {"cos", Operation::cos, 1, Angles::taken},   {"tan", Operation::tan, 1, Angles::taken},
    {"asin", Operation::asin, 1, Angles::given}, {"acos", Operation::acos, 1, Angles::given}, {"atan", Operation::atan, 1, Angles::given},
    {"atan2", Operation::atan2, 2, Angles::any}, {"sinh", Operation::sinh, 1, Angles::none},  {"cosh", Operation::cosh, 1, Angles::none},
    {"tanh", Operation::tanh, 1, Angles::none},  {"sqrt", Operation::sqrt, 1, Angles::any},   {"exp", Operation::exp, 1, Angles::none},
    {"log", Operation::log, 1, Angles::none},    {"abs", Operation::abs, 1, Angles::any},     {"min", Operation::min, 2, Angles::any},
    {"max", Operation::max, 2, Angles::any},     {"step5", Operation::step5, 3, Angles::any},
};
constexpr Dimension plain{}, angle{0, 0, 0, 1}, time_dimension{0, 0, 1, 0};

bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || c == '%' || static_cast<unsigned char>(c) >= 0x80;
}
bool is_digit(char c) { return c >= '0' && c <= '9'; }

}  // namespace

std::vector<std::string> expression_functions() {
  std::vector<std::string> out;
  for (const Function& f : functions) out.emplace_back(f.name);
  return out;
}

class ExpressionParser {
 public:
  ExpressionParser(std::string_view text, Time time, std::span<const Variable> variables)
      : text_(text), time_(time), variables_(variables) {}

  Expression parse() {
    if (text_.size() > longest_text)
      throw ExpressionError(0, fmt::format("expected at most {} characters, seen {}", longest_text, text_.size()));
    blank();
    if (at_end()) throw ExpressionError(0, "expected a quantity, seen an empty text");
    const Part whole = sum();
    if (!at_end()) throw ExpressionError(at_, "expected an operator (+ - * / ^) or the end, seen " + seen());
    out_.dimension_ = whole.dimension;
    return std::move(out_);
  }

 private:
  struct Part {  // of the expression: its last term, its dimension, where it starts
    int term;
    Dimension dimension;
    std::size_t start;
  };

  Part sum() {
    Part left = product();
    while (peek() == '+' || peek() == '-') {
      const bool plus = take() == '+';
      const Part right = product();
      if (left.dimension != right.dimension)
        throw ExpressionError(right.start,
                              plus ? fmt::format("cannot add {} and {}", name_of(left.dimension), name_of(right.dimension))
                                   : fmt::format("cannot subtract {} from {}", name_of(right.dimension), name_of(left.dimension)));
      left = {emit({plus ? Operation::add : Operation::subtract, left.term, right.term}), left.dimension, left.start};
    }
    return left;
  }

  Part product() {
    Part left = signed_power();
    while (peek() == '*' || peek() == '/') {
      const bool times = take() == '*';
      const Part right = signed_power();
      left = {emit({times ? Operation::multiply : Operation::divide, left.term, right.term}),
              bounded(times ? left.dimension * right.dimension : left.dimension / right.dimension, left.start), left.start};
    }
    return left;
  }

  Part signed_power() {
    const Depth depth(*this);
    if (peek() != '+' && peek() != '-') return power();
    const std::size_t start = at_;
    const bool negative = take() == '-';
    const Part x = signed_power();
    return {negative ? emit({Operation::negate, x.term}) : x.term, x.dimension, start};
  }

  Part power() {
    const Part base = measured();
    if (peek() != '^') return base;
    take();
    const std::size_t first_term = out_.terms_.size();
    const Part exponent = signed_power();
    if (exponent.dimension != plain)
      throw ExpressionError(exponent.start, "expected a plain number as the exponent, seen " + name_of(exponent.dimension));
    for (std::size_t i = first_term; i < out_.terms_.size(); ++i) {
      const Term& term = out_.terms_[i];
      if (term.operation == Operation::time || term.operation == Operation::variable)
        throw ExpressionError(exponent.start,
                              fmt::format("expected a constant exponent, seen one that depends on {}",
                                          term.operation == Operation::time ? "t" : variables_[static_cast<std::size_t>(term.a)].name),
                              "write exp(x*log(a)) for a to the power of x");
    }
    const double n = out_.at(0, std::vector<Jet<double>>(variables_.size())).value;  // the exponent's own terms name none of them
    out_.terms_.resize(first_term);
    Dimension dimension;
    if (base.dimension != plain) {
      if (!(std::abs(n) <= largest_exponent) || n != std::round(n))
        throw ExpressionError(exponent.start, fmt::format("expected a whole number as the exponent of {}, seen {}", name_of(base.dimension),
                                                          format_number(n, 6)));
      const int k = static_cast<int>(n);
      const Dimension& d = base.dimension;
      dimension = {d.length * k, d.mass * k, d.time * k, d.angle * k};
    }
    return {emit({Operation::power, base.term, -1, -1, n}), bounded(dimension, base.start), base.start};
  }

  Part measured() {
    const Part x = atom();
    const std::size_t start = at_;
    if (!could_be_measured_) return x;
    if (!starts_unit()) {
      require_known_unit();
      return x;
    }
    Unit unit{"", 1, {}};
    int sign = 1;
    for (;;) {
      unit_factor(unit, sign);
      const std::size_t operation = at_;
      if (peek() != '*' && peek() != '/') break;
      sign = take() == '*' ? 1 : -1;
      blank();
      if (word() == "t" || !starts_unit()) {  // the time, not the tonne
        at_ = operation;
        break;
      }
    }
    return {emit({Operation::multiply, x.term, constant(unit.factor)}), bounded(x.dimension * unit.dimension, start), x.start};
  }

  Part atom() {
    const Depth depth(*this);
    could_be_measured_ = true;
    blank();
    const std::size_t start = at_;
    if (at_end()) throw ExpressionError(start, "expected a number, a unit or a function, seen the end");
    if (is_digit(text_[at_]) || text_[at_] == '.') return {constant(number()), plain, start};
    if (text_[at_] == '(') {
      take();
      const Part inner = sum();
      close(start);
      could_be_measured_ = true;
      return {inner.term, inner.dimension, start};
    }
    if (!is_letter(text_[at_])) throw ExpressionError(start, "expected a number, a unit or a function, seen " + seen());
    const std::string_view name = word();
    if (name != "t" && starts_unit()) {
      Unit unit{"", 1, {}};
      unit_factor(unit, 1);
      could_be_measured_ = false;
      return {constant(unit.factor), unit.dimension, start};
    }
    at_ += name.size();
    if (peek() == '(') return call(name, start);
    could_be_measured_ = false;
    if (name == "t" && time_ == Time::allowed) return {emit({Operation::time}), time_dimension, start};
    if (name == "pi") return {constant(std::numbers::pi), plain, start};
    for (std::size_t i = 0; i < variables_.size(); ++i)
      if (variables_[i].name == name) return {emit({Operation::variable, static_cast<int>(i)}), variables_[i].dimension, start};
    throw unknown(name, start);
  }

  Part call(std::string_view name, std::size_t start) {
    const auto* f = std::find_if(std::begin(functions), std::end(functions), [&](const Function& x) { return x.name == name; });
    if (f == std::end(functions))
      throw ExpressionError(start, "unknown function " + in_quotes(name) + did_you_mean(name, expression_functions()),
                            "the functions are " + listed(expression_functions(), "and"));
    const std::size_t parenthesis = at_;
    take();
    std::vector<Part> arguments{sum()};
    while (peek() == ',') {
      take();
      arguments.push_back(sum());
    }
    close(parenthesis);
    if (arguments.size() != static_cast<std::size_t>(f->arguments))
      throw ExpressionError(
          start, fmt::format("{} takes {} argument{}, seen {}", name, f->arguments, f->arguments == 1 ? "" : "s", arguments.size()));
    could_be_measured_ = true;
    Term term{f->operation, arguments[0].term};
    if (arguments.size() > 1) term.b = arguments[1].term;
    if (arguments.size() > 2) term.c = arguments[2].term;
    return {emit(term), result(*f, arguments), start};
  }

  // The dimension that a function gives; throws where its arguments have the wrong one.
  Dimension result(const Function& f, const std::vector<Part>& arguments) {
    const Part& x = arguments[0];
    for (const Part& other : arguments)
      if (other.dimension != x.dimension)
        throw ExpressionError(other.start, fmt::format("{} compares like with like: expected {} as before, seen {}", f.name,
                                                       name_of(x.dimension), name_of(other.dimension)));
    if (f.operation == Operation::sqrt) {
      const Dimension& d = x.dimension;
      if (d.length % 2 != 0 || d.mass % 2 != 0 || d.time % 2 != 0 || d.angle % 2 != 0)
        throw ExpressionError(x.start, "expected a square under the root, seen " + name_of(d));
      return {d.length / 2, d.mass / 2, d.time / 2, d.angle / 2};
    }
    if (f.operation == Operation::atan2) return angle;
    if (f.operation == Operation::step5) return plain;
    if (f.angles == Angles::any) return x.dimension;
    if (x.dimension != plain && !(f.angles == Angles::taken && x.dimension == angle))
      throw ExpressionError(
          x.start,
          fmt::format("{} takes {}a plain number, seen {}", f.name, f.angles == Angles::taken ? "an angle or " : "", name_of(x.dimension)),
          x.dimension == time_dimension ? "divide it by a time: t/10 s" : "");
    return f.angles == Angles::given ? angle : plain;
  }

  double number() {
    double value = 0;
    const char *first = text_.data() + at_, *last = text_.data() + text_.size();
    const auto [end, error] = std::from_chars(first, last, value);
    if (error == std::errc::result_out_of_range) throw ExpressionError(at_, "a number beyond the range of numbers");
    if (error != std::errc{}) throw ExpressionError(at_, "expected a number, seen " + seen());
    at_ += static_cast<std::size_t>(end - first);
    if (!at_end() && (text_[at_] == '.' || (text_[at_] == ',' && at_ + 1 < text_.size() && is_digit(text_[at_ + 1]) && parentheses_ == 0)))
      throw ExpressionError(at_, "expected a number with one decimal point, seen " + seen(), "the decimal sign is a point: 0.5");
    return value;
  }

  void unit_factor(Unit& unit, int sign) {
    const std::string_view symbol = word();
    const Unit factor = *parse_unit(symbol);
    at_ += symbol.size();
    int exponent = 1;
    if (peek() == '^') {
      const std::size_t hat = at_;
      take();
      blank();
      const auto [end, error] = std::from_chars(text_.data() + at_, text_.data() + text_.size(), exponent);
      if (error != std::errc{} || std::abs(exponent) > largest_exponent)
        throw ExpressionError(
            at_, fmt::format("expected a whole number from {} to {} as the exponent of {}", -largest_exponent, largest_exponent, symbol));
      at_ = static_cast<std::size_t>(end - text_.data());
      if (!at_end() && text_[at_] == '.')
        throw ExpressionError(hat + 1, fmt::format("expected a whole number as the exponent of {}", symbol));
    }
    const int k = sign * exponent;
    const Dimension& d = factor.dimension;
    unit.factor *= std::pow(factor.factor, k);
    unit.dimension = bounded(unit.dimension * Dimension{d.length * k, d.mass * k, d.time * k, d.angle * k}, at_);
  }

  // A unit symbol that is not the variable t and not a function, as min is both.
  bool starts_unit() {
    blank();
    const std::string_view symbol = word();
    if (symbol.empty() || (symbol == "t" && time_ == Time::allowed) || !parse_unit(symbol)) return false;
    std::size_t after = at_ + symbol.size();
    while (after < text_.size() && text_[after] == ' ') ++after;
    return after >= text_.size() || text_[after] != '(';
  }

  // "12 furlong": where a word follows a number, a unit was meant, unless it is the name of something else.
  void require_known_unit() const {
    const std::string_view name = word();
    const auto is_name = [&](const auto& x) { return x.name == name; };
    if (name.empty() || name == "t" || name == "pi" || parse_unit(name)) return;
    if (std::any_of(std::begin(functions), std::end(functions), is_name) || std::any_of(variables_.begin(), variables_.end(), is_name))
      return;
    // "m2": an exponent without its sign.
    const std::string_view stem = name.substr(0, name.find_first_of("0123456789"));
    const std::string meant = stem.size() < name.size() && parse_unit(stem)
                                  ? "; did you mean " + in_quotes(fmt::format("{}^{}", stem, name.substr(stem.size()))) + "?"
                                  : did_you_mean(name, unit_symbols());
    throw ExpressionError(at_, fmt::format("unknown unit {}{}", in_quotes(name), meant), "the units are " + listed(unit_symbols(), "and"));
  }

  // Letters, and digits after the first of them (atan2).
  std::string_view word() const {
    std::size_t end = at_;
    while (end < text_.size() && (is_letter(text_[end]) || (end > at_ && is_digit(text_[end])))) ++end;
    return text_.substr(at_, end - at_);
  }

  ExpressionError unknown(std::string_view name, std::size_t start) const {
    if (name == "nan" || name == "inf" || name == "infinity") return {start, fmt::format("expected a finite number, seen {}", name)};
    if (name == "t") return {start, "expected a constant quantity, seen one that depends on t"};
    if (const auto* f = std::find_if(std::begin(functions), std::end(functions), [&](const Function& x) { return x.name == name; });
        f != std::end(functions))
      return {start, fmt::format("expected \"(\" after the function {}", name)};
    std::vector<std::string> known = unit_symbols();
    for (std::string& f : expression_functions()) known.push_back(std::move(f));
    known.emplace_back("pi");
    std::vector<std::string> own;
    for (const Variable& v : variables_) own.push_back(v.name);
    known.insert(known.begin(), own.begin(), own.end());
    return {start, "unknown unit or name " + in_quotes(name) + did_you_mean(name, known),
            (own.empty() ? "" : "the quantities are t, " + listed(own, "and") + "; ") + "the units are " + listed(unit_symbols(), "and")};
  }

  void close(std::size_t opened) {
    if (peek() != ')')
      throw ExpressionError(
          at_, fmt::format("expected \")\" for the \"(\" at character {}, seen {}", characters(text_.substr(0, opened)) + 1, seen()));
    take();
  }

  Dimension bounded(const Dimension& d, std::size_t where) const {
    for (const int exponent : {d.length, d.mass, d.time, d.angle})
      if (std::abs(exponent) > largest_exponent) throw ExpressionError(where, "a dimension beyond all that is physical: " + name_of(d));
    return d;
  }

  std::string seen() const {
    if (at_end()) return "the end";
    const std::string_view name = word();
    if (!name.empty()) return in_quotes(name);
    return in_quotes(text_.substr(at_, 1));
  }

  // Every nested call of the parser; it shall end before the stack does.
  struct Depth {
    explicit Depth(ExpressionParser& p) : parser(p) {
      if (++parser.depth_ > deepest_nest) throw ExpressionError(parser.at_, fmt::format("expected at most {} nested parts", deepest_nest));
    }
    ~Depth() { --parser.depth_; }
    Depth(const Depth&) = delete;
    Depth& operator=(const Depth&) = delete;
    ExpressionParser& parser;
  };

  void blank() {
    while (at_ < text_.size() && text_[at_] == ' ') ++at_;
  }
  bool at_end() const { return at_ >= text_.size(); }
  char peek() {
    blank();
    return at_end() ? '\0' : text_[at_];
  }
  char take() {
    const char c = text_[at_++];
    parentheses_ += c == '(' ? 1 : c == ')' ? -1 : 0;
    return c;
  }
  int emit(Term term) {
    out_.terms_.push_back(term);
    return static_cast<int>(out_.terms_.size()) - 1;
  }
  int constant(double value) { return emit({Operation::constant, -1, -1, -1, value}); }

  std::string_view text_;
  Time time_;
  std::span<const Variable> variables_;
  std::size_t at_ = 0;
  int depth_ = 0, parentheses_ = 0;
  bool could_be_measured_ = false;  // the last atom was a number or closed a parenthesis: units may follow
  Expression out_;
};

Expression Expression::parse(std::string_view text, Time time, std::span<const Variable> variables) {
  return ExpressionParser(text, time, variables).parse();
}

}  // namespace pmreport::scenario
