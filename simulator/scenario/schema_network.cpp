// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "simulator/scenario/names.hpp"
#include "simulator/scenario/network_names.hpp"

// Managers, what happens to them and to devices, and what a manager is asked. [SRS_MGR_155, SRS_SIM_047]
namespace counterpoint::simulator
{
namespace
{
using T = ValueType;
constexpr Range kNodes{1U, 127U};
constexpr Range kSrdos{1U, 64U};
constexpr Range kNumbers{0U, 0xFFFFFFFFU};
constexpr Range kIdentifiers{0U, 0x7FFU};

const KeySpec kDevice{"node", T::kNode, kNeeded, "relay", "which node"};
const KeySpec kSlave{"node", T::kNodeId, kNeeded, "33", "one of the manager's network, or of the scenario"};
const KeySpec kOneManager{"node", Number(kNodes), kOptional, "127", "node-ID of a manager; default: the first one"};
const KeySpec kManager{"manager", Number(kNodes), kOptional, "127",
                       "node-ID of the manager that is asked; default: the first one"};
const KeySpec kSrdo{"srdo", Number(kSrdos), "1", "1", "number of an SRDO that the device consumes"};
const KeySpec kEvery{"every", T::kLasting, "1 ms", "2 ms", "time between two frames"};
const KeySpec kUntil{"until", T::kDuration, kNeeded, "5 s", "when it is over"};
const KeySpec kBack{"until", T::kDuration, kNeeded, "5 s", "when it is back, within the scenario"};
const KeySpec kAt{"at", T::kDuration, kOptional, "4 s", "when it is looked at; default: the end"};

SectionSpec Event(const char* const name, const char* const meaning, std::vector<KeySpec> keys)
{
    return {name, "an event", "events", meaning, std::move(keys)};
}

KeySpec Is(const Shape& shape, const char* const example, const char* const meaning)
{
    return {"is", shape, kNeeded, example, meaning};
}
const std::vector<KeySpec> kEventKeys{
    Is(OneOf<kFoundEvents>(), "boot_up", "the event, as in the log of docs/manager.md"),
    {"node", T::kNodeId, kOptional, "33", "of this node; default: of any"},
    {"from", T::kDuration, "0 s", "3 s", "not before"},
    {"until", T::kDuration, kOptional, "3300 ms", "not after; default: the end"},
    kManager};
} // namespace

const std::vector<SectionSpec> kNetworkSections{
    Section("manager", "a manager",
            "A network manager by its network file (docs/manager.md); each has a node-ID of its own.",
            {{"network", T::kText, kNeeded, "chain.yaml", "its network file, relative to this file"},
             {"node", Number(kNodes), kOptional, "126", "its node-ID instead of the file's"},
             {"at", T::kDuration, "0 s", "2 s", "when it is switched on"}}),
    Section(
        "events", "an event",
        "Every event; its other keys follow from what it does. One that would change nothing is refused: an insert of "
        "a device that is there, an order to a manager that is not.",
        {{"at", T::kDuration, kNeeded, "3 s", "when, before the end of the scenario"},
         {"do", OneOf<kActionWords>(), kNeeded, "pull", "what happens"},
         kProfileKey}),
    Event("events.pull", "The device disappears.", {kDevice}),
    Event("events.insert", "A device that was pulled comes back.", {kDevice}),
    Event("events.reset", "Its supply blinks; nobody commanded it.", {kDevice}),
    Event("events.replace", "Another device of its kind takes its place, also that of a pulled one.",
          {kDevice, {"serial", Number(kNumbers), kNeeded, "77", "1018h:04 of the other one"}}),
    Event("events.duplicate", "A second device with its node-ID comes.", {kDevice}),
    Event("events.store",
          "Somebody writes into the device, unseen by the manager. The run does not hold if the device refuses it.",
          {kDevice,
           {"object", T::kObject, kNeeded, "0x1017:00", "an object that the device has"},
           {"value", Number(kNumbers), kNeeded, "0",
            "what stands there from then on; an SRDO's only before OPERATIONAL"}}),
    Event("events.acknowledge", "Its acknowledge input for this SRDO is pressed.", {kDevice, kSrdo}),
    Event("events.emcy_storm", "Emergency messages, one after the other.",
          {{"node", T::kNodeId, kNeeded, "2", "whose emergencies, whether it is there or not"},
           {"code", Number({0U, 0xFFFFU}), "0x1000", "0x8130", "emergency error code"},
           kEvery,
           kUntil}),
    Event("events.babble", "A defective device sends frames of eight zeros.",
          {{"identifier", Number(kIdentifiers), kNeeded, "0x001", "COB-ID of the frames"}, kEvery, kUntil}),
    Event("events.send", "A frame of somebody else.",
          {{"identifier", Number(kIdentifiers), kNeeded, "0x000", "COB-ID of the frame"},
           {"data", T::kText, kOptional, "01 21", "up to 8 bytes of two hexadecimal digits"},
           {"every", T::kLasting, kOptional, "100 ms", "again each; with 'until'"},
           {"until", T::kDuration, kOptional, "5 s", "when it is over; with 'every'"}}),
    Event("events.order", "An order to a manager.",
          {{"order", T::kText, kNeeded, "start 33", "an order of docs/manager.md that acts"}, kOneManager}),
    Event("events.kill_manager", "It loses its supply for good.",
          {{"node", Number(kNodes), kNeeded, "127", "node-ID of a manager"}}),
    Event("events.bus_off", "The controller of a manager is bus-off.", {kOneManager, kBack}),
    Event("events.no_controller", "The controller of a manager does not start.", {kOneManager, kBack}),
    Expected("state", "The state of a node as the manager knows it.",
             {kSlave, Is(OneOf<kFoundStates>(), "operational", "as the manager heard it last"), kAt, kManager}),
    Expected("device", "The state of a device as it is.",
             {kDevice, Is(OneOf<kFoundDevices>(), "operational", "as it is; absent: not there"), kAt}),
    Expected("letter", "How the start-up of a slave ended; profile cia302.",
             {kSlave, Is(OneOf<kFoundLetters>(), "O", "the letter of CiA 302-2"), kAt, kManager}),
    Expected("code", "The code of a slave; profiles el6751 and plc_designer.",
             {kSlave, Is(T::kText, "5", "a NodeState of el6751, an nStatus of plc_designer"), kAt, kManager}),
    Expected("gate", "The verification of a safety slave.",
             {kSlave, Is(OneOf<kFoundGates>(), "open", "what the gate says"), kAt, kManager}),
    Expected("finding", "What the start-up or the verification of a slave found.",
             {kSlave, Is(T::kText, "\"0x1018:04\"", "the object that is wrong; none: none is"), kAt, kManager}),
    Expected("output", "The output of an SRDO that the device consumes.",
             {kDevice, Is(OneOf<kFoundOutputs>(), "closed", "its output"), kSrdo, kAt}),
    Expected("event", "The manager told such an event in this window; of guarding only for who is guarded.",
             kEventKeys),
    Expected("no_event", "The manager told no such event in this window; of guarding only for who is guarded.",
             kEventKeys),
    Expected("active", "Whether a flying master commands the network; another manager does while it is there.",
             {Is(OneOf<kYesWords>(), "true", "whether it is the active master"), kAt, kManager}),
    Expected("flying",
             "What the election told a flying master: 1 slave, 2 forces the negotiation, 3 begins it, 4 "
             "master, 5 configuration error.",
             {Is(T::kText, "3 4", "numbers of its events so far, or none"), kAt, kManager}),
};
} // namespace counterpoint::simulator
