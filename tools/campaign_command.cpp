// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tools/campaign/order.hpp"
#include "tools/command_line/options.hpp"
#include "tools/command_table.hpp"

#include <cerrno>
#include <filesystem>
#include <ostream>
#include <string>
#include <system_error>
#include <unistd.h>
#include <vector>

namespace counterpoint::tools
{
namespace
{
constexpr const char* kProgram = "counterpoint_campaign";

/// `counterpoint campaign`: hands its command line to the program beside this one. [SRS_CMG_013, SRS_CMG_120]
class CampaignCommand final : public Command
{
  public:
    void Describe(Options& options) override
    {
        DescribeCampaign(options, order_);
    }

    [[nodiscard]] ExitStatus Run(const Streams& streams) override
    {
        std::error_code error;
        const std::filesystem::path own = std::filesystem::read_symlink("/proc/self/exe", error);
        const std::string program = (own.parent_path() / kProgram).string();
        std::vector<std::string> arguments = ArgumentsOf(order_);
        arguments.insert(arguments.begin(), {program, "campaign"});
        std::vector<char*> pointers;
        for (std::string& argument : arguments)
        {
            pointers.push_back(argument.data());
        }
        pointers.push_back(nullptr);
        streams.out.flush();
        streams.err.flush();
        execv(program.c_str(), pointers.data());
        streams.err << "counterpoint campaign: no program " << program << " (" << std::generic_category().message(errno)
                    << "), expected it beside this one, as a build of this tree has it\n";
        return ExitStatus::kBadInput;
    }

  private:
    CampaignOrder order_;
};
} // namespace

std::unique_ptr<Command> MakeCampaignCommand()
{
    return std::make_unique<CampaignCommand>();
}
} // namespace counterpoint::tools
