// Masks of a segmentation server: SAM, SAM 2, MobileSAM, or any other that answers in the form of
// perception/mask_answer.h.
#pragma once
#include <memory>

#include "perception/mask_source.h"
#include "perception/part_server.h"

namespace marketgen::perception {

// Where such servers are published: GenManip's.
constexpr const char* mask_server_path = "/generate_masks";

// It is sent the part of the picture that shows what is wanted, as PNG, and asked for run lengths
// ("format" of the form), which servers that do not know them may leave. Its masks are cut to the
// pixels that are wanted; what it leaves out is masked by the program's own source, and so is the
// whole picture when it fails. Masks may overlap.
class ServedMasks : public MaskSource {
 public:
  ServedMasks(std::shared_ptr<PartServer> server, std::unique_ptr<MaskSource> offline)
      : server_(std::move(server)), offline_(std::move(offline)) {}

  std::vector<Mask> masks(const ViewCloud& cloud,
                          const std::vector<std::uint8_t>& wanted) const override;

 private:
  std::shared_ptr<PartServer> server_;
  std::unique_ptr<MaskSource> offline_;
};

}  // namespace marketgen::perception
