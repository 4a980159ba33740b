// Every single fault in a table that is otherwise sound is found and told.
#include <array>
#include <catch2/catch.hpp>
#include <core/host/plugin_file.hpp>
#include <core/host/plugin_table.hpp>
#include <core/numbers.hpp>
#include <cstring>
#include <functional>
#include <limits>
#include <tests/fuzz/corpus.hpp>
#include <tests/fuzz/plugin_table.hpp>

using pmreport::infinity;
using pmreport::host::PluginError;
using pmreport::host::require_sound;

namespace {

pm_status create(const pm_value*, std::size_t, pm_instance**, pm_text*) { return PM_FAILED; }
void destroy(pm_instance*) {}
pm_status topology(const pm_instance*, pm_topology*, pm_text*) { return PM_FAILED; }
pm_status numbers(const pm_instance*, pm_order, std::size_t, const double*, double*, pm_text*) { return PM_FAILED; }
pm_status at_pose(const pm_instance*, const double*, const double*, double*, pm_text*) { return PM_FAILED; }
pm_status listing(const pm_instance*, pm_list*, pm_text*) { return PM_FAILED; }

// A sound table with one parameter of each kind, of which a test spoils one part.
struct Table {
  std::array<double, 1> radius{0.4};
  std::array<double, 3> axis{0, 0, 1};
  std::array<double, 1> word{1};
  std::array<const char*, 2> words{"x", "y"};
  std::array<pm_parameter, 3> parameters{{
      {"base_radius", "radius", "m", "mm", PM_NUMBER, radius.data(), 1, 0.01, 100, 1, 1, nullptr, 0, 0, nullptr},
      {"axis", "axis", "", "", PM_NUMBERS, axis.data(), 3, -1, 1, 3, 6, nullptr, 0, 0, nullptr},
      {"dependent", "which", "", "", PM_CHOICE, word.data(), 1, 0, 1, 1, 1, words.data(), 2, 0, nullptr},
  }};
  pm_kinematics kinematics{sizeof(pm_kinematics), topology, numbers};
  pm_statics statics{sizeof(pm_statics), listing, numbers};
  pm_dynamics dynamics{sizeof(pm_dynamics), listing};
  pm_appearance appearance{sizeof(pm_appearance), listing};
  pm_closed_forms closed_forms{sizeof(pm_closed_forms), listing, at_pose, listing, at_pose};
  pm_elasticity elasticity{sizeof(pm_elasticity), listing};
  pm_mechanism mechanism{sizeof(pm_mechanism),
                         "4sps-spr",
                         "title",
                         "source",
                         5,
                         {parameters.data(), parameters.size(), sizeof(pm_parameter)},
                         create,
                         destroy,
                         &kinematics,
                         &statics,
                         &dynamics,
                         &appearance,
                         &closed_forms,
                         nullptr,
                         &elasticity};
  pm_mechanism second = mechanism;
  std::array<const pm_mechanism*, 2> mechanisms{&mechanism, &second};
  pm_plugin_table table{sizeof(pm_plugin_table), PM_ABI_MAJOR, PM_ABI_MINOR, "test", 1, mechanisms.data()};

  Table() = default;
  Table(const Table&) = delete;
  Table& operator=(const Table&) = delete;
  pm_parameter& number() { return parameters[0]; }
  pm_parameter& list() { return parameters[1]; }
  pm_parameter& choice() { return parameters[2]; }
};

std::string judgement(const Table& t) {
  try {
    require_sound(t.table, "p.so");
  } catch (const PluginError& error) {
    return error.what();
  }
  return "sound";
}

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

}  // namespace

TEST_CASE("a table without a fault is sound, with or without what is optional") {
  Table t;
  CHECK(judgement(t) == "sound");
  t.mechanism.appearance = nullptr;
  t.mechanism.closed_forms = nullptr;
  t.mechanism.elasticity = nullptr;
  t.mechanism.parameters = {nullptr, 0, 0};
  CHECK(judgement(t) == "sound");
}

TEST_CASE("a mechanism of version 1.0, which ends before the closed forms, is sound, and what follows it is not read") {
  Table t;
  t.mechanism.struct_size = offsetof(pm_mechanism, closed_forms);
  t.mechanism.closed_forms = reinterpret_cast<const pm_closed_forms*>(1);  // would crash whoever looks
  CHECK(judgement(t) == "sound");
}

TEST_CASE("a mechanism of version 1.2, which ends before what records, is sound, and what follows it is not read") {
  Table t;
  t.mechanism.struct_size = offsetof(pm_mechanism, record);
  CHECK(judgement(t) == "sound");
}

TEST_CASE("a mechanism of version 1.3, which ends before its elastic elements, is sound, and what follows it is not read") {
  Table t;
  t.mechanism.struct_size = offsetof(pm_mechanism, elasticity);
  t.mechanism.elasticity = reinterpret_cast<const pm_elasticity*>(1);  // would crash whoever looks
  CHECK(judgement(t) == "sound");
}

TEST_CASE("a parameter may give way to another, and in version 1.1, which does not know that, what follows is not read") {
  Table t;
  t.number().unless = "axis";
  CHECK(judgement(t) == "sound");
  struct Shorter {
    char bytes[offsetof(pm_parameter, unless)];
  };
  std::array<Shorter, 3> shorter{};
  for (std::size_t i = 0; i < 3; ++i) std::memcpy(&shorter[i], &t.parameters[i], sizeof(Shorter));
  t.mechanism.parameters = {shorter.data(), shorter.size(), sizeof(Shorter)};
  CHECK(judgement(t) == "sound");
}

TEST_CASE("structs that have grown at their end are sound") {
  Table t;
  t.table.struct_size += 8;
  t.mechanism.struct_size += 16;
  t.kinematics.struct_size += 8;
  struct Longer {
    pm_parameter known;
    double unknown;
  };
  std::array<Longer, 3> longer{{{t.parameters[0], 1}, {t.parameters[1], 2}, {t.parameters[2], 3}}};
  t.mechanism.parameters = {longer.data(), longer.size(), sizeof(Longer)};
  CHECK(judgement(t) == "sound");
  longer[2].known.name = "Not A Name";
  CHECK(judgement(t).find("'Not A Name'") != std::string::npos);
}

TEST_CASE("one fault makes a table unsound, and the sentence names it") {
  struct Fault {
    const char* sentence;  // a part of it
    std::function<void(Table&)> spoil;
  };
  const Fault faults[] = {
      {"p.so: expected a plugin table of at least", [](Table& t) { t.table.struct_size = 8; }},
      {"a plugin table of at least", [](Table& t) { t.table.struct_size -= 1; }},
      {"expected a plugin for ABI 1.x, seen 3.4", [](Table& t) { t.table.abi_major = 3, t.table.abi_minor = 4; }},
      {"a build string, seen a null pointer", [](Table& t) { t.table.build = nullptr; }},
      {"at least one mechanism, seen none", [](Table& t) { t.table.mechanism_count = 0; }},
      {"a table of mechanisms, seen a null pointer", [](Table& t) { t.table.mechanisms = nullptr; }},
      {"mechanism 1: expected a table, seen a null pointer", [](Table& t) { t.mechanisms[0] = nullptr; }},
      {"mechanisms of different names, seen '4sps-spr' twice", [](Table& t) { t.table.mechanism_count = 2; }},
      {"mechanism 1: expected a table of at least", [](Table& t) { t.mechanism.struct_size = offsetof(pm_mechanism, closed_forms) - 1; }},
      {"a name of lower-case letters, digits and dashes, seen nothing", [](Table& t) { t.mechanism.name = nullptr; }},
      {"a name of lower-case letters, digits and dashes, seen ''", [](Table& t) { t.mechanism.name = ""; }},
      {"seen '4SPS'", [](Table& t) { t.mechanism.name = "4SPS"; }},
      {"seen '../x'", [](Table& t) { t.mechanism.name = "../x"; }},
      {"seen 'a\\x0ab'", [](Table& t) { t.mechanism.name = "a\nb"; }},
      {"mechanism '4sps-spr': expected a title", [](Table& t) { t.mechanism.title = nullptr; }},
      {"a source", [](Table& t) { t.mechanism.source = nullptr; }},
      {"1 to 6 degrees of freedom, seen 0", [](Table& t) { t.mechanism.dof = 0; }},
      {"1 to 6 degrees of freedom, seen 7", [](Table& t) { t.mechanism.dof = 7; }},
      {"the function create", [](Table& t) { t.mechanism.create = nullptr; }},
      {"the function destroy", [](Table& t) { t.mechanism.destroy = nullptr; }},
      {"the table kinematics, seen a null pointer", [](Table& t) { t.mechanism.kinematics = nullptr; }},
      {"the table kinematics of at least", [](Table& t) { t.kinematics.struct_size -= 1; }},
      {"the function kinematics.topology", [](Table& t) { t.kinematics.topology = nullptr; }},
      {"the function kinematics.place", [](Table& t) { t.kinematics.place = nullptr; }},
      {"the table statics, seen a null pointer", [](Table& t) { t.mechanism.statics = nullptr; }},
      {"the table statics of at least", [](Table& t) { t.statics.struct_size -= 1; }},
      {"the function statics.constraints", [](Table& t) { t.statics.constraints = nullptr; }},
      {"the function statics.jacobian", [](Table& t) { t.statics.jacobian = nullptr; }},
      {"the table dynamics, seen a null pointer", [](Table& t) { t.mechanism.dynamics = nullptr; }},
      {"the table dynamics of at least", [](Table& t) { t.dynamics.struct_size -= 1; }},
      {"the function dynamics.inertias", [](Table& t) { t.dynamics.inertias = nullptr; }},
      {"the table appearance of at least", [](Table& t) { t.appearance.struct_size -= 1; }},
      {"the table closed_forms of at least", [](Table& t) { t.closed_forms.struct_size -= 1; }},
      {"the function closed_forms.matrices", [](Table& t) { t.closed_forms.matrices = nullptr; }},
      {"the function closed_forms.evaluate", [](Table& t) { t.closed_forms.evaluate = nullptr; }},
      {"the function closed_forms.readings", [](Table& t) { t.closed_forms.readings = nullptr; }},
      {"the function closed_forms.read", [](Table& t) { t.closed_forms.read = nullptr; }},
      {"the table elasticity of at least", [](Table& t) { t.elasticity.struct_size -= 1; }},
      {"the function elasticity.elements", [](Table& t) { t.elasticity.elements = nullptr; }},
      {"the function appearance.shapes", [](Table& t) { t.appearance.shapes = nullptr; }},
      {"a list of parameters, seen a null pointer", [](Table& t) { t.mechanism.parameters.items = nullptr; }},
      {"a stride of the parameters of at least",
       [](Table& t) { t.mechanism.parameters.stride = offsetof(pm_parameter, working_mode) - 8; }},
      {"parameters at addresses that divide by 8, seen a stride of 129 bytes", [](Table& t) { t.mechanism.parameters.stride = 129; }},
      {"parameters at addresses that divide by 8",
       [](Table& t) { t.mechanism.parameters.items = reinterpret_cast<const char*>(t.parameters.data()) + 1; }},
      {"digits and underscores for parameter 2, seen nothing", [](Table& t) { t.list().name = nullptr; }},
      {"digits and underscores for parameter 2, seen 'base-radius'", [](Table& t) { t.list().name = "base-radius"; }},
      {"parameters of different names, seen 'base_radius' twice", [](Table& t) { t.list().name = "base_radius"; }},
      {"parameter 'base_radius': expected another parameter that stands in its place, seen 'points'",
       [](Table& t) { t.number().unless = "points"; }},
      {"parameter 'axis': expected another parameter that stands in its place, seen 'axis'", [](Table& t) { t.list().unless = "axis"; }},
      {"parameter 'axis': expected a title", [](Table& t) { t.list().title = nullptr; }},
      {"a unit", [](Table& t) { t.list().unit = nullptr; }},
      {"a display unit", [](Table& t) { t.list().display = nullptr; }},
      {"a kind of parameter that this pmreport knows (number, numbers, choice), seen kind 9", [](Table& t) { t.list().kind = 9; }},
      {"parameter 'base_radius': expected defaults: 1, seen 0", [](Table& t) { t.number().default_count = 0; }},
      {"defaults, seen a null pointer", [](Table& t) { t.number().defaults = nullptr; }},
      {"expected defaults from 0.01 to 100, seen 0.001", [](Table& t) { t.radius[0] = 0.001; }},
      {"expected defaults from 0.01 to 100, seen nan", [](Table& t) { t.radius[0] = not_a_number; }},
      {"a finite range, min first, seen 2 to 1", [](Table& t) { t.number().min = 2, t.number().max = 1; }},
      {"a finite range, min first, seen nan to 100", [](Table& t) { t.number().min = not_a_number; }},
      {"a finite range, min first, seen 0.01 to inf", [](Table& t) { t.number().max = infinity; }},
      {"parameter 'axis': expected defaults: 3 to 6, seen 2", [](Table& t) { t.list().default_count = 2; }},
      {"count_min no more than count_max, seen 3 and 2", [](Table& t) { t.list().count_max = 2; }},
      {"expected defaults from -1 to 1, seen 1.5", [](Table& t) { t.axis[2] = 1.5; }},
      {"parameter 'dependent': expected a list of choices, seen none", [](Table& t) { t.choice().choices = nullptr; }},
      {"a list of choices, seen none", [](Table& t) { t.choice().choice_count = 0; }},
      {"a word for choice 1, seen a null pointer", [](Table& t) { t.words[1] = nullptr; }},
      {"a default index from 0 to 1, seen 2", [](Table& t) { t.word[0] = 2; }},
      {"a default index from 0 to 1, seen 0.5", [](Table& t) { t.word[0] = 0.5; }},
      {"a default index from 0 to 1, seen nan", [](Table& t) { t.word[0] = not_a_number; }},
  };
  for (const Fault& fault : faults) {
    Table t;
    fault.spoil(t);
    const std::string sentence = judgement(t);
    CAPTURE(fault.sentence, sentence);
    CHECK(sentence.starts_with("p.so: "));
    CHECK(sentence.find(fault.sentence) != sentence.npos);
    CHECK(sentence.find('\n') == sentence.npos);
  }
}

TEST_CASE("no table of the fuzzer's corpus, and none made of them, breaks a promise") {
  fuzz::check_promises("plugin_table", fuzz::broken_by_plugin_table);
}
