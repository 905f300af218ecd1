// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DISTRIBUTED_COMPLEXES_DISTRIBUTED_CHECKPOINT_H
#define CGAL_DISTRIBUTED_COMPLEXES_DISTRIBUTED_CHECKPOINT_H

#include <CGAL/Distributed_complexes/Communicator.h>
#include <CGAL/Distributed_complexes/Distributed_complex.h>
#include <CGAL/Distributed_complexes/internal/ranks/Distributed_mesh.h>
#include <CGAL/Distributed_complexes/internal/ranks/Piece.h>
#include <CGAL/Distributed_complexes/internal/ranks/Placement.h>
#include <CGAL/Mesh_files/internal/checkpoints/checkpoint_file.h>
#include <CGAL/Mesh_files/internal/text/files.h>
#include <CGAL/Mesh_files/replace_file.h>
#include <CGAL/Mesh_support/coordinates.h>

#include <optional>

namespace CGAL {
namespace Deformable_simplicial_complexes::internal {

// A checkpoint of a distributed complex consists of a block with the data that all ranks know, and
// a block with the vertices and cells of each rank.

// An entry of `Known_components`.
struct Checkpoint_component
{
  std::uint32_t number;
  std::int32_t label;
  std::int64_t volume;

  template <class Component> static auto members(Component& c) {
    return std::tie(c.number, c.label, c.volume);
  }
};

// Returns the own cells of a rank, and all their vertices.
template <class Complex> std::string encoded_piece(const Distributed_mesh<Complex>& mesh) {
  using Index = typename Distributed_mesh<Complex>::Index;
  static constexpr int d = Complex::dimension;
  std::vector<Sent_cell<d>> cells;
  std::vector<std::uint8_t> is_needed(mesh.piece.vertex_bound(), 0);
  for (Index c : mesh.own_cells()) {
    cells.push_back(mesh.piece.sent(c));
    for (Index v : mesh.piece.cell(c).vertices)
      is_needed[v] = 1;
  }
  std::vector<Piece_vertex<d>> vertices;
  for (Index v = 0; v < mesh.piece.vertex_bound(); ++v)
    if (is_needed[v])
      vertices.push_back(mesh.piece.vertex(v));
  return encoded(vertices, cells);
}

// Returns the data that all ranks know.
template <class Complex>
std::string encoded_head(const Distributed_mesh<Complex>& mesh, const std::string& metadata) {
  std::vector<Checkpoint_component> components;
  for (const auto& [number, component] : mesh.components)
    components.push_back({number, component.label, component.volume});
  return encoded(std::uint32_t(mesh.communicator->size()),
                 coordinates_of<Complex::dimension>(mesh.normalization.translation),
                 mesh.normalization.scale, mesh.mean_interface_edge, mesh.minimum_interface_edge,
                 mesh.domain_measure, mesh.next_id, components, metadata);
}

// Decodes the data that all ranks know. Returns whether it is complete.
template <class Complex>
bool decode_head(const Communicator::Bytes& bytes, Distributed_mesh<Complex>& mesh,
                 std::uint32_t& number_of_pieces, std::string& metadata) {
  std::array<double, Complex::dimension> translation = {};
  std::vector<Checkpoint_component> components;
  if (!decode({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, number_of_pieces,
              translation, mesh.normalization.scale, mesh.mean_interface_edge,
              mesh.minimum_interface_edge, mesh.domain_measure, mesh.next_id, components, metadata))
    return false;
  mesh.normalization.translation = vector_of<Complex>(translation);
  for (const Checkpoint_component& c : components)
    mesh.components[c.number] = {c.label, c.volume};
  return true;
}

template <class Complex>
void write_checkpoint_blocks(const std::string& path, const Distributed_mesh<Complex>& mesh,
                             const std::string& metadata) {
  Communicator& communicator = *mesh.communicator;
  std::vector<Communicator::Message> own(1); // before the others wait for it: memory can be short
  {
    const std::string piece = encoded_piece(mesh);
    own[0].bytes.assign(piece.begin(), piece.end());
  }
  int sent = 0; // pieces
  // Returns the next piece, on the first rank.
  const auto next_piece = [&] {
    const bool is_own = mesh.rank() == sent++;
    auto arrived = communicator.exchange(is_own ? std::move(own) : decltype(own)());
    return arrived.empty() ? Communicator::Bytes() : std::move(arrived.front().bytes);
  };
  std::exception_ptr failure;
  if (mesh.rank() == 0)
    try {
      replace_file(path, [&](std::ostream& out) {
        out << checkpoint_magic(Checkpoint_kind::ranks, Complex::dimension);
        write_block(out, encoded_head(mesh, metadata));
        while (sent < communicator.size()) {
          const Communicator::Bytes bytes = next_piece();
          write_block(out, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
        }
      });
    } catch (const std::bad_alloc&) {
      throw; // another rank can wait until its piece is received
    } catch (...) {
      failure = std::current_exception();
    }
  // The other ranks send their pieces, even if the first one can no longer write.
  while (sent < communicator.size())
    next_piece();
  communicator.call_together([&] {
    if (failure)
      std::rethrow_exception(failure);
  });
}

template <class Complex>
std::string read_checkpoint_blocks(const std::string& path, Distributed_mesh<Complex>& mesh) {
  static constexpr int d = Complex::dimension;
  Communicator& communicator = *mesh.communicator;
  mesh.clear();
  std::optional<Input_file> in;
  std::optional<Checkpoint_reader> reader; // on the first rank
  std::string head;
  communicator.call_together([&] {
    if (mesh.rank() != 0)
      return;
    in.emplace(path, ".dsc");
    reader.emplace(*in, path, Checkpoint_kind::ranks, d);
    head = reader->next(false);
  });
  const auto bytes = communicator.all_gather({head.begin(), head.end()}).front();
  std::uint32_t n = 0; // number of pieces
  std::string metadata;
  require_checkpoint(decode_head(bytes, mesh, n, metadata), path, inconsistent_checkpoint);

  for (std::uint32_t i = 0; i < n; ++i) {
    Placement<d> placement;
    try {
      communicator.call_together([&] {
        if (mesh.rank() != 0)
          return;
        std::vector<Piece_vertex<d>> vertices;
        std::vector<Sent_cell<d>> cells;
        bool is_consistent = decode(reader->next(i + 1 == n), vertices, cells);
        for (Piece_vertex<d>& v : vertices) {
          is_consistent = is_consistent && v.owner >= 0 && std::uint32_t(v.owner) < n;
          // The owners of the file become ranks in the same order.
          v.owner = int(std::int64_t(v.owner) * communicator.size() / n);
        }
        require_checkpoint(is_consistent, path, inconsistent_checkpoint);
        placement.add(vertices, cells);
      });
    } catch (...) {
      mesh.clear();
      throw;
    }
    placement.send(communicator, mesh.piece);
  }
  mesh.find_ghosts();
  // A checkpoint that was written after an exception in a motion has new components.
  bool has_new_cells = false;
  for (std::uint32_t c = 0; c < mesh.piece.cell_bound(); ++c)
    has_new_cells = has_new_cells || mesh.piece.cell(c).data.component == 0;
  mesh.are_components_known =
      communicator.reduced(Communicator::Operation::maximum, has_new_cells ? 1 : 0) == 0;
  return metadata;
}

} // namespace Deformable_simplicial_complexes::internal

namespace IO {

/*!
\ingroup PkgDistributedComplexesRef

Writes a distributed complex to one file. A run that continues from the file gives a bitwise
identical complex for any number of ranks. The first rank writes the file; it holds one piece of
another rank at a time. A temporary file in the same folder is written and renamed when complete, so
if a process ends while writing, the previous checkpoint is unchanged. Collective.

The file is binary and the same on all machines. Each piece has a checksum.

\param path name of the file; its folder must exist
\param complex the complex
\param metadata any sequence of bytes, on the first rank
\throws Deformable_simplicial_complexes::Error on all ranks if the file cannot be written; an older
        file of that name is then unchanged
*/
template <class Complex>
void write_checkpoint(const std::string& path,
                      const Deformable_simplicial_complexes::Distributed_complex<Complex>& complex,
                      const std::string& metadata = std::string()) {
  Deformable_simplicial_complexes::internal::write_checkpoint_blocks(path, complex.mesh(),
                                                                     metadata);
}

/*!
\ingroup PkgDistributedComplexesRef

Reads a file that `write_checkpoint()` wrote for a distributed complex, with any number of ranks.
The first rank reads the file; it holds one piece at a time. Collective.

\param path name of the file
\param complex receives the complex; it is empty after an error
\return the metadata, on all ranks
\throws Deformable_simplicial_complexes::Error on all ranks if the file cannot be read, is not such a
        checkpoint, is truncated or damaged
*/
template <class Complex>
std::string
read_checkpoint(const std::string& path,
                Deformable_simplicial_complexes::Distributed_complex<Complex>& complex) {
  return Deformable_simplicial_complexes::internal::read_checkpoint_blocks(path, complex.mesh());
}

} // namespace IO
} // namespace CGAL

#endif // CGAL_DISTRIBUTED_COMPLEXES_DISTRIBUTED_CHECKPOINT_H
