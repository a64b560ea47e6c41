// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tools/command_line/man_page.hpp"
#include "tools/command_line/options.hpp"
#include "tools/command_table.hpp"

#include <ostream>

namespace counterpoint::tools
{
namespace
{
class ManCommand final : public Command
{
  public:
    void Describe(Options& options) override
    {
        options.Footer("To read it: counterpoint man | man -l -");
    }

    [[nodiscard]] ExitStatus Run(const Streams& streams) override
    {
        streams.out << ManPage(CommandTable());
        return ExitStatus::kHolds;
    }
};
} // namespace

std::unique_ptr<Command> MakeManCommand()
{
    return std::make_unique<ManCommand>();
}
} // namespace counterpoint::tools
