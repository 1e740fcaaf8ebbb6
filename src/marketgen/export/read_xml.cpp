#include "export/read_xml.h"

#include <fmt/format.h>

#include <cmath>
#include <sstream>

#include "export/exporter.h"
#include "io/file.h"
#include "robots/rotation.h"

namespace marketgen::exporters {

using tinyxml2::XMLElement;

Result<XmlFile> XmlFile::read(const std::filesystem::path& file, const char* root_name) {
  MARKETGEN_TRY(const std::string text, io::read_file(file));
  XmlFile made(file.string());
  if (made.document_->Parse(text.data(), text.size()) != tinyxml2::XML_SUCCESS)
    return mismatch(fmt::format("{}:{}", file.string(), made.document_->ErrorLineNum()),
                    fmt::format("it is no XML: {}", made.document_->ErrorName()));
  const XMLElement* root = made.document_->RootElement();
  if (root == nullptr || std::string_view(root->Name()) != root_name)
    return mismatch(file.string(), fmt::format("its first element is not <{}>", root_name));
  return made;
}

std::string XmlFile::place(const XMLElement& element) const {
  return fmt::format("{}:{}", name_, element.GetLineNum());
}

Error XmlFile::fault(const XMLElement& element, const std::string& message) const {
  return mismatch(place(element), message);
}

Result<const XMLElement*> XmlFile::child(const XMLElement& parent, const char* name) const {
  const XMLElement* found = parent.FirstChildElement(name);
  if (found == nullptr) return fault(parent, fmt::format("<{}> has no <{}>", parent.Name(), name));
  return found;
}

Result<std::string> XmlFile::attribute(const XMLElement& element, const char* name) const {
  const char* found = element.Attribute(name);
  if (found == nullptr)
    return fault(element, fmt::format("<{}> has no \"{}\"", element.Name(), name));
  return std::string(found);
}

Result<std::vector<double>> XmlFile::numbers(const XMLElement& element,
                                             const char* text,
                                             std::size_t count) const {
  std::vector<double> read;
  std::istringstream in(text == nullptr ? "" : text);
  in.imbue(std::locale::classic());
  for (double number = 0; in >> number;)
    read.push_back(number);
  const bool finite = std::ranges::all_of(read, [](double n) { return std::isfinite(n); });
  if (!in.eof() || !finite || read.size() != count)
    return fault(element,
                 fmt::format("<{}> says \"{}\", expected {} numbers",
                             element.Name(),
                             text == nullptr ? "" : text,
                             count));
  return read;
}

Result<double> XmlFile::attribute_number(const XMLElement& element, const char* name) const {
  MARKETGEN_TRY(const std::vector<double> read, numbers(element, element.Attribute(name), 1));
  return read.front();
}

Result<double> XmlFile::child_number(const XMLElement& parent, const char* name) const {
  MARKETGEN_TRY(const XMLElement* element, child(parent, name));
  MARKETGEN_TRY(const std::vector<double> read, numbers(*element, element->GetText(), 1));
  return read.front();
}

std::vector<const XMLElement*> children(const XMLElement& parent, const char* name) {
  std::vector<const XMLElement*> found;
  for (const XMLElement* e = parent.FirstChildElement(name); e != nullptr;
       e = e->NextSiblingElement(name))
    found.push_back(e);
  return found;
}

Pose pose_from_xyz_rpy(const std::vector<double>& n) {
  return {{n[0], n[1], n[2]}, robots::rotation_from_rpy({n[3], n[4], n[5]})};
}

}  // namespace marketgen::exporters
