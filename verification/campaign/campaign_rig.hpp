// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_CAMPAIGN_CAMPAIGN_RIG_HPP
#define VERIFICATION_CAMPAIGN_CAMPAIGN_RIG_HPP

#include "tests/tools/command_run.hpp"
#include "verification/campaign/command.hpp"
#include "verification/campaign/session.hpp"
#include "verification/campaign/trap.hpp"
#include "verification/trace/ids/campaign.hpp"
#include "verification/trace/verifies.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace counterpoint::campaign::test
{
/// Behind which a step's faults stand.
inline Phase PhaseOf(const FlowStep step)
{
    return static_cast<Phase>(static_cast<std::uint8_t>(Phase::kFirstStep) + static_cast<std::uint8_t>(step) - 1U);
}

/// What a CSV file of these results has in it.
inline std::string CsvText(const campaign::Campaign& campaign, const Results& results)
{
    std::string text;
    CsvReport(campaign, results, [&text](const std::string_view piece) { text += piece; });
    return text;
}

/// What a JSON file of them has in it.
inline std::string JsonText(const campaign::Campaign& campaign, const Summary& summary)
{
    std::string text;
    JsonReport(campaign, summary, [&text](const std::string_view piece) { text += piece; });
    return text;
}

/// Plans in a folder of their own, on the scenario of the examples.
class CampaignTest : public tools::test::CommandTest
{
  protected:
    /// A plan for a device, with more lines.
    [[nodiscard]] std::string PlanFile(const std::string& name, const std::string& device,
                                       const std::string& more) const
    {
        return File(name, "title: A test\nscenario: " COUNTERPOINT_SOURCE_FOLDER
                          "/examples/campaigns/at_work.yaml\ndevice: " +
                              device + "\n" + more);
    }
    /// Runs `counterpoint campaign` in this process.
    [[nodiscard]] static tools::test::Answer Campaign(std::vector<std::string> arguments)
    {
        arguments.insert(arguments.begin(), "campaign");
        std::ostringstream out;
        std::ostringstream err;
        const tools::ExitStatus status =
            tools::RunCommandLine(arguments, {{"campaign", "A test", &MakeCampaign}}, {out, err});
        return {static_cast<int>(status), out.str(), err.str()};
    }
    /// A fault in the member of this name.
    [[nodiscard]] static Experiment FaultIn(const Session& session, const std::string& member, const std::size_t byte,
                                            const std::uint8_t bit)
    {
        const std::vector<Place>& places = session.Parts().device.Places();
        for (std::size_t index = 0U; index < places.size(); ++index)
        {
            if (places[index].name == member)
            {
                return {places[index].part, FaultKind::kFlip, index, places[index].offset + byte, bit, 499U,
                        Phase::kAfterFrames};
            }
        }
        ADD_FAILURE() << "no member " << member;
        return {};
    }
};
} // namespace counterpoint::campaign::test

#endif // VERIFICATION_CAMPAIGN_CAMPAIGN_RIG_HPP
