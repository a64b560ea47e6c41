// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TOOLS_SRDO_OPTIONS_HPP
#define TOOLS_SRDO_OPTIONS_HPP

#include "canopen/cia306/edit/mapping_text.hpp"
#include "canopen/cia306/edit/srdo_plan.hpp"
#include "tools/command_line/options.hpp"
#include "tools/questions.hpp"

#include <cstdint>
#include <optional>
#include <string>

namespace counterpoint::tools
{
/// Says what is wrong with a number of an option: outside the range, or with a leading 0. [SRS_CLI_020]
[[nodiscard]] std::string ProblemOfRange(const std::string& text, std::uint32_t lowest, std::uint32_t highest);
/// Says what is wrong with the mapping of an SRDO. [SRS_NEW_003]
[[nodiscard]] std::string ProblemOfMapping(const std::string& text);

/// What the options say of SRDOs besides their mapping; a text that is empty was not given.
struct SrdoOptions
{
    std::string refresh;
    std::string sct;
    std::string srvt;
    std::string detection;
    std::string release;

    /// Adds them to a command.
    void Describe(Options& options);
    /// Asks for what was not given and is needed. Throws std::runtime_error for an option that fits none of the SRDOs.
    void Complete(Questions& questions, bool has_producer, bool has_consumer);
    /// The SRDO with this mapping; Complete was called. Throws std::runtime_error, which names the
    /// option, where it has no COB-ID.
    [[nodiscard]] cia306::SrdoPlan PlanOf(std::uint8_t number, bool is_producer, const std::string& mapping,
                                          std::optional<std::uint8_t> node_id) const;
};

/// Whether an SRDO with this mapping has a COB-ID: its own, or that of the pre-defined connection set.
[[nodiscard]] std::optional<std::uint32_t> CobIdOf(const cia306::MappingText& mapping, std::uint8_t number,
                                                   bool is_producer, std::optional<std::uint8_t> node_id);
} // namespace counterpoint::tools

#endif // TOOLS_SRDO_OPTIONS_HPP
