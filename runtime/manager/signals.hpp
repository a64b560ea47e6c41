// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef RUNTIME_MANAGER_SIGNALS_HPP
#define RUNTIME_MANAGER_SIGNALS_HPP

namespace counterpoint::runtime
{
/// While it lives, SIGINT, SIGTERM and SIGHUP do not end the process by themselves (SIGHUP only where nohup does not
/// ignore it). SIGPIPE is ignored for good: the reader of the output may end, and the network goes on. One object at a
/// time. [SRS_MGR_004]
class CaughtSignals
{
  public:
    CaughtSignals();
    ~CaughtSignals();
    CaughtSignals(const CaughtSignals&) = delete;
    CaughtSignals& operator=(const CaughtSignals&) = delete;

    /// @brief Whether one of these signals came since the construction.
    [[nodiscard]] static bool IsCaught() noexcept;

  private:
    using Handler = void (*)(int);

    Handler before_int_;
    Handler before_term_;
    Handler before_hup_;
};
} // namespace counterpoint::runtime

#endif // RUNTIME_MANAGER_SIGNALS_HPP
