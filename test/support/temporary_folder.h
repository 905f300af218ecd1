#ifndef DEFORMABLE_SIMPLICIAL_COMPLEX_3_TEST_TEMPORARY_FOLDER_H
#define DEFORMABLE_SIMPLICIAL_COMPLEX_3_TEST_TEMPORARY_FOLDER_H

// A unique folder that is removed at the end of the scope.
#include "test.h"

class Temporary_folder
{
public:
  Temporary_folder()
      : m_path(std::filesystem::path(testing::TempDir()) /
               ("dsc_test_" + std::to_string(std::random_device()()) + "_" +
                std::to_string(std::random_device()()))) {
    std::filesystem::create_directories(m_path);
  }
  Temporary_folder(const Temporary_folder&) = delete;
  Temporary_folder& operator=(const Temporary_folder&) = delete;
  ~Temporary_folder() { std::filesystem::remove_all(m_path); }

  std::string operator/(const std::string& name) const { return (m_path / name).string(); }

  std::ptrdiff_t number_of_files() const {
    return std::distance(std::filesystem::directory_iterator(m_path),
                         std::filesystem::directory_iterator());
  }

private:
  std::filesystem::path m_path;
};

inline std::string file_bytes(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

inline void write_bytes(const std::string& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

#endif // DEFORMABLE_SIMPLICIAL_COMPLEX_3_TEST_TEMPORARY_FOLDER_H
