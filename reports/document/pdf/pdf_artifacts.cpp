#include <reports/document/pdf/pdf_artifacts.hpp>

#include <qpdf/Buffer.hh>
#include <qpdf/BufferInputSource.hh>
#include <qpdf/QPDFTokenizer.hh>

#include <memory>
#include <set>
#include <string_view>

namespace pmreport::document::pdf {

namespace {

// Operators that leave ink (ISO 32000-1, table 51), and those that begin and end what is marked.
const std::set<std::string_view> paints{"S", "s", "f", "F", "f*", "B", "B*", "b", "b*", "sh", "Do", "Tj", "TJ", "'", "\""};

}  // namespace

// A run of operators outside of marks becomes one artifact when it paints. Texts of ligatures are marked as well, without a number of their
// own: they belong to what they stand in.
std::string with_artifacts(const std::string& content) {
  std::string out, run;  // `run`: since the last mark of the structure
  bool run_paints = false;
  const auto close_run = [&] {
    if (run_paints && !out.empty()) out += '\n';
    out += run_paints ? "/Artifact BMC\n" + run + "\nEMC\n" : run;
    run.clear();
    run_paints = false;
  };
  const auto source = std::make_shared<BufferInputSource>("content", content);
  QPDFTokenizer tokenizer;
  tokenizer.allowEOF();
  tokenizer.includeIgnorable();
  int inside = 0, artifact = 0;  // depths of marks
  std::string operands;
  bool numbered = false;
  for (;;) {
    const QPDFTokenizer::Token token = tokenizer.readToken(source, "content", true);
    if (token.getType() == QPDFTokenizer::tt_eof) break;
    operands += token.getRawValue();
    if (token.getType() == QPDFTokenizer::tt_name && token.getValue() == "/MCID") numbered = true;
    if (token.getType() != QPDFTokenizer::tt_word) continue;
    const std::string& word = token.getValue();
    const bool begins = word == "BDC" || word == "BMC", ends = word == "EMC";
    if (inside == 0 && artifact == 0 && begins && numbered) {
      close_run();
      inside = 1;
      out += operands;
    } else if (inside > 0) {
      inside += begins - ends;
      out += operands;
    } else {
      artifact += begins - ends;
      if (paints.contains(word)) run_paints = true;
      run += operands;
    }
    operands.clear();
    numbered = false;
  }
  (inside > 0 ? out : run) += operands;
  close_run();
  return out;
}

void mark_decoration(QPDF& pdf, QPDFObjectHandle page) {
  std::string content;
  for (QPDFObjectHandle& part : page.getPageContents()) {
    const auto bytes = part.getStreamData(qpdf_dl_generalized);
    content.append(reinterpret_cast<const char*>(bytes->getBuffer()), bytes->getSize());
    content += '\n';
  }
  page.replaceKey("/Contents", QPDFObjectHandle::newStream(&pdf, with_artifacts(content)));
}

}  // namespace pmreport::document::pdf
