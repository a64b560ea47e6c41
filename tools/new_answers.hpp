// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TOOLS_NEW_ANSWERS_HPP
#define TOOLS_NEW_ANSWERS_HPP

#include "canopen/cia306/edit/new_device.hpp"
#include "tools/command_line/options.hpp"
#include "tools/questions.hpp"
#include "tools/srdo_options.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace counterpoint::tools
{
/// What a person says of a new device, by options or by answers; a text that is empty was not said.
class NewAnswers
{
  public:
    /// Adds the options.
    void Describe(Options& options);
    /// Asks for what the options did not say. Throws std::runtime_error, which names the option, where something is
    /// missing or does not fit. [SRS_NEW_002]
    void Complete(Questions& questions);
    /// The device; everything was said.
    [[nodiscard]] cia306::DevicePlan Plan() const;

  private:
    void CompleteRole(Questions& questions);
    void CompleteMappings(Questions& questions, const char* option, std::vector<std::string>& mappings);
    void CompleteCobIds(Questions& questions);
    [[nodiscard]] std::uint8_t NodeId() const;

    std::string role_;
    std::string node_id_;
    std::string name_;
    std::vector<std::string> produced_;
    std::vector<std::string> consumed_;
    SrdoOptions srdos_;
    std::string gfc_;
    std::string bit_rate_;
    std::string vendor_name_;
    std::string vendor_id_;
    std::string product_code_;
};
} // namespace counterpoint::tools

#endif // TOOLS_NEW_ANSWERS_HPP
