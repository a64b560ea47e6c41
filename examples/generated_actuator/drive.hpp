// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef EXAMPLES_GENERATED_ACTUATOR_DRIVE_HPP
#define EXAMPLES_GENERATED_ACTUATOR_DRIVE_HPP

#include "canopen/cia301/dictionary/entry.hpp"
#include "canopen/cia301/nmt/heartbeat_producer.hpp"
#include "examples/common/settings.hpp"

namespace counterpoint::examples
{

/// The drive of examples/actuator. Whatever stands in its DCF comes from generated code.
class Drive final : public QuietApplication
{
  public:
    /// @brief After each cycle: whether the drive may move. `open` is what the gate lets through.
    [[nodiscard]] static bool MayMove(SrdoMask open) noexcept;
};

/// Takes what is written to 1017h to the service that sends heartbeats.
class HeartbeatTime final : public cia301::WriteHook
{
  public:
    explicit HeartbeatTime(cia301::HeartbeatProducer& producer) noexcept : producer_(producer)
    {
    }
    [[nodiscard]] cia301::SdoAbort OnWrite(const ObjectAddress& address, const cia301::Bytes& value) noexcept override;

  private:
    cia301::HeartbeatProducer& producer_;
};

} // namespace counterpoint::examples

#endif
