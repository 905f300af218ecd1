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
#ifdef __linux__
#include <sys/prctl.h>
#endif

#include <algorithm>
#include <exception>
#include <filesystem>
#include <iostream>
#include <new>

namespace {

/// Ends this process if a damaged file makes a reader allocate much memory or loop forever, and
/// when the calling program ends.
void limit_resources(const std::string& input) {
#ifdef __linux__
  prctl(PR_SET_PDEATHSIG, SIGKILL);
#endif
  if (std::filesystem::is_directory(input))
    throw dsc_files::Failure(
        "is a folder; name a file in it (dcm2niix converts DICOM images to NIfTI)");
  if (!std::filesystem::is_regular_file(input))
    throw dsc_files::Failure("is no regular file; copy its content into a file");
  dsc_files::accept_content(0, double(std::filesystem::file_size(input)));
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

constexpr const char* no_memory = "needs more memory than fits to its size; is it damaged?\n";

} // namespace

int main(int argc, char** argv) {
  try {
    const bool writes = (argc == 4 || argc == 5) && std::string(argv[1]) == "--write";
    limit_resources(argc < 2 ? "" : argv[writes ? 2 : 1]);
    if (writes) {
      dsc_files::write_foreign(argv[2], argv[3], argc == 5 ? argv[4] : "");
      return 0;
    }
    const dsc_files::Translation result = translate(options_of(argc, argv));
    const auto print = [](std::string line) {
      std::replace(line.begin(), line.end(), '\n', ' ');
      std::cout << line << '\n';
    };
    print(result.path);
    for (const std::string& content : result.unused)
      print("unused " + content);
    for (const std::string& note : result.notes)
      print("note " + note);
    return std::cout.flush() ? 0 : 1;
  } catch (const std::bad_alloc&) {
    std::cerr << no_memory;
  } catch (const std::length_error&) { // a size that no memory has
    std::cerr << no_memory;
  } catch (const std::exception& error) {
    const std::string message = error.what();
    const bool has_advice = message.find_first_of(";?:") != std::string::npos;
    std::cerr << message << (has_advice ? "\n" : "; is it damaged?\n");
  }
  return 1;
}
