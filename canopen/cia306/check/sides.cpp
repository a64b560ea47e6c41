// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia306/check/sides.hpp"

#include "canopen/cia306/check/rules.hpp"

#include <map>
#include <string>
#include <utility>

namespace counterpoint::cia306
{
namespace
{
std::uint32_t AddressOf(const MappingEntry& entry)
{
    return entry.raw >> 8U;
}

std::string NameOf(const std::uint32_t address)
{
    return ObjectName(static_cast<std::uint16_t>(address >> 8U), static_cast<std::uint8_t>(address & 0xFFU));
}

std::string LineOf(const Entry& object)
{
    return " (line " + std::to_string(object.inverted_srad_place.line) + ")";
}

class Sides
{
  public:
    Sides(const Device& device, const SrdoConfiguration& srdo)
        : device_(device), srdo_(srdo), inverses_(InverseObjects(device))
    {
    }

    /// Inverse data in the place of normal data: the application would get the inverse of what was sent.
    void LookAtNormal(const MappingEntry& entry)
    {
        const auto found = inverses_.find(AddressOf(entry));
        if (found != inverses_.end())
        {
            const Entry& normal = *found->second;
            const std::string name = NameOf(AddressOf(entry));
            const std::string told = "normal entry " + name + " is the InvertedSRAD of " +
                                     ObjectName(normal.index, normal.sub) + LineOf(normal);
            const Entry* const object = device_.Find(entry.Index(), entry.Sub());
            const bool has_own = object != nullptr && object->inverted_srad;
            Tell(entry, has_own ? Problem{told + " and has one itself" + LineOf(*object), "one of the two"}
                                : Problem{told, "normal data here and " + name + " behind it"});
        }
    }

    /// Of two that stand in the places of a pair.
    void LookAtPair(const MappingEntry& normal, const MappingEntry& inverse)
    {
        const Entry* const object = device_.Find(normal.Index(), normal.Sub());
        const Entry* const other = device_.Find(inverse.Index(), inverse.Sub());
        const std::string text = "inverse entry " + NameOf(AddressOf(inverse));
        if (object != nullptr && object->inverted_srad)
        {
            if (*object->inverted_srad != AddressOf(inverse))
            {
                Tell(inverse, {text, NameOf(*object->inverted_srad) + ", the InvertedSRAD of " +
                                         NameOf(AddressOf(normal)) + LineOf(*object)});
            }
            return;
        }
        // One that names the normal entry makes that one inverse data, which is told there.
        const bool is_normal_data =
            other != nullptr && other->inverted_srad.value_or(AddressOf(normal)) != AddressOf(normal);
        if (is_normal_data)
        {
            Tell(inverse, {text + " has an InvertedSRAD of its own" + LineOf(*other) + ", as normal data has",
                           "inverse data of " + NameOf(AddressOf(normal))});
        }
    }

    [[nodiscard]] const std::vector<Finding>& Found() const noexcept
    {
        return found_;
    }

  private:
    void Tell(const MappingEntry& entry, const Problem& problem)
    {
        found_.push_back({WhenOn(srdo_), entry.place, ObjectName(srdo_.MappingIndex(), entry.sub),
                          problem.wrong + ", expected " + problem.expected});
    }

    const Device& device_;
    const SrdoConfiguration& srdo_;
    std::map<std::uint32_t, const Entry*> inverses_;
    std::vector<Finding> found_;
};
} // namespace

std::map<std::uint32_t, const Entry*> InverseObjects(const Device& device)
{
    std::map<std::uint32_t, const Entry*> inverses;
    for (const auto& [index, object] : device.objects)
    {
        for (const auto& [sub, entry] : object.entries)
        {
            const std::uint32_t own = (std::uint32_t{index} << 8U) | sub;
            if (entry.inverted_srad.value_or(own) != own)
            {
                inverses.emplace(*entry.inverted_srad, &entry);
            }
        }
    }
    return inverses;
}

std::vector<Finding> WrongSides(const Device& device, const SrdoConfiguration& srdo)
{
    Sides sides(device, srdo);
    const MappingEntry* normal = nullptr;
    for (const MappingEntry& entry : srdo.mapping)
    {
        if (entry.IsNormal())
        {
            sides.LookAtNormal(entry);
            normal = &entry;
            continue;
        }
        if (normal != nullptr && entry.sub == normal->sub + 1U) // Entries that cannot be read are left out.
        {
            sides.LookAtPair(*normal, entry);
        }
    }
    return sides.Found();
}

std::vector<Finding> ExchangedSides(const SafetyConfiguration& configuration)
{
    std::map<std::pair<std::uint32_t, bool>, const SrdoConfiguration*> users;
    std::vector<Finding> found;
    for (const SrdoConfiguration& srdo : configuration.srdos)
    {
        for (const MappingEntry& entry : srdo.mapping)
        {
            if (!srdo.IsOn() || entry.IsDummy())
            {
                continue;
            }
            const bool is_normal = entry.IsNormal();
            users.emplace(std::pair(AddressOf(entry), is_normal), &srdo);
            const auto other = users.find({AddressOf(entry), !is_normal});
            if (other != users.end() && other->second != &srdo)
            {
                found.push_back({Severity::kError, entry.place, ObjectName(srdo.MappingIndex(), entry.sub),
                                 (is_normal ? "normal entry " : "inverse entry ") + NameOf(AddressOf(entry)) + " is " +
                                     (is_normal ? "inverse" : "normal") + " data of SRDO " +
                                     std::to_string(other->second->number) + ", expected an object of one side"});
            }
        }
    }
    return found;
}
} // namespace counterpoint::cia306
