// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_API_OUTPUT_CUTOFF_HPP
#define HAL_API_OUTPUT_CUTOFF_HPP

namespace counterpoint::hal
{

/// The way to the safe output that an exception takes: callable at any moment, from any state, and needing nothing that
/// the exception may have destroyed. [SRS_STS_051]
class OutputCutoff
{
  public:
    /// @brief Closes every output; nothing but a restart opens one again.
    virtual void CutOff() noexcept = 0;

    OutputCutoff(const OutputCutoff&) = delete;
    OutputCutoff(OutputCutoff&&) = delete;
    OutputCutoff& operator=(const OutputCutoff&) = delete;
    OutputCutoff& operator=(OutputCutoff&&) = delete;

  protected:
    OutputCutoff() noexcept = default;
    ~OutputCutoff() noexcept = default;
};

} // namespace counterpoint::hal

#endif
