// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Mesh_files, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MESH_FILES_INTERNAL_CHECKPOINTS_CHECKPOINT_FILE_H
#define CGAL_MESH_FILES_INTERNAL_CHECKPOINTS_CHECKPOINT_FILE_H

#include <CGAL/Deformable_simplicial_complexes/State.h>
#include <CGAL/Mesh_files/File_error.h>
#include <CGAL/Mesh_files/internal/text/files.h>
#include <CGAL/Mesh_files/internal/text/little_endian.h>
#include <CGAL/Mesh_files/internal/text/open_input.h>
#include <CGAL/Mesh_files/replace_file.h>

#include <CGAL/assertions.h>

#include <boost/crc.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <ostream>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Returns the first eight bytes of a checkpoint file. A conversion of line ends or to seven-bit
// characters changes these bytes, so such damage is detected.
template <int d> std::string checkpoint_magic() {
  return "\211DSC" + std::to_string(d) + "\r\n\032";
}
constexpr std::size_t checkpoint_magic_size = 8;
constexpr std::uint32_t checkpoint_version = 5;
constexpr std::size_t checkpoint_header_size = 24;

// The data that follows the metadata in a file of version `checkpoint_version`.
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

inline std::uint32_t crc_32(const char* bytes, std::size_t size) {
  boost::crc_32_type crc;
  crc.process_bytes(bytes, size);
  return crc.checksum();
}

// An encoder that converts data to little-endian bytes.
class Checkpoint_encoder
{
public:
  template <class Number> void operator()(Number number) { append_little_endian(m_bytes, number); }

  template <class T, std::size_t n> void operator()(const std::array<T, n>& elements) {
    for (const T& element : elements)
      (*this)(element);
  }

  template <class T> void operator()(const std::vector<T>& elements) {
    (*this)(std::uint64_t(elements.size()));
    for (const T& element : elements)
      (*this)(element);
  }

  void operator()(const std::string& text) {
    (*this)(std::uint64_t(text.size()));
    m_bytes += text;
  }

  const std::string& bytes() const { return m_bytes; }

private:
  std::string m_bytes;
};

// A decoder for the bytes of a `Checkpoint_encoder`. It becomes invalid, and stays invalid, if
// there are too few bytes. It allocates memory only for elements that the remaining bytes can hold.
class Checkpoint_decoder
{
public:
  Checkpoint_decoder(const char* begin, const char* end) : m_position(begin), m_end(end) {}

  template <class Number> void operator()(Number& number) {
    m_is_valid = m_is_valid && sizeof(Number) <= remaining();
    if (m_is_valid) {
      number = little_endian<Number>(m_position);
      m_position += sizeof(Number);
    }
  }

  template <class T, std::size_t n> void operator()(std::array<T, n>& elements) {
    for (T& element : elements)
      (*this)(element);
  }

  template <class T> void operator()(std::vector<T>& elements) {
    elements.resize(number_of_elements(sizeof(T)));
    for (T& element : elements)
      (*this)(element);
  }

  void operator()(std::string& text) {
    // before `m_position` is read, because the call advances it
    const std::size_t size = number_of_elements(1);
    text.assign(m_position, size);
    m_position += size;
  }

  // Returns whether all expected data was present and no bytes are left.
  bool is_complete() const { return m_is_valid && m_position == m_end; }

private:
  std::size_t remaining() const { return static_cast<std::size_t>(m_end - m_position); }

  std::size_t number_of_elements(std::size_t element_size) {
    std::uint64_t n = 0;
    (*this)(n);
    m_is_valid = m_is_valid && n <= remaining() / element_size;
    return m_is_valid ? static_cast<std::size_t>(n) : 0;
  }

  const char* m_position;
  const char* m_end;
  bool m_is_valid = true;
};

// The content of a checkpoint file.
template <int d> struct Checkpoint
{
  State<d> state;       ///< the complex
  std::string metadata; ///< the data added by the program, e.g. time and settings
};

// Calls `use(header, payload)` with the two parts of a checkpoint file. The header consists of
// magic bytes, version, checksum and size.
// \pre The arrays of the state have consistent sizes.
template <int d, class Use>
void with_checkpoint_parts(const State<d>& state, const std::string& metadata, const Use& use) {
  CGAL_precondition(has_consistent_sizes(state));

  Checkpoint_encoder payload;
  payload(metadata);
  std::apply([&](const auto&... members) { (payload(members), ...); }, members(state));

  Checkpoint_encoder header;
  header(checkpoint_version);
  header(crc_32(payload.bytes().data(), payload.bytes().size()));
  header(std::uint64_t(payload.bytes().size()));
  use(checkpoint_magic<d>() + header.bytes(), payload.bytes());
}

// Returns the bytes of a checkpoint file.
// \pre The arrays of the state have consistent sizes.
template <int d>
std::string checkpoint_to_bytes(const State<d>& state, const std::string& metadata) {
  std::string result;
  with_checkpoint_parts(
      state, metadata,
      [&](const std::string& header, const std::string& payload) { result = header + payload; });
  return result;
}

// Writes a checkpoint file. The file is replaced only if everything has been written.
// \pre The arrays of the state have consistent sizes.
template <int d>
void write_checkpoint_file(const std::string& path, const State<d>& state,
                           const std::string& metadata) {
  with_checkpoint_parts(
      state, metadata, [&](const std::string& header, const std::string& payload) {
        replace_file_by_stream(path, [&](std::ostream& out) { out << header << payload; });
      });
}

// Returns the dimension given by the first bytes of a file, or 0 if the file is not a checkpoint.
inline int checkpoint_file_dimension(const std::string& path) {
  std::string bytes(checkpoint_magic_size, '\0');
  std::ifstream in = open_input(path, ".dsc");
  in.read(&bytes[0], std::streamsize(bytes.size()));
  return bytes == checkpoint_magic<2>() ? 2 : bytes == checkpoint_magic<3>() ? 3 : 0;
}

// Returns the content of a checkpoint file with given bytes. Throws `File_error` if it is not a
// checkpoint of dimension `d`, has another version, is truncated, or is damaged. `path` is its
// name.
template <int d>
Checkpoint<d> checkpoint_from_bytes(const std::string& bytes, const std::string& path) {
  const auto require = [&](bool condition, const std::string& what) {
    if (!condition)
      throw File_error(path + " " + what, path);
  };

  require(bytes.compare(0, checkpoint_magic_size, checkpoint_magic<d>()) == 0,
          "is not a checkpoint of a deformable simplicial complex in " + std::to_string(d) +
              " dimensions: choose another file");
  require(bytes.size() >= checkpoint_header_size,
          "is truncated: continue from an older checkpoint");

  std::uint32_t version = 0, crc = 0;
  std::uint64_t size = 0;
  const char* payload_begin = bytes.data() + checkpoint_header_size;
  Checkpoint_decoder header(bytes.data() + checkpoint_magic_size, payload_begin);
  header(version);
  header(crc);
  header(size);
  require(version == checkpoint_version,
          "has version " + std::to_string(version) + " instead of " +
              std::to_string(checkpoint_version) +
              ": read it with the version of this package that wrote it");
  const std::size_t payload_size = bytes.size() - checkpoint_header_size;
  require(size <= payload_size, "is truncated: continue from an older checkpoint");
  require(size == payload_size && crc == crc_32(payload_begin, payload_size),
          "is damaged: continue from an older checkpoint or a copy of the file");

  Checkpoint<d> checkpoint;
  Checkpoint_decoder payload(payload_begin, payload_begin + payload_size);
  payload(checkpoint.metadata);
  std::apply([&](auto&... members) { (payload(members), ...); }, members(checkpoint.state));
  require(payload.is_complete() && has_consistent_sizes(checkpoint.state),
          "is inconsistent: it was not written by this package; choose another file");
  return checkpoint;
}

// Reads a checkpoint file. Throws `File_error` as `checkpoint_from_bytes()` does.
template <int d> Checkpoint<d> read_checkpoint_file(const std::string& path) {
  return checkpoint_from_bytes<d>(file_contents(path), path);
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_MESH_FILES_INTERNAL_CHECKPOINTS_CHECKPOINT_FILE_H
