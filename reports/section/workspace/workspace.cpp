#include <reports/section/workspace/workspace.hpp>

#include <core/analysis/workspace/answers.hpp>
#include <core/text/text.hpp>
#include <reports/section/common/words/words.hpp>
#include <reports/section/workspace/motion_in_it.hpp>

#include <fmt/format.h>

namespace pmreport::section {

using document::Paragraph;

Result workspace_section(const Context& context, const WorkspaceOptions& options) {
  const mechanics::Machine& machine = context.analysis.machine();
  Result out;
  const std::string id =
      options.name.empty() ? context.number == 1 ? "workspace" : fmt::format("workspace-{}", context.number) : "workspace-" + options.name;
  document::Section& s = out.section = {id, "workspace", options.name.empty() ? "Workspace" : "Workspace: " + options.name, {}};
  Workspace w;
  try {
    analysis::WorkspaceRequest request = options.request;
    request.name = id;
    w = analysis::workspace(machine, request, context.progress);
  } catch (const analysis::NoProgram& e) {
    s.blocks.push_back(Paragraph{Paragraph::Tone::warning, fmt::format("The workspace was not examined: {}.", e.what())});
    s.blocks.push_back(
        document::Proof{{document::Evidence::not_examined("Where the mechanism reaches", "scanned by its recorded geometry", e.what())}});
    return out;
  }
  for (Paragraph& p : workspace_words(w, machine)) s.blocks.push_back(std::move(p));
  s.blocks.push_back(workspace_volumes(w));
  if (document::Table extent = workspace_extent(w, machine); !extent.rows.empty()) s.blocks.push_back(std::move(extent));
  Drawn drawn = draw_workspace(context, w, options, id);
  for (document::Block& b : drawn.blocks) s.blocks.push_back(std::move(b));
  Drawn motion = motion_in_workspace(context.analysis, w, id);
  for (document::Block& b : motion.blocks) s.blocks.push_back(std::move(b));
  if (document::Table reasons = workspace_reasons(w); !reasons.rows.empty()) s.blocks.push_back(std::move(reasons));
  if (document::Table safe = safe_limits(w, machine); !safe.rows.empty()) s.blocks.push_back(std::move(safe));
  s.blocks.push_back(workspace_proof(w, machine));
  if (std::string sentence = workspace_summary(w, options.name); !sentence.empty())
    out.findings.push_back({document::Finding::Kind::result, std::move(sentence)});
  if (const std::vector<std::string> cut = analysis::WorkspaceAnswers(w).cut_off(machine.topology()); !cut.empty())
    out.findings.push_back(
        {document::Finding::Kind::surprise,
         fmt::format("{}: the scan ends in {} before the workspace does, and a wider one finds more.", s.title, listed(cut, "and"))});
  out.values = workspace_values(w, machine, options);
  out.data = std::move(drawn.data);
  out.data.insert(out.data.begin(), workspace_counts(w, id));
  for (document::Data& d : motion.data) out.data.push_back(std::move(d));
  out.files = std::move(drawn.files);
  return out;
}

}  // namespace pmreport::section
