// The same brief and seed give the same store: for every thread count, in every process, in every
// build.
#include <gtest/gtest.h>

#include <set>

#include "base/parallel.h"
#include "io/file.h"
#include "store/store.h"
#include "support/committed_catalog.h"
#include "support/golden.h"
#include "support/run_program.h"

namespace marketgen {
namespace {

namespace fs = std::filesystem;

struct Sample {
  const char* name;
  const char* prompt;
  std::array<int, 2> size_mm;
  std::uint64_t seed;
};

constexpr Sample samples[] = {
    {"corner shop, 9 x 8 m, seed 3",
     "a tiny corner shop with drinks and snacks, one checkout",
     {9000, 8000},
     3},
    {"supermarket, 24 x 15 m, seed 7",
     "a bright supermarket with dairy along the back wall, produce by the entrance, five aisles "
     "and three checkouts",
     {24000, 15000},
     7},
    {"messy discounter, 20 x 14 m, seed 11",
     "an industrial discounter, messy, with misplaced products and some gaps on the shelves",
     {20000, 14000},
     11},
};

store::Manifest made(const Sample& sample, std::uint64_t seed, const fs::path& folder) {
  store::CreateOptions options;
  options.folder = folder;
  options.brief.prompt = sample.prompt;
  options.brief.size_mm = sample.size_mm;
  options.seed = seed;
  options.previews = false;
  auto created = store::create_store(options, committed_catalog());
  if (!created.ok()) fatal(to_string(created.error()).c_str());
  return std::move(created->manifest);
}

std::string hash_of(const Sample& sample, std::uint64_t seed) {
  const ScratchFolder scratch;
  return made(sample, seed, scratch.path() / "shop").scene_hash;
}

TEST(Determinism, SameForOneTwoAndFourThreads) {
  for (const Sample& sample : samples) {
    std::set<std::string> files;
    for (const int threads : {1, 2, 4}) {
      const ThreadLimit limit(threads);
      const ScratchFolder scratch;
      made(sample, sample.seed, scratch.path() / "shop");
      files.insert(contents_of(scratch.path() / "shop/scene.bin") +
                   contents_of(scratch.path() / "shop/store.json"));
    }
    EXPECT_EQ(files.size(), 1U) << sample.name;
  }
}

TEST(Determinism, SameInTwoProcesses) {
  const ScratchFolder scratch;
  for (const char* threads : {"1", "4"}) {
    const Ran ran = marketgen_run({"generate",
                                   samples[0].prompt,
                                   "--size=9x8m",
                                   "--seed=3",
                                   "--no-previews",
                                   "--threads",
                                   threads,
                                   "-o",
                                   std::string("shop-") + threads},
                                  scratch.path());
    ASSERT_EQ(ran.status, 0) << ran.err;
  }
  for (const char* file :
       {"store.json", "plan.json", "layout.json", "planogram.csv", "scene.bin"}) {
    const std::string one = contents_of(scratch.path() / "shop-1" / file);
    EXPECT_FALSE(one.empty()) << file;
    EXPECT_EQ(one, contents_of(scratch.path() / "shop-4" / file)) << file;
  }
  const ScratchFolder ours;  // and in this process
  made(samples[0], 3, ours.path() / "shop");
  EXPECT_EQ(contents_of(ours.path() / "shop/scene.bin"),
            contents_of(scratch.path() / "shop-1/scene.bin"));
}

TEST(Determinism, DifferentSeedsDiffer) {
  std::set<std::string> hashes;
  for (std::uint64_t seed = 1; seed <= 6; ++seed)
    hashes.insert(hash_of(samples[0], seed));
  EXPECT_EQ(hashes.size(), 6U);
}

TEST(Golden, GeneratedStores) {  // the same in release and dev builds
  for (const Sample& sample : samples)
    expect_golden(sample.name, hash_of(sample, sample.seed));
}

}  // namespace
}  // namespace marketgen
