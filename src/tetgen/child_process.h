// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_CHILD_PROCESS_H
#define DSC_CHILD_PROCESS_H

#include <cstddef>
#include <functional>
#include <vector>

#if defined(__unix__) || defined(__APPLE__)
#define DSC_HAS_FORK
#include <sys/types.h>
#endif

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

/// A child of this process, which runs a function and sends bytes back. The function may crash, use
/// up memory or never end: the child dies of that, not the caller. What the function prints is
/// dropped, and what it does to memory is lost with the child.
///
/// Of the threads of the caller, the child has none. So the function must not wait for them, and of
/// the locks that they might hold, it may take only those that fork() sets free in the child: those
/// of memory and, with glibc, of the streams of C.
///
/// Where there is no fork(), the function runs in this process and may take it down.
class Child_process
{
public:
  using Send = std::function<void(const void* data, std::size_t size)>;
  using Function = std::function<void(const Send&)>;

  enum class End {
    EXITED,
    CRASHED,
    KILLED, ///< by someone else, such as a system that is short of memory
    TIMED_OUT
  };

  struct Outcome
  {
    End end;
    int code; ///< what the child exited with, or the signal that killed it
  };

  /// Starts the child.
  /// \param function An `int` that it throws becomes the exit code, and nothing is destroyed on the
  ///        way. Any other exception is a crash. If it returns, the exit code is zero.
  /// \param seconds after which the child is killed, infinity for never
  /// \throws std::system_error if the system has no room for another process
  Child_process(const Function& function, double seconds);

  /// Kills the child unless it has ended. Never leaves a zombie.
  ~Child_process();

  Child_process(const Child_process&) = delete;
  Child_process& operator=(const Child_process&) = delete;

  /// Waits for the next `size` bytes that the function sends. False if it ended before. \throws
  /// Interrupted_error, see Progress_scope
  bool read(void* data, std::size_t size);

  /// Waits until the child has ended; what it still sends is lost. To be called once. Where the
  /// caller ignores SIGCHLD, nobody knows how it ended, which is taken for exit code zero.
  Outcome wait();

private:
  // Puts at least a byte into `m_data`. False if nothing comes any more.
  bool refill();

  std::vector<char> m_data;   // received
  std::size_t m_position = 0; // in it, of what has not been read
#ifdef DSC_HAS_FORK
  int m_pipe;
  pid_t m_pid;
#else
  Outcome m_outcome = {End::EXITED, 0};
#endif
};

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // DSC_CHILD_PROCESS_H
