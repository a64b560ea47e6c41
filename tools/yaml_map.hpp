// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TOOLS_YAML_MAP_HPP
#define TOOLS_YAML_MAP_HPP

#include "verification/simulator/fields.hpp"
#include "verification/simulator/yaml_document.hpp"

#include <cstddef>
#include <initializer_list>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace counterpoint::tools
{
/// The keys of one map of a YAML file: known ones once at the most, no others. Throws simulator::ScenarioError.
class YamlMap
{
  public:
    /// @brief Both outlive the map.
    YamlMap(const std::string& file, const simulator::YamlNode& node, std::initializer_list<const char*> known);

    [[nodiscard]] std::optional<simulator::ScenarioValue> Find(const std::string& name) const;
    [[nodiscard]] simulator::ScenarioValue Require(const std::string& name) const;
    /// @brief The line of each key that is there.
    [[nodiscard]] std::map<std::string, std::size_t> Lines() const;
    [[nodiscard]] const simulator::ScenarioValue& Value() const noexcept
    {
        return value_;
    }

  private:
    const std::string& file_;
    simulator::ScenarioValue value_;
};
} // namespace counterpoint::tools

#endif // TOOLS_YAML_MAP_HPP
