// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA306_CHECK_RULES_HPP
#define CANOPEN_CIA306_CHECK_RULES_HPP

#include "canopen/cia306/check/check.hpp"
#include "canopen/cia306/safety/device_parameters.hpp"
#include "canopen/cia306/safety/safety_configuration.hpp"
#include "canopen/cia306/text/input_error.hpp"

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace counterpoint::cia306
{
/// Collects what the rules find.
class Findings
{
  public:
    /// Adds an error: line of the file, object (may be empty), what is wrong, what was expected.
    void Error(const Place place, const std::string& object, const std::string& wrong, const std::string& expected)
    {
        Tell(Severity::kError, place, object, {wrong, expected});
    }
    /// Adds a warning of the same form.
    void Warning(const Place place, const std::string& object, const std::string& wrong, const std::string& expected)
    {
        Tell(Severity::kWarning, place, object, {wrong, expected});
    }
    /// Adds one or the other.
    void Tell(const Severity severity, const Place place, const std::string& object, const Problem& problem)
    {
        Add({{severity, place, object, problem.wrong + ", expected " + problem.expected}});
    }
    /// Adds findings that somebody else made.
    void Add(const std::vector<Finding>& findings)
    {
        for (const Finding& finding : findings)
        {
            if (finding.severity == Severity::kError)
            {
                error_places_.emplace(finding.place.line, finding.object);
            }
            findings_.push_back(finding);
        }
    }
    /// Whether there is any error.
    [[nodiscard]] bool HasError() const
    {
        return !error_places_.empty();
    }
    /// Whether there is an error of this object at this line.
    [[nodiscard]] bool HasErrorAt(const Place place, const std::string& object) const
    {
        return error_places_.count({place.line, object}) != 0U;
    }
    /// All findings, in the order of their lines.
    [[nodiscard]] std::vector<Finding> Sorted() const
    {
        return SortedByLine(findings_);
    }

  private:
    std::vector<Finding> findings_;
    std::set<std::pair<std::size_t, std::string>> error_places_;
};

/// What all rules look at.
struct CheckContext
{
    const Device& device;
    const SafetyConfiguration& configuration;
    const DeviceParameters& parameters;
    std::optional<std::uint8_t> node_id;
    std::uint32_t granularity_bits;
};

/// How bad it is to break a rule that a device looks at only when the SRDO is on. [SRS_CLI_031]
[[nodiscard]] inline Severity WhenOn(const SrdoConfiguration& srdo) noexcept
{
    return srdo.direction.Is(0U) ? Severity::kWarning : Severity::kError;
}

/// Direction, transmission type, COB-IDs and times of one SRDO. [SRS_CLI_010, SRS_CLI_011, SRS_CLI_017]
void CheckCommunication(const CheckContext& context, const SrdoConfiguration& srdo, Findings& findings);

/// Number, lengths and pairs of the mapping entries of one SRDO. [SRS_CLI_012, SRS_CLI_014]
void CheckMapping(const CheckContext& context, const SrdoConfiguration& srdo, Findings& findings);

/// Whether the object that one mapping entry names can be mapped. [SRS_CLI_013, SRS_CLI_015]
void CheckMappedObject(const CheckContext& context, const SrdoConfiguration& srdo, const MappingEntry& entry,
                       Findings& findings);

/// Whether two SRDOs of the device use the same identifier. [SRS_CLI_010]
void CheckIdentifiers(const SafetyConfiguration& configuration, Findings& findings);

/// Whether an object is mapped by two SRDOs that are on, one of which receives. [SRS_CLI_032]
void CheckShared(const SafetyConfiguration& configuration, Findings& findings);

/// Objects that every device has. [SRS_CLI_038]
void CheckMandatory(const Device& device, Findings& findings);

/// Sub-index 0 of lists and records from 2000h on. [SRS_CLI_039]
void CheckHighestSubs(const CheckContext& context, Findings& findings);

/// Access rights of what the kernel serves by its own rules. [SRS_CLI_040]
void CheckKernelAccess(const Device& device, Findings& findings);

/// 1300h, 13FEh, 13FFh, reserved indices, limits, InvertedSRAD. Comes last: 13FEh depends on the other findings.
/// [SRS_CLI_014, SRS_CLI_016, SRS_CLI_017]
void CheckObjects(const CheckContext& context, Findings& findings);

/// Whether a mapping that cannot be written keeps the rules of a static mapping. [SRS_CLI_023]
void CheckStaticMapping(const CheckContext& context, const SrdoConfiguration& srdo, Findings& findings);

/// Whether 5F04h is the digest that follows from the file. [SRS_CLI_022]
void CheckDigest(const CheckContext& context, Findings& findings);

/// Whether the times of 5F00h are such that a kernel starts with them. [SRS_CLI_018]
void CheckTimes(const CheckContext& context, Findings& findings);

/// Whether 5F00h to 5F03h and 5F05h have values that a device can use. [SRS_CLI_018]
void CheckParameters(const CheckContext& context, Findings& findings);
} // namespace counterpoint::cia306

#endif // CANOPEN_CIA306_CHECK_RULES_HPP
