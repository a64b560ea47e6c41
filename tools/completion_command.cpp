// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tools/command_line/completion.hpp"
#include "tools/command_line/options.hpp"
#include "tools/command_table.hpp"

#include <ostream>
#include <string>

namespace counterpoint::tools
{
namespace
{
class CompletionCommand final : public Command
{
  public:
    void Describe(Options& options) override
    {
        options.Add("SHELL", &shell_, "The shell to print the script for").Required().Type("").Words(CompletedShells());
        options.Footer("bash: source <(counterpoint completion bash)\n"
                       "zsh:  source <(counterpoint completion zsh), behind compinit\n"
                       "fish: counterpoint completion fish | source\n"
                       "The installed package has all three where these shells look for them.");
    }

    [[nodiscard]] ExitStatus Run(const Streams& streams) override
    {
        streams.out << CompletionScript(shell_, CommandTable());
        return ExitStatus::kHolds;
    }

  private:
    std::string shell_;
};
} // namespace

std::unique_ptr<Command> MakeCompletionCommand()
{
    return std::make_unique<CompletionCommand>();
}
} // namespace counterpoint::tools
