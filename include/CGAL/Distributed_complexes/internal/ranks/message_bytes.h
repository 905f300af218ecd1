// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DISTRIBUTED_COMPLEXES_INTERNAL_RANKS_MESSAGE_BYTES_H
#define CGAL_DISTRIBUTED_COMPLEXES_INTERNAL_RANKS_MESSAGE_BYTES_H

#include <CGAL/Distributed_complexes/Communicator.h>
#include <CGAL/Mesh_support/Error.h>

#include <cstring>
#include <map>
#include <type_traits>

namespace CGAL::Deformable_simplicial_complexes::internal {

// Appends lists of plain items to a message. All ranks run the same program on machines of one
// kind, so items are sent as they are in memory.
class Message_writer
{
public:
  template <class Item> void write(const Item& item) {
    static_assert(std::is_trivially_copyable<Item>::value, "items are sent as bytes");
    const auto* const first = reinterpret_cast<const unsigned char*>(&item);
    m_bytes.insert(m_bytes.end(), first, first + sizeof(Item));
  }

  template <class Item> void write(const std::vector<Item>& items) {
    static_assert(std::is_trivially_copyable<Item>::value, "items are sent as bytes");
    write(std::uint64_t(items.size()));
    const auto* const first = reinterpret_cast<const unsigned char*>(items.data());
    m_bytes.insert(m_bytes.end(), first, first + items.size() * sizeof(Item));
  }

  Communicator::Bytes take() { return std::move(m_bytes); }

private:
  Communicator::Bytes m_bytes;
};

// Reads a message in the order in which it was written.
class Message_reader
{
public:
  explicit Message_reader(const Communicator::Bytes& bytes) : m_bytes(bytes) {}

  bool is_at_end() const { return m_position == m_bytes.size(); }

  template <class Item> Item read() {
    Item item;
    copy(&item, sizeof(Item));
    return item;
  }

  template <class Item> std::vector<Item> read_list() {
    const std::uint64_t size = read<std::uint64_t>();
    if (size > (m_bytes.size() - m_position) / sizeof(Item))
      throw Error("a message between ranks is shorter than its list");
    std::vector<Item> items(size);
    copy(items.data(), size * sizeof(Item));
    return items;
  }

private:
  void copy(void* to, std::size_t size) {
    if (size > m_bytes.size() - m_position)
      throw Error("a message between ranks is too short");
    if (size > 0)
      std::memcpy(to, m_bytes.data() + m_position, size);
    m_position += size;
  }

  const Communicator::Bytes& m_bytes;
  std::size_t m_position = 0;
};

// Sends messages to ranks. Calls `receive(rank, reader)` for the messages that arrive, by
// increasing sender, for each until it is read.
template <class Receive>
void exchange_messages(Communicator& communicator, std::map<int, Message_writer>& writers,
                       const Receive& receive) {
  std::vector<Communicator::Message> messages;
  for (auto& [rank, writer] : writers)
    messages.push_back({rank, writer.take()});
  for (const auto& message : communicator.exchange(std::move(messages)))
    for (Message_reader reader(message.bytes); !reader.is_at_end();)
      receive(message.rank, reader);
}

// Sends each rank a list of items, and calls `receive(rank, items)` for each list that arrives, by
// increasing sender.
template <class Item, class Receive>
void exchange_lists(Communicator& communicator, const std::map<int, std::vector<Item>>& lists,
                    const Receive& receive) {
  std::map<int, Message_writer> writers;
  for (const auto& [rank, items] : lists)
    writers[rank].write(items);
  exchange_messages(communicator, writers, [&](int rank, Message_reader& reader) {
    receive(rank, reader.read_list<Item>());
  });
}

// Returns the items of all ranks, by increasing rank.
template <class Item>
std::vector<Item> gather_items(Communicator& communicator, const std::vector<Item>& items) {
  Message_writer writer;
  writer.write(items);
  std::vector<Item> result;
  for (const auto& bytes : communicator.all_gather(writer.take())) {
    const auto some = Message_reader(bytes).read_list<Item>();
    result.insert(result.end(), some.begin(), some.end());
  }
  return result;
}

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // CGAL_DISTRIBUTED_COMPLEXES_INTERNAL_RANKS_MESSAGE_BYTES_H
