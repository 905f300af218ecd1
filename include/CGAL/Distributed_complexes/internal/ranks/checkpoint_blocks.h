// Copyright (c) 2026 The deformable simplicial complex authors.
// All rights reserved.
//
// This file is part of the package Distributed_complexes, written for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISTRIBUTED_COMPLEXES_INTERNAL_RANKS_CHECKPOINT_BLOCKS_H
#define CGAL_DISTRIBUTED_COMPLEXES_INTERNAL_RANKS_CHECKPOINT_BLOCKS_H

#include <CGAL/Distributed_complexes/internal/ranks/Distributed_mesh.h>
#include <CGAL/Distributed_complexes/internal/ranks/Piece.h>
#include <CGAL/Distributed_complexes/internal/ranks/Placement.h>
#include <CGAL/Distributed_complexes/internal/ranks/message_bytes.h>
#include <CGAL/Distributed_complexes/is_distributed_checkpoint.h>
#include <CGAL/Mesh_files/internal/text/open_input.h>
#include <CGAL/Mesh_files/replace_file.h>
#include <CGAL/Mesh_support/Error.h>
#include <CGAL/Mesh_support/coordinates.h>

#include <boost/crc.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <ostream>
#include <string>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes::internal {

// A checkpoint of a distributed complex is a sequence of blocks: a header, followed by
// the vertices and cells of each rank. A block is its size, its checksum and its bytes.

template <int d> std::array<char, 8> magic_of_blocks() {
  std::array<char, 8> result = {{}};
  std::copy(magic_of_several_ranks.begin(), magic_of_several_ranks.end(), result.begin());
  result[5] = char('0' + d);
  result[6] = '\r';
  result[7] = '\n';
  return result;
}
constexpr std::uint32_t version_of_blocks = 2;

template <int d> struct Checkpoint_head
{
  std::uint32_t version, number_of_pieces;
  std::array<double, d> translation;
  double scale, mean_interface_edge, minimum_interface_edge, domain_measure;
  Global_id next_id;
};

struct Checkpoint_component
{
  std::uint32_t number;
  std::int32_t label;
  std::int64_t volume;
};

inline std::uint32_t checksum_of(const Communicator::Bytes& bytes) {
  boost::crc_32_type crc;
  crc.process_bytes(bytes.data(), bytes.size());
  return crc.checksum();
}

inline void write_block(std::ostream& out, const Communicator::Bytes& bytes) {
  const std::uint64_t size = bytes.size(), checksum = checksum_of(bytes);
  out.write(reinterpret_cast<const char*>(&size), sizeof(size));
  out.write(reinterpret_cast<const char*>(&checksum), sizeof(checksum));
  out.write(reinterpret_cast<const char*>(bytes.data()), std::streamsize(size));
}

// Reads a block. `left` is the number of remaining bytes of the file; it is decreased. Throws
// Error if the file is too short or the checksum is wrong.
inline Communicator::Bytes read_block(std::istream& in, const std::string& path,
                                      std::uint64_t& left) {
  std::uint64_t size = 0, checksum = 0;
  if (left < sizeof(size) + sizeof(checksum))
    throw Error(path + " is truncated: continue from an older checkpoint");
  in.read(reinterpret_cast<char*>(&size), sizeof(size));
  in.read(reinterpret_cast<char*>(&checksum), sizeof(checksum));
  left -= sizeof(size) + sizeof(checksum);
  if (!in || size > left)
    throw Error(path + " is truncated: continue from an older checkpoint");
  Communicator::Bytes bytes(size);
  in.read(reinterpret_cast<char*>(bytes.data()), std::streamsize(size));
  left -= size;
  if (!in || checksum_of(bytes) != checksum)
    throw Error(path + " is damaged: continue from an older checkpoint or a copy of the file");
  return bytes;
}

// Returns the own cells of a rank, and all their vertices.
template <class Complex> Communicator::Bytes bytes_of_piece(const Distributed_mesh<Complex>& mesh) {
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
  Message_writer writer;
  writer.write(vertices);
  writer.write(cells);
  return writer.take();
}

template <class Complex>
Communicator::Bytes head_of_checkpoint(const Distributed_mesh<Complex>& mesh,
                                       const std::string& metadata) {
  static constexpr int d = Complex::dimension;
  Message_writer head;
  head.write(Checkpoint_head<d>{version_of_blocks, std::uint32_t(mesh.communicator->size()),
                                coordinates_of<d>(mesh.normalization.translation),
                                mesh.normalization.scale, mesh.mean_interface_edge,
                                mesh.minimum_interface_edge, mesh.domain_measure, mesh.next_id});
  std::vector<Checkpoint_component> components;
  for (const auto& [number, component] : mesh.components)
    components.push_back({number, component.label, component.volume});
  head.write(components);
  head.write(std::vector<char>(metadata.begin(), metadata.end()));
  return head.take();
}

template <class Complex>
void write_checkpoint_blocks(const std::string& path, const Distributed_mesh<Complex>& mesh,
                             const std::string& metadata) {
  static constexpr int d = Complex::dimension;
  Communicator& communicator = *mesh.communicator;
  const Communicator::Bytes piece = bytes_of_piece(mesh);
  // Returns the piece of a rank, on the first rank.
  const auto next_piece = [&](int rank) {
    std::vector<Communicator::Message> messages;
    if (mesh.rank() == rank)
      messages.push_back({0, piece});
    auto arrived = communicator.exchange(std::move(messages));
    return arrived.empty() ? Communicator::Bytes() : std::move(arrived.front().bytes);
  };
  int sent = 0; // pieces
  communicator.call_together([&] {
    try {
      if (mesh.rank() == 0)
        replace_file_by_stream(path, [&](std::ostream& out) {
          const auto magic = magic_of_blocks<d>();
          out.write(magic.data(), magic.size());
          write_block(out, head_of_checkpoint(mesh, metadata));
          while (sent < communicator.size())
            write_block(out, next_piece(sent++));
        });
    } catch (...) {
      // The other ranks send their pieces, even if the first one can no longer write.
      while (sent < communicator.size())
        next_piece(sent++);
      throw;
    }
    while (sent < communicator.size())
      next_piece(sent++);
  });
}

template <class Complex>
std::string read_checkpoint_blocks(const std::string& path, Distributed_mesh<Complex>& mesh) {
  static constexpr int d = Complex::dimension;
  Communicator& communicator = *mesh.communicator;
  mesh.clear();
  std::ifstream in;
  std::uint64_t left = 0;
  Communicator::Bytes block;
  communicator.call_together([&] {
    if (mesh.rank() != 0)
      return;
    in = open_input(path, ".dsc");
    in.seekg(0, std::ios::end);
    left = std::uint64_t(in.tellg());
    in.seekg(0);
    std::array<char, 8> magic = {};
    in.read(magic.data(), magic.size());
    if (!in || magic != magic_of_blocks<d>())
      throw Error(path + " is not a checkpoint of a distributed complex in " + std::to_string(d) +
                  " dimensions: choose another file");
    left -= magic.size();
    block = read_block(in, path, left);
  });
  const Communicator::Bytes bytes = communicator.all_gather(block).front();
  Message_reader reader(bytes);
  const auto head = reader.template read<Checkpoint_head<d>>();
  if (head.version != version_of_blocks)
    throw Error(path + " has version " + std::to_string(head.version) + " instead of " +
                std::to_string(version_of_blocks) +
                ": read it with the version of this package that wrote it");
  mesh.normalization = {vector_of<Complex>(head.translation), head.scale};
  mesh.mean_interface_edge = head.mean_interface_edge;
  mesh.minimum_interface_edge = head.minimum_interface_edge;
  mesh.domain_measure = head.domain_measure;
  mesh.next_id = head.next_id;
  for (const auto& c : reader.template read_list<Checkpoint_component>())
    mesh.components[c.number] = {c.label, c.volume};
  const auto metadata = reader.template read_list<char>();

  // The owners of the file become ranks in the same order.
  const auto owner = [&](const Piece_vertex<d>& v) {
    return int(std::int64_t(v.owner) * communicator.size() / head.number_of_pieces);
  };
  for (std::uint32_t i = 0; i < head.number_of_pieces; ++i) {
    Placement<d> placement;
    try {
      communicator.call_together([&] {
        if (mesh.rank() != 0)
          return;
        const Communicator::Bytes piece = read_block(in, path, left);
        Message_reader piece_reader(piece);
        auto vertices = piece_reader.template read_list<Piece_vertex<d>>();
        const auto cells = piece_reader.template read_list<Sent_cell<d>>();
        for (Piece_vertex<d>& v : vertices)
          v.owner = owner(v);
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
  return std::string(metadata.begin(), metadata.end());
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DISTRIBUTED_COMPLEXES_INTERNAL_RANKS_CHECKPOINT_BLOCKS_H
