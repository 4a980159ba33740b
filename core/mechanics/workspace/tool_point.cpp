#include <core/mechanics/workspace/tool_point.hpp>

#include <core/program/batches.hpp>
#include <core/program/evaluate.hpp>
#include <core/program/recorder.hpp>

#include <fmt/format.h>

#include <array>
#include <memory>

namespace pmreport::mechanics {

namespace {

// Which coordinates are those of the reference point.
std::optional<std::array<int, 3>> coordinates_of_place(const program::Program& program, std::size_t first) {
  std::array<int, 3> out{};
  for (std::size_t k = 0; k < 3; ++k) {
    const program::Step& s = program.steps()[static_cast<std::size_t>(program.outputs()[first + k])];
    if (s.operation != program::Operation::input) return std::nullopt;
    out[k] = s.a;
  }
  return out;
}

std::vector<double> evaluated(const program::Program& program, std::span<const double> in) {
  std::vector<double> out(program.outputs().size());
  program::Evaluator<double>(program).run(in, out);
  return out;
}

}  // namespace

std::optional<ToolPoint> ToolPoint::of(const Machine& machine, const Eigen::Vector3d& at, std::string* why) {
  const program::Program* program = machine.program(why);
  if (program == nullptr) return std::nullopt;
  const int platform = machine.topology().platform;
  const std::size_t place = machine.layout().body(platform), rotation = place + 3;
  const auto refuse = [&](const std::string& sentence) {
    if (why != nullptr) *why = sentence;
    return std::nullopt;
  };
  const auto moved = coordinates_of_place(*program, place);
  if (!moved)
    return refuse(fmt::format("the coordinates of {} do not tell the place of the platform's reference point", machine.info().name));
  std::vector<int> turns(9);
  for (std::size_t e = 0; e < 9; ++e) turns[e] = static_cast<int>(rotation + e);
  const program::Program rotations = program->slice(turns);
  std::uint64_t by_place = 0;
  for (const int i : *moved) by_place |= std::uint64_t{1} << i;
  const std::vector<std::uint64_t> dependence = rotations.dependence();
  for (const int o : rotations.outputs())
    if ((dependence[static_cast<std::size_t>(o)] & by_place) != 0)
      return refuse(fmt::format("the platform of {} turns with the place of its reference point", machine.info().name));

  ToolPoint out;
  out.at_ = at;
  for (const bool back : {true, false}) {
    program::Recorder recorder(rotations);
    std::vector<Recorded> q;
    for (int i = 0; i < machine.dof(); ++i) q.push_back(recorder.input(i));
    for (std::size_t r = 0; r < 3; ++r) {
      Recorded arm(0.0);
      for (std::size_t c = 0; c < 3; ++c) arm += recorder.output(static_cast<int>(3 * r + c)) * at(static_cast<Eigen::Index>(c));
      Recorded& x = q[static_cast<std::size_t>((*moved)[r])];
      x = back ? x - arm : x + arm;
    }
    (back ? out.to_machine_ : out.to_tool_) = recorder.finish(q);
  }
  return out;
}

std::vector<double> ToolPoint::machine_pose(std::span<const double> by_tool) const { return evaluated(to_machine_, by_tool); }
std::vector<double> ToolPoint::by_tool(std::span<const double> machine_pose) const { return evaluated(to_tool_, machine_pose); }

ToolPoint::Judge ToolPoint::of_tool(Judge of_machine) const {
  if (!of_machine) return of_machine;
  return [batches = std::make_shared<program::Batches>(to_machine_), judge = std::move(of_machine)](std::size_t count, const double* poses,
                                                                                                    double* out) {
    std::vector<double> moved(batches->program().outputs().size() * count);
    batches->run(count, poses, moved.data());
    judge(count, moved.data(), out);
  };
}

program::Guided ToolPoint::of_tool(const program::Guided& of_machine) const {
  // Guides go through as they are.
  program::Recorder recorder(program::Program(to_machine_.steps(), of_machine.program.inputs(), to_machine_.outputs()));
  std::vector<Recorded> inputs;
  for (int o = 0; o < static_cast<int>(to_machine_.outputs().size()); ++o) inputs.push_back(recorder.output(o));
  for (int i = to_machine_.inputs(); i < of_machine.program.inputs(); ++i) inputs.push_back(recorder.input(i));
  return {program::composed(of_machine.program, recorder.finish(inputs)), of_machine.guides, of_tool(of_machine.choose)};
}

}  // namespace pmreport::mechanics
