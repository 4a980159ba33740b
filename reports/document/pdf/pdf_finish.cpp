#include <reports/document/pdf/pdf_date.hpp>
#include <reports/document/pdf/pdf_finish.hpp>
#include <reports/document/pdf/pdf_page.hpp>
#include <reports/document/text.hpp>
#include <reports/document/write.hpp>

#include <fmt/format.h>

#include <qpdf/QPDF.hh>
#include <qpdf/QPDFEFStreamObjectHelper.hh>
#include <qpdf/QPDFEmbeddedFileDocumentHelper.hh>
#include <qpdf/QPDFFileSpecObjectHelper.hh>
#include <qpdf/QPDFPageDocumentHelper.hh>
#include <qpdf/QPDFWriter.hh>

#include <map>
#include <new>
#include <reports/document/pdf/pdf_artifacts.hpp>

namespace pmreport::document::pdf {

namespace {

using Object = QPDFObjectHandle;

Object name(const std::string& text) { return Object::newName("/" + text); }

// Elements of Cairo's tree that hold content, in the order in which they were drawn. Its one group is the document.
void collect_contents(Object element, std::vector<Object>& contents) {
  Object kids = element.getKey("/K");
  bool grouping = false;
  const auto visit = [&](Object kid) {
    if (kid.isDictionary() && kid.hasKey("/S")) {
      grouping = true;
      collect_contents(kid, contents);
    }
  };
  if (kids.isArray())
    for (Object kid : kids.getArrayAsVector()) visit(kid);
  else
    visit(kids);
  if (!grouping && element.hasKey("/S") && !element.getKey("/S").isNameAndEquals("/Document")) contents.push_back(element);
}

// A kid of Cairo's as one that stands on its own: an identifier of marked content is counted within its page.
Object own_kid(Object kid, Object page) {
  if (!kid.isInteger()) return kid;
  Object reference = Object::newDictionary();
  reference.replaceKey("/Type", name("MCR"));
  reference.replaceKey("/Pg", page);
  reference.replaceKey("/MCID", kid);
  return reference;
}

class Tree {
 public:
  Tree(QPDF& pdf, const Structure& structure) : pdf_(pdf), root_(pdf.getRoot().getKey("/StructTreeRoot")) {
    std::vector<Object> contents;
    collect_contents(root_, contents);
    if (contents.size() != structure.marked().size())
      throw OutputError(fmt::format("report.pdf: {} parts were marked, and Cairo wrote {}", structure.marked().size(), contents.size()));
    document_ = new_element("Document", root_);
    for (const Element& e : structure.elements()) {
      Object parent = e.parent < 0 ? document_ : elements_[static_cast<std::size_t>(e.parent)];
      Object made = new_element(e.role, parent);
      describe(made, e);
      kids_of(parent).appendItem(made);
      elements_.push_back(made);
    }
    for (std::size_t i = 0; i < contents.size(); ++i) adopt(contents[i], structure, static_cast<std::size_t>(structure.marked()[i]));
    redirect_parents();
    root_.replaceKey("/K", document_);
  }

 private:
  Object new_element(const std::string& role, Object parent) {
    Object e = Object::newDictionary();
    e.replaceKey("/Type", name("StructElem"));
    e.replaceKey("/S", name(role));
    e.replaceKey("/P", parent);
    return pdf_.makeIndirectObject(e);
  }

  Object kids_of(Object element) {
    if (!element.hasKey("/K")) element.replaceKey("/K", Object::newArray());
    return element.getKey("/K");
  }

  static void describe(Object element, const Element& e) {
    if (!e.alternative.empty()) element.replaceKey("/Alt", Object::newUnicodeString(e.alternative));
    if (e.place) {
      Object attributes = Object::newDictionary();
      attributes.replaceKey("/O", name("Layout"));
      const Box& b = *e.place;
      attributes.replaceKey("/BBox",
                            Object::newArray(Object::Rectangle(b.x, paper_height - b.y - b.height, b.x + b.width, paper_height - b.y)));
      element.replaceKey("/A", attributes);
    }
    if (e.scope == Scope::none) return;
    Object attributes = Object::newDictionary();
    attributes.replaceKey("/O", name("Table"));
    attributes.replaceKey("/Scope", name(e.scope == Scope::column ? "Column" : "Row"));
    element.replaceKey("/A", attributes);
  }

  void adopt(Object content, const Structure& structure, std::size_t element) {
    const Element& e = structure.elements()[element];
    if (!content.getKey("/S").isNameAndEquals(std::string("/") + e.role))
      throw OutputError(fmt::format("report.pdf: a part marked as {} is written as {}", e.role, content.getKey("/S").getName()));
    Object page = content.getKey("/Pg"), kids = content.getKey("/K"), mine = kids_of(elements_[element]);
    const auto take = [&](Object kid) {
      mine.appendItem(own_kid(kid, page));
      // What a link says where its text is not read.
      if (kid.isDictionary() && kid.getKey("/Obj").isDictionary() && !e.alternative.empty())
        kid.getKey("/Obj").replaceKey("/Contents", Object::newUnicodeString(e.alternative));
    };
    if (kids.isArray())
      for (Object kid : kids.getArrayAsVector()) take(kid);
    else if (!kids.isNull())
      take(kids);
    element_of_[content.getObjGen()] = elements_[element];
  }

  // From each part of a page's content the way leads up to its element.
  void redirect_parents() {
    Object numbers = root_.getKey("/ParentTree").getKey("/Nums");
    const auto redirected = [&](Object o) {
      const auto found = element_of_.find(o.getObjGen());
      return found == element_of_.end() ? o : found->second;
    };
    for (int i = 1; i < numbers.getArrayNItems(); i += 2) {
      Object entry = numbers.getArrayItem(i);
      if (!entry.isArray()) {
        numbers.setArrayItem(i, redirected(entry));
        continue;
      }
      for (int j = 0; j < entry.getArrayNItems(); ++j) entry.setArrayItem(j, redirected(entry.getArrayItem(j)));
    }
  }

  QPDF& pdf_;
  Object root_, document_;
  std::vector<Object> elements_;
  std::map<QPDFObjGen, Object> element_of_;
};

std::string xmp(const Finishing& f) {
  std::string about;
  if (!f.author.empty()) about += "<dc:creator><rdf:Seq><rdf:li>" + escape(f.author) + "</rdf:li></rdf:Seq></dc:creator>\n";
  if (f.epoch >= 0) about += "<xmp:CreateDate>" + iso_date(f.epoch) + "</xmp:CreateDate>\n";
  return "<?xpacket begin=\"\xEF\xBB\xBF\" id=\"W5M0MpCehiHzreSzNTczkc9d\"?>\n"
         "<x:xmpmeta xmlns:x=\"adobe:ns:meta/\">\n<rdf:RDF xmlns:rdf=\"http://www.w3.org/1999/02/22-rdf-syntax-ns#\">\n"
         "<rdf:Description rdf:about=\"\" xmlns:dc=\"http://purl.org/dc/elements/1.1/\" xmlns:xmp=\"http://ns.adobe.com/xap/1.0/\" "
         "xmlns:pdfuaid=\"http://www.aiim.org/pdfua/ns/id/\">\n"
         "<dc:title><rdf:Alt><rdf:li xml:lang=\"x-default\">" +
         escape(f.title) + "</rdf:li></rdf:Alt></dc:title>\n<dc:language><rdf:Bag><rdf:li>en</rdf:li></rdf:Bag></dc:language>\n" + about +
         "<xmp:CreatorTool>" + escape(f.creator) +
         "</xmp:CreatorTool>\n<pdfuaid:part>1</pdfuaid:part>\n"
         "</rdf:Description>\n</rdf:RDF>\n</x:xmpmeta>\n<?xpacket end=\"r\"?>\n";
}

// Cairo leaves out what is the default; PDF/UA wants it said.
void complete_fonts(QPDF& pdf) {
  for (Object o : pdf.getAllObjects())
    if (o.isDictionaryOfType("/Font", "/CIDFontType2") && !o.hasKey("/CIDToGIDMap")) o.replaceKey("/CIDToGIDMap", name("Identity"));
}

void describe(QPDF& pdf, const Finishing& f) {
  Object root = pdf.getRoot();
  root.replaceKey("/Lang", Object::newUnicodeString("en"));
  Object shown = Object::newDictionary();
  shown.replaceKey("/DisplayDocTitle", Object::newBool(true));
  root.replaceKey("/ViewerPreferences", shown);
  Object metadata = Object::newStream(&pdf, xmp(f));
  metadata.getDict().replaceKey("/Type", name("Metadata"));
  metadata.getDict().replaceKey("/Subtype", name("XML"));
  root.replaceKey("/Metadata", metadata);
  Object information = pdf.getTrailer().getKey("/Info");
  information.removeKey("/CreationDate");  // Cairo's is the time of day
  if (f.epoch >= 0) information.replaceKey("/CreationDate", Object::newString(pdf_date(f.epoch)));
}

void attach(QPDF& pdf, const Finishing& f) {
  QPDFEmbeddedFileDocumentHelper files(pdf);
  Object associated = Object::newArray();
  for (const Attachment& a : f.attachments) {
    auto stream = QPDFEFStreamObjectHelper::createEFStream(pdf, a.bytes);
    stream.setSubtype(a.type);
    if (f.epoch >= 0) stream.setCreationDate(pdf_date(f.epoch)).setModDate(pdf_date(f.epoch));
    auto specification = QPDFFileSpecObjectHelper::createFileSpec(pdf, a.name, stream);
    specification.setDescription(a.title);
    specification.getObjectHandle().replaceKey("/AFRelationship", name("Data"));
    files.replaceEmbeddedFile(a.name, specification);
    associated.appendItem(specification.getObjectHandle());
  }
  if (!f.attachments.empty()) pdf.getRoot().replaceKey("/AF", associated);
}

std::string written(QPDF& pdf) {
  QPDFWriter writer(pdf);
  writer.setOutputMemory();
  writer.setMinimumPDFVersion("1.7");
  writer.setDeterministicID(true);
  writer.setObjectStreamMode(qpdf_o_generate);  // thousands of small elements
  writer.setCompressStreams(true);
  writer.setDecodeLevel(qpdf_dl_none);  // what Cairo has packed stays as it is
  writer.write();
  const std::unique_ptr<Buffer> bytes(writer.getBuffer());
  return {reinterpret_cast<const char*>(bytes->getBuffer()), bytes->getSize()};
}

}  // namespace

std::string packed(const std::string& drawn) {
  try {
    QPDF pdf;
    pdf.setSuppressWarnings(true);
    pdf.processMemoryFile("a picture", drawn.data(), drawn.size());
    return written(pdf);
  } catch (const std::bad_alloc&) {  // no fault of the output
    throw;
  } catch (const std::exception& e) {
    throw OutputError(std::string("the PDF of a picture could not be packed: ") + e.what());
  }
}

std::string finished(const std::string& drawn, const Finishing& f) {
  try {
    QPDF pdf;
    pdf.setSuppressWarnings(true);
    pdf.processMemoryFile("report.pdf", drawn.data(), drawn.size());
    for (QPDFPageObjectHelper& page : QPDFPageDocumentHelper(pdf).getAllPages()) {
      mark_decoration(pdf, page.getObjectHandle());
      page.getObjectHandle().replaceKey("/Tabs", name("S"));
    }
    const Tree tree(pdf, f.structure);
    complete_fonts(pdf);
    describe(pdf, f);
    attach(pdf, f);
    return written(pdf);
  } catch (const OutputError&) {
    throw;
  } catch (const std::bad_alloc&) {  // no fault of the output
    throw;
  } catch (const std::exception& e) {
    throw OutputError(std::string("report.pdf could not be finished: ") + e.what());
  }
}

}  // namespace pmreport::document::pdf
