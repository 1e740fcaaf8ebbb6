// Reading XML back with tinyxml2, for formats whose text we write ourselves. Errors:
// export.mismatch with file and line, io.*.
#pragma once
#include <tinyxml2.h>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "base/result.h"
#include "geometry/pose.h"

namespace marketgen::exporters {

class XmlFile {
 public:
  static Result<XmlFile> read(const std::filesystem::path& file, const char* root_name);

  const tinyxml2::XMLElement& root() const { return *document_->RootElement(); }
  // "shop.urdf:12".
  std::string place(const tinyxml2::XMLElement& element) const;
  Error fault(const tinyxml2::XMLElement& element, const std::string& message) const;

  Result<const tinyxml2::XMLElement*> child(const tinyxml2::XMLElement& parent,
                                            const char* name) const;
  Result<std::string> attribute(const tinyxml2::XMLElement& element, const char* name) const;
  // Exactly so many finite numbers.
  Result<std::vector<double>> numbers(const tinyxml2::XMLElement& element,
                                      const char* text,
                                      std::size_t count) const;
  // Of an attribute, or of the text of a child.
  Result<double> attribute_number(const tinyxml2::XMLElement& element, const char* name) const;
  Result<double> child_number(const tinyxml2::XMLElement& parent, const char* name) const;

 private:
  explicit XmlFile(std::string name) : name_(std::move(name)) {}

  std::string name_;
  std::unique_ptr<tinyxml2::XMLDocument> document_ = std::make_unique<tinyxml2::XMLDocument>();
};

// All children of this name, in order.
std::vector<const tinyxml2::XMLElement*> children(const tinyxml2::XMLElement& parent,
                                                  const char* name);

// Six numbers: a place, and roll, pitch, yaw.
Pose pose_from_xyz_rpy(const std::vector<double>& numbers);

}  // namespace marketgen::exporters
