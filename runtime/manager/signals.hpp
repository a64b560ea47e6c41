// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef RUNTIME_MANAGER_SIGNALS_HPP
#define RUNTIME_MANAGER_SIGNALS_HPP

namespace counterpoint::runtime
{
/// As long as it lives SIGINT, SIGTERM and, where nohup does not ignore it, SIGHUP of a terminal that is gone end
/// nothing by themselves. SIGPIPE is ignored for good: who reads the output may go, the network stays. One at a time.
/// [SRS_MGR_004]
class CaughtSignals
{
  public:
    CaughtSignals();
    ~CaughtSignals();
    CaughtSignals(const CaughtSignals&) = delete;
    CaughtSignals& operator=(const CaughtSignals&) = delete;

    /// @brief Whether one of them came since.
    [[nodiscard]] static bool IsCaught() noexcept;

  private:
    using Handler = void (*)(int);

    Handler before_int_;
    Handler before_term_;
    Handler before_hup_;
};
} // namespace counterpoint::runtime

#endif // RUNTIME_MANAGER_SIGNALS_HPP
