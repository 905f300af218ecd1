#ifndef DEFORMABLE_SIMPLICIAL_COMPLEX_3_TEST_BETTI_NUMBERS_H
#define DEFORMABLE_SIMPLICIAL_COMPLEX_3_TEST_BETTI_NUMBERS_H

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <ostream>
#include <set>
#include <vector>

// Betti numbers of labels and interfaces, counted from scratch.
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

// Sets of numbers that are joined one by one.
class Joined_sets
{
public:
  std::size_t find(std::size_t i) {
    while (i >= m_parents.size())
      m_parents.push_back(m_parents.size());
    while (m_parents[i] != i)
      i = m_parents[i] = m_parents[m_parents[i]];
    return i;
  }
  void join(std::size_t a, std::size_t b) { m_parents[find(a)] = find(b); }

private:
  std::vector<std::size_t> m_parents;
};

// Numbers of distinct simplices of a set of simplices and all their faces.
class Simplex_count
{
public:
  template <std::size_t N> void add(std::array<std::size_t, N> simplex) {
    std::sort(simplex.begin(), simplex.end());
    for (unsigned face = 1; face < (1u << N); ++face) {
      std::vector<std::size_t> vertices;
      for (std::size_t i = 0; i < N; ++i)
        if ((face >> i & 1) != 0)
          vertices.push_back(simplex[i]);
      m_simplices.insert(vertices);
    }
    for (std::size_t i = 1; i < N; ++i)
      m_sets.join(simplex[0], simplex[i]);
  }

  long euler_characteristic() const {
    return std::accumulate(m_simplices.begin(), m_simplices.end(), 0L,
                           [](long sum, const std::vector<std::size_t>& s) {
                             return sum + (s.size() % 2 == 1 ? 1 : -1);
                           });
  }
  long components() {
    long result = 0;
    for (const auto& s : m_simplices)
      result += s.size() == 1 && m_sets.find(s[0]) == s[0];
    return result;
  }

private:
  std::set<std::vector<std::size_t>> m_simplices;
  Joined_sets m_sets;
};

// Components, through facets, of the cells for which a condition holds, the outside being one cell
// for which it holds. Facets for which `is_wall` holds are not passed.
template <class Complex, class Condition, class Wall>
long parts_with_outside(const Complex& dsc, const Condition& condition, const Wall& is_wall) {
  Joined_sets sets;
  const auto number = [&](auto c) { return dsc.is_infinite(c) ? 0 : c->time_stamp() + 1; };
  std::set<std::size_t> cells = {0};
  for (auto c : dsc.triangulation().finite_cell_handles()) {
    if (!condition(c))
      continue;
    cells.insert(number(c));
    for (int i = 0; i < 4; ++i) {
      const auto n = c->neighbor(i);
      if ((dsc.is_infinite(n) || condition(n)) && !is_wall(c, n))
        sets.join(number(c), number(n));
    }
  }
  return std::count_if(cells.begin(), cells.end(),
                       [&](std::size_t i) { return sets.find(i) == i; });
}

inline Betti_numbers from(Simplex_count& count, long parts_of_complement) {
  Betti_numbers result;
  result.components = count.components();
  result.voids = parts_of_complement - 1;
  result.loops = result.components + result.voids - count.euler_characteristic();
  return result;
}

// Of the union of the closed cells for which a condition holds.
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
  return from(count,
              parts_with_outside(
                  dsc, [](auto) { return true; },
                  [&](auto c, auto n) { return !dsc.is_infinite(n) && c->label() != n->label(); }));
}

// Of everything that a deformation with topology control keeps: of each label, of what it leaves,
// which tells of its interior, and of the interface.
template <class Complex> std::vector<Betti_numbers> of_complex(const Complex& dsc) {
  std::vector<Betti_numbers> result;
  for (auto label : dsc.labels()) {
    result.push_back(of_cells(dsc, [&](auto c) { return c->label() == label; }));
    result.push_back(of_cells(dsc, [&](auto c) { return c->label() != label; }));
  }
  result.push_back(of_interface(dsc));
  return result;
}

} // namespace betti_numbers

#endif // DEFORMABLE_SIMPLICIAL_COMPLEX_3_TEST_BETTI_NUMBERS_H
