// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_CLAIMED_FOLDER_H
#define DSC_CLAIMED_FOLDER_H

#include <string>

namespace dsc {

/// Folders of results, which other runs must not use, and of files that nobody else knows.
enum class Folder_kind { results, temporary };

/// A folder that belongs to this process until the end of the scope. It contains a locked
/// file with the command of the process. The system releases the lock when the process ends,
/// however it ends.
class Claimed_folder
{
public:
  /// Creates the folder if necessary, and removes what a killed process has left half written. If
  /// the file system of results has no locks, a note says so.
  /// \throws Input_error if nothing can be written there, or if another process has claimed the
  /// folder
  explicit Claimed_folder(const std::string& path, Folder_kind kind = Folder_kind::results);
  ~Claimed_folder();
  Claimed_folder(const Claimed_folder&) = delete;
  Claimed_folder& operator=(const Claimed_folder&) = delete;

  /// \throws Input_error if the folder was removed or replaced since it was claimed
  void require() const;

  /// Returns the path of a file in the folder.
  std::string file(const std::string& name) const;

private:
  std::string m_path;
  std::string m_lock_path;
  int m_lock; ///< file descriptor
};

/// Returns whether a temporary folder was claimed by a process that was killed.
bool is_abandoned(const std::string& path);

} // namespace dsc

#endif // DSC_CLAIMED_FOLDER_H
