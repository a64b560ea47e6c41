// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef RUNTIME_MANAGER_OBJECTS_HPP
#define RUNTIME_MANAGER_OBJECTS_HPP

#include "canopen/cia302/network/objects.hpp"
#include "runtime/manager/assembly.hpp"
#include "runtime/manager/consumers.hpp"

namespace counterpoint::runtime
{
/// The objects by which a manager is seen and commanded, and what may be written while it runs. Hook of 1016h, 1017h,
/// 102Ah, 1F20h to 1F27h, 1F53h to 1F58h and 1F80h to 1F90h. [SRS_MGR_021, SRS_MGR_213,
/// SRS_MGR_214, SRS_MGR_215, SRS_MGR_216, SRS_MGR_217, SRS_MGR_218, SRS_MGR_219, SRS_MGR_220]
class ManagerObjects final : public cia301::ReadHook, public cia301::WriteHook
{
  public:
    /// @brief Both outlive it.
    ManagerObjects(ManagerAssembly& assembly, network_plan::LoadedNetwork& net);

    /// @brief Sets the time for what writes lead to.
    void SetNow(Instant now) noexcept;

    [[nodiscard]] cia301::Reading OnRead(const ObjectAddress& address, const cia301::Room& room) noexcept override;
    [[nodiscard]] cia301::SdoAbort OnWrite(const ObjectAddress& address, const cia301::Bytes& value) noexcept override;
    [[nodiscard]] cia301::SdoAbort OnWriteAgain(const ObjectAddress& address,
                                                const cia301::Bytes& value) noexcept override;

  private:
    [[nodiscard]] cia301::Reading ReadDomain(const ObjectAddress& address, const cia301::Room& room) noexcept;
    [[nodiscard]] cia301::SdoAbort MayWrite(const ObjectAddress& address, std::uint32_t value) const noexcept;
    [[nodiscard]] bool IsDoubtedStart(std::uint8_t sub, std::uint32_t value) const noexcept;
    [[nodiscard]] cia301::SdoAbort MayChange(cia302::NodeId node) const noexcept;
    [[nodiscard]] cia301::SdoAbort StoreAssignment(const ObjectAddress& address, const cia301::Bytes& value) noexcept;
    [[nodiscard]] cia301::SdoAbort Store(const ObjectAddress& address, const cia301::Bytes& value) noexcept;

    ManagerAssembly& assembly_;
    network_plan::LoadedNetwork& net_;
    cia302::NetworkObjects objects_;
    cia302::NetworkDomains domains_;
    cia302::FlyingMasterObject flying_;
    ManagerConsumers consumers_;
    Instant now_{0U};
};
} // namespace counterpoint::runtime

#endif // RUNTIME_MANAGER_OBJECTS_HPP
