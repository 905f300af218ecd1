#include "mesh_helpers.h"
#include "temporary_folder.h"
#include "test.h"

#include <CGAL/Mesh_files/MEDIT_3.h>
#include <CGAL/Mesh_files/VTU_3.h>
#include <CGAL/Mesh_files/checkpoint.h>
#include <CGAL/Mesh_files/labeled_surface_3.h>

#include <locale>

// Files do not depend on the number format of the locale.

namespace test_locale {

struct Comma : public std::numpunct<char>
{
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

class Locale : public testing::Test
{
protected:
  Locale() { std::locale::global(std::locale(std::locale::classic(), new Comma)); }
  ~Locale() override { std::locale::global(std::locale::classic()); }
};

TEST_F(Locale, does_not_change_files) {
  const small_meshes::Complex dsc = mesh_helpers::jittered_grid(8, small_meshes::ball, .3, 1);
  const Temporary_folder folder;
  const auto write = [&](const std::string& name) {
    for (const char* extension : {".off", ".obj", ".ply", ".stl"})
      CGAL::IO::write_interface(folder / (name + extension), dsc);
    CGAL::IO::write_MEDIT(folder / (name + ".mesh"), dsc);
    CGAL::IO::write_VTU(folder / (name + ".vtu"), dsc);
    CGAL::IO::write_checkpoint(folder / (name + ".dsc"), dsc.state());
  };
  write("comma");
  const auto surface = CGAL::IO::read_labeled_surface(folder / "comma.off");
  std::locale::global(std::locale::classic());
  write("point");
  EXPECT_EQ(surface.points, CGAL::IO::read_labeled_surface(folder / "point.off").points);
  for (const char* extension : {".off", ".obj", ".ply", ".stl", ".mesh", ".vtu", ".dsc"}) {
    const std::string file = file_bytes(folder / (std::string("comma") + extension));
    EXPECT_FALSE(file.empty()) << extension;
    EXPECT_EQ(file, file_bytes(folder / (std::string("point") + extension))) << extension;
  }
}

} // namespace test_locale
