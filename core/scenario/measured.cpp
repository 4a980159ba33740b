#include <fmt/format.h>

#include <algorithm>
#include <core/scenario/section/section_part.hpp>
#include <core/text/digits.hpp>
#include <core/text/text.hpp>

namespace pmreport::scenario {
namespace {

const std::vector<std::string> reductions{"min", "max", "rms", "at"};
constexpr const char* forms = "write max(abs(actuator_force)), min(l1), rms(x_rate), at(l1, 2.5 s) or mobility.freedoms";

struct Piece {  // of the text
  std::string_view text;
  std::size_t offset = 0;
};

Piece piece(const std::string& whole, std::size_t begin, std::size_t end) {
  const std::string_view raw = std::string_view(whole).substr(begin, end - begin), text = trim(raw);
  return {text, text.empty() ? begin : static_cast<std::size_t>(text.data() - whole.data())};
}

// What stands in "name( ... )", parts without blanks around them.
struct Call {
  Piece name, inside;
};
Call call(const std::string& whole, const Piece& p) {
  const std::size_t open = p.text.find('(');
  if (open == std::string_view::npos || p.text.back() != ')')
    throw ExpressionError(p.offset, fmt::format("expected a reduction of a column, seen {}", in_quotes(p.text)), forms);
  return {piece(whole, p.offset, p.offset + open), piece(whole, p.offset + open + 1, p.offset + p.text.size() - 1)};
}

// "max(abs(actuator_force))" or "at(l1, 2.5 s)": the reduction goes to `measured`; where its parts stand is returned.
struct Parts {
  Piece column, time;  // column: or a group of columns
};
Parts parse_that(const std::string& that, Measured& measured) {
  const Call outer = call(that, piece(that, 0, that.size()));
  measured.reduction = outer.name.text;
  if (std::find(reductions.begin(), reductions.end(), measured.reduction) == reductions.end())
    throw ExpressionError(outer.name.offset,
                          fmt::format("expected {}, seen {}{}", listed(reductions, "or"), in_quotes(measured.reduction),
                                      did_you_mean(measured.reduction, reductions)),
                          forms);
  Piece inside = outer.inside, time{};
  if (measured.reduction == "at") {
    const std::size_t comma = inside.text.rfind(',');
    if (comma == std::string_view::npos)
      throw ExpressionError(inside.offset + inside.text.size(), "expected a comma and a time (e.g. \"at(l1, 2.5 s)\")");
    time = piece(that, inside.offset + comma + 1, inside.offset + inside.text.size());
    inside = piece(that, inside.offset, inside.offset + comma);
    try {
      const Expression t = Expression::parse(time.text, Time::forbidden);
      if (t.dimension() != Dimension{0, 0, 1, 0})
        throw ExpressionError(0, fmt::format("expected a time (e.g. \"2.5 s\"), seen {}", name_of(t.dimension())));
      measured.time = t.at(0).value;
    } catch (const ExpressionError& e) {
      throw ExpressionError(time.offset + e.offset, e.what(), e.hint);
    }
  }
  if (inside.text.find('(') == std::string_view::npos) return {inside, time};
  const Call absolute = call(that, inside);
  if (absolute.name.text != "abs")
    throw ExpressionError(absolute.name.offset, fmt::format("expected abs or a column, seen {}", in_quotes(absolute.name.text)), forms);
  measured.absolute = true;
  return {absolute.inside, time};
}

// `what`, which is of a motion, needs one.
void need_motion_of(std::size_t offset, std::string_view what, const Measurable& measurable) {
  if (measurable.span && measurable.span->empty())
    throw ExpressionError(offset, fmt::format("{} is of a motion, and this scenario has none", in_quotes(what)),
                          "add [motion], duration = \"10 s\" and samples = 501");
}

// Finds the columns of a name: a column or a group of a section that the report has.
void resolve(const Piece& name, const Measurable& measurable, const Topology& topology, Measured& measured) {
  std::vector<std::string> known, groups;
  bool mixed = false;
  for (const SectionKind* kind : measurable.kinds) {
    if (kind->columns == nullptr) continue;
    const bool requested = std::any_of(measurable.sections.begin(), measurable.sections.end(),
                                       [&](const Section& s) { return s.kind == kind || s.kind == nullptr; });
    for (const Column& column : kind->columns(topology)) {
      const bool meant = column.name == name.text || column.group == name.text;
      if (meant && !requested) {
        throw ExpressionError(
            name.offset,
            fmt::format("{} belongs to the section {}, which this scenario does not have", in_quotes(name.text), in_quotes(kind->name)),
            fmt::format("add [[section]] and kind = \"{}\"", kind->name));
      }
      known.push_back(column.name);
      if (std::find(groups.begin(), groups.end(), column.group) == groups.end()) groups.push_back(column.group);
      if (!meant) continue;
      mixed = mixed || (!measured.columns.empty() && column.unit != measured.unit);
      measured.columns.push_back(column.name);
      measured.unit = column.unit;
    }
  }
  known.insert(known.end(), groups.begin(), groups.end());
  if (measured.columns.empty())
    throw ExpressionError(
        name.offset, fmt::format("no column or group is called {}{}", in_quotes(name.text), did_you_mean(name.text, known)),
        fmt::format("the groups of columns are {}; a single column is called as in the data files", listed(groups, "and")));
  need_motion_of(name.offset, name.text, measurable);
  if (mixed)
    throw ExpressionError(name.offset, fmt::format("the columns of {} have different units", in_quotes(name.text)),
                          fmt::format("name one of them: {}", listed(measured.columns, "or")));
}

// The kinds that have quantities: those about the mechanism and its poses first, then those about forces in motion.
std::vector<const SectionKind*> with_quantities(Kinds kinds) {
  std::vector<const SectionKind*> out;
  for (const bool forces : {false, true})
    for (const SectionKind* kind : kinds)
      if (kind->quantities != nullptr && kind->needs.dynamics == forces) out.push_back(kind);
  return out;
}

// Its quantities where none of its keys stands.
std::vector<Quantity> plain_quantities(const SectionKind& kind) {
  const std::shared_ptr<Options> options = kind.make_options != nullptr ? kind.make_options() : nullptr;
  return kind.quantities(options.get());
}

// Those of all sections of the kind, as their keys make them; the plain ones where a section whose kind is not known may be the first of
// them. Nothing: there is no such section.
std::optional<std::vector<Quantity>> quantities_of(const SectionKind& kind, const std::vector<Section>& sections) {
  std::optional<std::vector<Quantity>> out;
  for (const Section& s : sections) {
    if (s.kind == nullptr && !out) return plain_quantities(kind);
    if (s.kind != &kind) continue;
    if (!out) out.emplace();
    for (Quantity& q : kind.quantities(s.options.get())) out->push_back(std::move(q));
  }
  return out;
}

// Finds a quantity that a section names, "mobility.redundant".
void resolve_quantity(const std::string& that, const Measurable& measurable, Measured& measured) {
  const std::string prefix = that.substr(0, that.find('.'));
  std::vector<std::string> all, known, own;  // own: of the kind that `prefix` names
  bool unread = false;
  for (const SectionKind* kind : with_quantities(measurable.kinds)) {
    all.push_back(kind->name);
    const std::optional<std::vector<Quantity>> asked = quantities_of(*kind, measurable.sections);
    const bool missing = !asked;
    // Without its section nobody knows what its keys would have said: all that it could ever have is found, the plain ones are told.
    const std::vector<Quantity> quantities = missing ? kind->quantities(nullptr) : *asked;
    // The keys of such a section may name more than can be read of them without its mechanism, which is told already.
    unread = unread || (kind->name == prefix && !missing && !measurable.topology);
    if (kind->name == prefix)
      for (const Quantity& q : missing ? plain_quantities(*kind) : quantities) own.push_back(q.name);
    for (const Quantity& q : quantities) {
      known.push_back(q.name);
      if (q.name != that) continue;
      if (missing)
        throw ExpressionError(
            0, fmt::format("{} belongs to the section {}, which this scenario does not have", in_quotes(that), in_quotes(kind->name)),
            fmt::format("add [[section]] and kind = \"{}\"", kind->name));
      if (q.of_motion) need_motion_of(0, that, measurable);
      measured.quantity = q.name;
      measured.unit = q.unit;
      measured.count = q.count;
      return;
    }
  }
  if (unread) return;
  throw ExpressionError(0, fmt::format("no quantity is called {}{}", in_quotes(that), did_you_mean(that, known)),
                        own.empty() ? fmt::format("the sections with quantities are {}", listed(all, "and"))
                                    : fmt::format("the quantities of {} are {}", prefix, listed(own, "and")));
}

// Leaves out what this scenario leaves empty, as the kinds know it.
void narrow(const Measurable& measurable, std::size_t offset, Measured& measured) {
  for (const SectionKind* kind : measurable.kinds)
    if (kind->narrow != nullptr) kind->narrow(measurable, offset, measured);
}

// A name with a point in it and no reduction around it.
bool names_quantity(std::string_view text) { return text.find('(') == std::string_view::npos && text.find('.') != std::string_view::npos; }

}  // namespace

std::optional<Measured> read_measured(const Value& value, const Measurable& measurable, const Reader& reader) {
  const auto text = reader.text(value);
  if (!text) return std::nullopt;
  Measured out;
  out.that = *text;
  try {
    if (names_quantity(*text)) {
      resolve_quantity(std::string(trim(*text)), measurable, out);
      narrow(measurable, 0, out);
      return out;
    }
    const auto [name, time] = parse_that(*text, out);
    const auto& span = measurable.span;
    if (out.reduction == "at" && span && !span->empty() && !(out.time >= span->begin && out.time <= span->end))
      throw ExpressionError(time.offset,
                            fmt::format("expected a time within the motion, {} s to {} s, seen {} s", format_number(span->begin, 6),
                                        format_number(span->end, 6), format_outside(out.time, span->begin, span->end, 6)));
    if (measurable.topology) {
      resolve(name, measurable, *measurable.topology, out);
      narrow(measurable, name.offset, out);
    }
  } catch (const ExpressionError& e) {
    reader.refuse(value, e);
    return std::nullopt;
  }
  return out;
}

bool judged(const Measured& m) { return !m.quantity.empty() || !m.columns.empty(); }

}  // namespace pmreport::scenario
