// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DISTRIBUTED_COMPLEXES_COMMUNICATOR_H
#define CGAL_DISTRIBUTED_COMPLEXES_COMMUNICATOR_H

#include <CGAL/Mesh_support/Error.h>
#include <CGAL/Mesh_support/Progress_scope.h>

#include <cstddef>
#include <cstdint>
#include <new>
#include <string>
#include <vector>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgDistributedComplexesRef

Messages between the ranks of a distributed complex. All functions are collective:
each rank calls the same functions in the same order.

A class derives from this class for each way to send messages: `Mpi_communicator` for processes,
and the threads of `run_in_threads()` for tests and debuggers.
*/
class Communicator
{
public:
  using Bytes = std::vector<unsigned char>; ///< contents of a message

  /// Message to a rank, or from a rank.
  struct Message
  {
    int rank;    ///< receiver or sender
    Bytes bytes; ///< contents
  };

  /// Operation of `reduce()`.
  enum class Operation { sum, minimum, maximum };

  /// What a rank sent since the communicator was constructed.
  struct Traffic
  {
    std::uint64_t bytes = 0;      ///< bytes to other ranks; reductions and gathers count once
    std::uint64_t messages = 0;   ///< messages to other ranks
    std::uint64_t exchanges = 0;  ///< calls of `exchange()`
    std::uint64_t reductions = 0; ///< calls of `reduce()` and `all_gather()`
  };

  Communicator() = default;
  Communicator(const Communicator&) = delete;
  Communicator& operator=(const Communicator&) = delete;
  virtual ~Communicator() = default;

  /// Returns the number of this rank, in [0, size()).
  virtual int rank() const = 0;
  /// Returns the number of ranks.
  virtual int size() const = 0;

  /// Sends messages, and returns the messages that this rank receives, ordered by sender. A rank
  /// may send to itself, and sends at most one message to each rank.
  std::vector<Message> exchange(std::vector<Message> messages) {
    ++m_traffic.exchanges;
    for (const Message& message : messages)
      if (message.rank != rank()) {
        ++m_traffic.messages;
        m_traffic.bytes += message.bytes.size();
      }
    return do_exchange(std::move(messages));
  }

  /// Returns the bytes of each rank, ordered by rank.
  std::vector<Bytes> all_gather(const Bytes& bytes) {
    ++m_traffic.reductions;
    if (size() > 1)
      m_traffic.bytes += bytes.size();
    return do_all_gather(bytes);
  }

  /// Replaces each number by the sum, minimum or maximum of the numbers of all ranks at this place.
  /// \pre All ranks pass the same number of numbers, and no sum overflows.
  void reduce(Operation operation, std::vector<std::int64_t>& numbers) {
    ++m_traffic.reductions;
    if (size() > 1)
      m_traffic.bytes += numbers.size() * sizeof(std::int64_t);
    do_reduce(operation, numbers);
  }

  /// Returns the sum, minimum or maximum of a number of all ranks.
  std::int64_t reduced(Operation operation, std::int64_t number) {
    std::vector<std::int64_t> numbers(1, number);
    reduce(operation, numbers);
    return numbers.front();
  }

  /// Throws an error on all ranks if there is an error on one of them: the same error, with the
  /// message of the first rank that has one.
  /// \param message the error of this rank; empty without an error
  /// \throws Error if the message of a rank is not empty
  void agree_on_error(const std::string& message) {
    const std::int64_t first = reduced(Operation::minimum, message.empty() ? size() : rank());
    if (first == size())
      return;
    const std::vector<Bytes> all = all_gather(Bytes(message.begin(), message.end()));
    const Bytes& text = all[std::size_t(first)];
    throw Error(std::string(text.begin(), text.end()));
  }

  /// Calls a function on each rank. If it throws on one of them, all ranks throw.
  /// \param function function object without arguments. It must not call functions of the
  ///        communicator, or they must throw on all ranks or on none.
  /// \throws Error on all ranks with the message of the first rank whose function throws a
  ///         `std::exception`
  /// \throws Interrupted_error on all ranks if a function throws it
  template <class Function> void call_together(const Function& function) {
    std::string error;
    bool is_interrupted = false;
    try {
      function();
    } catch (const Interrupted_error&) {
      is_interrupted = true;
    } catch (const std::bad_alloc&) {
      error = "not enough memory on rank " + std::to_string(rank()) + "; use more ranks";
    } catch (const std::exception& e) {
      error = e.what();
      if (error.empty())
        error = "unknown error";
    }
    // One reduction if nothing was thrown: iterations of solvers call this function.
    if (reduced(Operation::maximum, is_interrupted || !error.empty()) == 0)
      return;
    agree_on_error(error);
    agree_on_interrupt(is_interrupted);
  }

  /// Calls `Progress_scope::check()` on all ranks. If it throws on one of them, all ranks throw.
  /// \throws Interrupted_error if the callback of a scope of a rank returned `false`
  void check_progress() {
    call_together([] { Progress_scope::check(); });
  }

  /// Throws `Interrupted_error` on all ranks if a rank is interrupted.
  /// \throws Interrupted_error if the argument is `true` on a rank
  void agree_on_interrupt(bool is_interrupted) {
    if (reduced(Operation::maximum, is_interrupted) != 0)
      throw Interrupted_error();
  }

  /// Returns what this rank sent.
  const Traffic& traffic() const { return m_traffic; }

private:
  virtual std::vector<Message> do_exchange(std::vector<Message> messages) = 0;
  virtual std::vector<Bytes> do_all_gather(const Bytes& bytes) = 0;
  virtual void do_reduce(Operation operation, std::vector<std::int64_t>& numbers) = 0;

  Traffic m_traffic;
};

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_DISTRIBUTED_COMPLEXES_COMMUNICATOR_H
