// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "read_dataset.h"

#include <vtkCellData.h>
#include <vtkCommand.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkErrorCode.h>
#include <vtkFieldData.h>
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
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkTIFFReader.h>
#include <vtkXMLGenericDataObjectReader.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <iterator>
#include <sstream>
#include <type_traits>
#include <vector>

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
  std::replace_if(
      message.begin(), message.end(), [](unsigned char c) { return std::iscntrl(c) != 0; }, ' ');
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
  if constexpr (std::is_same_v<Reader, vtkTIFFReader>)
    reader->SetOrientationType(4); // ORIENTATION_BOTLEFT: the last row of the file has y = 0
  if (reader->CanReadFile(path.c_str()) == 0)
    throw Failure("is not in the format of its extension, or is damaged");
  reader->SetFileName(path.c_str());
  return run(reader.Get(), messages);
}

/// Places an image: sets its origin, and from the images of unit vectors along its axes its
/// spacing and directions.
/// \param coordinate returns a coordinate of the vector between neighbors along an axis of the image
template <class Coordinate>
void place(vtkImageData* image, const Coordinate& coordinate, const std::array<double, 3>& origin) {
  vtkNew<vtkMatrix3x3> directions;
  double spacing[3];
  for (int j = 0; j < 3; ++j) {
    spacing[j] = std::hypot(coordinate(0, j), coordinate(1, j), coordinate(2, j));
    if (!(spacing[j] > 0 && std::isfinite(spacing[j])))
      throw Failure("has an axis of length 0 in its header");
    for (int i = 0; i < 3; ++i)
      directions->SetElement(i, j, coordinate(i, j) / spacing[j]);
  }
  image->SetSpacing(spacing);
  image->SetOrigin(origin.data());
  image->SetDirectionMatrix(directions);
}

vtkImageData* image_of(const Dataset& dataset) {
  vtkImageData* const image = vtkImageData::SafeDownCast(dataset.data);
  if (image == nullptr)
    throw Failure("contains no image");
  return image;
}

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
  vtkImageData* const image = image_of(result);
  const double slope = reader->GetRescaleSlope(), intercept = reader->GetRescaleIntercept();
  vtkDataArray* const stored = image->GetPointData()->GetScalars();
  if (stored != nullptr && slope != 0 && (slope != 1 || intercept != 0)) {
    vtkNew<vtkDoubleArray> scaled;
    scaled->SetName(stored->GetName());
    scaled->SetNumberOfComponents(stored->GetNumberOfComponents());
    scaled->SetNumberOfTuples(stored->GetNumberOfTuples());
    for (vtkIdType i = 0; i < stored->GetNumberOfTuples(); ++i)
      for (int k = 0; k < stored->GetNumberOfComponents(); ++k)
        scaled->SetComponent(i, k, slope * stored->GetComponent(i, k) + intercept);
    image->GetPointData()->SetScalars(scaled);
  }
  vtkMatrix4x4* matrix = reader->GetSFormMatrix();
  if (matrix == nullptr)
    matrix = reader->GetQFormMatrix();
  if (matrix == nullptr)
    return result;
  // The matrix maps coordinates with the spacing, but without the origin, to space.
  const auto coordinate = [&](int i, int j) {
    return matrix->GetElement(i, j) * image->GetSpacing()[j];
  };
  place(image, coordinate,
        {matrix->GetElement(0, 3), matrix->GetElement(1, 3), matrix->GetElement(2, 3)});
  return result;
}

/// Returns the numbers in a text, which parentheses and commas may separate.
std::vector<double> numbers_in(std::string text) {
  for (char& c : text)
    if (c == '(' || c == ')' || c == ',')
      c = ' ';
  std::istringstream in(text);
  return std::vector<double>(std::istream_iterator<double>(in), std::istream_iterator<double>());
}

/// Returns the value of the first of some keys in the text header of a file; empty if there is
/// none.
std::string header_value(const std::string& path, char separator,
                         std::initializer_list<const char*> keys) {
  std::ifstream file(path, std::ios::binary);
  for (std::string line; std::getline(file, line) && !line.empty() && line != "\r";) {
    const std::size_t mark = line.find(separator);
    std::string key = line.substr(0, mark);
    key.erase(key.find_last_not_of(" \t") + 1);
    if (mark != std::string::npos && std::find(keys.begin(), keys.end(), key) != keys.end())
      return line.substr(mark + 1);
    if (key == "ElementDataFile")
      break;
  }
  return "";
}

/// Reads a MetaImage. VTK ignores its directions.
Dataset read_meta_image(const std::string& path, Messages* messages) {
  Dataset result;
  result.data = read_image<vtkMetaImageReader>(path, messages);
  vtkImageData* const image = image_of(result);
  const std::vector<double> matrix =
      numbers_in(header_value(path, '=', {"TransformMatrix", "Rotation", "Orientation"}));
  if (matrix.size() != 9)
    return result;
  const auto coordinate = [&](int i, int j) {
    return matrix[std::size_t(3 * j + i)] * image->GetSpacing()[j];
  };
  const double* const origin = image->GetOrigin();
  place(image, coordinate, {origin[0], origin[1], origin[2]});
  return result;
}

/// Reads an image in the NRRD format. VTK ignores its directions.
Dataset read_nrrd(const std::string& path, Messages* messages) {
  // The reader of VTK does not end if the header does not end.
  std::ifstream file(path, std::ios::binary);
  std::string line = "NRRD";
  while (!line.empty() && line != "\r")
    if (!std::getline(file, line))
      throw Failure("has a header without an empty line at its end; is it truncated?");
  Dataset result;
  result.data = read_image<vtkNrrdReader>(path, messages);
  const std::vector<double> vectors = numbers_in(header_value(path, ':', {"space directions"})),
                            first = numbers_in(header_value(path, ':', {"space origin"}));
  if (vectors.size() != 9)
    return result;
  std::array<double, 3> origin = {0, 0, 0};
  if (first.size() == 3)
    std::copy(first.begin(), first.end(), origin.begin());
  place(
      image_of(result), [&](int i, int j) { return vectors[std::size_t(3 * j + i)]; }, origin);
  return result;
}

/// Returns the names of labels in the data of the whole grid, as this package writes them.
std::map<int, std::string> names_in(vtkDataSet* data) {
  std::map<int, std::string> result;
  vtkDataArray* const labels = data->GetFieldData()->GetArray("named_labels");
  auto* const names =
      vtkStringArray::SafeDownCast(data->GetFieldData()->GetAbstractArray("label_names"));
  if (labels != nullptr && names != nullptr && data->GetCellData()->HasArray("label") != 0)
    for (vtkIdType i = 0; i < std::min(labels->GetNumberOfTuples(), names->GetNumberOfTuples());
         ++i)
      result.emplace(int(labels->GetTuple1(i)), names->GetValue(i));
  return result;
}

/// Removes cells that other pieces of a file repeat.
void remove_ghost_cells(vtkDataSet* data) {
  if (vtkUnstructuredGrid* const grid = vtkUnstructuredGrid::SafeDownCast(data))
    grid->RemoveGhostCells();
  else if (vtkPolyData* const surface = vtkPolyData::SafeDownCast(data))
    surface->RemoveGhostCells();
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

Dataset read_dataset(const std::string& path, const std::string& folder) {
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF); // messages are reported below
  const vtkNew<Messages> messages;
  vtkOutputWindow::SetInstance(messages);
  if (std::filesystem::is_directory(path))
    throw Failure("is a folder; name a file in it (dcm2niix converts DICOM images to NIfTI)");
  const std::string format = format_of(path);
  require_complete(path, format);
  Dataset result;
  if (format == "vtu" || format == "vtp" || format == "vti" || format == "vtr" || format == "vts" ||
      format == "pvtu")
    result.data = read_named<vtkXMLGenericDataObjectReader>(path, messages);
  else if (format == "vtk")
    result.data = read_named<vtkGenericDataObjectReader>(path, messages);
  else if (format == "nii" || format == "nii.gz")
    result = read_nifti(path, messages);
  else if (format == "mha" || format == "mhd")
    result = read_meta_image(path, messages);
  else if (format == "nrrd" || format == "nhdr")
    result = read_nrrd(path, messages);
  else if (format == "tif" || format == "tiff")
    result.data = read_image<vtkTIFFReader>(path, messages);
  else if (format == "png")
    result.data = read_image<vtkPNGReader>(path, messages);
  else if (format == "pgm" || format == "ppm")
    result.data = read_image<vtkPNMReader>(path, messages);
  else if (format == "msh")
    result.data = read_gmsh(path, folder, result.translation);
  else if (format == "3mf")
    result.data = read_3mf(path, result.translation);
  else if (format == "vtm")
    result.data = read_blocks(path, result.translation);
  else if (format == "meshb")
    result.data = read_meshb(path, result.translation);
  else
    throw Failure("is in no format that VTK, Gmsh or lib3mf reads: its extension is '" + format +
                  "'");
  if (!messages->error.empty())
    throw Failure("cannot be read by VTK: " + shortened(messages->error));
  if (result.translation.names.empty())
    result.translation.names = names_in(result.data);
  remove_ghost_cells(result.data);
  return result;
}

} // namespace dsc_files
