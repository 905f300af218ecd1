// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_MESH_FILES_INTERNAL_CHECKPOINTS_CHECKPOINT_FILE_H
#define CGAL_MESH_FILES_INTERNAL_CHECKPOINTS_CHECKPOINT_FILE_H

#include <CGAL/Deformable_simplicial_complexes/State.h>
#include <CGAL/Mesh_files/File_error.h>
#include <CGAL/Mesh_files/internal/text/little_endian.h>

#include <CGAL/assertions.h>

#include <boost/crc.hpp>

#include <ios>
#include <istream>
#include <ostream>
#include <string_view>

namespace CGAL::Deformable_simplicial_complexes::internal {

// A checkpoint file consists of magic bytes and blocks. A block is a version, a checksum, a size,
// and data. A whole complex is a single block, a distributed complex is a sequence of blocks. All
// numbers are little-endian.

constexpr std::uint32_t checkpoint_version = 5;
constexpr std::size_t checkpoint_block_header_size = 16;

// The content of a file, as a letter of the magic bytes.
enum class Checkpoint_kind : char { whole = 'C', ranks = 'R' };

// Returns the first bytes of a checkpoint file. A conversion of line ends or to seven-bit
// characters changes these bytes, so such damage is detected.
inline std::string checkpoint_magic(Checkpoint_kind kind, int dimension) {
  return "\211DS" + std::string(1, char(kind)) + std::to_string(dimension) + "\r\n\032";
}

// Returns the first bytes of a stream, for comparison with magic bytes.
inline std::string checkpoint_magic_of(std::istream& in) {
  std::string result(8, '\0');
  in.read(&result[0], static_cast<std::streamsize>(result.size()));
  result.resize(static_cast<std::size_t>(in.gcount()));
  return result;
}

// Returns whether a file of several ranks has version 1 or 2, whose blocks were different.
inline bool is_old_magic_of_ranks(const std::string& magic) {
  return magic.compare(0, 5, "\211DSCR") == 0;
}

// The data that follows the metadata of a whole complex in version `checkpoint_version`.
template <int d>
using Checkpoint_members =
    std::tuple<std::vector<std::array<double, d>>&,            // points
               std::vector<std::uint8_t>&,                     // boundary_classes
               std::vector<float>&,                            // spacings
               std::vector<std::uint32_t>&,                    // vertex_cells
               std::vector<std::array<std::uint32_t, d + 1>>&, // cells
               std::vector<std::int32_t>&,                     // cell_labels
               std::vector<float>&,                            // noted_qualities
               std::vector<std::uint8_t>&,                     // failures
               std::vector<std::uint32_t>&,                    // cell_components
               double&, double&,                               // mean_, minimum_interface_edge
               std::array<double, d>&, double&,                // normalization_translation, _scale
               std::array<double, d>&>;                        // periods
static_assert(
    std::is_same<decltype(members(std::declval<State<3>&>())), Checkpoint_members<3>>::value,
    "the members of the state differ from the members in files: increase checkpoint_version");

inline std::uint32_t crc_32(std::string_view bytes) {
  boost::crc_32_type crc;
  crc.process_bytes(bytes.data(), bytes.size());
  return crc.checksum();
}

template <class Item> constexpr bool has_stored_size = false;
template <class T> constexpr bool has_stored_size<std::vector<T>> = true;
template <> inline constexpr bool has_stored_size<std::string> = true;
template <class Item> constexpr bool is_std_array = false;
template <class T, std::size_t n> constexpr bool is_std_array<std::array<T, n>> = true;

// Appends an item as bytes: numbers, lists with their sizes, arrays, and structs of these, for
// which `Item::members(item)` returns references to the members.
template <class Item> void encode(std::string& bytes, const Item& item) {
  if constexpr (std::is_arithmetic<Item>::value) {
    append_little_endian(bytes, item);
  } else if constexpr (has_stored_size<Item> || is_std_array<Item>) {
    if constexpr (has_stored_size<Item>)
      encode(bytes, std::uint64_t(item.size()));
    for (const auto& element : item)
      encode(bytes, element);
  } else {
    std::apply([&](const auto&... members) { (encode(bytes, members), ...); }, Item::members(item));
  }
}

// Returns the bytes of some items.
template <class... Items> std::string encoded(const Items&... items) {
  std::string bytes;
  (encode(bytes, items), ...);
  return bytes;
}

// A decoder for the bytes of `encode()`. It becomes invalid, and stays invalid, if there are too
// few bytes. It allocates memory only for elements that the remaining bytes can hold.
class Checkpoint_decoder
{
public:
  explicit Checkpoint_decoder(std::string_view bytes) : m_bytes(bytes) {}

  template <class Item> void operator()(Item& item) {
    if constexpr (std::is_arithmetic<Item>::value) {
      if (may_take(1, sizeof(Item))) {
        item = little_endian<Item>(m_bytes.data());
        m_bytes.remove_prefix(sizeof(Item));
      }
    } else if constexpr (has_stored_size<Item> || is_std_array<Item>) {
      if constexpr (has_stored_size<Item>)
        item.resize(number_of_elements(encoded(typename Item::value_type()).size()));
      for (auto& element : item)
        (*this)(element);
    } else {
      std::apply([this](auto&... members) { ((*this)(members), ...); }, Item::members(item));
    }
  }

  // Returns whether all expected data was present and no bytes are left.
  bool is_complete() const { return m_is_valid && m_bytes.empty(); }

private:
  // Returns whether elements are left; the decoder becomes invalid if not.
  bool may_take(std::uint64_t n, std::size_t element_size) {
    return m_is_valid = m_is_valid && n <= m_bytes.size() / element_size;
  }

  std::size_t number_of_elements(std::size_t element_size) {
    std::uint64_t n = 0;
    (*this)(n);
    return may_take(n, element_size) ? static_cast<std::size_t>(n) : 0;
  }

  std::string_view m_bytes; // that are left
  bool m_is_valid = true;
};

inline void require_checkpoint(bool condition, const std::string& path, const std::string& what) {
  if (!condition)
    throw File_error(path + " " + what, path);
}

// Decodes the data of a block. Returns whether it consists of the items.
template <class... Items> bool decode(std::string_view data, Items&... items) {
  Checkpoint_decoder decoder(data);
  (decoder(items), ...);
  return decoder.is_complete();
}
constexpr const char* inconsistent_checkpoint =
    "is inconsistent: it was not written by this package; choose another file";

inline void write_block(std::ostream& out, std::string_view data) {
  out << encoded(checkpoint_version, crc_32(data), std::uint64_t(data.size())) << data;
}

// A reader for the blocks of a checkpoint. It allocates memory only for bytes that exist. `path` is
// the name of the file in messages.
class Checkpoint_reader
{
public:
  // Throws `File_error` if the stream has no checkpoint of this kind and dimension.
  Checkpoint_reader(std::istream& in, std::string path, Checkpoint_kind kind, int dimension)
      : m_in(in), m_path(std::move(path)) {
    in.seekg(0, std::ios::end);
    m_left = std::uint64_t(in.tellg());
    in.seekg(0);
    const std::string magic = checkpoint_magic_of(in);
    m_left -= magic.size();
    require(!is_old_magic_of_ranks(magic),
            "was written by several processes with an older version of this package: read it with "
            "that version");
    require(magic == checkpoint_magic(kind, dimension),
            std::string("is not a checkpoint of a ") +
                (kind == Checkpoint_kind::whole ? "deformable simplicial" : "distributed") +
                " complex in " + std::to_string(dimension) + " dimensions: choose another file");
  }

  // Returns the data of the next block. Throws `File_error` if it is truncated, damaged, or has
  // another version, or if bytes follow the last block.
  std::string next(bool is_last) {
    std::uint32_t version = 0, crc = 0;
    std::uint64_t size = 0;
    decode(bytes(checkpoint_block_header_size), version, crc, size);
    require(version == checkpoint_version,
            "has version " + std::to_string(version) + " instead of " +
                std::to_string(checkpoint_version) +
                ": read it with the version of this package that wrote it");
    std::string data = bytes(size);
    require(crc == crc_32(data) && (m_left == 0 || !is_last),
            "is damaged: continue from an older checkpoint or a copy of the file");
    return data;
  }

private:
  void require(bool condition, const std::string& what) const {
    require_checkpoint(condition, m_path, what);
  }

  // Returns the next bytes. Throws `File_error` if there are fewer.
  std::string bytes(std::uint64_t size) {
    const char* const truncated = "is truncated: continue from an older checkpoint";
    require(size <= m_left, truncated);
    std::string result(static_cast<std::size_t>(size), '\0');
    require(bool(m_in.read(&result[0], static_cast<std::streamsize>(size))), truncated);
    m_left -= size;
    return result;
  }

  std::istream& m_in;
  std::string m_path;
  std::uint64_t m_left; // number of bytes
};

// The content of a checkpoint file.
template <int d> struct Checkpoint
{
  State<d> state;       ///< the complex
  std::string metadata; ///< the data added by the program, e.g. time and settings
};

// Writes a checkpoint of a whole complex.
// \pre The arrays of the state have consistent sizes.
template <int d>
void write_whole(std::ostream& out, const State<d>& state, const std::string& metadata) {
  CGAL_precondition(has_consistent_sizes(state));
  out << checkpoint_magic(Checkpoint_kind::whole, d);
  std::apply([&](const auto&... members) { write_block(out, encoded(metadata, members...)); },
             members(state));
}

// Reads a checkpoint of a whole complex. Throws `File_error` as `IO::read_checkpoint()` does.
template <int d> Checkpoint<d> read_whole(std::istream& in, const std::string& path) {
  const std::string data = Checkpoint_reader(in, path, Checkpoint_kind::whole, d).next(true);
  Checkpoint<d> result;
  const bool is_complete =
      std::apply([&](auto&... members) { return decode(data, result.metadata, members...); },
                 members(result.state));
  require_checkpoint(is_complete && has_consistent_sizes(result.state), path,
                     inconsistent_checkpoint);
  return result;
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_MESH_FILES_INTERNAL_CHECKPOINTS_CHECKPOINT_FILE_H
