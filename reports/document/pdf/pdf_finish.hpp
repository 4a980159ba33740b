// What Cairo 1.16 cannot write into a PDF, added to the finished file by libqpdf: the tree of the structure with its attributes, language
// and metadata, decoration told from content, and the data as attachments; and objects packed together.
#pragma once

#include <reports/document/pdf/pdf_structure.hpp>

#include <string>
#include <vector>

namespace pmreport::document::pdf {

struct Attachment {
  std::string name;   // "displacement.csv"
  std::string type;   // "text/csv"
  std::string title;  // what it is, a phrase
  std::string bytes;
};

struct Finishing {
  const Structure& structure;
  std::string title, author, creator;
  std::vector<Attachment> attachments;
  long long epoch;  // of the document's date [s since 1970]; negative: it has none
};

// The same bytes for the same input. Throws OutputError when the drawn file does not hold what `structure` says.
std::string finished(const std::string& drawn, const Finishing& f);

// A drawing that stands alone, its many small objects (of each shaded bar a handful) packed together: a third smaller, and otherwise the
// same. The same bytes for the same input. Throws OutputError for what is no PDF.
std::string packed(const std::string& drawn);

}  // namespace pmreport::document::pdf
