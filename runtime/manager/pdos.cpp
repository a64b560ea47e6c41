// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "runtime/manager/pdos.hpp"

#include "canopen/cia306/safety/signature.hpp"
#include "canopen/cia306/text/number.hpp"

#include <algorithm>

namespace counterpoint::runtime
{
namespace
{
using cia302::El6751Pdo;
using network_plan::StartProfile;

constexpr std::uint32_t kIdentifierMask = 0x7FFU;
constexpr std::uint64_t kTellUs = 100000U; ///< Least time between two events of one PDO.
} // namespace

ManagerPdos::ManagerPdos(network_plan::LoadedNetwork& net) : net_(net)
{
    for (const auto& slave : net.Slaves())
    {
        for (const El6751Pdo& pdo : slave->profile.tx_pdos)
        {
            Input input;
            input.value.node = slave->plan.node;
            input.value.number = pdo.number;
            input.value.bytes.resize(pdo.length_bytes);
            by_identifier_.emplace(pdo.cob_id & kIdentifierMask, inputs_.size());
            inputs_.push_back(input);
        }
    }
}

std::string ManagerPdos::Set(const std::uint8_t node, const std::uint16_t number,
                             const std::vector<std::uint8_t>& bytes)
{
    network_plan::LoadedSlave* const slave = net_.Find(node);
    const std::string name = "RxPDO " + std::to_string(number) + " of node " + std::to_string(node);
    if (slave == nullptr || net_.Plan().manager.profile != StartProfile::kEl6751)
    {
        return name + ", expected a slave of a network with the profile el6751";
    }
    const auto& pdos = slave->profile.rx_pdos;
    const auto found =
        std::find_if(pdos.begin(), pdos.end(), [number](const El6751Pdo& pdo) { return pdo.number == number; });
    if (found == pdos.end())
    {
        return "no " + name + ", expected one that its DCF switches on and maps";
    }
    if (bytes.size() != found->length_bytes)
    {
        return name + " with " + std::to_string(bytes.size()) + " bytes, expected " +
               std::to_string(found->length_bytes);
    }
    auto& output = slave->profile.outputs.at(static_cast<std::size_t>(found - pdos.begin()));
    std::copy(bytes.begin(), bytes.end(), output.begin());
    return "taken";
}

void ManagerPdos::OnFrame(const CanFrame& frame, const std::uint64_t now_us)
{
    if (frame.kind != FrameKind::kData)
    {
        return;
    }
    const auto [first, last] = by_identifier_.equal_range(frame.identifier);
    for (auto place = first; place != last; ++place)
    {
        Input& input = inputs_[place->second];
        std::vector<std::uint8_t>& bytes = input.value.bytes;
        if (frame.length_bytes < bytes.size())
        {
            continue; // NodeState 20, and no value.
        }
        const bool is_new = !input.value.was_seen || !std::equal(bytes.begin(), bytes.end(), &frame.data[0]);
        std::copy_n(&frame.data[0], bytes.size(), bytes.begin());
        input.value.was_seen = true;
        input.value.at_us = now_us;
        if (is_new && !input.is_news)
        {
            input.is_news = true;
            news_.push_back(place->second);
        }
    }
}

std::vector<const PdoValue*> ManagerPdos::TakeNews(const std::uint64_t now_us)
{
    std::vector<const PdoValue*> told;
    std::vector<std::size_t> later;
    for (const std::size_t place : news_)
    {
        Input& input = inputs_[place];
        const bool is_due = !input.was_told || now_us - input.told_us >= kTellUs;
        if (is_due)
        {
            input.is_news = false;
            input.was_told = true;
            input.told_us = now_us;
            told.push_back(&input.value);
        }
        else
        {
            later.push_back(place);
        }
    }
    news_ = later;
    return told;
}

std::vector<PdoValue> ManagerPdos::Values() const
{
    std::vector<PdoValue> values;
    for (const auto& slave : net_.Slaves())
    {
        const network_plan::ProfileSlave& profile = slave->profile;
        for (std::size_t place = 0U; place < profile.rx_pdos.size(); ++place)
        {
            const El6751Pdo& pdo = profile.rx_pdos[place];
            const auto& bytes = profile.outputs[place];
            values.push_back(
                {slave->plan.node, true, pdo.number, {bytes.begin(), bytes.begin() + pdo.length_bytes}, true, 0U});
        }
    }
    for (const Input& input : inputs_)
    {
        values.push_back(input.value);
    }
    std::stable_sort(values.begin(), values.end(),
                     [](const PdoValue& left, const PdoValue& right) { return left.node < right.node; });
    return values;
}

std::optional<std::vector<std::uint8_t>> BytesFrom(const std::string& text)
{
    std::vector<std::uint8_t> bytes;
    for (std::size_t place = 0U; place < text.size(); place += 2U)
    {
        place = text.find_first_not_of(' ', place);
        const auto byte = (place == std::string::npos || place + 1U >= text.size())
                              ? std::nullopt
                              : cia306::ParseUnsigned("0x" + text.substr(place, 2U), 0xFFU);
        if (!byte) // Nor with a space for its second digit.
        {
            return std::nullopt;
        }
        bytes.push_back(static_cast<std::uint8_t>(*byte));
    }
    const bool is_some = !bytes.empty() && bytes.size() <= kMaxPayloadBytes;
    return is_some ? std::optional(bytes) : std::nullopt;
}

std::string BytesText(const std::vector<std::uint8_t>& bytes)
{
    return cia306::HexBytes(bytes);
}

std::string NameOf(const PdoValue& value)
{
    return (value.is_output ? "RxPDO " : "TxPDO ") + std::to_string(value.number);
}
} // namespace counterpoint::runtime
