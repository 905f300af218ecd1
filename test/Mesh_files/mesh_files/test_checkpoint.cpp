#include "small_meshes.h"
#include "temporary_folder.h"
#include "test.h"
#include "whole_files.h"

#include <CGAL/Deformable_simplicial_complexes/State.h>
#include <CGAL/Mesh_files/File_error.h>
#include <CGAL/Mesh_files/checkpoint.h>
#include <CGAL/Mesh_files/internal/text/little_endian.h>

#include <cstring>

namespace test_checkpoint {

using CGAL::Deformable_simplicial_complexes::File_error;
using State = DSC::State<3>;
namespace internal = CGAL::Deformable_simplicial_complexes::internal;

using whole_files::checkpoint_header_size;
using whole_files::signed_checkpoint;

State ball_state() {
  auto dsc = small_meshes::make_complex(small_meshes::grid(4, small_meshes::ball));
  dsc.set_normalization({small_meshes::Complex::Vector_3(0.1, -2, 1e-3), 1. / 3});
  return dsc.state();
}

// Returns the error message of reading the file, or an empty string.
std::string complaint(const std::string& path) {
  try {
    CGAL::IO::read_checkpoint(path);
  } catch (const File_error& error) {
    EXPECT_EQ(error.path(), path);
    EXPECT_NE(std::string(error.what()).find(path), std::string::npos);
    return error.what();
  }
  return "";
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(Checkpoint, state_and_metadata_come_back_bit_for_bit) {
  const Temporary_folder folder;
  const State state = ball_state();
  const std::string metadata("time = 0.5\n\0\xff end", 17);
  CGAL::IO::write_checkpoint(folder / "a.dsc", state, metadata);
  const auto checkpoint = CGAL::IO::read_checkpoint(folder / "a.dsc");
  EXPECT_EQ(checkpoint.state, state);
  EXPECT_EQ(checkpoint.metadata, metadata);
  CGAL::IO::write_checkpoint(folder / "b.dsc", checkpoint.state, checkpoint.metadata);
  EXPECT_EQ(file_bytes(folder / "a.dsc"), file_bytes(folder / "b.dsc"));
  EXPECT_EQ(folder.number_of_files(), 2);
}

TEST(Checkpoint, bytes_in_memory_are_those_of_the_file) {
  const Temporary_folder folder;
  const State state = ball_state();
  const std::string bytes = CGAL::IO::checkpoint_to_bytes(state, "metadata");
  CGAL::IO::write_checkpoint(folder / "checkpoint", state, "metadata");
  EXPECT_EQ(bytes, file_bytes(folder / "checkpoint"));
  const auto checkpoint = CGAL::IO::checkpoint_from_bytes<3>(bytes);
  EXPECT_TRUE(checkpoint.state == state);
  EXPECT_EQ(checkpoint.metadata, "metadata");
  EXPECT_THROW(CGAL::IO::checkpoint_from_bytes<2>(bytes), File_error);
  EXPECT_THROW(CGAL::IO::checkpoint_from_bytes<3>(bytes.substr(0, bytes.size() - 1)), File_error);
  EXPECT_THROW(CGAL::IO::checkpoint_from_bytes<3>(""), File_error);
}

TEST(Checkpoint, restored_complex_has_the_same_state) {
  const Temporary_folder folder;
  const State state = ball_state();
  CGAL::IO::write_checkpoint(folder / "a.dsc", state);
  const auto checkpoint = CGAL::IO::read_checkpoint(folder / "a.dsc");
  EXPECT_EQ(checkpoint.metadata, "");
  small_meshes::Complex restored;
  restored.restore(checkpoint.state);
  EXPECT_TRUE(restored.is_valid(true));
  EXPECT_EQ(restored.state(), state);
}

TEST(Checkpoint, extreme_numbers_keep_their_bits) {
  const Temporary_folder folder;
  using Limits = std::numeric_limits<double>;
  State state = ball_state();
  state.points[0] = {-0., Limits::denorm_min(), Limits::max()};
  state.points[1] = {Limits::quiet_NaN(), -Limits::infinity(), 1 + Limits::epsilon()};
  state.cell_labels[0] = (std::numeric_limits<std::int32_t>::min)();
  state.vertex_cells[0] = (std::numeric_limits<std::uint32_t>::max)();
  state.boundary_classes[0] = 255;
  CGAL::IO::write_checkpoint(folder / "a.dsc", state);
  const State read = CGAL::IO::read_checkpoint(folder / "a.dsc").state;
  ASSERT_EQ(read.points.size(), state.points.size());
  EXPECT_EQ(std::memcmp(read.points.data(), state.points.data(),
                        state.points.size() * sizeof(state.points[0])),
            0);
  EXPECT_EQ(read.cell_labels, state.cell_labels);
  EXPECT_EQ(read.vertex_cells, state.vertex_cells);
  EXPECT_EQ(read.boundary_classes, state.boundary_classes);
}

TEST(Checkpoint, truncated_files_are_refused) {
  const Temporary_folder folder;
  CGAL::IO::write_checkpoint(folder / "whole.dsc", ball_state(), "metadata");
  const std::string whole = file_bytes(folder / "whole.dsc"), path = folder / "part.dsc";
  for (std::size_t size = 0; size < whole.size(); size += 97) {
    write_bytes(path, whole.substr(0, size));
    EXPECT_NE(complaint(path), "") << size;
  }
  write_bytes(path, whole.substr(0, checkpoint_header_size - 1));
  EXPECT_TRUE(contains(complaint(path), "truncated"));
  write_bytes(path, whole.substr(0, whole.size() - 1));
  EXPECT_TRUE(contains(complaint(path), "truncated"));
  write_bytes(path, whole + '\0');
  EXPECT_TRUE(contains(complaint(path), "damaged"));
}

TEST(Checkpoint, damaged_files_are_refused) {
  const Temporary_folder folder;
  CGAL::IO::write_checkpoint(folder / "whole.dsc", ball_state(), "metadata");
  const std::string whole = file_bytes(folder / "whole.dsc"), path = folder / "damaged.dsc";
  for (std::size_t i = 0; i < whole.size(); i += i < 2 * checkpoint_header_size ? 1 : 97) {
    std::string damaged = whole;
    damaged[i] = char(damaged[i] ^ (1 << i % 8));
    write_bytes(path, damaged);
    EXPECT_NE(complaint(path), "") << i;
  }
  std::string newer = whole;
  ++newer[8];
  write_bytes(path, newer);
  EXPECT_TRUE(contains(complaint(path), "version 6"));
}

TEST(Checkpoint, foreign_files_are_refused) {
  const Temporary_folder folder;
  EXPECT_TRUE(contains(complaint(folder / "missing.dsc"), "cannot open"));
  EXPECT_TRUE(contains(complaint(folder / "."), "cannot open"));
  write_bytes(folder / "text.dsc", std::string(1000, 'x'));
  EXPECT_TRUE(contains(complaint(folder / "text.dsc"), "is not a checkpoint"));
  write_bytes(folder / "empty.dsc", "");
  EXPECT_TRUE(contains(complaint(folder / "empty.dsc"), "is empty"));
}

// Sizes beyond the end of the file are rejected before memory is allocated, even if the product
// with the element size overflows.
TEST(Checkpoint, impossible_sizes_are_refused) {
  const Temporary_folder folder;
  CGAL::IO::write_checkpoint(folder / "a.dsc", ball_state(), "");
  const std::string whole = file_bytes(folder / "a.dsc");
  ASSERT_EQ(signed_checkpoint(whole), whole);
  for (std::size_t position : {0, 8}) // sizes of the metadata and of the points
    for (std::uint64_t size : {std::uint64_t(1) << 40, std::uint64_t(1) << 61, ~std::uint64_t(0)}) {
      std::string field;
      internal::append_little_endian(field, size);
      std::string forged = whole;
      forged.replace(checkpoint_header_size + position, field.size(), field);
      write_bytes(folder / "forged.dsc", signed_checkpoint(forged));
      EXPECT_TRUE(contains(complaint(folder / "forged.dsc"), "is inconsistent"));
    }
}

TEST(Checkpoint, arrays_that_do_not_fit_together_are_refused) {
  const Temporary_folder folder;
  State state = ball_state();
  CGAL::IO::write_checkpoint(folder / "a.dsc", state);
  state.cell_labels.pop_back();
  const std::string payload = std::apply(
      [](const auto&... members) { return internal::encoded(std::string(), members...); },
      internal::members(state));
  write_bytes(
      folder / "b.dsc",
      signed_checkpoint(file_bytes(folder / "a.dsc").substr(0, checkpoint_header_size) + payload));
  EXPECT_TRUE(contains(complaint(folder / "b.dsc"), "is inconsistent"));
}

TEST(Checkpoint, unwritable_places_are_refused) {
  const Temporary_folder folder;
  const State state = ball_state();
  EXPECT_THROW(CGAL::IO::write_checkpoint(folder / "missing/a.dsc", state), File_error);
  EXPECT_THROW(CGAL::IO::write_checkpoint(folder / ".", state), File_error);
  EXPECT_EQ(folder.number_of_files(), 0);
}

} // namespace test_checkpoint
