// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "read_dataset.h"

#include <vtkCell.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCommand.h>
#include <vtkDataArray.h>
#include <vtkDataSetAttributes.h>
#include <vtkDoubleArray.h>
#include <vtkErrorCode.h>
#include <vtkFieldData.h>
#include <vtkGenericCell.h>
#include <vtkGenericDataObjectReader.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
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
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkStringArray.h>
#include <vtkTIFFReader.h>
#include <vtkXMLGenericDataObjectReader.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <sstream>
#include <type_traits>

namespace dsc_files {
namespace {

/// Returns the last line of a message of VTK, without the address of the reader.
std::string shortened(std::string message) {
  while (!message.empty() && std::isspace(static_cast<unsigned char>(message.back())) != 0)
    message.pop_back();
  message.erase(0, message.rfind('\n') + 1);
  const std::size_t end_of_address = message.find("): ");
  return end_of_address == std::string::npos ? message : message.substr(end_of_address + 3);
}

/// What errors of VTK mean: the file is damaged, or the disk is full.
const char *complaint = "cannot be read by VTK: ", *advice = "; is it damaged?";

/// Receives the messages that VTK prints. The first error or warning ends this process: readers of
/// VTK warn about truncated files, and may crash if they continue, or are destroyed, after an
/// error.
class Messages : public vtkOutputWindow
{
public:
  static Messages* New();
  vtkTypeMacro(Messages, vtkOutputWindow);

  void DisplayErrorText(const char* text) override {
    end_process(complaint + shortened(text) + advice);
  }
  void DisplayWarningText(const char* text) override { DisplayErrorText(text); }
  void DisplayGenericWarningText(const char* text) override { DisplayErrorText(text); }
  void DisplayText(const char*) override {}

  double bytes = 0; ///< of the file that is read
};
vtkStandardNewMacro(Messages);

vtkSmartPointer<vtkDataSet> only_dataset(vtkDataObject* object) {
  vtkDataSet* const result = vtkDataSet::SafeDownCast(object);
  if (result == nullptr)
    throw Failure(object == nullptr ? std::string("contains no data that VTK reads")
                                    : std::string("contains a ") + object->GetClassName() +
                                          "; write one grid, surface or image");
  return result;
}

/// Returns the bytes of the image that a reader announces; 0 if it announces none.
double content_of_image(vtkInformation* announced) {
  int extent[6];
  if (announced == nullptr || !announced->Has(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT()))
    return 0;
  announced->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent);
  double result = 1;
  for (int axis = 0; axis < 3; ++axis)
    result *= (std::max)(0., double(extent[2 * axis + 1]) - extent[2 * axis] + 1);
  vtkInformation* const values = vtkDataObject::GetActiveFieldInformation(
      announced, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
  if (values != nullptr)
    result *=
        double(vtkDataArray::GetDataTypeSize(values->Get(vtkDataObject::FIELD_ARRAY_TYPE()))) *
        (std::max)(1, values->Get(vtkDataObject::FIELD_NUMBER_OF_COMPONENTS()));
  return result;
}

/// Runs a reader and returns its output.
template <class Reader> vtkSmartPointer<vtkDataSet> run(Reader* reader, Messages* messages) {
  reader->UpdateInformation();
  accept_content(content_of_image(reader->GetOutputInformation(0)), messages->bytes);
  reader->Update();
  if (reader->GetErrorCode() != vtkErrorCode::NoError)
    throw Failure(std::string(complaint) +
                  vtkErrorCode::GetStringFromErrorCode(reader->GetErrorCode()));
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
      throw Failure("has an axis of length 0 in its header; correct it");
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

/// Reads a MetaImage. VTK ignores its directions.
Dataset read_meta_image(const std::string& path, Messages* messages) {
  Dataset result;
  result.data = read_image<vtkMetaImageReader>(path, messages);
  vtkImageData* const image = image_of(result);
  const std::vector<double> matrix =
      numbers_in(header_value(path, '=', {"transformmatrix", "rotation", "orientation"}));
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
    for (vtkIdType i = 0; i < (std::min)(labels->GetNumberOfTuples(), names->GetNumberOfTuples());
         ++i)
      result.emplace(int(labels->GetTuple1(i)), names->GetValue(i));
  return result;
}

/// Checks lists of cells, which VTK reads as they are.
void require_valid_cells(vtkCellArray* cells, vtkIdType points) {
  const vtkIdType n = cells->GetNumberOfConnectivityIds();
  vtkIdType last = 0;
  for (vtkIdType i = 0; i <= cells->GetNumberOfCells(); ++i) {
    const vtkIdType next = vtkIdType(cells->GetOffsetsArray()->GetTuple1(i));
    if (next < last || next > n)
      throw Failure("has cells with wrong offsets; is it damaged?");
    last = next;
  }
  for (vtkIdType i = 0; i < n; ++i)
    if (const double corner = cells->GetConnectivityArray()->GetTuple1(i);
        !(corner >= 0 && corner < double(points)))
      throw Failure("has a cell with an unknown vertex; is it damaged?");
}

void require_valid_cells(vtkDataSet* data) {
  const vtkIdType points = data->GetNumberOfPoints();
  if (vtkPolyData* const surface = vtkPolyData::SafeDownCast(data))
    for (vtkCellArray* cells :
         {surface->GetVerts(), surface->GetLines(), surface->GetPolys(), surface->GetStrips()})
      require_valid_cells(cells, points);
  vtkUnstructuredGrid* const grid = vtkUnstructuredGrid::SafeDownCast(data);
  if (grid == nullptr || grid->GetNumberOfCells() == 0)
    return;
  require_valid_cells(grid->GetCells(), points);
  std::map<int, vtkIdType> least; // numbers of corners
  for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i) {
    const int type = grid->GetCellType(i);
    const auto [place, is_new] = least.emplace(type, 0);
    if (is_new)
      if (const auto cell = vtkSmartPointer<vtkCell>::Take(vtkGenericCell::InstantiateCell(type)))
        place->second = cell->GetNumberOfPoints();
    if (grid->GetCells()->GetCellSize(i) < place->second)
      throw Failure("has a cell with too few vertices; is it damaged?");
  }
}

/// Removes cells that other pieces of a file repeat.
void remove_ghost_cells(vtkDataSet* data) {
  if (vtkUnstructuredGrid* const grid = vtkUnstructuredGrid::SafeDownCast(data))
    grid->RemoveGhostCells();
  else if (vtkPolyData* const surface = vtkPolyData::SafeDownCast(data))
    surface->RemoveGhostCells();
}

} // namespace

void expect_errors_of_disk() {
  complaint = "cannot be written: ";
  advice = "; check that the folder for temporary files (TMPDIR) is not full";
}

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
  const std::string format = format_of(path);
  const Header header(path, format);
  accept_content(header.content, header.bytes);
  messages->bytes = header.bytes;
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
  require_valid_cells(result.data);
  if (result.translation.names.empty())
    result.translation.names = names_in(result.data);
  remove_ghost_cells(result.data);
  return result;
}

} // namespace dsc_files
