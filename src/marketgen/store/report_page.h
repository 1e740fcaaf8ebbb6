// The report on stores as one self-contained HTML page: pictures, plots, tables, and each metric in
// a sentence.
#pragma once
#include <string>
#include <vector>

#include "base/result.h"
#include "catalog/catalog.h"
#include "store/report_plots.h"
#include "store/store.h"

namespace marketgen::store {

struct PagePicture {
  std::string title;
  std::string media_type, bytes;  // "image/png" and the file
};

// What the page shows of one store beside its documents.
struct StorePage {
  Manifest manifest;
  StoreReport report;
  std::vector<PagePicture> pictures;          // the layout, then the store's previews
  std::vector<PlotBar> fill, categories;      // by zone; items by category
  std::vector<double> prices_eur, masses_kg;  // of every SKU that stands in the store
};

// Draws the layout, and takes the previews from the store's folder, where it has some. Errors:
// image.*, io.*.
Result<StorePage> page_of(const Store& store, StoreReport report, const catalog::Catalog& catalog);

// Loads nothing: pictures are within it. Every text of a person or a file is escaped.
std::string report_html(const std::vector<StorePage>& stores);

}  // namespace marketgen::store
