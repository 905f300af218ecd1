// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The program `dsc-files`, which the other programs execute to read files of other programs. It
// translates a file into a format of this package, and prints the name of the translation, then
// what is not in it. It is a program of its own, so that the others need no VTK and survive a
// crash.
//
// Usage: dsc-files INPUT FOLDER [--labels NAME] [--threshold VALUES] [--values gray|color]
//        dsc-files --write INPUT OUTPUT [LIKE], see write_foreign()

#include "Translation.h"
#include "read_dataset.h"

#include <vtkImageData.h>

#include <signal.h>
#include <sys/resource.h>
#include <unistd.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif

#include <algorithm>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <iostream>
#include <new>
#include <string>

namespace {

void limit(int resource, rlim_t bound) {
  rlimit limits = {};
  getrlimit(resource, &limits);
  limits.rlim_cur = std::min(limits.rlim_max, bound);
  setrlimit(resource, &limits);
}

/// Returns the number of bytes of the files in a folder.
std::uintmax_t bytes_in(const std::filesystem::path& folder) {
  std::uintmax_t result = 0;
  std::error_code none; // without the folder
  for (const auto& entry : std::filesystem::directory_iterator(folder, none))
    if (entry.is_regular_file())
      result += entry.file_size();
  return result;
}

/// Returns the number of bytes of a file; of the files beside it, if it is only a header.
std::uintmax_t bytes_of(const std::filesystem::path& input) {
  const std::string format = dsc_files::format_of(input.string());
  if (format == "vtm") // the blocks are in a folder with the name of the file
    return bytes_in(std::filesystem::path(input).replace_extension());
  if (format != "mhd" && format != "nhdr" && format != "pvtu")
    return std::filesystem::file_size(input);
  return bytes_in(std::filesystem::absolute(input).parent_path());
}

/// Ends this process if a damaged file makes a reader allocate much memory or loop forever, and
/// when the calling program ends. The bounds allow for compressed images.
void limit_resources(const std::string& input) {
  static constexpr rlim_t least_seconds = 10, bytes_per_second = 1 << 18; // of processor time
  static constexpr rlim_t least_memory = rlim_t(4) << 30, memory_of_byte = 2000;
  std::error_code error;
  if (std::filesystem::is_regular_file(input, error)) {
    const std::uintmax_t bytes = bytes_of(input);
    limit(RLIMIT_CPU, least_seconds + rlim_t(bytes) / bytes_per_second);
    limit(RLIMIT_AS, least_memory + rlim_t(bytes) * memory_of_byte);
  }
#ifdef __linux__
  prctl(PR_SET_PDEATHSIG, SIGKILL);
#endif
}

dsc_files::Options options_of(int argc, char** argv) {
  dsc_files::Options options;
  if (argc < 3 || argc % 2 == 0)
    throw dsc_files::Failure("usage: dsc-files INPUT FOLDER [--labels NAME] [--threshold VALUES] "
                             "[--values gray|color]");
  options.input = argv[1];
  options.folder = argv[2];
  for (int i = 3; i < argc; i += 2) {
    const std::string name = argv[i];
    if (name != "--labels" && name != "--threshold" && name != "--values")
      throw dsc_files::Failure("unknown option " + name);
    (name == "--labels"   ? options.labels
     : name == "--values" ? options.values
                          : options.thresholds) = argv[i + 1];
  }
  return options;
}

dsc_files::Translation translate(const dsc_files::Options& options) {
  const std::string format = dsc_files::format_of(options.input);
  const bool is_text = format == "csv" || format == "pcd" || format == "geojson";
  if (is_text && !options.values.empty())
    throw dsc_files::Failure("is no image; give an image of pixels or voxels");
  if (format == "csv")
    return translate_csv(options);
  if (format == "pcd")
    return translate_pcd(options);
  if (format == "geojson")
    return translate_geojson(options);
  const dsc_files::Dataset dataset = dsc_files::read_dataset(options.input, options.folder);
  vtkImageData* const image = vtkImageData::SafeDownCast(dataset.data);
  if (image != nullptr && !options.labels.empty())
    throw dsc_files::Failure("is an image, whose labels are its values; leave out --labels");
  if (image == nullptr && !options.values.empty())
    throw dsc_files::Failure("is no image; give an image of pixels or voxels");
  if (image == nullptr && !options.thresholds.empty())
    throw dsc_files::Failure("is no image; leave out --threshold");
  dsc_files::Translation result =
      image == nullptr         ? write_cells(dataset.data, dataset.translation.names, options)
      : options.values.empty() ? write_image(image, options)
                               : write_channels(image, options);
  const dsc_files::Translation& before = dataset.translation;
  result.unused.insert(result.unused.begin(), before.unused.begin(), before.unused.end());
  result.notes.insert(result.notes.begin(), before.notes.begin(), before.notes.end());
  return result;
}

} // namespace

int main(int argc, char** argv) {
  try {
    limit_resources(argc < 2 ? "" : argv[1]);
    if ((argc == 4 || argc == 5) && std::string(argv[1]) == "--write") {
      dsc_files::write_foreign(argv[2], argv[3], argc == 5 ? argv[4] : "");
      return 0;
    }
    const dsc_files::Translation result = translate(options_of(argc, argv));
    std::cout << result.path << '\n';
    for (const std::string& content : result.unused)
      std::cout << "unused " << content << '\n';
    for (const std::string& note : result.notes)
      std::cout << "note " << note << '\n';
    return std::cout.flush() ? 0 : 1;
  } catch (const std::bad_alloc&) {
    std::cerr << "needs more memory than there is; is it damaged?\n";
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
  }
  return 1;
}
