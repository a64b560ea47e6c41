// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef RUNTIME_DEVICE_OBJECTS_HOOKS_HPP
#define RUNTIME_DEVICE_OBJECTS_HOOKS_HPP

#include "canopen/cia301/dictionary/entry.hpp"
#include "canopen/cia301/dictionary/foreign_objects.hpp"

namespace counterpoint::runtime
{
/// Of a value that cannot change while the device runs: a write of the same value is accepted, any other refused.
class FixedHook final : public cia301::WriteHook
{
  public:
    explicit FixedHook(const cia301::EntryTable& table) noexcept : table_(table)
    {
    }
    [[nodiscard]] cia301::SdoAbort OnWrite(const ObjectAddress& address, const cia301::Bytes& value) noexcept override;

  private:
    const cia301::EntryTable& table_;
};

/// A plain device has no objects but its own. [SRS_NODE_016]
class NoSafetyObjects final : public cia301::ForeignObjects
{
  public:
    [[nodiscard]] ObjectReading Read(const ObjectAddress& address) noexcept override;
    [[nodiscard]] AbortCode Write(const ObjectAddress& address, const ObjectData& data) noexcept override;
};

/// 1010h and 1011h of a device without a store: sub-indices tell that nothing is saved, commands are refused.
class NoStoreHook final : public cia301::ReadHook, public cia301::WriteHook
{
  public:
    [[nodiscard]] cia301::Reading OnRead(const ObjectAddress& address, const cia301::Room& room) noexcept override;
    [[nodiscard]] cia301::SdoAbort OnWrite(const ObjectAddress& address, const cia301::Bytes& value) noexcept override;
};
} // namespace counterpoint::runtime

#endif // RUNTIME_DEVICE_OBJECTS_HOOKS_HPP
