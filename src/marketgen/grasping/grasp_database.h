// Success rates of grasps, kept between runs: $MARKETGEN_CACHE/grasps/grasps.sqlite.
//
//   grasp_rates(sku, tool, setting, archetype, excluded, reason, tries, held, first, catalogue,
//   seed)
//     one row a product, tool and setting: how many of its tries held; `first` = what became of the
//     best candidate; `excluded` = "none", or why there were no tries; `catalogue` =
//     grasp_study_key(): changes with everything that it was made from
//   grasp_tries(sku, tool, setting, number, strategy, ended, width_mm, force_n, slip_mm,
//   turned_deg,
//               neighbour_n)
//     one row a try, best candidate first, from 0
//
// A new study replaces the rows of the products, tools and settings that it tried; those of two at
// once both stay. An entry of the cache (io/cache_entry.h): what other programs write into it is
// lost. Safe to delete.
#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "base/result.h"
#include "grasping/grasp_study.h"

namespace marketgen::grasping {

std::filesystem::path grasp_database_file();

// Of the catalogue's rows, the tools' rows under `data`, the options but the settings, and the
// program's own sources. Errors: io.cannot_read.
Result<std::string> grasp_study_key(const std::filesystem::path& data,
                                    const std::string& catalog_hash,
                                    const StudyOptions& options);

// Errors: io.cannot_write; io.in_use when another process does not get done with it.
Result<void> keep_grasp_rates(const std::vector<GraspRate>& rates,
                              const std::string& study_key,
                              std::uint64_t seed);

// All that was kept under this key, by SKU, tool and setting; none when there is no file that can
// be used.
std::vector<GraspRate> kept_grasp_rates(const std::string& study_key);

}  // namespace marketgen::grasping
