// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Translation.h"
#include "read_dataset.h"

#include <vtkDataArray.h>
#include <vtkDataSetWriter.h>
#include <vtkImageData.h>
#include <vtkMatrix3x3.h>
#include <vtkMetaImageWriter.h>
#include <vtkNIFTIImageReader.h>
#include <vtkNIFTIImageWriter.h>
#include <vtkNew.h>
#include <vtkPLYReader.h>
#include <vtkPNGWriter.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkTIFFWriter.h>
#include <vtkXMLImageDataWriter.h>
#include <vtkXMLPolyDataWriter.h>

#include <cmath>
#include <filesystem>

namespace dsc_files {
namespace {

constexpr char no_room[] =
    "cannot be written; check that the folder for temporary files (TMPDIR) is not full";

template <class Writer> void write(vtkDataObject* data, const std::string& path, Writer* writer) {
  writer->SetInputData(data);
  writer->SetFileName(path.c_str());
  writer->Write();
  if (writer->GetErrorCode() != 0)
    throw Failure(no_room);
}

template <class Writer> void write(vtkDataObject* data, const std::string& path) {
  write(data, path, vtkNew<Writer>().Get());
}

/// Returns an image with the axes of another one, and with the values of the voxels of `labels`
/// with the same centers.
vtkSmartPointer<vtkImageData> along_axes_of(vtkImageData* like, vtkImageData* labels) {
  auto result = vtkSmartPointer<vtkImageData>::New();
  result->SetDimensions(like->GetDimensions());
  result->SetSpacing(like->GetSpacing());
  result->SetOrigin(like->GetOrigin());
  result->SetDirectionMatrix(like->GetDirectionMatrix());
  vtkDataArray* const from = labels->GetPointData()->GetArray(0);
  if (from == nullptr || result->GetNumberOfPoints() != labels->GetNumberOfPoints())
    throw Failure("has another grid than the image of --grid");
  const auto to = vtkSmartPointer<vtkDataArray>::Take(from->NewInstance());
  to->SetName(from->GetName());
  to->SetNumberOfTuples(from->GetNumberOfTuples());
  const int* const size = labels->GetDimensions();
  for (vtkIdType i = 0; i < result->GetNumberOfPoints(); ++i) {
    double p[3];
    result->GetPoint(i, p);
    vtkIdType index[3];
    for (int axis = 0; axis < 3; ++axis) {
      index[axis] = vtkIdType(
          std::lround((p[axis] - labels->GetOrigin()[axis]) / labels->GetSpacing()[axis]));
      if (index[axis] < 0 || index[axis] >= size[axis])
        throw Failure("cannot get the grid of --grid, whose axes are rotated in space");
    }
    to->SetTuple(i, index[0] + size[0] * (index[1] + vtkIdType(size[1]) * index[2]), from);
  }
  result->GetPointData()->SetScalars(to);
  return result;
}

/// Returns the matrix of an image from its axes to space, without the spacing.
vtkSmartPointer<vtkMatrix4x4> matrix_of(vtkImageData* image) {
  auto result = vtkSmartPointer<vtkMatrix4x4>::New();
  for (int i = 0; i < 3; ++i) {
    result->SetElement(i, 3, image->GetOrigin()[i]);
    for (int j = 0; j < 3; ++j)
      result->SetElement(i, j, image->GetDirectionMatrix()->GetElement(i, j));
  }
  return result;
}

void write_nifti(vtkImageData* image, const std::string& path, double slice_order) {
  vtkNew<vtkNIFTIImageWriter> writer;
  const auto matrix = matrix_of(image);
  writer->SetQFac(slice_order);
  writer->SetQFormMatrix(matrix);
  writer->SetSFormMatrix(matrix);
  vtkNew<vtkImageData> at_origin; // the matrix contains the place
  at_origin->ShallowCopy(image);
  at_origin->SetOrigin(0, 0, 0);
  at_origin->SetDirectionMatrix(vtkNew<vtkMatrix3x3>().Get());
  write(at_origin, path, writer.Get());
}

void write_image_as(vtkImageData* image, const std::string& path, const std::string& format,
                    double slice_order) {
  if (format == "vti")
    write<vtkXMLImageDataWriter>(image, path);
  else if (format == "vtk")
    write<vtkDataSetWriter>(image, path);
  else if (format == "mha")
    write<vtkMetaImageWriter>(image, path);
  else if (format == "nii" || format == "nii.gz")
    write_nifti(image, path, slice_order);
  else if (format == "tif" || format == "tiff") {
    if (image->GetScalarType() != VTK_UNSIGNED_SHORT)
      throw Failure("cannot contain labels outside 0 to 65535; write .nii, .mha or .vti");
    write<vtkTIFFWriter>(image, path);
  } else if (format == "png") {
    if (image->GetDimensions()[2] != 1)
      throw Failure("cannot contain several layers; write .nii, .mha or .vti");
    if (image->GetScalarType() != VTK_UNSIGNED_SHORT)
      throw Failure("cannot contain labels outside 0 to 65535; write .nii, .mha or .vti");
    write<vtkPNGWriter>(image, path);
  } else
    throw Failure("cannot contain an image; write .inr, .mha, .nii, .tif, .vti or .vtk");
}

/// Writes a dataset. Returns what was written; null if the format is one of this package.
vtkSmartPointer<vtkDataSet> write_dataset(const std::string& input, const std::string& output,
                                          const std::string& like, const std::string& folder) {
  const std::string format = format_of(output);
  if (format_of(input) == "ply") {
    vtkNew<vtkPLYReader> reader;
    reader->SetFileName(input.c_str());
    reader->Update();
    if (format == "vtp")
      write<vtkXMLPolyDataWriter>(reader->GetOutput(), output);
    else
      write<vtkDataSetWriter>(reader->GetOutput(), output);
    return reader->GetOutput();
  }
  const Dataset dataset = read_dataset(input, folder);
  vtkImageData* const image = vtkImageData::SafeDownCast(dataset.data);
  if (image == nullptr) {
    write<vtkDataSetWriter>(dataset.data, output);
    return dataset.data;
  }
  if (format == "inr") {
    Options options;
    options.folder = folder;
    std::filesystem::rename(write_image(image, options).path, output);
    return nullptr;
  }
  if (like.empty()) {
    write_image_as(image, output, format, dataset.slice_order);
    return image;
  }
  const Dataset model = read_dataset(like, folder);
  vtkImageData* const model_image = vtkImageData::SafeDownCast(model.data);
  if (model_image == nullptr)
    throw Failure("has no image as --grid");
  const auto placed = along_axes_of(model_image, image);
  write_image_as(placed, output, format, model.slice_order);
  return placed;
}

/// Returns whether a file can be read and contains as much as was written.
bool is_complete(vtkDataSet* written, const std::string& path, const std::string& folder) {
  try {
    const Dataset read = read_dataset(path, folder);
    return read.data->GetNumberOfPoints() == written->GetNumberOfPoints() &&
           read.data->GetNumberOfCells() == written->GetNumberOfCells();
  } catch (const std::exception&) {
    return false;
  }
}

} // namespace

void write_foreign(const std::string& input, const std::string& output, const std::string& like) {
  expect_errors_of_disk();
  const std::string folder = std::filesystem::path(output).parent_path().string();
  const vtkSmartPointer<vtkDataSet> written = write_dataset(input, output, like, folder);
  // The writers of VTK do not notice all errors of the disk; those of compressed images do.
  if (written != nullptr && format_of(output) != "nii.gz" && !is_complete(written, output, folder))
    throw Failure(no_room);
}

} // namespace dsc_files
