// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_MESH_SUPPORT_PROGRESS_SCOPE_H
#define CGAL_MESH_SUPPORT_PROGRESS_SCOPE_H

#include <chrono>
#include <exception>
#include <functional>
#include <utility>

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgMeshSupportRef

Exception thrown by functions of this package if the callback of a `Progress_scope` returned
`false`. If the function was changing a complex, the complex is valid. If it was creating an object
or a file, the object or file does not exist. The class does not derive from `Error`, since the
input is not the cause.
*/
class Interrupted_error : public std::exception
{
public:
  /// Returns a message.
  const char* what() const noexcept override {
    return "interrupted: the progress callback returned false";
  }
};

/*!
\ingroup PkgMeshSupportRef

Scope that reports the progress of functions of this package and can stop them. While a scope
exists, all functions called in its thread call its callback about twenty times a second. This holds
for all functions: building, tetrahedralization, images, reconstruction, repair, cut loci,
improvement, motions, fluids, files. If the callback returns `false`, the function throws
`Interrupted_error` within a second.

\code
CGAL::Deformable_simplicial_complexes::Progress_scope scope(
    [&](const char* phase) { return !is_cancelled; });
auto complex = make_deformable_simplicial_complex_3<Complex>(surface, tetrahedralizer);
\endcode

Scopes can be nested. The callbacks of all scopes of the thread are called at the interval of the
innermost scope, in the order from the innermost to the outermost scope.
*/
class Progress_scope
{
public:
  /// Callback type. The argument names the current phase, such as "filling the box with
  /// tetrahedra". The result tells whether to continue.
  using Callback = std::function<bool(const char* phase)>;

  /// Begins the scope. If the callback throws, the function of the package throws the same
  /// exception. The callback may call functions of the package that do not modify the object being
  /// changed. These functions do not call the callback.
  /// \param callback called to ask whether to continue
  /// \param interval shortest time between two calls while this scope is the innermost one; 0 for a
  ///        call at each check
  /// \pre `callback` is not empty. Scopes of a thread are destroyed in the reverse order of their
  ///      construction, in that thread.
  explicit Progress_scope(Callback callback,
                          std::chrono::milliseconds interval = std::chrono::milliseconds(50))
      : m_callback(std::move(callback)), m_interval(interval),
        m_outer(std::exchange(innermost(), this)) {}

  /// Ends the scope.
  ~Progress_scope() { innermost() = m_outer; }

  Progress_scope(const Progress_scope&) = delete;
  Progress_scope& operator=(const Progress_scope&) = delete;

  /// Calls the callbacks of all scopes of this thread if the interval of the innermost scope has
  /// passed since the last call. Loops of user code may call this function, too.
  /// \throws Interrupted_error if one of the callbacks returned `false`
  static void check() {
    if (innermost() != nullptr)
      innermost()->check_now_and_then();
  }

private:
  friend class Progress_pause;
  friend class Progress_phase;
  using Clock = std::chrono::steady_clock;

  static Progress_scope*& innermost() {
    static thread_local Progress_scope* scope = nullptr;
    return scope;
  }

  // Disables all scopes of the thread while callbacks run, since callbacks may call functions of
  // the package.
  struct Silence
  {
    Progress_scope* scope = std::exchange(innermost(), nullptr);

    Silence() = default;
    ~Silence() { innermost() = scope; }
    Silence(const Silence&) = delete;
    Silence& operator=(const Silence&) = delete;
  };

  static const char*& phase() {
    static thread_local const char* name = "computing";
    return name;
  }

  // Reading the clock takes longer than many steps of a loop. While checks follow each other fast,
  // only some of them read it.
  void check_now_and_then() {
    static constexpr unsigned skipped = 7; // checks; even slow steps then end within a second
    static constexpr std::chrono::milliseconds soon(1);
    if (m_number_to_skip > 0) {
      --m_number_to_skip;
      return;
    }
    const Clock::time_point now = Clock::now();
    m_number_to_skip = m_interval > soon && now - m_last < soon ? skipped : 0;
    m_last = now;
    if (now < m_next)
      return;
    m_next = now + m_interval;
    const Silence while_asking;
    for (const Progress_scope* scope = this; scope != nullptr; scope = scope->m_outer)
      if (!scope->m_callback(phase()))
        throw Interrupted_error();
  }

  Callback m_callback;
  std::chrono::milliseconds m_interval;
  Progress_scope* m_outer;
  Clock::time_point m_next = Clock::time_point(); // time of the next call
  Clock::time_point m_last = Clock::time_point(); // when the clock was read
  unsigned m_number_to_skip = 0;                  // checks that do not read the clock
};

/*!
\ingroup PkgMeshSupportRef

Pause of all scopes of a thread. While an object of this class exists, functions of this package
called in its thread do not call callbacks and cannot be interrupted. Use a pause to restore the
previous state after an interrupt.
*/
class Progress_pause
{
public:
  /// Begins the pause.
  Progress_pause() = default;
  Progress_pause(const Progress_pause&) = delete;
  Progress_pause& operator=(const Progress_pause&) = delete;

private:
  Progress_scope::Silence m_silence;
};

/*!
\ingroup PkgMeshSupportRef

Name of the current phase of the thread, passed to the callbacks of `Progress_scope`. The phase ends
with the object.
*/
class Progress_phase
{
public:
  /// Begins a phase.
  /// \pre `name` is valid until the phase ends, as string literals are.
  /// \throws Interrupted_error as `Progress_scope::check()` does; the previous phase is then
  ///         current again
  explicit Progress_phase(const char* name)
      : m_outer(std::exchange(Progress_scope::phase(), name)) {
    try {
      Progress_scope::check();
    } catch (...) {
      Progress_scope::phase() = m_outer;
      throw;
    }
  }

  /// Returns to the previous phase.
  ~Progress_phase() { Progress_scope::phase() = m_outer; }

  Progress_phase(const Progress_phase&) = delete;
  Progress_phase& operator=(const Progress_phase&) = delete;

private:
  const char* m_outer;
};

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_MESH_SUPPORT_PROGRESS_SCOPE_H
