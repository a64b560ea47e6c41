// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SIMULATOR_SCENARIO_FIELDS_HPP
#define SIMULATOR_SCENARIO_FIELDS_HPP

#include "simulator/scenario/scenario.hpp"
#include "simulator/scenario/schema.hpp"
#include "simulator/scenario/values.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace counterpoint::simulator
{
/// The keys of one map of a scenario. Every value that is found was checked against the schema. It remembers which keys
/// were asked for, so that Close can refuse all others.
class Fields
{
  public:
    /// @brief `section` names the section of the schema that describes this map.
    Fields(const YamlValue& value, const char* section);

    /// @brief From now on the keys of another section are known, too.
    void Extend(const char* section);
    /// @brief The value of a key; if it is not there, the default of the schema; if there is none, nothing.
    [[nodiscard]] std::optional<YamlValue> Find(const std::string& key);
    /// @brief The value of a key that must be there or have a default.
    [[nodiscard]] YamlValue Require(const std::string& key);
    /// @brief Whether such a key is known here.
    [[nodiscard]] bool Has(const std::string& key) const;
    /// @brief The map itself.
    [[nodiscard]] const YamlValue& Value() const noexcept;
    /// @brief All keys with their values, in the order of the file.
    [[nodiscard]] std::vector<std::pair<YamlValue, YamlValue>> All();
    /// @brief Throws for the first key that is unknown, or that nobody asked for.
    void Close() const;

  private:
    [[nodiscard]] const KeySpec* SpecOf(const std::string& key) const;

    YamlValue value_;
    std::vector<const SectionSpec*> sections_; ///< The last one names the map in messages.
    std::vector<std::string> known_;
};
} // namespace counterpoint::simulator

#endif // SIMULATOR_SCENARIO_FIELDS_HPP
