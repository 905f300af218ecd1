// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_PROGRESS_SCOPE_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_PROGRESS_SCOPE_H

#include <chrono>
#include <exception>
#include <functional>
#include <utility>

namespace CGAL {
namespace Deformable_simplicial_complexes {

/*!
\ingroup PkgDeformableSimplicialComplex3Ref

is thrown by a function of this package when the callback of a `Progress_scope` returned `false`. A
complex that the function was changing is valid; whatever it was making does not exist. It is no
`Error`, as the input is not to blame.
*/
class Interrupted_error : public std::exception
{
public:
  /// returns what happened.
  const char* what() const noexcept override {
    return "interrupted: the progress callback returned false";
  }
};

/*!
\ingroup PkgDeformableSimplicialComplex3Ref

Lets the functions of this package report their progress, and stops them. While a scope exists, all
functions that are called in its thread ask its callback about twenty times a second, whatever they
do: building, tetrahedralization, images, reconstruction, repair, cut loci, improvement, motions,
fluids, files. If the callback returns `false`, the function throws `Interrupted_error` within a
second.

\code
CGAL::Deformable_simplicial_complexes::Progress_scope scope(
    [&](const char* phase) { return !is_cancelled; });
auto complex = CGAL::make_deformable_simplicial_complex_3<Complex>(surface, tetrahedralizer);
\endcode

Scopes nest: the callbacks of all scopes of the thread are asked, the innermost one first.
*/
class Progress_scope
{
public:
  /// The argument names what is being done, such as "filling the box with tetrahedra". The result
  /// tells whether to go on.
  using Callback = std::function<bool(const char* phase)>;

  /// Begins the scope. The callback may throw: the exception leaves the function of the package.
  /// \param callback asked whether to go on
  /// \param interval shortest time between two calls of the callback; 0 for a call at each check
  explicit Progress_scope(Callback callback,
                          std::chrono::milliseconds interval = std::chrono::milliseconds(50))
      : m_callback(std::move(callback)), m_interval(interval),
        m_outer(std::exchange(innermost(), this)) {}

  /// Ends the scope.
  ~Progress_scope() { innermost() = m_outer; }

  Progress_scope(const Progress_scope&) = delete;
  Progress_scope& operator=(const Progress_scope&) = delete;

  /// Asks the callbacks of all scopes of this thread, unless the interval of the innermost one has
  /// not passed. For loops of users, and of this package. \throws Interrupted_error if one of them
  /// returned `false`
  static void check() {
    if (innermost() != nullptr)
      innermost()->check_now_and_then();
  }

private:
  friend class Progress_phase;
  using Clock = std::chrono::steady_clock;

  static Progress_scope*& innermost() {
    static thread_local Progress_scope* scope = nullptr;
    return scope;
  }

  static const char*& phase() {
    static thread_local const char* name = "computing";
    return name;
  }

  void check_now_and_then() {
    const Clock::time_point now = Clock::now();
    if (now < m_next)
      return;
    m_next = now + m_interval;
    for (const Progress_scope* scope = this; scope != nullptr; scope = scope->m_outer)
      if (!scope->m_callback(phase()))
        throw Interrupted_error();
  }

  Callback m_callback;
  std::chrono::milliseconds m_interval;
  Progress_scope* m_outer;
  Clock::time_point m_next = Clock::time_point(); // when to ask again
};

/*!
\ingroup PkgDeformableSimplicialComplex3Ref

Names what the thread is doing, for the callbacks of `Progress_scope`, until the end of its life.
*/
class Progress_phase
{
public:
  /// Begins a phase. \pre `name` outlives the phase; string literals do.
  explicit Progress_phase(const char* name)
      : m_outer(std::exchange(Progress_scope::phase(), name)) {
    Progress_scope::check();
  }

  /// Returns to the phase that was going on before.
  ~Progress_phase() { Progress_scope::phase() = m_outer; }

  Progress_phase(const Progress_phase&) = delete;
  Progress_phase& operator=(const Progress_phase&) = delete;

private:
  const char* m_outer;
};

} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_PROGRESS_SCOPE_H
