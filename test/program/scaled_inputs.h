#ifndef DEFORMABLE_SIMPLICIAL_COMPLEX_3_TEST_SCALED_INPUTS_H
#define DEFORMABLE_SIMPLICIAL_COMPLEX_3_TEST_SCALED_INPUTS_H

#include "test.h"

#include <nlohmann/json.hpp>

// Small inputs of all formats, with coordinates multiplied by a unit of length.
namespace scaled_inputs {

using Point = std::array<double, 3>;

inline std::string digits(double x) {
  std::ostringstream out;
  out.precision(std::numeric_limits<double>::max_digits10);
  out << x;
  return out.str();
}

inline std::string list(const std::vector<double>& numbers, double unit,
                        const std::string& separator = ",") {
  std::string result;
  for (double x : numbers)
    result += (result.empty() ? "" : separator) + digits(x * unit);
  return result;
}

inline std::string words(const Point& p, double unit) {
  return list({p[0], p[1], p[2]}, unit, " ") + '\n';
}

// Returns a pseudo-random number from 0 to 1, so that rounding has no ties to break.
inline double noise(std::size_t i) {
  const double x = std::sin(12.9898 * double(i + 1)) * 43758.5453;
  return x - std::floor(x);
}

struct Surface
{
  std::vector<Point> points;
  std::vector<std::array<std::size_t, 3>> triangles;
};

// An irregular ellipsoid of 128 triangles.
inline const Surface& ball() {
  static const Surface result = [] {
    Surface s{
        {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
        {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
    for (int level = 0; level < 2; ++level) {
      std::map<std::array<std::size_t, 2>, std::size_t> middles;
      const auto middle = [&](std::size_t a, std::size_t b) {
        const auto [place, is_new] = middles.emplace(
            std::array<std::size_t, 2>{(std::min)(a, b), (std::max)(a, b)}, s.points.size());
        if (is_new) {
          Point p;
          for (int i = 0; i < 3; ++i)
            p[i] = s.points[a][i] + s.points[b][i];
          const double length = std::hypot(p[0], p[1], p[2]);
          s.points.push_back({p[0] / length, p[1] / length, p[2] / length});
        }
        return place->second;
      };
      std::vector<std::array<std::size_t, 3>> finer;
      for (const auto& [a, b, c] : s.triangles) {
        const std::size_t x = middle(a, b), y = middle(b, c), z = middle(c, a);
        finer.insert(finer.end(), {{a, x, z}, {x, b, y}, {z, y, c}, {x, y, z}});
      }
      s.triangles.swap(finer);
    }
    // Returns the value in single precision, for STL.
    const Point center = {.1, .2, -.05}, radii = {1, .83, .71};
    for (std::size_t v = 0; v < s.points.size(); ++v)
      for (std::size_t i = 0; i < 3; ++i)
        s.points[v][i] = float(center[i] + radii[i] * s.points[v][i] * (1 + .1 * noise(3 * v + i)));
    return s;
  }();
  return result;
}

inline std::string off(double unit, const Surface& s = ball()) {
  std::string text =
      "OFF\n" + std::to_string(s.points.size()) + ' ' + std::to_string(s.triangles.size()) + " 0\n";
  for (const Point& p : s.points)
    text += words(p, unit);
  for (const auto& [a, b, c] : s.triangles)
    text += "3 " + std::to_string(a) + ' ' + std::to_string(b) + ' ' + std::to_string(c) + '\n';
  return text;
}

// One triangle is duplicated, another triangle is missing.
inline std::string broken_off(double unit) {
  Surface s = ball();
  s.triangles.push_back(s.triangles[0]);
  s.triangles.erase(s.triangles.begin() + 7);
  return off(unit, s);
}

inline std::string obj(double unit) {
  std::string text;
  for (const Point& p : ball().points)
    text += "v " + words(p, unit);
  for (const auto& [a, b, c] : ball().triangles)
    text += "f " + std::to_string(a + 1) + ' ' + std::to_string(b + 1) + ' ' +
            std::to_string(c + 1) + '\n';
  return text;
}

inline std::string ply(double unit) {
  const std::string body = off(unit);
  return "ply\nformat ascii 1.0\nelement vertex " + std::to_string(ball().points.size()) +
         "\nproperty double x\nproperty double y\nproperty double z\nelement face " +
         std::to_string(ball().triangles.size()) +
         "\nproperty list uchar int vertex_indices\nend_header\n" +
         body.substr(body.find('\n', 4) + 1);
}

inline std::string stl(double unit) {
  std::string text = "solid\n";
  for (const auto& triangle : ball().triangles) {
    text += "facet normal 0 0 0\nouter loop\n";
    for (std::size_t v : triangle)
      text += "vertex " + words(ball().points[v], unit);
    text += "endloop\nendfacet\n";
  }
  return text + "endsolid\n";
}

template <class Number> void append_bytes(std::string& text, Number x) {
  text.append(reinterpret_cast<const char*>(&x), sizeof x); // little endian, as in all tests
}

inline std::string binary_stl(double unit) {
  std::string text(80, '\0');
  append_bytes(text, std::uint32_t(ball().triangles.size()));
  for (const auto& triangle : ball().triangles) {
    text.append(12, '\0');
    for (std::size_t v : triangle)
      for (double x : ball().points[v])
        append_bytes(text, float(x * unit));
    text.append(2, '\0');
  }
  return text;
}

// Points of an irregular grid from 0 to 3, and its tetrahedra with labels 1 and 2.
struct Tetrahedra
{
  std::vector<Point> points;
  std::vector<std::array<std::size_t, 5>> cells; // the label is last
};

inline Tetrahedra grid() {
  constexpr std::size_t n = 4;
  Tetrahedra result;
  for (std::size_t v = 0; v < n * n * n; ++v) {
    const std::size_t place[] = {v % n, v / n % n, v / n / n};
    Point p;
    for (std::size_t i = 0; i < 3; ++i) {
      const bool is_inside = place[i] > 0 && place[i] + 1 < n;
      p[i] = double(place[i]) + (is_inside ? .2 * (noise(3 * v + i) - .5) : 0);
    }
    result.points.push_back(p);
  }
  const std::size_t steps[] = {1, n, n * n};
  for (std::size_t k = 0; k + 1 < n; ++k)
    for (std::size_t j = 0; j + 1 < n; ++j)
      for (std::size_t i = 0; i + 1 < n; ++i)
        for (std::size_t a = 0; a < 3; ++a)
          for (std::size_t b : {(a + 1) % 3, (a + 2) % 3}) {
            const std::size_t v = i + n * j + n * n * k, label = i + j + k < 4 ? 1 : 2,
                              first = v + steps[a], second = first + steps[b],
                              last = v + 1 + n + n * n;
            if (b == (a + 1) % 3)
              result.cells.push_back({v, first, second, last, label});
            else
              result.cells.push_back({v, first, last, second, label});
          }
  return result;
}

inline std::string medit(double unit) {
  const Tetrahedra mesh = grid();
  std::ostringstream text;
  text << "MeshVersionFormatted 2\nDimension 3\nVertices " << mesh.points.size() << '\n';
  for (const Point& p : mesh.points)
    text << list({p[0], p[1], p[2]}, unit, " ") << " 0\n";
  text << "Tetrahedra " << mesh.cells.size() << '\n';
  for (const auto& c : mesh.cells)
    text << c[0] + 1 << ' ' << c[1] + 1 << ' ' << c[2] + 1 << ' ' << c[3] + 1 << ' ' << c[4]
         << '\n';
  text << "End\n";
  return text.str();
}

inline std::string vtu(double unit) {
  const Tetrahedra mesh = grid();
  std::ostringstream points, cells, offsets, types, labels;
  for (const Point& p : mesh.points)
    points << words(p, unit);
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    for (std::size_t i = 0; i < 4; ++i)
      cells << mesh.cells[c][i] << ' ';
    offsets << 4 * (c + 1) << ' ';
    types << "10 ";
    labels << mesh.cells[c][4] << ' ';
  }
  const auto array = [](const std::string& type, const std::string& name, const auto& content) {
    return "<DataArray type=\"" + type + "\" Name=\"" + name + "\" format=\"ascii\"" +
           (name == "points" ? " NumberOfComponents=\"3\">" : ">") + content.str() +
           "</DataArray>\n";
  };
  return "<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
         "<UnstructuredGrid><Piece NumberOfPoints=\"" +
         std::to_string(mesh.points.size()) + "\" NumberOfCells=\"" +
         std::to_string(mesh.cells.size()) + "\">\n<Points>" + array("Float64", "points", points) +
         "</Points>\n<Cells>" + array("Int64", "connectivity", cells) +
         array("Int64", "offsets", offsets) + array("UInt8", "types", types) +
         "</Cells>\n<CellData>" + array("Int32", "label", labels) +
         "</CellData>\n</Piece></UnstructuredGrid></VTKFile>\n";
}

// A ball of voxels.
inline std::string inr(double unit) {
  constexpr int n = 9;
  std::string voxels;
  for (int k = 0; k < n; ++k)
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i)
        voxels += std::pow(i - 4, 2) + 1.2 * std::pow(j - 4.2, 2) + std::pow(k - 3.7, 2) < 9 ? '\1'
                                                                                             : '\0';
  std::string text = "#INRIMAGE-4#{\nXDIM=9\nYDIM=9\nZDIM=9\nVDIM=1\nTYPE=unsigned fixed\n"
                     "PIXSIZE=8 bits\nCPU=decm\n";
  for (const char* axis : {"VX=", "VY=", "VZ="})
    text += axis + digits(unit) + '\n';
  const std::string end = "##}\n";
  text.resize(256 - end.size(), '\n');
  return text + end + voxels;
}

// Points of an ellipsoid, along a spiral.
inline std::string xyz(double unit) {
  constexpr int n = 300;
  std::string text;
  for (int i = 0; i < n; ++i) {
    const double z = 1 - (2 * i + 1.) / n, r = std::sqrt(1 - z * z), a = 2.399963229728653 * i;
    text += words({r * std::cos(a), .9 * r * std::sin(a), .8 * z}, unit);
  }
  return text;
}

// A closed curve in the plane.
inline std::vector<std::array<double, 2>> curve() {
  constexpr std::size_t n = 30;
  std::vector<std::array<double, 2>> result;
  for (std::size_t i = 0; i < n; ++i) {
    const double t = (double(i) + .3 * noise(i)) * 2 * 3.14159265358979 / n;
    result.push_back({std::cos(t) * (1 + .2 * std::sin(3 * t)), std::sin(t)});
  }
  return result;
}

inline std::string wkt(double unit) {
  std::string text = "POLYGON ((";
  for (const auto& [x, y] : curve())
    text += list({x, y}, unit, " ") + ", ";
  return text + list({curve()[0][0], curve()[0][1]}, unit, " ") + "))\n";
}

inline std::string poly(double unit) {
  const auto points = curve();
  const std::size_t n = points.size();
  std::ostringstream text;
  text << n << " 2\n";
  for (std::size_t i = 0; i < n; ++i)
    text << i + 1 << ' ' << list({points[i][0], points[i][1]}, unit, " ") << '\n';
  text << n << '\n';
  for (std::size_t i = 0; i < n; ++i)
    text << i + 1 << ' ' << i + 1 << ' ' << (i + 1) % n + 1 << '\n';
  text << "0\n1\n1 " << list({.1, .05}, unit, " ") << " 5\n";
  return text.str();
}

} // namespace scaled_inputs

#endif // DEFORMABLE_SIMPLICIAL_COMPLEX_3_TEST_SCALED_INPUTS_H
