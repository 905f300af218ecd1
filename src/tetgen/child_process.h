// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_CHILD_PROCESS_H
#define DSC_CHILD_PROCESS_H

#include <cstddef>
#include <functional>
#include <limits>
#include <vector>

#if defined(__unix__) || defined(__APPLE__)
#define DSC_HAS_FORK
#include <sys/types.h>
#endif

namespace CGAL::Deformable_simplicial_complexes::internal {

/// A child process that runs a function and sends bytes to this process. If the function crashes,
/// exhausts the memory or does not terminate, only the child ends. The output of the function is
/// discarded, and its changes of memory are lost with the child.
///
/// The child has only the calling thread. So the function must not wait for other threads. Of the
/// locks that other threads may hold, it may take only those that fork() resets in the child: the
/// locks of memory allocation and, with glibc, of the streams of C.
///
/// On systems without fork(), the function runs in this process, and a crash ends this process.
class Child_process
{
public:
  using Send = std::function<void(const void* data, std::size_t size)>;
  using Function = std::function<void(const Send&)>;

  enum class End {
    EXITED,
    CRASHED,
    KILLED, ///< by another process or the system, for example for lack of memory
    TIMED_OUT
  };

  struct Outcome
  {
    End end;
    int code; ///< exit code of the child, or the signal that killed it
  };

  /// Starts the child.
  /// \param function The function to run. An `int` that it throws becomes the exit code;
  /// destructors are not called in this case. Any other exception is a crash. If it returns, the
  /// exit code is zero.
  /// \param seconds time limit after which the child is killed; infinity for no limit
  /// \param processor_seconds the same for its processor time, which is rounded up to seconds
  /// \throws std::system_error if the system cannot create another process
  Child_process(const Function& function, double seconds,
                double processor_seconds = std::numeric_limits<double>::infinity());

  /// Kills the child unless it has ended. Never leaves a zombie process.
  ~Child_process();

  Child_process(const Child_process&) = delete;
  Child_process& operator=(const Child_process&) = delete;

  /// Waits for the next `size` bytes from the function. Returns false if the function ended before.
  /// \throws Interrupted_error if the computation is interrupted; see Progress_scope
  bool read(void* data, std::size_t size);

  /// Waits until the child has ended. Bytes that the child still sends are discarded. Must be
  /// called at most once. If the caller ignores SIGCHLD, the exit status is unknown and counts as
  /// exit code zero.
  Outcome wait();

private:
  // Receives at least one byte into `m_data`. Returns false if there are no more bytes.
  bool refill();

  std::vector<char> m_data;   // received bytes
  std::size_t m_position = 0; // position of the first unread byte
#ifdef DSC_HAS_FORK
  int m_pipe;
  pid_t m_pid;
#else
  Outcome m_outcome = {End::EXITED, 0};
#endif
};

} // namespace CGAL::Deformable_simplicial_complexes::internal

#endif // DSC_CHILD_PROCESS_H
