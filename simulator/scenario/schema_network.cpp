// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "simulator/scenario/names.hpp"
#include "simulator/scenario/network_names.hpp"

// Managers, what happens to them and to devices, and what a manager is asked. [SRS_MGR_012, SRS_SIM_047]
namespace counterpoint::simulator
{
namespace
{
using T = ValueType;
constexpr Range kNone{0U, 0U};
constexpr Range kNodes{1U, 127U};
constexpr Range kSrdos{1U, 64U};
constexpr Range kNumbers{0U, 0xFFFFFFFFU};
constexpr Range kIdentifiers{0U, 0x7FFU};

const KeySpec kDevice{"node", T::kNode, kNone, nullptr, nullptr, kNeeded, "relay", "which node"};
const KeySpec kSlave{"node",  T::kNodeId, kNone, nullptr,
                     nullptr, kNeeded,    "33",  "one of the manager's network, or of the scenario"};
const KeySpec kOneManager{"node",  T::kNumber, kNodes, nullptr,
                          nullptr, nullptr,    "127",  "node-ID of a manager; default: the first one"};
const KeySpec kManager{"manager", T::kNumber, kNodes, nullptr,
                       nullptr,   nullptr,    "127",  "node-ID of the manager that is asked; default: the first one"};
const KeySpec kSrdo{"srdo",  T::kNumber, kSrdos, nullptr,
                    nullptr, "1",        "1",    "number of an SRDO that the device consumes"};
const KeySpec kEvery{"every", T::kLasting, kNone, nullptr, nullptr, "1 ms", "2 ms", "time between two frames"};
const KeySpec kUntil{"until", T::kDuration, kNone, nullptr, nullptr, kNeeded, "5 s", "when it is over"};
const KeySpec kBack{"until", T::kDuration, kNone, nullptr,
                    nullptr, kNeeded,      "5 s", "when it is back, within the scenario"};
const KeySpec kAt{"at",    T::kDuration, kNone, nullptr,
                  nullptr, nullptr,      "4 s", "when it is looked at; default: the end"};

SectionSpec Event(const char* const name, std::vector<KeySpec> keys, const char* const meaning)
{
    return {name, "an event", {"events"}, std::move(keys), meaning};
}

SectionSpec Expected(const char* const name, std::vector<KeySpec> keys, const char* const meaning)
{
    return {name, "an expectation", {"expect"}, std::move(keys), meaning};
}

KeySpec Is(std::string (*words)(), const char* const example, const char* const meaning)
{
    return {"is", T::kWord, kNone, words, nullptr, kNeeded, example, meaning};
}

KeySpec IsText(const char* const example, const char* const meaning)
{
    return {"is", T::kText, kNone, nullptr, nullptr, kNeeded, example, meaning};
}
} // namespace

namespace
{
const std::vector<SectionSpec> kNetworkSections{
    {"manager",
     "a manager",
     {},
     {
         {"network", T::kText, kNone, nullptr, nullptr, kNeeded, "chain.yaml",
          "its network file, relative to this file"},
         {"node", T::kNumber, kNodes, nullptr, nullptr, nullptr, "126", "its node-ID instead of the file's"},
         {"at", T::kDuration, kNone, nullptr, nullptr, "0 s", "2 s", "when it is switched on"},
     },
     "A network manager by its network file (docs/manager.md); each has a node-ID of its own."},
    {"events",
     "an event",
     {},
     {
         {"at", T::kDuration, kNone, nullptr, nullptr, kNeeded, "3 s", "when, before the end of the scenario"},
         {"do", T::kWord, kNone, &WordsOf<kActionWords>, nullptr, kNeeded, "pull", "what happens"},
         {"profile", T::kWordOrList, kNone, &WordsOf<kProfileWords>, nullptr, nullptr, "el6751",
          "only under these of the scenario's 'profiles'"},
     },
     "Every event; its other keys follow from what it does. One that would change nothing is refused: an insert of a "
     "device that is there, an order to a manager that is not."},
    Event("events.pull", {kDevice}, "The device disappears."),
    Event("events.insert", {kDevice}, "A device that was pulled comes back."),
    Event("events.reset", {kDevice}, "Its supply blinks; nobody commanded it."),
    Event("events.replace",
          {kDevice, {"serial", T::kNumber, kNumbers, nullptr, nullptr, kNeeded, "77", "1018h:04 of the other one"}},
          "Another device of its kind takes its place, also that of a pulled one."),
    Event("events.duplicate", {kDevice}, "A second device with its node-ID comes."),
    Event("events.store",
          {kDevice,
           {"object", T::kObject, kNone, nullptr, nullptr, kNeeded, "0x1017:00", "an object that the device has"},
           {"value", T::kNumber, kNumbers, nullptr, nullptr, kNeeded, "0", "what stands there from then on"}},
          "Somebody writes into the device, unseen by the manager."),
    Event("events.acknowledge", {kDevice, kSrdo}, "Its acknowledge input for this SRDO is pressed."),
    Event("events.emcy_storm",
          {{"node", T::kNodeId, kNone, nullptr, nullptr, kNeeded, "2", "whose emergencies, whether it is there or not"},
           {"code", T::kNumber, {0U, 0xFFFFU}, nullptr, nullptr, "0x1000", "0x8130", "emergency error code"},
           kEvery,
           kUntil},
          "Emergency messages, one after the other."),
    Event("events.babble",
          {{"identifier", T::kNumber, kIdentifiers, nullptr, nullptr, kNeeded, "0x001", "COB-ID of the frames"},
           kEvery,
           kUntil},
          "A defective device sends frames of eight zeros."),
    Event("events.send",
          {{"identifier", T::kNumber, kIdentifiers, nullptr, nullptr, kNeeded, "0x000", "COB-ID of the frame"},
           {"data", T::kText, kNone, nullptr, nullptr, nullptr, "01 21", "up to 8 bytes of two hexadecimal digits"},
           {"every", T::kLasting, kNone, nullptr, nullptr, nullptr, "100 ms", "again each; with 'until'"},
           {"until", T::kDuration, kNone, nullptr, nullptr, nullptr, "5 s", "when it is over; with 'every'"}},
          "A frame of somebody else."),
    Event("events.order",
          {{"order", T::kText, kNone, nullptr, nullptr, kNeeded, "start 33", "an order of docs/manager.md that acts"},
           kOneManager},
          "An order to a manager."),
    Event("events.kill_manager",
          {{"node", T::kNumber, kNodes, nullptr, nullptr, kNeeded, "127", "node-ID of a manager"}},
          "It loses its supply for good."),
    Event("events.bus_off", {kOneManager, kBack}, "The controller of a manager is bus-off."),
    Event("events.no_controller", {kOneManager, kBack}, "The controller of a manager does not start."),
    Expected("state",
             {kSlave, Is(&WordsOf<kFoundStates>, "operational", "as the manager heard it last"), kAt, kManager},
             "The state of a node as the manager knows it."),
    Expected("device", {kDevice, Is(&WordsOf<kFoundDevices>, "operational", "as it is; absent: not there"), kAt},
             "The state of a device as it is."),
    Expected("letter", {kSlave, Is(&WordsOf<kFoundLetters>, "O", "the letter of CiA 302-2"), kAt, kManager},
             "How the start-up of a slave ended; profile cia302."),
    Expected("code", {kSlave, IsText("5", "a NodeState of el6751, an nStatus of plc_designer"), kAt, kManager},
             "The code of a slave; profiles el6751 and plc_designer."),
    Expected("gate", {kSlave, Is(&WordsOf<kFoundGates>, "open", "what the gate says"), kAt, kManager},
             "The verification of a safety slave."),
    Expected("finding", {kSlave, IsText("\"0x1018:04\"", "the object that is wrong; none: none is"), kAt, kManager},
             "What the start-up or the verification of a slave found."),
    Expected("output", {kDevice, Is(&WordsOf<kFoundOutputs>, "closed", "its output"), kSrdo, kAt},
             "The output of an SRDO that the device consumes."),
};
const std::vector<KeySpec> kEventKeys{
    Is(&WordsOf<kFoundEvents>, "boot_up", "the event, as in the log of docs/manager.md"),
    {"node", T::kNodeId, kNone, nullptr, nullptr, nullptr, "33", "of this node; default: of any"},
    {"from", T::kDuration, kNone, nullptr, nullptr, "0 s", "3 s", "not before"},
    {"until", T::kDuration, kNone, nullptr, nullptr, nullptr, "3300 ms", "not after; default: the end"},
    kManager};
} // namespace

std::vector<SectionSpec> NetworkSections()
{
    std::vector<SectionSpec> all = kNetworkSections;
    all.push_back(Expected("event", kEventKeys,
                           "The manager told such an event in this window; of guarding only for who is guarded."));
    all.push_back(Expected("no_event", kEventKeys,
                           "The manager told no such event in this window; of guarding only for who is guarded."));
    all.push_back(Expected("active",
                           {Is(&WordsOf<kYesWords>, "true", "whether it is the active master"), kAt, kManager},
                           "Whether a flying master commands the network; another manager does while it is there."));
    all.push_back(Expected("flying", {IsText("3 4", "numbers of its events so far, or none"), kAt, kManager},
                           "What the election told a flying master: 1 slave, 2 forces the negotiation, 3 begins it, 4 "
                           "master, 5 configuration error."));
    return all;
}
} // namespace counterpoint::simulator
