// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef RUNTIME_DEVICE_OBJECTS_HOOKS_HPP
#define RUNTIME_DEVICE_OBJECTS_HOOKS_HPP

#include "canopen/cia301/dictionary/entry.hpp"
#include "canopen/cia301/dictionary/foreign_objects.hpp"

namespace counterpoint::runtime
{
/// Hook of values that cannot change while the device runs: writing the same value is accepted, any other value is
/// refused.
class FixedHook final : public cia301::WriteHook
{
  public:
    /// @brief `table` outlives the hook.
    explicit FixedHook(const cia301::EntryTable& table) noexcept : table_(table)
    {
    }
    [[nodiscard]] cia301::SdoAbort OnWrite(const ObjectAddress& address, const cia301::Bytes& value) noexcept override;

  private:
    const cia301::EntryTable& table_;
};

/// The foreign objects of a plain device: there are none. [SRS_NODE_016]
class NoSafetyObjects final : public cia301::ForeignObjects
{
  public:
    [[nodiscard]] ObjectReading Read(const ObjectAddress& address) noexcept override;
    [[nodiscard]] AbortCode Write(const ObjectAddress& address, const ObjectData& data) noexcept override;
};

/// Hook of 1010h and 1011h of a device without a store: sub-indices say that nothing is saved, and commands are
/// refused.
class NoStoreHook final : public cia301::ReadHook, public cia301::WriteHook
{
  public:
    [[nodiscard]] cia301::Reading OnRead(const ObjectAddress& address, const cia301::Room& room) noexcept override;
    [[nodiscard]] cia301::SdoAbort OnWrite(const ObjectAddress& address, const cia301::Bytes& value) noexcept override;
};
} // namespace counterpoint::runtime

#endif // RUNTIME_DEVICE_OBJECTS_HOOKS_HPP
