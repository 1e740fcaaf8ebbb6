// Every fault under tests/fixtures/invalid: its code, its exit status, its message, and nothing
// left behind.
//
// cases.json has one row a fault: args (with {dir} for this folder, {out} for a path that does not
// exist yet, {store} for a good store, {bad_index} for one whose scene.bin names a product that is
// not in its catalogue, {changed} for one whose scene.bin is another than its manifest says, "hex:"
// for bytes that JSON cannot hold), the exit status, the error code and a part of the message.
#include <gtest/gtest.h>

#include <set>

#include <nlohmann/json.hpp>

#include "base/error_codes.h"
#include "io/file.h"
#include "io/json.h"
#include "scene/scene_file.h"
#include "small_store.h"
#include "store/store.h"

namespace marketgen {
namespace {

namespace fs = std::filesystem;

const fs::path& invalid_folder() {
  static const fs::path folder = fs::path(MARKETGEN_SOURCE_DIR) / "tests/fixtures/invalid";
  return folder;
}

std::string from_hex(const std::string& digits) {
  std::string bytes;
  for (std::size_t i = 0; i + 1 < digits.size(); i += 2)
    bytes += static_cast<char>(std::stoi(digits.substr(i, 2), nullptr, 16));
  return bytes;
}

std::string replaced(std::string text, const std::string& name, const std::string& value) {
  for (std::size_t at = text.find(name); at != std::string::npos;
       at = text.find(name, at + value.size()))
    text.replace(at, name.size(), value);
  return text;
}

// Well-formed to the last byte: only the program's own check of indices can find the fault.
const fs::path& store_with_bad_index() {
  static const ScratchFolder scratch;
  static const fs::path folder = [] {
    scene::Scene scene = scene::open_scene(small_store() / "scene.bin").value();
    scene.products.at(0).sku = 99'999;
    const std::string bytes = scene::encode_scene(scene);
    EXPECT_TRUE(io::write_file(scratch.path() / "scene.bin", bytes).ok());
    store::Manifest manifest;
    manifest.files = {{"scene.bin", io::sha256_hex(bytes), bytes.size()}};
    EXPECT_TRUE(io::write_file(scratch.path() / "store.json", io::write_json(manifest)).ok());
    return scratch.path();
  }();
  return folder;
}

// A good store with one byte of its scene changed: the coordinate of some product, say, which is
// still a number.
const fs::path& changed_store() {
  static const ScratchFolder scratch;
  static const fs::path folder = [] {
    fs::copy(small_store(), scratch.path() / "shop", fs::copy_options::recursive);
    std::string bytes = contents_of(scratch.path() / "shop/scene.bin");
    bytes[bytes.size() / 2] ^= 1;
    EXPECT_TRUE(io::write_file(scratch.path() / "shop/scene.bin", bytes).ok());
    return scratch.path() / "shop";
  }();
  return folder;
}

std::vector<std::string> arguments_of(const nlohmann::json& row, const fs::path& scratch) {
  std::vector<std::string> arguments;
  for (std::string word : row["args"]) {
    if (word.starts_with("hex:")) {
      arguments.push_back(from_hex(word.substr(4)));
      continue;
    }
    word = replaced(word, "{dir}", invalid_folder().string());
    word = replaced(word, "{out}", (scratch / "out").string());
    if (word.find("{store}") != std::string::npos)
      word = replaced(word, "{store}", small_store().string());
    if (word.find("{bad_index}") != std::string::npos)
      word = replaced(word, "{bad_index}", store_with_bad_index().string());
    if (word.find("{changed}") != std::string::npos)
      word = replaced(word, "{changed}", changed_store().string());
    arguments.push_back(word);
  }
  return arguments;
}

std::set<std::string> listing(const fs::path& folder) {
  std::set<std::string> paths;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
    paths.insert(entry.path().string());
  return paths;
}

const nlohmann::json& rows() {
  static const nlohmann::json table =
      nlohmann::json::parse(contents_of(invalid_folder() / "cases.json"));
  return table;
}

TEST(Invalid, EveryFaultIsRefusedWithItsCodeAndLeavesNothing) {
  ASSERT_GE(rows().size(), 24U);
  small_store();
  const auto fixtures_before = listing(invalid_folder());
  for (const nlohmann::json& row : rows()) {
    const std::string name = row["name"];
    SCOPED_TRACE(name);
    const ScratchFolder scratch;
    const Ran ran = marketgen_run(arguments_of(row, scratch.path()), scratch.path());
    EXPECT_EQ(ran.status, row["exit"]) << ran.err;
    EXPECT_NE(ran.err.find("error[" + row["code"].get<std::string>() + "] "), std::string::npos)
        << ran.err;
    EXPECT_NE(ran.err.find(row["says"].get<std::string>()), std::string::npos) << ran.err;
    EXPECT_EQ(ran.err.find("error[", ran.err.find("error[") + 1), std::string::npos)
        << "more than one error: " << ran.err;
    EXPECT_TRUE(fs::is_empty(scratch.path())) << "left " << *listing(scratch.path()).begin();
  }
  EXPECT_EQ(listing(invalid_folder()), fixtures_before);
}

TEST(Invalid, CodesAndStatusesAreThoseOfTheList) {
  std::set<std::string> known;
  for (const ErrorCodeInfo& info : error_codes())
    known.insert(std::string(info.code));
  std::set<std::string> names;
  for (const nlohmann::json& row : rows()) {
    EXPECT_TRUE(names.insert(row["name"]).second) << row["name"];
    EXPECT_TRUE(known.contains(row["code"])) << row["code"];
    EXPECT_EQ(exit_status_of(row["code"].get<std::string>()), row["exit"]) << row["name"];
    EXPECT_FALSE(row["says"].get<std::string>().empty()) << row["name"];
  }
}

TEST(Invalid, EveryFileHasACase) {
  std::string all;
  for (const nlohmann::json& row : rows())
    all += row["args"].dump();
  for (const fs::directory_entry& entry : fs::directory_iterator(invalid_folder())) {
    const std::string name = entry.path().filename().string();
    if (name == "cases.json") continue;
    EXPECT_NE(all.find("{dir}/" + name), std::string::npos) << name << " is used by no case";
  }
}

}  // namespace
}  // namespace marketgen
