// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DISTRIBUTED_COMPLEXES_RUN_IN_THREADS_H
#define CGAL_DISTRIBUTED_COMPLEXES_RUN_IN_THREADS_H

#include <CGAL/Distributed_complexes/Communicator.h>

#include <algorithm>
#include <condition_variable>
#include <mutex>
#include <thread>

namespace CGAL::Deformable_simplicial_complexes {
namespace internal {

// The place where the threads of a process exchange messages.
class Thread_exchange
{
public:
  using Bytes = Communicator::Bytes;
  using Message = Communicator::Message;

  // Thrown on a rank that waits for a rank that failed.
  struct Other_rank_failed
  {
  };

  explicit Thread_exchange(int size) : m_size(size), m_inboxes(size), m_gathered(size) {}

  int size() const { return m_size; }

  std::vector<Message> exchange(int rank, std::vector<Message> messages) {
    {
      const std::lock_guard<std::mutex> lock(m_mutex);
      for (Message& message : messages)
        m_inboxes[message.rank].push_back({rank, std::move(message.bytes)});
    }
    wait_for_all();
    std::vector<Message> result;
    result.swap(m_inboxes[rank]);
    wait_for_all(); // nobody sends again before all have received
    std::sort(result.begin(), result.end(),
              [](const Message& a, const Message& b) { return a.rank < b.rank; });
    return result;
  }

  std::vector<Bytes> all_gather(int rank, const Bytes& bytes) {
    {
      const std::lock_guard<std::mutex> lock(m_mutex);
      m_gathered[rank] = bytes;
    }
    wait_for_all();
    std::vector<Bytes> result = m_gathered;
    wait_for_all();
    return result;
  }

  // Ends the waiting of all ranks.
  void fail() {
    const std::lock_guard<std::mutex> lock(m_mutex);
    m_has_failed = true;
    m_changed.notify_all();
  }

private:
  void wait_for_all() {
    std::unique_lock<std::mutex> lock(m_mutex);
    const std::size_t phase = m_phase;
    if (++m_waiting == m_size) {
      m_waiting = 0;
      ++m_phase;
      m_changed.notify_all();
    } else {
      m_changed.wait(lock, [&] { return m_has_failed || m_phase != phase; });
    }
    if (m_has_failed)
      throw Other_rank_failed();
  }

  int m_size;
  std::mutex m_mutex;
  std::condition_variable m_changed;
  int m_waiting = 0;
  std::size_t m_phase = 0;
  bool m_has_failed = false;
  std::vector<std::vector<Message>> m_inboxes;
  std::vector<Bytes> m_gathered;
};

// A rank that is a thread of this process.
class Thread_communicator : public Communicator
{
public:
  Thread_communicator(Thread_exchange& exchange, int rank) : m_exchange(exchange), m_rank(rank) {}

  int rank() const override { return m_rank; }
  int size() const override { return m_exchange.size(); }

private:
  std::vector<Message> do_exchange(std::vector<Message> messages) override {
    return m_exchange.exchange(m_rank, std::move(messages));
  }

  std::vector<Bytes> do_all_gather(const Bytes& bytes) override {
    return m_exchange.all_gather(m_rank, bytes);
  }

  void do_reduce(Operation operation, std::vector<std::int64_t>& numbers) override {
    const auto* const first = reinterpret_cast<const unsigned char*>(numbers.data());
    const std::vector<Bytes> all =
        m_exchange.all_gather(m_rank, Bytes(first, first + numbers.size() * sizeof(std::int64_t)));
    for (int r = 0; r < size(); ++r) {
      if (r == m_rank)
        continue;
      const auto* const others = reinterpret_cast<const std::int64_t*>(all[r].data());
      for (std::size_t i = 0; i < numbers.size(); ++i)
        numbers[i] = operation == Operation::sum       ? numbers[i] + others[i]
                     : operation == Operation::minimum ? (std::min)(numbers[i], others[i])
                                                       : (std::max)(numbers[i], others[i]);
    }
  }

  Thread_exchange& m_exchange;
  int m_rank;
};

} // namespace internal

/*!
\ingroup PkgDistributedComplexesRef

Runs a function on several ranks that are threads of this process. A debugger thus sees all ranks,
and tests need no other program. The result of a function of this package does not depend on whether
its ranks are threads or processes.

\param size the number of ranks, at least 1
\param function function object, called as `function(Communicator&)` once for each rank
\throws the exception of the lowest rank whose function throws. The function of another rank is left by
        an internal exception at its next call of the communicator, so it must not catch `...`
        without rethrowing.
*/
template <class Function> void run_in_threads(int size, const Function& function) {
  internal::Thread_exchange exchange(size);
  std::vector<std::exception_ptr> errors(size);
  std::vector<std::thread> threads;
  const auto run = [&](int rank) {
    try {
      internal::Thread_communicator communicator(exchange, rank);
      function(static_cast<Communicator&>(communicator));
    } catch (const internal::Thread_exchange::Other_rank_failed&) {
      // the error of that rank is reported
    } catch (...) {
      errors[rank] = std::current_exception();
      exchange.fail();
    }
  };
  for (int rank = 1; rank < size; ++rank)
    threads.emplace_back(run, rank);
  run(0);
  for (std::thread& thread : threads)
    thread.join();
  for (const std::exception_ptr& error : errors)
    if (error)
      std::rethrow_exception(error);
}

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_DISTRIBUTED_COMPLEXES_RUN_IN_THREADS_H
