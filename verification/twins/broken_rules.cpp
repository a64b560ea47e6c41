// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// The requirement mutants. A new one is a line here: its requirement, how it is broken, and what does that.
#include "verification/twins/broken.hpp"

#include <tuple>
#include <utility>

namespace counterpoint::twins
{
namespace
{

class Book
{
  public:
    /// @brief A rule whose `member` is `hook`.
    template <typename Hook, typename Made>
    void Add(const char* requirement, const std::string& how, Hook Rule::* member, Made hook)
    {
        Rule rule;
        rule.requirement = requirement;
        rule.how = how;
        rule.*member = Hook{hook};
        rules.push_back(rule);
    }
    /// @brief What is told is none of it.
    template <typename T>
    void Silent(const char* requirement, const std::string& what, std::function<void(T&)> Rule::* member)
    {
        Add(requirement, what + " is all 0", member, [](T& value) { value = T{}; });
    }
    /// @brief One field of what is told, or of an argument, is always 0, or one more, or one less.
    template <typename T, typename F, typename Result>
    void Field(const char* requirement, const std::string& what, std::function<Result(T&)> Rule::* member, F T::* field)
    {
        for (const std::uint32_t kind : {0U, 1U, 2U})
        {
            static const char* const kHow[] = {" is always 0", " is one more", " is one less"};
            Add(requirement, what + kHow[kind], member,
                [field, kind](T& value)
                {
                    const auto was = static_cast<std::uint64_t>(value.*field);
                    value.*field = static_cast<F>((kind == 0U) ? 0U : ((kind == 1U) ? (was + 1U) : (was - 1U)));
                    return true;
                });
        }
    }
    /// @brief One field has always this value.
    template <typename T, typename F, typename Result>
    void Always(const char* requirement, const std::string& how, std::function<Result(T&)> Rule::* member, F T::* field,
                F constant)
    {
        Add(requirement, how, member,
            [field, constant](T& value)
            {
                value.*field = constant;
                return true;
            });
    }

    std::vector<Rule> rules{};
};

void AddMask(Book& book, const char* requirement, const std::string& what, SrdoMask CycleOutcome::* field)
{
    book.Always(requirement, what + " is always 0", &Rule::outcome, field, SrdoMask{0U});
    book.Always(requirement, what + " is always full", &Rule::outcome, field, ~SrdoMask{0U});
    book.Add(requirement, what + " is inverted", &Rule::outcome,
             [field](CycleOutcome& outcome) { outcome.*field = ~(outcome.*field); });
    book.Add(requirement, what + " is one slot further", &Rule::outcome,
             [field](CycleOutcome& outcome) { outcome.*field <<= 1U; });
}

void AddMasks(Book& book)
{
    static const std::pair<const char*, SrdoMask CycleOutcome::*> kMasks[] = {
        {"released", &CycleOutcome::released},  {"faulted", &CycleOutcome::faulted},
        {"waiting", &CycleOutcome::waiting},    {"new_fault", &CycleOutcome::new_fault},
        {"fresh", &CycleOutcome::fresh},        {"due", &CycleOutcome::due},
        {"signalled", &CycleOutcome::signalled}};
    for (const auto& [name, mask] : kMasks)
    {
        AddMask(book, "SRS_CONS_023", std::string{"mask "} + name, mask);
    }
    AddMask(book, "SRS_PROD_013", "mask refresh", &CycleOutcome::refresh);
    book.Add("SRS_PROD_013", "mask refresh is the mask due", &Rule::outcome,
             [](CycleOutcome& outcome) { outcome.refresh = outcome.due; });
}

void AddOutcomes(Book& book)
{
    book.Silent("SRS_CONS_023", "outcome", &Rule::outcome);
    book.Field("SRS_CONS_023", "number of the cycle", &Rule::outcome, &CycleOutcome::cycle);
    book.Field("SRS_CONS_023", "sum of the ordinals", &Rule::outcome, &CycleOutcome::ordinal_sum);
    book.Field("SRS_CONS_023", "sct_checked", &Rule::outcome, &CycleOutcome::sct_checked);
    book.Field("SRS_CONS_023", "is_tx", &Rule::outcome, &CycleOutcome::is_tx);
    book.Field("SRS_CONS_023", "is_invalid", &Rule::outcome, &CycleOutcome::is_invalid);
    book.Field("SRS_CONS_023", "not_operational", &Rule::outcome, &CycleOutcome::not_operational);
    for (const GuardView view :
         {GuardView::kInvalid, GuardView::kConfigured, GuardView::kUnconfigured, GuardView::kStale})
    {
        book.Always("SRS_CFG_031", "view of the guard is always " + std::to_string(static_cast<unsigned>(view)),
                    &Rule::outcome, &CycleOutcome::guard, view);
    }
}

void AddViews(Book& book)
{
    book.Silent("SRS_CONS_025", "view of a slot", &Rule::view);
    book.Field("SRS_CONS_025", "ordinal in the view", &Rule::view, &SrdoView::ordinal);
    book.Field("SRS_CONS_021", "signals in the view", &Rule::view, &SrdoView::signals);
    book.Field("SRS_CONS_012", "error count", &Rule::view, &SrdoView::error_count);
    book.Field("SRS_CONS_025", "holds_pair in the view", &Rule::view, &SrdoView::holds_pair);
    book.Always("SRS_CONS_025", "data in the view are 0", &Rule::view, &SrdoView::data, Payload{});
    for (const SrdoState state : {SrdoState::kInvalid, SrdoState::kOff, SrdoState::kWaiting, SrdoState::kFaulted,
                                  SrdoState::kProducer, SrdoState::kReleased})
    {
        book.Always("SRS_CONS_025", "state in the view is always " + std::to_string(static_cast<unsigned>(state)),
                    &Rule::view, &SrdoView::state, state);
    }
    book.Always("SRS_CONS_020", "first cause is none", &Rule::view, &SrdoView::first_cause, SrdoCause::kNone);
    book.Always("SRS_CONS_020", "first cause is invalid", &Rule::view, &SrdoView::first_cause, SrdoCause::kInvalid);
    book.Silent("SRS_CONS_025", "held pair", &Rule::held);
    book.Field("SRS_CONS_025", "ordinal of the held pair", &Rule::held, &HeldPair::ordinal);
    book.Field("SRS_CONS_025", "holds_pair of the held pair", &Rule::held, &HeldPair::holds_pair);
    book.Always("SRS_CONS_025", "held data are 0", &Rule::held, &HeldPair::data, Payload{});
    book.Silent("SRS_REL_010", "permit", &Rule::permit);
    book.Silent("SRS_REL_011", "slots not as they were written", &Rule::found);
    book.Add("SRS_REL_011", "no slot is as it was written", &Rule::found,
             [](SrdoMask& found) { found = ~SrdoMask{0U}; });
    book.Field("SRS_REL_010", "mask of the permit", &Rule::permit, &Permit::mask);
    book.Field("SRS_REL_010", "response of the permit", &Rule::permit, &Permit::response);
}

void AddChecks(Book& book)
{
    const std::pair<const char*, std::function<void(CheckResult&)> Rule::*> calls[] = {
        {"SRS_CFG_020", &Rule::validated}, {"SRS_CFG_030", &Rule::rechecked}};
    for (const auto& [requirement, member] : calls)
    {
        const std::string call = (member == &Rule::validated) ? "validation: " : "recheck: ";
        book.Silent(requirement, call + "result", member);
        book.Field(requirement, call + "signature", member, &CheckResult::signature);
        for (std::uint32_t fault = 0U; fault <= 10U; ++fault)
        {
            const ConfigFault told = (fault == 10U) ? ConfigFault::kNone : static_cast<ConfigFault>(fault);
            book.Always(requirement, call + "fault is always " + std::to_string(fault), member, &CheckResult::fault,
                        told);
            book.Add(requirement, call + "fault " + std::to_string(fault) + " is not told", member,
                     [told](CheckResult& result)
                     { result.fault = (result.fault == told) ? ConfigFault::kNone : result.fault; });
        }
    }
}

void AddDigests(Book& book)
{
    book.Silent("SRS_CFG_003", "loaded item", &Rule::load);
    book.Add("SRS_CFG_003", "loaded values are 0", &Rule::load, [](ConfigItem& item) { item.value = 0U; });
    book.Add("SRS_CFG_003", "nothing is stored", &Rule::store, [](ConfigItem&) { return false; });
    book.Add("SRS_CFG_032", "no fields are registered", &Rule::fields, [](StaticFields&) { return false; });
    book.Silent("SRS_CFG_034", "digest", &Rule::digest);
    book.Field("SRS_CFG_034", "digest", &Rule::digest, &DeviceDigest::value);
    book.Add("SRS_CFG_034", "digest is not complemented", &Rule::digest,
             [](DeviceDigest& digest) { digest.value = ~digest.value; });
    book.Field("SRS_CFG_034", "digest before", &Rule::before, &DeviceDigest::value);
    book.Add("SRS_CFG_034", "digest before is complemented", &Rule::before,
             [](DeviceDigest& digest) { digest.value = ~digest.value; });
}

void AddDigestParts(Book& book)
{
    for (std::uint32_t part = 0U; part < kDigestParts; ++part)
    {
        for (std::uint32_t broken = 0U; broken < kDigestBreaks; ++broken)
        {
            const DigestRule rule{part, broken};
            book.Add("SRS_CFG_034", DigestRuleText(rule), &Rule::whole_digest,
                     [rule](const DigestSource& source, DeviceDigest before)
                     { return BrokenDigest(rule, source, before); });
        }
    }
}

void AddStores(Book& book)
{
    for (std::uint32_t number = 1U; number <= 11U; ++number)
    {
        const auto field = static_cast<ConfigField>(number);
        const std::string what = "field " + std::to_string(number);
        book.Add("SRS_CFG_003", what + " loads as 0", &Rule::load,
                 [field](ConfigItem& item) { item.value = (item.address.field == field) ? 0U : item.value; });
        book.Add("SRS_CFG_003", what + " is not stored", &Rule::store,
                 [field](ConfigItem& item) { return item.address.field != field; });
        book.Add("SRS_CFG_003", what + " is stored as 0", &Rule::store,
                 [field](ConfigItem& item)
                 {
                     item.value = (item.address.field == field) ? 0U : item.value;
                     return true;
                 });
        book.Add("SRS_CFG_003", what + " is stored in slot 0", &Rule::store,
                 [field](ConfigItem& item)
                 {
                     item.address.slot = (item.address.field == field) ? SlotIndex{0U} : item.address.slot;
                     return true;
                 });
        for (const std::uint32_t bits : {8U, 16U, 24U})
        {
            book.Add("SRS_CFG_003", what + " has only " + std::to_string(bits) + " bits", &Rule::store,
                     [field, bits](ConfigItem& item)
                     {
                         item.value &= (item.address.field == field) ? ((1U << bits) - 1U) : 0xFFFFFFFFU;
                         return true;
                     });
        }
    }
}

using FrameHook = std::function<bool(CanFrame&, Instant&)>;
const std::pair<const char*, FrameHook Rule::*> kFrameCalls[] = {{"SRS_CONS_001", &Rule::frame},
                                                                 {"SRS_PROD_007", &Rule::confirmed}};

void AddFrames(Book& book)
{
    for (const auto& [requirement, member] : kFrameCalls)
    {
        const std::string call = (member == &Rule::frame) ? "frame: " : "confirmation: ";
        book.Add(requirement, call + "none is taken", member, [](CanFrame&, Instant&) { return false; });
        book.Add(requirement, call + "any kind is taken", member,
                 [](CanFrame& frame, Instant&)
                 {
                     frame.kind = FrameKind::kData;
                     return true;
                 });
        book.Add(requirement, call + "no GFC", member,
                 [](CanFrame& frame, Instant&) { return frame.identifier != kGfcIdentifier; });
        for (const std::uint32_t offset : {0xFFFFFFFFU, 1U})
        {
            const std::string how = (offset == 1U) ? " one more" : " one less";
            book.Add(requirement, call + "identifier" + how, member,
                     [offset](CanFrame& frame, Instant&)
                     {
                         frame.identifier += offset;
                         return true;
                     });
            book.Add(requirement, call + "length" + how, member,
                     [offset](CanFrame& frame, Instant&)
                     {
                         frame.length_bytes = static_cast<std::uint8_t>(frame.length_bytes + offset);
                         return true;
                     });
            book.Add(requirement, call + "stamp" + how, member,
                     [offset](CanFrame&, Instant& stamp)
                     {
                         stamp.us += offset;
                         return true;
                     });
        }
        book.Add(requirement, call + "stamp is 0", member,
                 [](CanFrame&, Instant& stamp)
                 {
                     stamp.us = 0U;
                     return true;
                 });
    }
}

void AddPayloads(Book& book)
{
    for (const auto& [requirement, member] : kFrameCalls)
    {
        const std::string call = (member == &Rule::frame) ? "frame: " : "confirmation: ";
        for (std::uint32_t kind = 0U; kind < 5U; ++kind)
        {
            book.Add(requirement, call + "identifiers of 11 bits only, kind " + std::to_string(kind) + " taken as data",
                     member,
                     [kind](CanFrame& frame, Instant&)
                     {
                         frame.kind = (frame.kind == static_cast<FrameKind>(kind)) ? FrameKind::kData : frame.kind;
                         return true;
                     });
        }
        for (std::uint32_t byte = 0U; byte < kMaxPayloadBytes; ++byte)
        {
            book.Add(requirement, call + "byte " + std::to_string(byte) + " is 0", member,
                     [byte](CanFrame& frame, Instant&)
                     {
                         frame.data[byte] = 0U;
                         return true;
                     });
        }
        book.Add(requirement, call + "bytes reversed", member,
                 [](CanFrame& frame, Instant&)
                 {
                     for (std::uint32_t i = 0U; i < 4U; ++i)
                     {
                         std::swap(frame.data[i], frame.data[7U - i]);
                     }
                     return true;
                 });
    }
}

void AddInputs(Book& book)
{
    for (const std::uint32_t offset : {0xFFFFFFFFU, 1U})
    {
        const std::string how = (offset == 1U) ? " is one later" : " is one earlier";
        book.Add("SRS_TIME_002", "now" + how, &Rule::input, [offset](CycleInput& input) { input.now.us += offset; });
        book.Add("SRS_CFG_031", "challenge" + how, &Rule::input,
                 [offset](CycleInput& input) { input.challenge += offset; });
        book.Add("SRS_CFG_031", "token" + how, &Rule::input,
                 [offset](CycleInput& input) { input.guard_token += offset; });
    }
    book.Add("SRS_TIME_002", "now is 0", &Rule::input, [](CycleInput& input) { input.now.us = 0U; });
    book.Always("SRS_CFG_031", "challenge is 0", &Rule::input, &CycleInput::challenge, 0U);
    book.Always("SRS_CFG_031", "token is 0", &Rule::input, &CycleInput::guard_token, 0U);
    const std::tuple<const char*, const char*, SrdoMask CycleInput::*> masks[] = {
        {"SRS_REL_005", "acknowledge", &CycleInput::acknowledge},
        {"SRS_PROD_003", "request", &CycleInput::request},
        {"SRS_PROD_012", "standing", &CycleInput::stand}};
    for (const auto& [requirement, what, mask] : masks)
    {
        const auto field = mask;
        book.Always(requirement, std::string{"no "} + what, &Rule::input, field, SrdoMask{0U});
        book.Always(requirement, std::string{"always "} + what, &Rule::input, field, ~SrdoMask{0U});
        book.Add(requirement, std::string{what} + " inverted", &Rule::input,
                 [field](CycleInput& input) { input.*field = ~(input.*field); });
    }
    for (const NmtState state : {NmtState::kPreOperational, NmtState::kOperational})
    {
        book.Always("SRS_CONS_019", (state == NmtState::kOperational) ? "always OPERATIONAL" : "never OPERATIONAL",
                    &Rule::input, &CycleInput::nmt, state);
    }
    book.Always("SRS_CONS_016", "queue never overflows", &Rule::input, &CycleInput::queue, QueueState::kIntact);
    book.Always("SRS_CONS_016", "queue always overflows", &Rule::input, &CycleInput::queue, QueueState::kOverflowed);
    book.Add("SRS_CONS_016", "queue inverted", &Rule::input, [](CycleInput& input)
             { input.queue = (input.queue == QueueState::kIntact) ? QueueState::kOverflowed : QueueState::kIntact; });
    for (const QueueState state : {QueueState::kInvalid, QueueState::kOverflowed})
    {
        book.Add("SRS_CONS_016", "queue state " + std::to_string(static_cast<unsigned>(state)) + " is no overflow",
                 &Rule::input, [state](CycleInput& input)
                 { input.queue = (input.queue == state) ? QueueState::kIntact : input.queue; });
    }
}

void AddCalls(Book& book)
{
    book.Add("SRS_REL_006", "Demote does nothing", &Rule::demote, [](SlotIndex) { return false; });
    book.Add("SRS_REL_002", "Commit does nothing", &Rule::commit, [](Agreement&) { return false; });
    book.Add("SRS_REL_002", "nothing is agreed", &Rule::commit,
             [](Agreement& agreement)
             {
                 agreement.agreed = 0U;
                 return true;
             });
    book.Add("SRS_REL_002", "everything is agreed", &Rule::commit,
             [](Agreement& agreement)
             {
                 agreement.agreed = ~SrdoMask{0U};
                 return true;
             });
    book.Add("SRS_REL_002", "nothing is matched", &Rule::commit,
             [](Agreement& agreement)
             {
                 agreement.matched = 0U;
                 return true;
             });
    book.Add("SRS_REL_002", "everything is matched", &Rule::commit,
             [](Agreement& agreement)
             {
                 agreement.matched = ~SrdoMask{0U};
                 return true;
             });
    book.Add("SRS_REL_002", "agreed and matched swapped", &Rule::commit,
             [](Agreement& agreement)
             {
                 std::swap(agreement.agreed, agreement.matched);
                 return true;
             });
}

void AddPrepared(Book& book)
{
    book.Silent("SRS_PROD_005", "prepared pair", &Rule::prepared);
    for (const PrepareStatus status : {PrepareStatus::kInvalid, PrepareStatus::kReady, PrepareStatus::kNotProducer})
    {
        book.Always("SRS_PROD_005", "status of Prepare is always " + std::to_string(static_cast<unsigned>(status)),
                    &Rule::prepared, &PreparedPair::status, status);
    }
    book.Always("SRS_PROD_005", "prepared frame is all 0", &Rule::prepared, &PreparedPair::normal, CanFrame{});
    book.Silent("SRS_PROD_006", "inverse frame", &Rule::inverse);
    const std::pair<const char*, std::function<void(CanFrame&)>> spoiled[] = {
        {"identifier 0", [](CanFrame& frame) { frame.identifier = 0U; }},
        {"identifier one more", [](CanFrame& frame) { ++frame.identifier; }},
        {"identifier one less", [](CanFrame& frame) { --frame.identifier; }},
        {"kind 0", [](CanFrame& frame) { frame.kind = FrameKind::kInvalid; }},
        {"kind data", [](CanFrame& frame) { frame.kind = FrameKind::kData; }},
        {"controller 0", [](CanFrame& frame) { frame.port = CanPortId::kInvalid; }},
        {"controller 1", [](CanFrame& frame) { frame.port = CanPortId::kFirst; }},
        {"length 0", [](CanFrame& frame) { frame.length_bytes = 0U; }},
        {"length one more", [](CanFrame& frame) { ++frame.length_bytes; }},
        {"length one less", [](CanFrame& frame) { --frame.length_bytes; }},
        {"data 0",
         [](CanFrame& frame) { frame = CanFrame{frame.identifier, frame.kind, frame.port, frame.length_bytes, {}}; }}};
    for (const auto& [how, spoil] : spoiled)
    {
        const auto hook = spoil;
        book.Add("SRS_PROD_006", std::string{"inverse frame: "} + how, &Rule::inverse, hook);
        book.Add("SRS_PROD_006", std::string{"inverse frame, if there is one: "} + how, &Rule::inverse,
                 [hook](CanFrame& frame)
                 {
                     if (frame.kind != FrameKind::kInvalid)
                     {
                         hook(frame);
                     }
                 });
        book.Add("SRS_PROD_005", std::string{"prepared frame: "} + how, &Rule::prepared,
                 [hook](PreparedPair& pair) { hook(pair.normal); });
        book.Add("SRS_PROD_005", std::string{"prepared frame, if there is one: "} + how, &Rule::prepared,
                 [hook](PreparedPair& pair)
                 {
                     if (pair.status == PrepareStatus::kReady)
                     {
                         hook(pair.normal);
                     }
                 });
    }
}

void AddConfirmed(Book& book)
{
    book.Silent("SRS_PROD_007", "confirmation", &Rule::confirmation);
    book.Field("SRS_PROD_007", "slot of the confirmation", &Rule::confirmation, &Confirmation::slot);
    for (const ConfirmStep step : {ConfirmStep::kNone, ConfirmStep::kNormal, ConfirmStep::kPair})
    {
        book.Always("SRS_PROD_007", "step of the confirmation is always " + std::to_string(static_cast<unsigned>(step)),
                    &Rule::confirmation, &Confirmation::step, step);
    }
    book.Add("SRS_PROD_009", "a failed transmission does nothing", &Rule::fault, [](TransmitFault&) { return false; });
    for (std::uint32_t cause = 0U; cause <= 19U; ++cause)
    {
        book.Add("SRS_PROD_009", "a failed transmission of cause " + std::to_string(cause) + " does nothing",
                 &Rule::fault, [cause](TransmitFault& fault) { return fault.cause != static_cast<SrdoCause>(cause); });
        book.Always("SRS_PROD_009", "a failed transmission always has cause " + std::to_string(cause), &Rule::fault,
                    &TransmitFault::cause, static_cast<SrdoCause>(cause));
    }
}

template <typename F>
void AddDescription(Book& book, const char* requirement, const std::string& what, F DeviceConfig::* field)
{
    for (const std::uint32_t kind : {0U, 1U, 2U})
    {
        static const char* const kHow[] = {" is 0", " is one more", " is one less"};
        book.Add(requirement, what + kHow[kind], &Rule::config,
                 [field, kind](DeviceConfig& config, SrdoSetup*)
                 {
                     const auto was = static_cast<std::uint64_t>(config.*field);
                     config.*field = static_cast<F>((kind == 0U) ? 0U : ((kind == 1U) ? (was + 1U) : (was - 1U)));
                 });
    }
}

template <typename F>
void AddSetup(Book& book, const char* requirement, const std::string& how, F SrdoSetup::* field, F constant)
{
    book.Add(requirement, how, &Rule::config,
             [field, constant](DeviceConfig& config, SrdoSetup* setups)
             {
                 for (std::uint32_t slot = 0U; slot < config.srdo_count; ++slot)
                 {
                     setups[slot].*field = constant;
                 }
             });
}

void AddDescriptions(Book& book)
{
    AddDescription(book, "SRS_CONS_015", "cycle time", &DeviceConfig::cycle_us);
    AddDescription(book, "SRS_CONS_015", "tolerance of the cycle", &DeviceConfig::cycle_tolerance_us);
    AddDescription(book, "SRS_PROD_001", "node-ID", &DeviceConfig::node_id);
    AddDescription(book, "SRS_CFG_027", "granularity", &DeviceConfig::granularity_bits);
    AddDescription(book, "SRS_CFG_026", "number of entries", &DeviceConfig::map_entries);
    AddDescription(book, "SRS_CFG_027", "number of objects", &DeviceConfig::object_count);
    AddDescription(book, "SRS_CFG_033", "dummies", &DeviceConfig::dummies);
    AddDescription(book, "SRS_CONS_017", "use of the GFC", &DeviceConfig::gfc);
    AddDescription(book, "SRS_CFG_034", "gaps of numbers", &DeviceConfig::gaps);
    AddDescription(book, "SRS_CONS_004", "controller of normal frames", &DeviceConfig::normal_port);
    AddDescription(book, "SRS_CONS_004", "controller of inverse frames", &DeviceConfig::inverse_port);
    AddDescription(book, "SRS_REL_005", "time of the acknowledge", &DeviceConfig::acknowledge_window_us);
    AddDescription(book, "SRS_CFG_034", "discrepancy time", &DeviceConfig::discrepancy_us);
    AddDescription(book, "SRS_CFG_034", "diagnostic interval", &DeviceConfig::diagnostic_interval_us);
    AddDescription(book, "SRS_CFG_034", "test interval", &DeviceConfig::test_interval_us);
    AddDescription(book, "SRS_CFG_034", "clock tolerance", &DeviceConfig::clock_tolerance_us);
    AddDescription(book, "SRS_CFG_034", "clock interval", &DeviceConfig::clock_interval_us);
    AddDescription(book, "SRS_CFG_034", "output time", &DeviceConfig::output_time_us);
    AddSetup(book, "SRS_CFG_034", "number 0", &SrdoSetup::number, std::uint8_t{0U});
    for (const ReleasePolicy policy : {ReleasePolicy::kInterlock, ReleasePolicy::kAutomatic})
    {
        AddSetup(book, "SRS_REL_004", (policy == ReleasePolicy::kAutomatic) ? "no interlock" : "always interlock",
                 &SrdoSetup::policy, policy);
    }
    for (const ProducerForm form : {ProducerForm::kApplicationSends, ProducerForm::kProviderCalled})
    {
        AddSetup(book, "SRS_PROD_002", "form " + std::to_string(static_cast<unsigned>(form)), &SrdoSetup::form, form);
    }
    for (const SrvtDetection detection : {SrvtDetection::kEarly, SrvtDetection::kLate})
    {
        AddSetup(book, "SRS_TIME_009",
                 (detection == SrvtDetection::kLate) ? "always late detection" : "always early detection",
                 &SrdoSetup::detection, detection);
    }
    AddSetup(book, "SRS_REL_002", "safe value 0", &SrdoSetup::safe_value, Payload{});
    AddSetup(book, "SRS_CFG_032", "no static mapping", &SrdoSetup::map, StaticMap{});
}

/// Each point of the plain channel in each of its ways. The first one is nothing broken at all.
void AddPoints(Book& book)
{
    Rule unbroken;
    unbroken.requirement = "none";
    unbroken.how = "the plain channel, nothing broken";
    unbroken.is_plain = true;
    book.rules.push_back(unbroken);
    for (const plain::Point* const point : plain::Point::All())
    {
        for (const plain::Slip slip : point->Slips())
        {
            Rule rule = unbroken;
            rule.requirement = point->Requirement();
            rule.how = point->Text(slip);
            rule.point = point;
            rule.slip = slip;
            book.rules.push_back(rule);
        }
    }
}

} // namespace

const std::vector<Rule>& Rules()
{
    static const std::vector<Rule> all = []
    {
        Book book;
        AddPoints(book);
        AddMasks(book);
        AddOutcomes(book);
        AddViews(book);
        AddChecks(book);
        AddDigests(book);
        AddDigestParts(book);
        AddStores(book);
        AddFrames(book);
        AddPayloads(book);
        AddInputs(book);
        AddCalls(book);
        AddPrepared(book);
        AddConfirmed(book);
        AddDescriptions(book);
        return book.rules;
    }();
    return all;
}

} // namespace counterpoint::twins
