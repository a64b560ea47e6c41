// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/campaign/commands.hpp"

#include "verification/campaign/variants.hpp"

#include <algorithm>

namespace counterpoint::campaign
{
namespace
{
void Hand(const Command& command, Kernel& kernel)
{
    if (command.is_gfc)
    {
        static_cast<void>(kernel.SendGfc()); // Refused is refused.
    }
    else
    {
        kernel.SetNmtState(command.nmt);
    }
}
} // namespace

void Commands::Rewind(const std::size_t cycle, const Experiment* const fault)
{
    const auto next =
        std::lower_bound(recording_.commands.begin(), recording_.commands.end(), cycle,
                         [](const RecordedCommand& each, const std::size_t wanted) { return each.cycle < wanted; });
    next_ = static_cast<std::size_t>(next - recording_.commands.begin());
    fault_ = (fault != nullptr && fault->part == Part::kCommands) ? fault : nullptr;
    has_extra_ = fault_ != nullptr && fault_->kind != FaultKind::kSkipped && fault_->kind != FaultKind::kWrongCommand;
}

void Commands::TellUntil(const std::size_t cycle, Kernel& kernel)
{
    for (; next_ < recording_.commands.size() && recording_.commands[next_].cycle <= cycle; ++next_)
    {
        Tell(next_, kernel);
    }
    if (has_extra_ && cycle >= ExtraCycle())
    {
        has_extra_ = false;
        Hand((fault_->kind == FaultKind::kInserted) ? CommandNumber(fault_->variant)
                                                    : recording_.commands[fault_->subject].what,
             kernel);
    }
}

void Commands::Tell(const std::size_t command, Kernel& kernel)
{
    const Command& what = recording_.commands[command].what;
    const bool is_hit = fault_ != nullptr && fault_->kind != FaultKind::kInserted && fault_->subject == command;
    if (!is_hit || fault_->kind == FaultKind::kDoubled)
    {
        Hand(what, kernel);
    }
    else if (fault_->kind == FaultKind::kWrongCommand)
    {
        Hand(WrongCommand(what, fault_->variant), kernel);
    }
    else
    {
        // It comes later, or never.
    }
}

/// In which the fault tells its command: again from the same cycle on, late from the next one on.
std::size_t Commands::ExtraCycle() const noexcept
{
    if (fault_->kind == FaultKind::kInserted)
    {
        return fault_->cycle;
    }
    return fault_->cycle + fault_->variant + ((fault_->kind == FaultKind::kLate) ? 1U : 0U);
}

bool Commands::IsOver(const std::size_t cycle) const noexcept
{
    return fault_ == nullptr || (!has_extra_ && cycle >= fault_->cycle);
}
} // namespace counterpoint::campaign
