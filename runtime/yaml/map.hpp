// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef RUNTIME_YAML_MAP_HPP
#define RUNTIME_YAML_MAP_HPP

#include "runtime/yaml/document.hpp"
#include "runtime/yaml/value.hpp"

#include <cstddef>
#include <initializer_list>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace counterpoint::runtime
{
/// The keys of one map of a YAML file. Unknown keys and keys that stand twice are refused. Throws runtime::YamlError.
class YamlMap
{
  public:
    /// @brief Both outlive the map.
    YamlMap(const std::string& file, const runtime::YamlNode& node, std::initializer_list<const char*> known);

    /// @brief The value of a key; nothing if the key is not there.
    [[nodiscard]] std::optional<runtime::YamlValue> Find(const std::string& name) const;
    /// @brief The value of a key that must be there.
    [[nodiscard]] runtime::YamlValue Require(const std::string& name) const;
    /// @brief The lines of the keys that are there.
    [[nodiscard]] std::map<std::string, Place> Places() const;
    /// @brief The map itself.
    [[nodiscard]] const runtime::YamlValue& Value() const noexcept
    {
        return value_;
    }

  private:
    const std::string& file_;
    runtime::YamlValue value_;
};
} // namespace counterpoint::runtime

#endif // RUNTIME_YAML_MAP_HPP
