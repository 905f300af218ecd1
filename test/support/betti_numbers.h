#ifndef DEFORMABLE_SIMPLICIAL_COMPLEX_3_TEST_BETTI_NUMBERS_H
#define DEFORMABLE_SIMPLICIAL_COMPLEX_3_TEST_BETTI_NUMBERS_H

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <ostream>
#include <set>
#include <unordered_map>
#include <utility>
#include <vector>

// Betti numbers of labels and interfaces, computed from scratch.
namespace betti_numbers {

struct Betti_numbers
{
  long components, loops, voids;

  friend bool operator==(const Betti_numbers& a, const Betti_numbers& b) {
    return a.components == b.components && a.loops == b.loops && a.voids == b.voids;
  }
  friend std::ostream& operator<<(std::ostream& out, const Betti_numbers& b) {
    return out << '(' << b.components << ", " << b.loops << ", " << b.voids << ')';
  }
};

// Union-find for sets of numbers. Numbers may be large, for example time stamps.
class Joined_sets
{
public:
  // Returns the representative of i. The first call makes a new set.
  std::size_t find(std::size_t i) {
    std::size_t& parent = m_parents.try_emplace(i, i).first->second;
    if (parent != i)
      parent = find(parent);
    return parent;
  }
  void join(std::size_t a, std::size_t b) {
    const std::size_t root = find(a);
    m_parents[root] = find(b);
  }
  long number_of_sets() const {
    return std::count_if(m_parents.begin(), m_parents.end(),
                         [](const auto& item) { return item.first == item.second; });
  }

private:
  std::unordered_map<std::size_t, std::size_t> m_parents;
};

// Returns the numbers of distinct simplices of a set of simplices and of all their faces.
class Simplex_count
{
public:
  template <std::size_t N> void add(std::array<std::size_t, N> simplex) {
    std::sort(simplex.begin(), simplex.end());
    for (unsigned face = 1; face < (1u << N); ++face) {
      Simplex vertices = {};
      std::size_t n = 0;
      for (std::size_t i = 0; i < N; ++i)
        if ((face >> i & 1) != 0)
          vertices[n++] = simplex[i];
      m_simplices[n - 1].push_back(vertices);
    }
    for (std::size_t i = 1; i < N; ++i)
      m_sets.join(simplex[0], simplex[i]);
  }

  long euler_characteristic() {
    long result = 0, sign = 1;
    for (std::vector<Simplex>& simplices : m_simplices) {
      std::sort(simplices.begin(), simplices.end());
      simplices.erase(std::unique(simplices.begin(), simplices.end()), simplices.end());
      result += sign * long(simplices.size());
      sign = -sign;
    }
    return result;
  }
  long components() const { return m_sets.number_of_sets(); }

private:
  using Simplex = std::array<std::size_t, 4>; // vertices in increasing order, then zeros

  std::array<std::vector<Simplex>, 4> m_simplices; // by dimension
  Joined_sets m_sets;
};

// Components, connected by facets, of the cells that satisfy a condition; the outside is one such
// cell. Facets with `is_wall` separate cells.
template <class Complex, class Condition, class Wall>
long parts_with_outside(const Complex& dsc, const Condition& condition, const Wall& is_wall) {
  static constexpr std::size_t outside = 0;
  Joined_sets sets;
  sets.find(outside);
  const auto number = [&](auto c) { return dsc.is_infinite(c) ? outside : c->time_stamp() + 1; };
  for (auto c : dsc.triangulation().finite_cell_handles()) {
    if (!condition(c))
      continue;
    sets.find(number(c));
    for (int i = 0; i < 4; ++i) {
      const auto n = c->neighbor(i);
      if ((dsc.is_infinite(n) || condition(n)) && !is_wall(c, n))
        sets.join(number(c), number(n));
    }
  }
  return sets.number_of_sets();
}

inline Betti_numbers from(Simplex_count& count, long parts_of_complement) {
  Betti_numbers result;
  result.components = count.components();
  result.voids = parts_of_complement - 1;
  result.loops = result.components + result.voids - count.euler_characteristic();
  return result;
}

// Returns the Betti numbers of the union of the closed cells that satisfy a condition.
template <class Complex, class Condition>
Betti_numbers of_cells(const Complex& dsc, const Condition& condition) {
  Simplex_count count;
  for (auto c : dsc.triangulation().finite_cell_handles())
    if (condition(c))
      count.add(std::array<std::size_t, 4>{c->vertex(0)->time_stamp(), c->vertex(1)->time_stamp(),
                                           c->vertex(2)->time_stamp(), c->vertex(3)->time_stamp()});
  return from(count,
              parts_with_outside(
                  dsc, [&](auto c) { return !condition(c); }, [](auto, auto) { return false; }));
}

template <class Complex> Betti_numbers of_interface(const Complex& dsc) {
  Simplex_count count;
  for (const auto& f : dsc.interface_facets()) {
    const auto v = dsc.facet_vertices(f);
    count.add(
        std::array<std::size_t, 3>{v[0]->time_stamp(), v[1]->time_stamp(), v[2]->time_stamp()});
  }
  return from(count, parts_with_outside(
                         dsc, [](auto) { return true; },
                         [&](auto c, auto n) {
                           return !dsc.is_infinite(n) &&
                                  c->subdomain_index() != n->subdomain_index();
                         }));
}

// The Betti numbers that a deformation with topology control preserves.
struct Topology
{
  // of each label and of its complement, which describes its interior
  std::map<int, std::pair<Betti_numbers, Betti_numbers>> labels;
  Betti_numbers surface; // the interface

  friend bool operator==(const Topology& a, const Topology& b) {
    return a.labels == b.labels && a.surface == b.surface;
  }
  friend std::ostream& operator<<(std::ostream& out, const Topology& t) {
    for (const auto& [label, numbers] : t.labels)
      out << label << ": " << numbers.first << " in " << numbers.second << ", ";
    return out << "interface: " << t.surface;
  }
};

template <class Complex> Topology of_complex(const Complex& dsc) {
  Topology result;
  for (auto label : dsc.labels())
    result.labels[label] = {of_cells(dsc, [&](auto c) { return c->subdomain_index() == label; }),
                            of_cells(dsc, [&](auto c) { return c->subdomain_index() != label; })};
  result.surface = of_interface(dsc);
  return result;
}

// Returns whether only the topology of some labels, and of the interface, differs.
inline bool differ_only_in(const std::set<int>& labels, Topology a, Topology b) {
  for (int label : labels) {
    a.labels.erase(label);
    b.labels.erase(label);
    a.surface = b.surface;
  }
  return a == b;
}

} // namespace betti_numbers

#endif // DEFORMABLE_SIMPLICIAL_COMPLEX_3_TEST_BETTI_NUMBERS_H
