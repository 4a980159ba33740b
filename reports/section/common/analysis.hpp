// What every section reads: the analysis of the run, under its own names.
#pragma once

#include <core/analysis/analysis.hpp>

namespace pmreport::section {

using analysis::Analysis;
using analysis::Column;
using analysis::column_of;
using analysis::ColumnId;
using analysis::ColumnList;
using analysis::Crossing;
using analysis::LimitBreach;
using analysis::Measure;
using analysis::OfActuator;
using analysis::OfJoint;
using analysis::OfMachine;
using analysis::OfMotion;
using analysis::Outcome;
using analysis::Progress;
using analysis::SampleRun;
using analysis::Worst;
using mechanics::Indeterminate;

}  // namespace pmreport::section
