// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TOOLS_COMMAND_LINE_END_SIGNALS_HPP
#define TOOLS_COMMAND_LINE_END_SIGNALS_HPP

namespace counterpoint::tools
{
/// From here on a SIGTERM that EndSignals catches leaves the program two seconds to be read: then it ends with
/// ExitStatus::kBadInput, whatever it waits for. For a program as a whole, whose last output is written when its
/// command is over. [SRS_MON_001, SRS_LIVE_056]
void LimitWaitForReader();

/// While it lives, SIGINT and SIGTERM ask a command to end, and do not end the process. One object at a time.
class EndSignals
{
  public:
    EndSignals();
    ~EndSignals();
    EndSignals(const EndSignals&) = delete;
    EndSignals& operator=(const EndSignals&) = delete;

    [[nodiscard]] bool IsAsked() const noexcept;

  private:
    using Handler = void (*)(int);
    Handler before_int_;
    Handler before_term_;
};
} // namespace counterpoint::tools

#endif // TOOLS_COMMAND_LINE_END_SIGNALS_HPP
