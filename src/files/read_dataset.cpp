// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "read_dataset.h"

#include "Translation.h"
#include "read_gmsh.h"
#include "read_meshb.h"
#include "require_complete.h"

#include <vtkCommand.h>
#include <vtkDICOMImageReader.h>
#include <vtkDataSetReader.h>
#include <vtkErrorCode.h>
#include <vtkGenericDataObjectReader.h>
#include <vtkImageData.h>
#include <vtkLogger.h>
#include <vtkMatrix3x3.h>
#include <vtkMatrix4x4.h>
#include <vtkMetaImageReader.h>
#include <vtkNIFTIImageReader.h>
#include <vtkNew.h>
#include <vtkNrrdReader.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>
#include <vtkPNGReader.h>
#include <vtkPNMReader.h>
#include <vtkStringArray.h>
#include <vtkTIFFReader.h>
#include <vtkXMLGenericDataObjectReader.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>

namespace dsc_files {
namespace {

/// Receives the messages that VTK prints. The first error or warning is the cause of a failure:
/// readers of VTK warn about truncated files.
class Messages : public vtkOutputWindow
{
public:
  static Messages* New();
  vtkTypeMacro(Messages, vtkOutputWindow);

  void DisplayErrorText(const char* text) override {
    if (error.empty())
      error = text;
  }
  void DisplayWarningText(const char* text) override { DisplayErrorText(text); }
  void DisplayGenericWarningText(const char* text) override { DisplayErrorText(text); }
  void DisplayText(const char*) override {}

  std::string error;
};
vtkStandardNewMacro(Messages);

/// Returns the last line of a message of VTK, without the address of the reader.
std::string shortened(std::string message) {
  while (!message.empty() && std::isspace(static_cast<unsigned char>(message.back())) != 0)
    message.pop_back();
  message.erase(0, message.rfind('\n') + 1);
  const std::size_t end_of_address = message.find("): ");
  return end_of_address == std::string::npos ? message : message.substr(end_of_address + 3);
}

vtkSmartPointer<vtkDataSet> only_dataset(vtkDataObject* object) {
  vtkDataSet* const result = vtkDataSet::SafeDownCast(object);
  if (result == nullptr)
    throw Failure(object == nullptr ? std::string("contains no data that VTK reads")
                                    : std::string("contains a ") + object->GetClassName() +
                                          "; write one grid, surface or image");
  return result;
}

/// Runs a reader and returns its output.
template <class Reader> vtkSmartPointer<vtkDataSet> run(Reader* reader, Messages* messages) {
  reader->Update();
  if (reader->GetErrorCode() != vtkErrorCode::NoError || !messages->error.empty())
    throw Failure("cannot be read by VTK: " +
                  (messages->error.empty()
                       ? std::string(vtkErrorCode::GetStringFromErrorCode(reader->GetErrorCode()))
                       : shortened(messages->error)));
  return only_dataset(reader->GetOutputDataObject(0));
}

template <class Reader>
vtkSmartPointer<vtkDataSet> read_named(const std::string& path, Messages* messages) {
  vtkNew<Reader> reader;
  reader->SetFileName(path.c_str());
  return run(reader.Get(), messages);
}

/// Reads an image whose header has to be valid.
template <class Reader>
vtkSmartPointer<vtkDataSet> read_image(const std::string& path, Messages* messages) {
  vtkNew<Reader> reader;
  if (reader->CanReadFile(path.c_str()) == 0)
    throw Failure("is not in the format of its extension, or is damaged");
  reader->SetFileName(path.c_str());
  return run(reader.Get(), messages);
}

/// Reads an image of medicine. Its axes may be permuted or reversed in space: the image gets a
/// direction matrix then.
Dataset read_nifti(const std::string& path, Messages* messages) {
  vtkNew<vtkNIFTIImageReader> reader;
  if (reader->CanReadFile(path.c_str()) == 0)
    throw Failure("is not in the NIfTI format, or is damaged");
  reader->SetFileName(path.c_str());
  Dataset result;
  result.data = run(reader.Get(), messages);
  result.slice_order = reader->GetQFac();
  if (reader->GetTimeDimension() > 1)
    throw Failure("contains a series in time; write one image");
  vtkMatrix4x4* matrix = reader->GetSFormMatrix();
  if (matrix == nullptr)
    matrix = reader->GetQFormMatrix();
  vtkImageData* const image = vtkImageData::SafeDownCast(result.data);
  if (matrix == nullptr || image == nullptr)
    return result;
  // The matrix maps coordinates with the spacing, but without the origin, to space.
  static constexpr double rounding = 1e-4; // of numbers that files store in 32 bits
  vtkNew<vtkMatrix3x3> directions;
  double origin[3];
  for (int i = 0; i < 3; ++i) {
    origin[i] = matrix->GetElement(i, 3);
    for (int j = 0; j < 3; ++j) {
      const double x = matrix->GetElement(i, j), nearest = std::round(x);
      result.has_oblique_axes = result.has_oblique_axes || std::abs(x - nearest) > rounding;
      directions->SetElement(i, j, nearest);
    }
  }
  if (!result.has_oblique_axes) {
    image->SetDirectionMatrix(directions);
    image->SetOrigin(origin);
  }
  return result;
}

vtkSmartPointer<vtkDataSet> read_dicom(const std::string& folder) {
  vtkNew<vtkDICOMImageReader> reader;
  reader->SetDirectoryName(folder.c_str());
  reader->Update(); // warns of other files in the folder
  vtkImageData* const image = reader->GetOutput();
  if (image == nullptr || image->GetNumberOfPoints() == 0)
    throw Failure("contains no DICOM images that VTK reads");
  return image;
}

} // namespace

std::string format_of(const std::string& path) {
  std::string name = std::filesystem::path(path).filename().string();
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char c) { return char(std::tolower(c)); });
  const std::string compressed = ".nii.gz";
  if (name.size() > compressed.size() &&
      name.compare(name.size() - compressed.size(), compressed.size(), compressed) == 0)
    return "nii.gz";
  const std::size_t dot = name.rfind('.');
  return dot == std::string::npos ? "" : name.substr(dot + 1);
}

Dataset read_dataset(const std::string& path) {
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF); // messages are reported below
  const vtkNew<Messages> messages;
  vtkOutputWindow::SetInstance(messages);
  if (std::filesystem::is_directory(path))
    return {read_dicom(path)};
  const std::string format = format_of(path);
  require_complete(path, format);
  if (format == "vtu" || format == "vtp" || format == "vti" || format == "vtr" || format == "vts" ||
      format == "pvtu")
    return {read_named<vtkXMLGenericDataObjectReader>(path, messages)};
  if (format == "vtk")
    return {read_named<vtkGenericDataObjectReader>(path, messages)};
  if (format == "nii" || format == "nii.gz")
    return read_nifti(path, messages);
  if (format == "mha" || format == "mhd")
    return {read_image<vtkMetaImageReader>(path, messages)};
  if (format == "nrrd" || format == "nhdr")
    return {read_image<vtkNrrdReader>(path, messages)};
  if (format == "tif" || format == "tiff")
    return {read_image<vtkTIFFReader>(path, messages)};
  if (format == "png")
    return {read_image<vtkPNGReader>(path, messages)};
  if (format == "pgm" || format == "ppm")
    return {read_image<vtkPNMReader>(path, messages)};
  if (format == "msh")
    return {read_gmsh(path)};
  if (format == "meshb")
    return {read_meshb(path)};
  throw Failure("is in no format that VTK or Gmsh reads: its extension is '" + format + "'");
}

} // namespace dsc_files
