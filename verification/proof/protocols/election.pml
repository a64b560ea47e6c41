/* Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0

   Two flying masters of the default preset on one bus, from power-on on. Levels, the time between the two power-ons, the order of
   what happens at one instant are free, and so are either one lost frame and one failure of a device, or the claims of a third device
   of level 2 with node-ID 9, which is deaf to 076h and never has a heartbeat, whenever somebody asked. Written from SRS_FLY_002 to SRS_FLY_013.

   Times in ms; nothing happens between two deadlines, so time goes from one to the next. Heartbeats of a master always come. */

#define NONE 30000    /* A deadline that is not set. */
#define DELAY 5       /* 1F90h:02 */
#define TIMEOUT 32    /* 1F90h:01: a master answers 073h after its node-ID in ms. */
#define LEVEL_SLOT 509
#define DEVICE_SLOT 4
#define CYCLE(i) (3000 + 100 * (i)) /* 1F90h:06 */
#define WATCH 6000    /* How long the heartbeat of a master may be missing. */
#define LONGEST 1563  /* One negotiation: DELAY + TIMEOUT + 2 LEVEL_SLOT + 127 DEVICE_SLOT. */
#define MOST_RESTARTS 3

#define OFF 0
#define WAIT 1 /* Step 1, before 073h. */
#define DETECT 2
#define RACE 3
#define SLAVE 4
#define MASTER 5

#define RESET 1
#define CLAIM 2
#define BEGIN 3  /* 072h */
#define ASK 4    /* 073h */
#define FORCE 5  /* 076h */

#define SETUP 0
#define CYCLED 1
#define HEARS 2
#define PASSES 3
#define FAILS 4

#define FOREIGN 6 /* 071h of the third device */

/* State of the two devices and of the bus. */
byte level[2], st[2], restarts[2];
bool first[2], asked[2], strange[2]; /* strange: slave of the third device */
short main[2], second[2], raced[2], rested[2];
short queue[2]; /* Frames that the device has still to hear, a digit each, the first one highest. */

/* Budgets and observers. */
byte losses, failures, claims;
short calm;     /* since the last power-on, loss or failure */
short doubled;  /* how long there have been two masters */
bool third;     /* the third device was heard: a better one may give up at the bound of its restarts */

byte choice_a, choice_b, choice_c, choice_d;
hidden short sent_frames, head, step, rest, i_now;
hidden short k_st[2], k_restarts[2], k_first[2], k_asked[2], k_strange[2], k_main[2], k_second[2], k_raced[2], k_rested[2], k_queue[2], k_level[2];

inline Send(i, frame)
{
    sent_frames = sent_frames * 10 + frame;
    if :: st[1 - i] != OFF -> assert(queue[1 - i] < 3000); queue[1 - i] = queue[1 - i] * 10 + frame :: else -> skip fi
}

inline Enter(i, state, time)
{
    st[i] = state; main[i] = time; second[i] = NONE; asked[i] = false; rested[i] = 0; raced[i] = 0; strange[i] = false;
    if :: state == RACE -> first[i] = false :: else -> skip fi
}

inline Follow(i)
{
    first[i] = false;
    Enter(i, SLAVE, WATCH);
    strange[i] = (head == FOREIGN)
}

/* A worse master has to yield, a bounded number of times. */
inline Yield(i)
{
    if
#ifdef PLANTED_NO_BOUND
    :: false -> skip
#else
    :: restarts[i] >= MOST_RESTARTS -> Follow(i)
#endif
    :: else -> restarts[i] = restarts[i] + 1; first[i] = false; Send(i, FORCE); Enter(i, WAIT, DELAY)
    fi
}

inline Rest(i)
{
    if :: (st[i] == SLAVE || st[i] == MASTER) && (rested[i] >= LONGEST) -> restarts[i] = 0 :: else -> skip fi
}

inline Slot(i)
{
    rest = level[i] * LEVEL_SLOT + (i + 1) * DEVICE_SLOT
}

inline RunMaster(i)
{
    if :: second[i] == 0 -> Send(i, CLAIM); second[i] = NONE :: else -> skip fi;
    if :: main[i] == 0 -> Send(i, FORCE); main[i] = CYCLE(i + 1) :: else -> skip fi
}

/* `rest` is the level of who claims. */
inline OnClaim(i)
{
    rest = (head == FOREIGN -> 2 : level[1 - i]);
    if
    :: st[i] == MASTER && head == CLAIM && (rest < level[i] || (rest == level[i] && i == 1)) -> Follow(i)
    :: st[i] == MASTER && !(head == CLAIM && (rest < level[i] || (rest == level[i] && i == 1))) -> second[i] = 0; RunMaster(i)
    :: st[i] == SLAVE && strange[i] == (head == FOREIGN) -> second[i] = NONE; asked[i] = false; main[i] = WATCH
    :: st[i] == SLAVE && strange[i] && head == CLAIM -> Follow(i)
#ifdef PLANTED_ANY_MASTER
    :: st[i] == WAIT || st[i] == DETECT || st[i] == RACE -> Follow(i)
#else
    :: (st[i] == WAIT || st[i] == DETECT || st[i] == RACE) && rest <= level[i] -> Follow(i)
    :: (st[i] == DETECT || st[i] == RACE) && rest > level[i] -> Yield(i)
#endif
    :: else -> skip
    fi
}

inline OnFrame(i)
{
    Rest(i);
    if
    :: head == RESET && st[i] != MASTER -> first[i] = false; Enter(i, WAIT, DELAY)
    :: head == CLAIM || head == FOREIGN -> OnClaim(i)
    :: head == BEGIN && st[i] == MASTER -> second[i] = 0; RunMaster(i)
    :: head == BEGIN && (st[i] == WAIT || st[i] == DETECT || (st[i] == RACE && raced[i] >= DEVICE_SLOT / 2)) ->
        step = (st[i] != DETECT);
        Slot(i); Enter(i, RACE, rest);
        if :: step -> Send(i, ASK); asked[i] = true :: else -> skip fi
    :: head == ASK && st[i] == MASTER ->
        if :: second[i] > i + 1 -> second[i] = i + 1 :: else -> skip fi;
        RunMaster(i)
    :: head == FORCE && st[i] == MASTER ->
#ifdef PLANTED_STUBBORN_MASTER
        skip
#else
        Send(i, RESET); Enter(i, WAIT, DELAY)
#endif
    :: else -> skip
    fi
}

inline OnCycle(i)
{
    Rest(i);
    if
    :: st[i] == MASTER -> RunMaster(i)
    :: st[i] == SLAVE -> Enter(i, WAIT, DELAY)
    :: st[i] == WAIT -> Send(i, ASK); Enter(i, DETECT, TIMEOUT)
    :: st[i] == DETECT && first[i] -> Send(i, RESET); first[i] = false; Enter(i, WAIT, DELAY)
    :: st[i] == DETECT && !first[i] -> Send(i, BEGIN); Slot(i); Enter(i, RACE, rest)
    :: st[i] == RACE -> Send(i, CLAIM); Enter(i, MASTER, CYCLE(i + 1))
    :: st[i] == OFF -> first[i] = true; restarts[i] = 0; Enter(i, WAIT, DELAY); queue[i] = 0; calm = 0
    fi
}

inline Down(value, by)
{
    if :: value != NONE -> value = value - by :: else -> skip fi
}

inline Up(value, by, limit)
{
    value = (value + by < limit -> value + by : limit)
}

inline Pass()
{
    step = NONE;
    for (i_now : 0 .. 1) {
        if :: main[i_now] < step -> step = main[i_now] :: else -> skip fi;
        if :: second[i_now] < step -> step = second[i_now] :: else -> skip fi
    }
    for (i_now : 0 .. 1) {
        Down(main[i_now], step); Down(second[i_now], step);
        if :: st[i_now] == RACE -> Up(raced[i_now], step, DEVICE_SLOT / 2) :: else -> skip fi;
        if :: st[i_now] == SLAVE || st[i_now] == MASTER -> Up(rested[i_now], step, LONGEST) :: else -> skip fi
    }
    for (i_now : 0 .. 1) { /* Its heartbeats keep the standby. */
        if :: st[i_now] == SLAVE && !strange[i_now] && st[1 - i_now] == MASTER -> Rest(i_now); main[i_now] = WATCH :: else -> skip fi
    }
    Up(calm, step, 20000);
    if :: st[0] == MASTER && st[1] == MASTER -> doubled = doubled + step :: else -> skip fi
}

inline Observe()
{
    /* 076h because of a worse master is bounded. */
    assert(restarts[0] <= MOST_RESTARTS && restarts[1] <= MOST_RESTARTS);
    if :: !(st[0] == MASTER && st[1] == MASTER) -> doubled = 0 :: else -> skip fi;
    /* Two masters do not last longer than one cyclic message and one negotiation. */
    assert(doubled <= CYCLE(2) + LONGEST);
    /* Once the bus is undisturbed for a heartbeat's time, a cyclic message and three negotiations there is exactly one master, which
       the other device follows unless it is off; no worse than the other one, unless the third device was heard. */
    if
    :: calm > WATCH + CYCLE(2) + 3 * LONGEST && queue[0] == 0 && queue[1] == 0 ->
        assert((st[0] == MASTER && st[1] == SLAVE && !strange[1] && (level[0] <= level[1] || third)) ||
               (st[1] == MASTER && st[0] == SLAVE && !strange[0] && (level[1] <= level[0] || third)) ||
               (st[0] == MASTER && st[1] == OFF) || (st[1] == MASTER && st[0] == OFF))
    :: else -> skip
    fi
}

inline Keep()
{
    for (i_now : 0 .. 1) {
        k_st[i_now] = st[i_now]; k_restarts[i_now] = restarts[i_now]; k_first[i_now] = first[i_now]; k_asked[i_now] = asked[i_now]; k_strange[i_now] = strange[i_now];
        k_main[i_now] = main[i_now]; k_second[i_now] = second[i_now]; k_raced[i_now] = raced[i_now]; k_rested[i_now] = rested[i_now];
        k_queue[i_now] = queue[i_now]; k_level[i_now] = level[i_now]
    }
    sent_frames = 0; step = 0; head = 0
}

#define NOW level[0], level[1], st[0], st[1], restarts[0], restarts[1], first[0], first[1], asked[0], asked[1], strange[0], \
    strange[1], main[0], main[1], second[0], second[1], raced[0], raced[1], rested[0], rested[1], queue[0], queue[1]
#define BEFORE k_level[0], k_level[1], k_st[0], k_st[1], k_restarts[0], k_restarts[1], k_first[0], k_first[1], k_asked[0], k_asked[1], \
    k_strange[0], k_strange[1], k_main[0], k_main[1], k_second[0], k_second[1], k_raced[0], k_raced[1], k_rested[0], \
    k_rested[1], k_queue[0], k_queue[1]
/* When the device does something next; nobody asks a device that is off. */
#define FIRST_OF(i) (st[i] == OFF -> 0 : (main[i] < second[i] -> main[i] : second[i]))

inline Tell(act, i, value)
{
    printf("T %d %d %d %d %d %d %d %d %d %d %d %d %d %d %d %d %d %d %d %d %d %d | ", BEFORE);
    printf("%d %d %d %d %d | ", act, i, value, level[0], level[1]);
    printf("%d %d %d %d %d %d %d %d %d %d %d %d %d %d %d %d %d %d %d %d %d %d | ", NOW);
    printf("%d %d %d %d %d %d %d\n", st[0], st[1], restarts[0], restarts[1], FIRST_OF(0), FIRST_OF(1), sent_frames)
}

inline Take(i)
{
    if
    :: queue[i] >= 1000 -> head = queue[i] / 1000; queue[i] = queue[i] % 1000
    :: queue[i] < 1000 && queue[i] >= 100 -> head = queue[i] / 100; queue[i] = queue[i] % 100
    :: queue[i] < 100 && queue[i] >= 10 -> head = queue[i] / 10; queue[i] = queue[i] % 10
    :: else -> head = queue[i]; queue[i] = 0
    fi
}

#define IS_DUE(i) (main[i] == 0 || second[i] == 0)

inline MayDo(i)
{
    if
    :: IS_DUE(i) -> d_step { Keep(); OnCycle(i); Observe(); Tell(CYCLED, i, 0) }
    :: queue[i] > 0 -> d_step { Keep(); Take(i); OnFrame(i); Observe(); Tell(HEARS, i, head) }
    :: queue[i] > 0 && losses > 0 -> d_step { losses = losses - 1; calm = 0; Keep(); Take(i); Tell(HEARS, i, 0) }
    :: claims > 0 && st[i] == DETECT && !IS_DUE(i) && queue[i] == 0 ->
        d_step { claims = claims - 1; calm = 0; third = true; Keep(); head = FOREIGN; OnFrame(i); Observe(); Tell(HEARS, i, FOREIGN) }
    :: failures > 0 && st[i] != OFF && !IS_DUE(i) && queue[i] == 0 ->
        d_step { failures = failures - 1; calm = 0; Keep(); Enter(i, OFF, 700); first[i] = false; restarts[i] = 0; Tell(FAILS, i, 0) }
    fi
}

active proctype Bus()
{
    atomic {
        select(choice_a : 0 .. 2); select(choice_b : 0 .. 2);
        if
        :: choice_c = 0 :: choice_c = 1 :: choice_c = 3 :: choice_c = 5 :: choice_c = 20 :: choice_c = 37 :: choice_c = 42 :: choice_c = 250
        fi;
        if :: choice_d = 0 :: choice_d = 5 fi;
        d_step {
            Keep();
            claims = choice_d; losses = (choice_d == 0); failures = losses;
            level[0] = choice_a; level[1] = choice_b; Enter(0, OFF, 0); Enter(1, OFF, choice_c);
            Tell(SETUP, 0, choice_c); choice_a = 0; choice_b = 0; choice_c = 0; choice_d = 0
        }
    }
    do
    :: atomic { IS_DUE(0) || queue[0] > 0 || (failures > 0 && st[0] != OFF) || (claims > 0 && st[0] == DETECT) -> MayDo(0) }
    :: atomic { IS_DUE(1) || queue[1] > 0 || (failures > 0 && st[1] != OFF) || (claims > 0 && st[1] == DETECT) -> MayDo(1) }
    :: d_step {
        !IS_DUE(0) && !IS_DUE(1) && queue[0] == 0 && queue[1] == 0 ->
        Keep(); Pass(); Observe(); Tell(PASSES, 0, step)
    }
    od
}
