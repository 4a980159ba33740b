// Recordings that are none, or of another geometry: what needs them says why there is none, what does not works, and the suite tells.
#include <core/program/program.hpp>
#include <tests/mechanics/conformance/tilt_table.hpp>

using namespace pmreport;
using namespace pmreport::test;
using Catch::Contains;
using Catch::StartsWith;

namespace {

using Sound = Table<>;

// The sound table with another function that records.
struct Recording {
  pm_mechanism table = contract::mechanism<Sound>;
  explicit Recording(decltype(pm_mechanism::record) record) { table.record = record; }

  Machine machine() const { return Machine(table, default_values(describe(table))); }
  std::string why_none() const {
    std::string why = "there is one";
    const Machine m = machine();
    CHECK(m.pose(std::vector<double>{0.1, -0.1}).status == PM_OK);  // all else works
    m.program(&why);
    CHECK(m.program() == nullptr);
    return why;
  }
  Property property(const std::string& claim) const {
    for (const Property& p : check_properties(machine(), {20, 1}))
      if (p.claim == claim) return p;
    throw std::out_of_range(claim);
  }
};

const std::string values = "recording equals place and jacobian", rates = "recording has the same rates",
                  partials = "recording has the same partials";

// Records as the table does, and lets `spoil` change the list.
template <auto spoil>
pm_status spoiled(const pm_instance* p, pm_recording* out, pm_text* text) {
  const pm_status status = contract::record<Sound>(p, out, text);
  spoil(*out);
  return status;
}
// The first step of an operation.
pm_step& first(const pm_recording& list, pm_operation o) {
  for (std::size_t i = 0; i < list.count; ++i)
    if (list.steps[i].operation == o) return list.steps[i];
  throw std::out_of_range("no such step");
}

// A table that does something else with some kinds of numbers, as no author should: it turns further.
enum class Lies { when_recorded, on_jets, on_partials, throws };
template <Lies lies>
class Liar : public Mechanism<2> {
 public:
  static constexpr const char *name = "liar", *title = "tilt table", *source = "a test";
  static constexpr auto& parameters = Sound::parameters;
  explicit Liar(const Parameters& p) : sound_(p) {}
  Topology topology() const { return sound_.topology(); }
  template <class T>
  void place(const Coordinates<T>& q, Placement<T>& at) const {
    constexpr bool recording = std::is_same_v<T, Recorded>;
    if constexpr (lies == Lies::throws && recording) throw std::runtime_error("no pen");
    Coordinates<T> other = q;
    if constexpr (lies == Lies::when_recorded && recording) other[0] = other[0] + 1e-3;
    if constexpr (lies == Lies::on_jets && std::is_same_v<T, Jet<double>>) other[1] = Jet<double>(q[1].value, 1.01 * q[1].rate, 0);
    if constexpr (lies == Lies::on_partials && std::is_same_v<T, Partials<double, 2>>) other[1].partial[1] = 1.01;
    sound_.place(other, at);
  }
  template <class T>
  Matrix6<T> jacobian(const Placement<T>& at) const {
    return sound_.jacobian(at);
  }

 private:
  Sound sound_;
};
template <Lies lies>
Property property_of_liar(const std::string& claim) {
  const pm_mechanism& table = contract::mechanism<Liar<lies>>;
  for (const Property& p : check_properties(Machine(table, default_values(describe(table))), {20, 1}))
    if (p.claim == claim) return p;
  throw std::out_of_range(claim);
}

}  // namespace

TEST_CASE("the table records what it computes") {
  const Recording sound(contract::record<Sound>);
  CHECK(sound.machine().program() != nullptr);
  for (const std::string& claim : {values, rates, partials}) {
    const Property p = sound.property(claim);
    CHECK(p.verdict() == Verdict::passed);
    CHECK(p.evaluations > 1000);  // numbers of a placement, of some poses
  }
}

TEST_CASE("a recording that is no program is told by its sentence, and fails the suite with it") {
  struct Evil {
    decltype(pm_mechanism::record) record;
    std::string why;
  };
  const Evil all[] = {
      {spoiled<[](pm_recording& list) { first(list, PM_OP_CONSTANT).constant = std::nan(""); }>,
       "records a constant that is not finite as step "},
      {spoiled<[](pm_recording& list) { list.count = 1000000; }>, "records 1000000 operations, more than the 65536 that are looked at"},
      {spoiled<[](pm_recording& list) { first(list, PM_OP_MULTIPLY).operation = PM_OP_AND; }>,
       "records a number in the place of a comparison as step "},
      {spoiled<[](pm_recording& list) { first(list, PM_OP_ADD).operation = PM_OP_LESS; }>,
       "records a comparison in the place of a number as step "},
      {spoiled<[](pm_recording& list) { first(list, PM_OP_SIN).a = static_cast<std::int32_t>(list.count - 1); }>,
       "records an operation on a step that is not before it as step "},
      {spoiled<[](pm_recording& list) { first(list, PM_OP_SIN).a = -1; }>, "records an operation on a step that is not before it as step "},
      {spoiled<[](pm_recording& list) { first(list, PM_OP_SIN).operation = 1234; }>,
       "records operation 1234, which this pmreport does not know"},
      {spoiled<[](pm_recording& list) { first(list, PM_OP_INPUT).a = 2; }>, "records coordinate 3 of 2 as step 1"},
      {spoiled<[](pm_recording& list) { list.outputs[3] = static_cast<std::int32_t>(list.count); }>, "records a result that no step gives"},
      {spoiled<[](pm_recording& list) { list.outputs[3] = -1; }>, "records a result that no step gives"},
      {[](const pm_instance*, pm_recording*, pm_text*) -> pm_status { return PM_OK; }, "records a result that no step gives"},
      {[](const pm_instance*, pm_recording*, pm_text* text) -> pm_status { return contract::say(text, "the pen broke"), PM_FAILED; },
       "cannot record its geometry: the pen broke"},
      {[](const pm_instance* p, pm_recording* out, pm_text* text) -> pm_status {
         static int calls = 0;
         const pm_status status = contract::record<Sound>(p, out, text);
         first(*out, PM_OP_CONSTANT).constant = ++calls;
         return status;
       },
       "records other operations at a second call"},
  };
  for (const Evil& evil : all) {
    CAPTURE(evil.why);
    const Recording recording(evil.record);
    CHECK_THAT(recording.why_none(), StartsWith("the mechanism " + evil.why));
    const Property failed = recording.property(values);
    CHECK(failed.verdict() == Verdict::failed);
    CHECK_THAT(failed.where, StartsWith("the mechanism " + evil.why));
    CHECK(recording.property(rates).verdict() == Verdict::not_examined);
    CHECK_THAT(recording.property(rates).unexamined, StartsWith("the mechanism " + evil.why));
  }
}

TEST_CASE("a list longer than the host's is not read beyond it") {
  const Recording endless([](const pm_instance*, pm_recording* out, pm_text*) -> pm_status {
    Recorded x = Recorded::input(*out, 0);
    for (int i = 0; i < 1000000; ++i) x = sin(x);
    for (int i = 0; i < 10; ++i) out->outputs[i] = 0;
    return PM_OK;
  });
  CHECK(endless.why_none() == "the mechanism records 1000001 operations, more than the 65536 that are looked at");
}

TEST_CASE("an exception while it records becomes the reason") {
  const pm_mechanism& table = contract::mechanism<Liar<Lies::throws>>;
  const Machine machine(table, default_values(describe(table)));
  std::string why;
  CHECK(machine.program(&why) == nullptr);
  CHECK(why == "the mechanism cannot record its geometry: no pen");
  CHECK(machine.home_pose().status == PM_OK);
}

TEST_CASE("a mechanism that does not offer to record is not examined, with the reason, and that is no fault") {
  const Recording none(nullptr);
  CHECK(none.why_none() == "the plugin was built before geometry was recorded (contract 1.3)");
  for (const std::string& claim : {values, rates, partials}) {
    const Property p = none.property(claim);
    CHECK(p.verdict() == Verdict::not_examined);
    CHECK(p.unexamined == "the plugin was built before geometry was recorded (contract 1.3)");
    CHECK(p.optional);
  }
  Recording short_table(contract::record<Sound>);
  short_table.table.struct_size = offsetof(pm_mechanism, record);
  CHECK(short_table.why_none() == "the plugin was built before geometry was recorded (contract 1.3)");
}

TEST_CASE("a recording of another geometry fails, and the number is named with what to look at") {
  const Recording scaled(spoiled<[](pm_recording& list) { first(list, PM_OP_SQRT).operation = PM_OP_ABS; }>);
  const Property p = scaled.property(values);
  CHECK(p.verdict() == Verdict::failed);
  CHECK_THAT(p.where, Contains("number ") && Contains(" at ") && Contains("it computes another thing when it is recorded"));
  CHECK(scaled.property(rates).verdict() == Verdict::failed);

  // The table turns by a milliradian more: the number farthest off is told, and home is as good a pose as any.
  const Property lied = property_of_liar<Lies::when_recorded>(values);
  CHECK(lied.verdict() == Verdict::failed);
  CHECK(lied.worst > 1e-4);
  CHECK_THAT(lied.where, Contains(" of ") && Contains(": it computes another thing when it is recorded; look for an if on the type of T"));
}

TEST_CASE("one number that is wrong is named") {
  // y of the centre of joint B1, a ball on the table's edge: x and y of it are exchanged in the recording.
  const Machine sound = Recording(contract::record<Sound>).machine();
  static std::size_t at = 0;
  for (std::size_t j = 0; j < sound.topology().joints.size(); ++j)
    if (sound.topology().joints[j].name == "B1") at = sound.layout().joint(static_cast<int>(j));
  REQUIRE(at > 0);
  const Recording one([](const pm_instance* p, pm_recording* out, pm_text* text) -> pm_status {
    const pm_status status = contract::record<Sound>(p, out, text);
    out->outputs[at + 1] = out->outputs[0];
    return status;
  });
  CHECK_THAT(one.property(values).where, StartsWith("number " + std::to_string(at + 1) + ": y of the centre of joint B1 at "));
}

TEST_CASE("rates that are computed in another way than the value are told") {
  CHECK(property_of_liar<Lies::on_jets>(values).verdict() == Verdict::passed);
  CHECK(property_of_liar<Lies::on_jets>(partials).verdict() == Verdict::passed);
  const Property jets = property_of_liar<Lies::on_jets>(rates);
  CHECK(jets.verdict() == Verdict::failed);
  CHECK_THAT(jets.where, Contains("its rates are computed in another way than its value; look for an if on the type of T"));
  CHECK(property_of_liar<Lies::on_partials>(rates).verdict() == Verdict::passed);
  CHECK(property_of_liar<Lies::on_partials>(partials).verdict() == Verdict::failed);
}
