#ifndef DEFORMABLE_SIMPLICIAL_COMPLEX_3_TEST_STAMPED_VALUES_H
#define DEFORMABLE_SIMPLICIAL_COMPLEX_3_TEST_STAMPED_VALUES_H

#include "test.h"

#include <CGAL/property_map.h>

#include <unordered_map>

// Values on vertices or cells, and property maps that refer to them.
namespace stamped_values {

// Values by time stamp; the values of removed simplices may remain.
template <class Handle, class Value> struct Stamped_map
{
  using key_type = Handle;
  using value_type = Value;
  using reference = Value;
  using category = boost::read_write_property_map_tag;

  friend Value get(const Stamped_map& map, Handle h) { return map.values->at(h->time_stamp()); }
  friend void put(const Stamped_map& map, Handle h, const Value& value) {
    (*map.values)[h->time_stamp()] = value;
  }

  std::unordered_map<std::size_t, Value>* values;
};

// A map and the values that it refers to.
template <class Handle, class Value = double> struct Values
{
  using Map = Stamped_map<Handle, Value>;

  Map map() { return {&values}; }
  Value operator[](Handle h) { return get(map(), h); }
  void set(Handle h, const Value& value) { put(map(), h, value); }

  std::unordered_map<std::size_t, Value> values;
};

} // namespace stamped_values

#endif // DEFORMABLE_SIMPLICIAL_COMPLEX_3_TEST_STAMPED_VALUES_H
