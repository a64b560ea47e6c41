// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_CONFORMANCE_CASE_HPP
#define VERIFICATION_CONFORMANCE_CASE_HPP

#include "verification/conformance/device.hpp"
#include "verification/conformance/steps.hpp"
#include "verification/trace/requirement_id.hpp"

#include <cstddef>
#include <cstdint>

namespace counterpoint::conformance
{

constexpr std::size_t kMaxRequirements = 5U;

/// One conformance case. `requirements` ends with the first one without text.
struct Case
{
    const char* name;
    req::RequirementId requirements[kMaxRequirements];
    const Device* device;
    const Step* steps;
    std::uint32_t step_count;
};

/// The cases of one topic.
struct CaseTable
{
    const char* topic;
    const Case* cases;
    std::uint32_t count;
};

/// The requirements that a case verifies, one to five.
struct Shows
{
    req::RequirementId first;
    req::RequirementId second{nullptr};
    req::RequirementId third{nullptr};
    req::RequirementId fourth{nullptr};
    req::RequirementId fifth{nullptr};
};

template <std::size_t kCount>
constexpr Case MakeCase(const char* name, const Shows& shows, const Device& device, const Step (&steps)[kCount])
{
    return Case{name, {shows.first, shows.second, shows.third, shows.fourth, shows.fifth}, &device, steps, kCount};
}

template <std::size_t kCount> constexpr CaseTable MakeTable(const char* topic, const Case (&cases)[kCount])
{
    return CaseTable{topic, cases, kCount};
}

} // namespace counterpoint::conformance

#endif
