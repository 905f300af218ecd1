// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_PYTHON_GUARDED_H
#define DSC_PYTHON_GUARDED_H

#include <CGAL/Mesh_support/Progress_scope.h>

#include <pybind11/pybind11.h>

#include <stdexcept>
#include <thread>

namespace dsc_python {

namespace py = pybind11;

/// Thrown if an object is used while another thread changes it, or changed while it is changed.
class Busy_error : public std::runtime_error
{
public:
  Busy_error()
      : std::runtime_error("the object is being changed; wait until the change is complete, or use "
                           "a copy") {}
};

/// Lets the interpreter run other threads during a long function, and stops the function if a
/// signal arrives, such as Ctrl-C, or if a callback of the user returns `False`.
class Long_function
{
public:
  /// \param progress called with the name of the current phase, True for a line on the terminal, or
  /// None
  /// \throws py::type_error if it is something else
  explicit Long_function(const py::object& progress)
      : m_progress(checked(progress)), m_owns_line(progress.ptr() == Py_True),
        m_scope([this](const char* phase) { return may_continue(phase); }) {}

  ~Long_function() {
    if (!m_owns_line)
      return;
    const py::gil_scoped_acquire lock;
    try {
      m_progress.attr("close")();
    } catch (py::error_already_set& error) { // the terminal may be gone
      error.discard_as_unraisable(__func__);
    }
  }
  Long_function(const Long_function&) = delete;
  Long_function& operator=(const Long_function&) = delete;

private:
  static py::object checked(const py::object& progress) {
    if (progress.ptr() == Py_False)
      return py::none();
    if (progress.ptr() == Py_True)
      return py::module_::import("dsc._progress").attr("ProgressLine")();
    if (!progress.is_none() && PyCallable_Check(progress.ptr()) == 0)
      throw py::type_error("progress must be a function, True, or None");
    return progress;
  }

  bool may_continue(const char* phase) {
    const py::gil_scoped_acquire lock;
    if (PyErr_CheckSignals() != 0)
      throw py::error_already_set();
    if (m_progress.is_none())
      return true;
    const py::object answer = m_progress(phase);
    return answer.is_none() || bool(py::bool_(answer));
  }

  py::object m_progress;
  bool m_owns_line; // on the terminal
  CGAL::Deformable_simplicial_complexes::Progress_scope m_scope;
  py::gil_scoped_release m_release; // last, so that it is acquired again first
};

/// An object that one thread at a time changes, while no other thread reads it. All functions are
/// called with the lock of the interpreter, which makes the flag safe.
template <class T> class Guarded
{
public:
  explicit Guarded(T value) : m_value(std::move(value)) {}

  /// Returns the object for reading. The thread that changes the object may read it, in callbacks.
  /// \throws Busy_error if another thread is changing it
  const T& read() const {
    if (m_changing != std::thread::id() && m_changing != std::this_thread::get_id())
      throw Busy_error();
    return m_value;
  }

  /// Returns the object for something that must not happen during a change.
  /// \throws Busy_error if a thread is changing it
  const T& at_rest() const {
    if (m_changing != std::thread::id() || m_readers > 0)
      throw Busy_error();
    return m_value;
  }

  /// Calls `change` with the object, as a long function.
  /// \throws Busy_error if a thread is changing the object
  template <class Change> auto change(const py::object& progress, const Change& change) {
    if (m_changing != std::thread::id() || m_readers > 0)
      throw Busy_error();
    const Flag flag(m_changing);
    const Long_function function(progress);
    return change(m_value);
  }

  /// Calls `read` with the object, as a long function. Several threads may read at the same time.
  /// \throws Busy_error if another thread is changing the object
  template <class Read> auto read_long(const py::object& progress, const Read& read) const {
    const T& value = this->read();
    ++m_readers;
    const Reader reader{m_readers}; // released when the lock is held again
    const Long_function function(progress);
    return read(value);
  }

private:
  struct Flag
  {
    explicit Flag(std::thread::id& changing) : m_changing(changing) {
      m_changing = std::this_thread::get_id();
    }
    ~Flag() { m_changing = std::thread::id(); }
    Flag(const Flag&) = delete;
    Flag& operator=(const Flag&) = delete;

    std::thread::id& m_changing;
  };

  struct Reader
  {
    ~Reader() { --readers; }
    int& readers;
  };

  T m_value;
  std::thread::id m_changing; // none if no thread changes the object
  mutable int m_readers = 0;  // threads that read it without the lock of the interpreter
};

} // namespace dsc_python

#endif // DSC_PYTHON_GUARDED_H
