// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_COMPLEX_TIME_STAMPS_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_COMPLEX_TIME_STAMPS_H

#include <cstddef>

namespace CGAL {
namespace Deformable_simplicial_complexes {
namespace internal {

// Numbers vertices and cells in the order in which they are created. CGAL does so, too; but CGAL 6
// gives what is created in place of an item the number of that again.
class Time_stamps
{
public:
  template <class Handle> Handle mark(Handle created) {
    created->set_time_stamp(m_next++);
    return created;
  }

private:
  std::size_t m_next = 1; // the infinite vertex has 0
};

// Orders vertices or cells by creation.
struct Less_time_stamp
{
  template <class Handle> bool operator()(Handle a, Handle b) const {
    return a->time_stamp() < b->time_stamp();
  }
};

} // namespace internal
} // namespace Deformable_simplicial_complexes
} // namespace CGAL

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_INTERNAL_COMPLEX_TIME_STAMPS_H
