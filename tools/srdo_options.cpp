// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tools/srdo_options.hpp"

#include "canopen/cia306/text/number.hpp"

#include <stdexcept>

namespace counterpoint::tools
{
namespace
{
constexpr std::uint32_t kMostSctMs = 65535U;
constexpr std::uint32_t kMostSrvtMs = 255U;
constexpr const char* kRefreshMs = "25";
constexpr const char* kSctMs = "50";
constexpr const char* kSrvtMs = "20";

std::string ProblemOfSct(const std::string& text)
{
    return ProblemOfRange(text, 1U, kMostSctMs);
}

std::string ProblemOfSrvt(const std::string& text)
{
    return ProblemOfRange(text, 1U, kMostSrvtMs);
}

std::string ProblemOfDetection(const std::string& text)
{
    return text == "early" || text == "late" ? "" : cia306::Quoted(text) + ", expected early or late";
}

std::string ProblemOfRelease(const std::string& text)
{
    return text == "interlock" || text == "automatic" ? "" : cia306::Quoted(text) + ", expected interlock or automatic";
}

/// A number that was checked before.
std::uint64_t NumberOf(const std::string& text)
{
    return cia306::ParseTyped(text, kMostSctMs).value();
}
} // namespace

std::string ProblemOfRange(const std::string& text, const std::uint32_t lowest, const std::uint32_t highest)
{
    const auto number = cia306::ParseTyped(text, highest);
    const bool is_right = number && *number >= lowest;
    return is_right ? ""
                    : cia306::Quoted(text) + ", expected a number from " + std::to_string(lowest) + " to " +
                          std::to_string(highest);
}

std::string ProblemOfMapping(const std::string& text)
{
    const cia306::Problem problem = cia306::ParseMapping(text).problem;
    return problem.wrong.empty() ? "" : problem.wrong + ", expected " + problem.expected;
}

void SrdoOptions::Describe(Options& options)
{
    options.Add("--refresh", &refresh, "Refresh time of what is sent [ms] (default: 25)")
        .Type("MS")
        .Check(ProblemOfSct);
    options.Add("--sct", &sct, "SCT of what is received [ms] (default: 50)").Type("MS").Check(ProblemOfSct);
    options.Add("--srvt", &srvt, "SRVT [ms] (default: 20)").Type("MS").Check(ProblemOfSrvt);
    options.Add("--detection", &detection, "SRVT detection of what is received: early (default) or late")
        .Type("WORD")
        .Words({"early", "late"})
        .Check(ProblemOfDetection);
    options.Add("--release", &release, "Release of what is received: interlock (default) or automatic")
        .Type("WORD")
        .Words({"interlock", "automatic"})
        .Check(ProblemOfRelease);
}

void SrdoOptions::Complete(Questions& questions, const bool has_producer, const bool has_consumer)
{
    const bool is_receiving_told = !sct.empty() || !detection.empty() || !release.empty();
    if (!has_producer && !refresh.empty())
    {
        throw std::runtime_error("--refresh fits no SRDO that is received, expected --sct");
    }
    if (!has_consumer && is_receiving_told)
    {
        throw std::runtime_error("--sct, --detection and --release fit no SRDO that is sent, expected --refresh");
    }
    if (has_producer)
    {
        questions.Complete(refresh, {"--refresh", "Refresh time of what it sends [ms]", kRefreshMs, ProblemOfSct});
    }
    if (has_consumer)
    {
        questions.Complete(sct, {"--sct", "SCT of what it receives [ms]", kSctMs, ProblemOfSct});
    }
    questions.Complete(srvt, {"--srvt", "SRVT [ms]", kSrvtMs, ProblemOfSrvt});
    if (has_consumer)
    {
        questions.Complete(detection, {"--detection", "SRVT detection, early or late", "early", ProblemOfDetection});
        questions.Complete(release, {"--release", "Release, interlock or automatic", "interlock", ProblemOfRelease});
    }
}

std::optional<std::uint32_t> CobIdOf(const cia306::MappingText& mapping, const std::uint8_t number,
                                     const bool is_producer, const std::optional<std::uint8_t> node_id)
{
    return mapping.cob_id ? mapping.cob_id : cia306::DefaultCobId(number, is_producer, node_id.value_or(0U));
}

cia306::SrdoPlan SrdoOptions::PlanOf(const std::uint8_t number, const bool is_producer, const std::string& mapping,
                                     const std::optional<std::uint8_t> node_id) const
{
    const cia306::MappingText text = cia306::ParseMapping(mapping);
    const auto cob_id = CobIdOf(text, number, is_producer, node_id);
    if (!cob_id)
    {
        throw std::runtime_error((is_producer ? "--produce " : "--consume ") + cia306::Quoted(mapping) + ": SRDO " +
                                 std::to_string(number) + " has no default COB-ID, expected one behind @, such as " +
                                 mapping + "@0x109 or " + mapping + "@node5");
    }
    cia306::SrdoPlan plan;
    plan.number = number;
    plan.is_producer = is_producer;
    plan.sct_ms = static_cast<std::uint16_t>(NumberOf(is_producer ? refresh : sct));
    plan.srvt_ms = static_cast<std::uint8_t>(NumberOf(srvt));
    plan.cob_id = *cob_id;
    plan.is_late = !is_producer && detection == "late";
    plan.is_automatic = !is_producer && release == "automatic";
    plan.pairs = text.pairs;
    return plan;
}
} // namespace counterpoint::tools
