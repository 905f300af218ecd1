// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_IO_CHECKPOINT_3_H
#define CGAL_IO_CHECKPOINT_3_H

#include <CGAL/Deformable_simplicial_complexes/State.h>
#include <CGAL/Deformable_simplicial_complexes/exceptions.h>
#include <CGAL/Deformable_simplicial_complexes/internal/IO/files.h>
#include <CGAL/Deformable_simplicial_complexes/internal/IO/little_endian.h>

#include <CGAL/assertions.h>

#include <boost/crc.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <ostream>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// A checkpoint is a header of 24 bytes and a payload: eight bytes of magic, the version and the
// CRC-32 of the payload in four bytes each, the size of the payload in eight. The payload is the
// metadata and the members of the state; what has variable length comes after its number of
// elements in eight bytes.
inline constexpr char checkpoint_magic[] = "\211DSC3\r\n\032"; // damaged by any conversion of text
constexpr std::size_t checkpoint_magic_size = sizeof(checkpoint_magic) - 1;
constexpr std::uint32_t checkpoint_version = 4;
constexpr std::size_t checkpoint_header_size = 24;

// What follows the metadata in a file of this version.
using Checkpoint_members =
    std::tuple<std::vector<std::array<double, 3>>&,        // points
               std::vector<std::uint8_t>&,                 // boundary_classes
               std::vector<float>&,                        // spacings
               std::vector<std::uint32_t>&,                // vertex_cells
               std::vector<std::array<std::uint32_t, 4>>&, // cells
               std::vector<std::int32_t>&,                 // cell_labels
               std::vector<float>&,                        // noted_qualities
               std::vector<std::uint8_t>&,                 // failures
               std::vector<std::uint32_t>&,                // cell_components
               std::vector<double>&,                       // component_volumes
               double&, double&,                           // mean_, minimum_interface_edge
               std::array<double, 3>&, double&,            // normalization_translation, _scale
               std::array<double, 3>&>;                    // periods
static_assert(
    std::is_same<decltype(members(std::declval<Deformable_simplicial_complex_state_3&>())),
                 Checkpoint_members>::value,
    "the state has other members than files have: raise checkpoint_version, too");

inline std::uint32_t crc_32(const char* bytes, std::size_t size) {
  boost::crc_32_type crc;
  crc.process_bytes(bytes, size);
  return crc.checksum();
}

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

// Reads what the encoder wrote. Becomes and stays invalid when there are too few bytes; nothing is
// allocated for elements that are not there.
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
    const std::size_t size = number_of_elements(1); // first, as it moves the position
    text.assign(m_position, size);
    m_position += size;
  }

  // whether everything was there and everything was read
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

} // namespace internal
} // namespace Deformable_simplicial_complexes

namespace IO {

/*!
\ingroup PkgDeformableSimplicialComplex3Ref

is what a checkpoint file holds.
*/
struct Checkpoint_3
{
  Deformable_simplicial_complex_state_3 state; ///< the complex
  std::string metadata;                        ///< what the program added, e.g. time and settings
};

/*!
\ingroup PkgDeformableSimplicialComplex3Ref

writes the state of a complex to a file from which a run continues to the same bits.

The file is binary and the same on all machines: numbers are little-endian, and a checksum covers
all of them. It is written beside its final place and renamed when complete, so that a program that
is stopped while writing leaves the previous checkpoint as it was.

\param path is the name of the file; its folder must exist.
\param state is what `Deformable_simplicial_complex_3::state()` returned.
\param metadata is any sequence of bytes, given back by `read_checkpoint()`.

\pre the arrays of `state` that run parallel have the same size.
\throws Deformable_simplicial_complexes::File_error if the file cannot be written; an older file
of that name is unchanged then.

Linear in the size of the state; takes memory for a second copy of it.
*/
inline void write_checkpoint(const std::string& path,
                             const Deformable_simplicial_complex_state_3& state,
                             const std::string& metadata = std::string()) {
  namespace internal = Deformable_simplicial_complexes::internal;
  CGAL_precondition(internal::has_consistent_sizes(state));

  internal::Checkpoint_encoder payload;
  payload(metadata);
  std::apply([&](const auto&... members) { (payload(members), ...); }, internal::members(state));

  internal::Checkpoint_encoder header;
  header(internal::checkpoint_version);
  header(internal::crc_32(payload.bytes().data(), payload.bytes().size()));
  header(std::uint64_t(payload.bytes().size()));

  internal::replace_file_by_stream(path, [&](std::ostream& out) {
    out << internal::checkpoint_magic << header.bytes() << payload.bytes();
  });
}

/*!
\ingroup PkgDeformableSimplicialComplex3Ref

reads a file written by `write_checkpoint()`.

\param path is the name of the file.
\return the state, to be handed to `Deformable_simplicial_complex_3::restore()`, and the metadata,
both bit for bit as they were written.

\throws Deformable_simplicial_complexes::File_error if the file cannot be read, is not a
checkpoint, was written by another version, is truncated, or was changed since. Nothing is read
from such a file, and never is more memory asked for than a small multiple of the file's size.

Linear in the size of the file.
*/
inline Checkpoint_3 read_checkpoint(const std::string& path) {
  namespace internal = Deformable_simplicial_complexes::internal;
  const auto require = [&](bool condition, const std::string& what) {
    if (!condition)
      throw Deformable_simplicial_complexes::File_error(path + " " + what, path);
  };

  const std::string bytes = internal::file_contents(path);
  require(bytes.compare(0, internal::checkpoint_magic_size, internal::checkpoint_magic) == 0,
          "is not a checkpoint of a deformable simplicial complex: choose another file");
  require(bytes.size() >= internal::checkpoint_header_size,
          "is truncated: continue from an older checkpoint");

  std::uint32_t version = 0, crc = 0;
  std::uint64_t size = 0;
  const char* payload_begin = bytes.data() + internal::checkpoint_header_size;
  internal::Checkpoint_decoder header(bytes.data() + internal::checkpoint_magic_size,
                                      payload_begin);
  header(version);
  header(crc);
  header(size);
  require(version == internal::checkpoint_version,
          "has version " + std::to_string(version) + " and not " +
              std::to_string(internal::checkpoint_version) +
              ": read it with the version of this package that wrote it");
  const std::size_t payload_size = bytes.size() - internal::checkpoint_header_size;
  require(size <= payload_size, "is truncated: continue from an older checkpoint");
  require(size == payload_size && crc == internal::crc_32(payload_begin, payload_size),
          "is damaged: continue from an older checkpoint or a copy of the file");

  Checkpoint_3 checkpoint;
  internal::Checkpoint_decoder payload(payload_begin, payload_begin + payload_size);
  payload(checkpoint.metadata);
  std::apply([&](auto&... members) { (payload(members), ...); },
             internal::members(checkpoint.state));
  require(payload.is_complete() && internal::has_consistent_sizes(checkpoint.state),
          "contradicts itself: it was not written by this package, choose another file");
  return checkpoint;
}

} // namespace IO
} // namespace CGAL

#endif // CGAL_IO_CHECKPOINT_3_H
