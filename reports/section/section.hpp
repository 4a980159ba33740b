// The kinds of sections. Each turns the analysis into figures, tables, sentences and evidence; none opens a file.
#pragma once

#include <core/analysis/study/reduce.hpp>
#include <core/scenario/loaded.hpp>
#include <reports/document/report.hpp>
#include <reports/scene/studio.hpp>
#include <reports/section/common/analysis.hpp>

#include <limits>

namespace pmreport::section {

// Cameras shared by all pictures of a report: framed over the whole motion, so that pictures of one view compare.
class Stage {
 public:
  Stage(const Analysis& a, scene::Studio& studio);

  // A picture whose PNG is still being made.
  struct Ordered {
    document::Picture picture;
    std::future<std::string> png;
    document::Picture wait();
  };
  Ordered picture(int sample, const scenario::View& view, const scenario::SectionRequest& r, const std::string& id) const;
  // The same of the home pose; without path and load, which are of a motion.
  Ordered picture_at_home(const scenario::View& view, const scenario::SectionRequest& r, const std::string& id) const;
  Ordered portrait(const std::string& id) const;  // the home pose, with labels and frames
  // Any pose of a machine of this mechanism, framed by `bounds`: pictures that are to compare share them.
  Ordered picture(const mechanics::Machine& machine, const mechanics::Pose& pose, const scene::Extras& extras, const scene::Bounds& bounds,
                  const scenario::View& view, const std::string& id, const std::string& caption, const scene::Quality& quality) const;

 private:
  const Analysis& analysis_;
  scene::Studio& studio_;
  scene::Bounds bounds_;
  std::vector<Eigen::Vector3d> path_;
};

document::Section mechanism_section(const Analysis& a, const Stage& stage);
document::Section snapshots_section(const Analysis& a, const scenario::SectionRequest& r, const Stage& stage, const Progress& progress,
                                    int number);
document::Section displacement_section(const Analysis& a);
document::Section velocity_section(const Analysis& a);
document::Section acceleration_section(const Analysis& a);
document::Section statics_section(const Analysis& a);

// What a section gives besides itself: quantities by name (see quantities.hpp), data files, gates of its own.
struct Result {
  document::Section section;
  std::vector<document::Value> values;  // `section` the kind, `name` without it
  std::vector<document::Data> data;
  std::vector<document::Check> checks;
};
Result mobility_section(const Analysis& a, const scenario::SectionRequest& r);
Result singularity_section(const Analysis& a, const scenario::SectionRequest& r, const Stage& stage, const Progress& progress);
Result assembly_section(const Analysis& a, const scenario::SectionRequest& r, const Stage& stage, const Progress& progress);
Result classification_section();
Result dynamics_section(const Analysis& a, const scenario::SectionRequest& r);
Result drives_section(const Analysis& a);
Result reactions_section(const Analysis& a, const scenario::SectionRequest& r);
Result speed_section(const Analysis& a);
// `values`: those of all other sections.
Result comparison_section(const Analysis& a, const scenario::SectionRequest& r, const std::vector<document::Value>& values);

using analysis::Number;
// `largest`: of a group the largest column counts, else the smallest.
Number measure(const Analysis& a, const scenario::Measured& m, const std::vector<document::Value>& values, bool largest = true);

// Pose, limb lengths, rates, accelerations and forces on one page, when the scenario asks for enough of them.
std::vector<document::Section> overview_section(const Analysis& a);

// The [[check]] gates, and what every report demands: samples in reach, limits kept, no singular surface crossed.
std::vector<document::Check> evaluate_checks(const Analysis& a, const std::vector<document::Value>& values);

// The whole report. `build` is the plugin's, `version` the program's.
document::Report make_report(const scenario::Loaded& loaded, const std::string& version, const std::string& build,
                             const Progress& progress);

}  // namespace pmreport::section
