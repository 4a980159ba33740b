// The machine as a 3D model beside the report: what its pictures show, to be turned and played in the reader's own viewer.
#pragma once

#include <reports/document/report.hpp>
#include <reports/section/common/analysis.hpp>

namespace pmreport::section {

// "data/model.glb": at home; with a motion, animated through its samples that have a pose, 240 of them at most.
document::File model_file(const Analysis& a);

}  // namespace pmreport::section
