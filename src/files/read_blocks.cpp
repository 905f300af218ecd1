// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "read_dataset.h"

#include <vtkAppendFilter.h>
#include <vtkCellData.h>
#include <vtkCompositeDataSet.h>
#include <vtkDataObjectTreeIterator.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkIntArray.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkXMLMultiBlockDataReader.h>

#include <set>

namespace dsc_files {
namespace {

/// Names of the arrays of blocks. Arrays that not all blocks have are lost.
class Arrays_of_blocks
{
public:
  explicit Arrays_of_blocks(const char* kind) : m_kind(kind) {}

  void add(vtkFieldData* arrays) {
    for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
      if (const char* const name = arrays->GetArrayName(i))
        m_names.insert(name);
  }

  void leave_out_others(vtkFieldData* kept, Translation& translation) const {
    for (const std::string& name : m_names)
      if (kept->HasArray(name.c_str()) == 0)
        translation.unused.push_back(m_kind + " array (" + name + ") of some blocks");
  }

private:
  std::string m_kind;
  std::set<std::string> m_names;
};

} // namespace

vtkSmartPointer<vtkDataSet> read_blocks(const std::string& path, Translation& translation) {
  vtkNew<vtkXMLMultiBlockDataReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  auto* const blocks = vtkCompositeDataSet::SafeDownCast(reader->GetOutputDataObject(0));
  if (blocks == nullptr)
    throw Failure("contains no blocks; is it a multi-block file of VTK?");
  Names_of_parts parts;
  vtkNew<vtkAppendFilter> all;
  Arrays_of_blocks of_points("point"), of_cells("cell");
  std::size_t replaced = 0;
  const auto iterator = vtkSmartPointer<vtkCompositeDataIterator>::Take(blocks->NewIterator());
  for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem()) {
    auto* const block = vtkDataSet::SafeDownCast(iterator->GetCurrentDataObject());
    if (block == nullptr || vtkImageData::SafeDownCast(block) != nullptr)
      throw Failure("has a block that is no grid and no surface; write the blocks as such");
    vtkInformation* const about =
        iterator->HasCurrentMetaData() != 0 ? iterator->GetCurrentMetaData() : nullptr;
    const bool is_named = about != nullptr && about->Has(vtkCompositeDataSet::NAME()) != 0;
    const int label = parts.label_of(is_named ? about->Get(vtkCompositeDataSet::NAME()) : "",
                                     "block " + std::to_string(iterator->GetCurrentFlatIndex()));
    of_points.add(block->GetPointData());
    of_cells.add(block->GetCellData());
    vtkNew<vtkIntArray> labels;
    labels->SetName("label");
    labels->SetNumberOfValues(block->GetNumberOfCells());
    labels->FillValue(label);
    const auto copy = vtkSmartPointer<vtkDataSet>::Take(block->NewInstance());
    copy->ShallowCopy(block);
    replaced += copy->GetCellData()->HasArray("label") != 0;
    copy->GetCellData()->AddArray(labels);
    all->AddInputData(copy);
  }
  if (parts.names().empty())
    throw Failure("contains no blocks; write grids or surfaces");
  all->Update();
  of_points.leave_out_others(all->GetOutput()->GetPointData(), translation);
  of_cells.leave_out_others(all->GetOutput()->GetCellData(), translation);
  translation.leave_out(replaced, "cell array (label) of a block", "cell arrays (label) of blocks");
  translation.names = parts.names();
  return all->GetOutput();
}

} // namespace dsc_files
