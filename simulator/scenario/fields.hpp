// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef SIMULATOR_SCENARIO_FIELDS_HPP
#define SIMULATOR_SCENARIO_FIELDS_HPP

#include "simulator/scenario/schema.hpp"
#include "simulator/scenario/values.hpp"

#include "safety_core/kernel/object_access.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace counterpoint::simulator
{
/// The words of "loss, delay".
[[nodiscard]] std::vector<std::string> WordsIn(const std::string& list);
/// The items of a list, or a single value as a list of one.
[[nodiscard]] std::vector<YamlValue> ItemsOf(const YamlValue& value);

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
    /// @brief Sets `target` to the value of a key, read as the schema says, or to its default. False: there is neither,
    /// and it stays as it is.
    bool Into(const std::string& key, std::string& target);
    bool Into(const std::string& key, ObjectAddress& target);
    /// @brief The same of a time or a number.
    template <typename Target> bool Into(const std::string& key, Target& target)
    {
        const std::optional<YamlValue> found = Find(key);
        target = found ? static_cast<Target>(Quantity(key, *found)) : target;
        return found.has_value();
    }
    /// @brief The same of a list of numbers.
    template <typename Number> bool Into(const std::string& key, std::vector<Number>& target)
    {
        const std::optional<YamlValue> found = Find(key);
        for (const YamlValue& item : found ? ItemsOf(*found) : std::vector<YamlValue>{})
        {
            target.push_back(static_cast<Number>(item.Number({0U, std::numeric_limits<Number>::max()})));
        }
        return found.has_value();
    }
    /// @brief The same of a list in which no number may stand twice. [SRS_SIM_080]
    template <typename Number> bool IntoOnce(const std::string& key, std::vector<Number>& target)
    {
        const std::optional<YamlValue> found = Find(key);
        for (const YamlValue& item : found ? ItemsOf(*found) : std::vector<YamlValue>{})
        {
            const auto number = static_cast<Number>(item.Number({0U, std::numeric_limits<Number>::max()}));
            if (std::find(target.begin(), target.end(), number) != target.end())
            {
                item.Refuse(std::to_string(number) + " a second time", "each number once");
            }
            target.push_back(number);
        }
        return found.has_value();
    }
    /// @brief The same of a key that must be there or have a default.
    template <typename Target> void Need(const std::string& key, Target& target)
    {
        static_cast<void>(Require(key));
        static_cast<void>(Into(key, target));
    }
    /// @brief The map of a key, with the section that the schema says; nothing if it is not there.
    [[nodiscard]] std::optional<Fields> Map(const std::string& key);
    /// @brief The section of the maps of a key.
    [[nodiscard]] const char* SectionOf(const std::string& key) const;
    /// @brief Whether such a key is known here.
    [[nodiscard]] bool Has(const std::string& key) const
    {
        return SpecOf(key) != nullptr;
    }
    /// @brief The map itself.
    [[nodiscard]] const YamlValue& Value() const noexcept
    {
        return value_;
    }
    /// @brief All keys with their values, in the order of the file.
    [[nodiscard]] std::vector<std::pair<YamlValue, YamlValue>> All();
    /// @brief Throws for the first key that is unknown, or that nobody asked for.
    void Close() const;

  private:
    [[noreturn]] void RefuseWithout(const std::string& key) const;
    [[nodiscard]] const KeySpec* SpecOf(const std::string& key) const;
    [[nodiscard]] std::uint64_t Quantity(const std::string& key, const YamlValue& value) const;

    YamlValue value_;
    std::vector<const SectionSpec*> sections_; ///< The last one names the map in messages.
    std::vector<std::string> known_;
};
} // namespace counterpoint::simulator

#endif // SIMULATOR_SCENARIO_FIELDS_HPP
