// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "json_text.h"

#include "errors.h"

#include <cstddef>
#include <set>
#include <vector>

namespace dsc {
namespace {

/// A parser callback that detects duplicate fields in objects and lists.
class Field_names
{
public:
  explicit Field_names(const std::string& file) : m_file(file) {}

  void pass(Json::parse_event_t event, const Json& json) {
    using Event = Json::parse_event_t;
    switch (event) {
    case Event::object_start:
    case Event::array_start:
      m_levels.push_back({event == Event::array_start, 0, "", {}});
      break;
    case Event::object_end:
    case Event::array_end:
      m_levels.pop_back();
      pass_element();
      break;
    case Event::value:
      pass_element();
      break;
    case Event::key:
      Level& level = m_levels.back();
      level.field = json.get<std::string>();
      if (!level.fields.insert(level.field).second)
        throw Input_error(m_file + ": the field '" + place() +
                          "' occurs twice; remove one of them");
    }
  }

private:
  struct Level
  {
    bool is_list;
    std::size_t index;
    std::string field;
    std::set<std::string> fields;
  };

  void pass_element() {
    if (!m_levels.empty())
      ++m_levels.back().index;
  }

  /// Returns the place of the field read last, like "liquids[0].density".
  std::string place() const {
    std::string result;
    for (const Level& level : m_levels)
      result += level.is_list ? "[" + std::to_string(level.index) + "]"
                              : (result.empty() ? "" : ".") + level.field;
    return result;
  }

  std::string m_file;
  std::vector<Level> m_levels;
};

/// Returns the message of the library, without its error number.
std::string reason(const Json::exception& error) {
  const std::string text = error.what();
  const std::size_t bracket = text.find("] ");
  std::string result = bracket == std::string::npos ? text : text.substr(bracket + 2);
  if (text.find("/'") != std::string::npos)
    result += "; JSON has no comments";
  return result;
}

} // namespace

Json parse_json(const std::string& text, const std::string& name) {
  Field_names names(name);
  try {
    return Json::parse(text, [&](int, Json::parse_event_t event, const Json& json) {
      names.pass(event, json);
      return true;
    });
  } catch (const Json::exception& error) {
    throw Input_error(name + " is not valid JSON: " + reason(error));
  }
}

} // namespace dsc
