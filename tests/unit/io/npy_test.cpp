// NumPy files: the bytes that np.save() writes.
#include "io/npy.h"

#include <gtest/gtest.h>

#include <cstring>

#include "support/run_program.h"

namespace marketgen {
namespace {

TEST(Npy, HasTheHeaderThatNumPyExpects) {
  const ScratchFolder scratch;
  const std::vector<float> values{0, 1.5F, -2, 3, 4, 5.25F};
  ASSERT_TRUE(io::write_npy(scratch.path() / "a.npy", values, {2, 3}).ok());
  const std::string bytes = contents_of(scratch.path() / "a.npy");
  ASSERT_EQ(bytes.size(), 128U + 24U);
  EXPECT_EQ(bytes.substr(0, 8), std::string("\x93NUMPY\x01\x00", 8));
  EXPECT_EQ(static_cast<unsigned char>(bytes[8]), 118);  // 128 with the ten bytes before
  EXPECT_EQ(bytes[9], 0);
  EXPECT_EQ(bytes.substr(10, 60), "{'descr': '<f4', 'fortran_order': False, 'shape': (2,3,), } ");
  EXPECT_EQ(bytes[127], '\n');
  std::vector<float> again(6);
  std::memcpy(again.data(), bytes.data() + 128, 24);
  EXPECT_EQ(again, values);
}

TEST(Npy, SaysWhenItCannotWrite) {
  const auto written = io::write_npy("/proc/marketgen.npy", std::vector<float>{1}, {1});
  ASSERT_FALSE(written.ok());
  EXPECT_EQ(written.error().code, "io.cannot_write");
}

}  // namespace
}  // namespace marketgen
