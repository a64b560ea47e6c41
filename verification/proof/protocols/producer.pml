/* Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0

   One producer of form kProviderCalled in a channel, under every sequence of calls: cycles with and without a request, in and out
   of OPERATIONAL, Prepare at any time, confirmations of the right and of wrong frames on the call and a microsecond behind it,
   transmit faults. Written from SRS_PROD_001 to SRS_PROD_011 and SRS_PROD_013.

   Cycle 1 ms, refresh time 2 ms, SRVT 1 ms, node-ID 2 (first transmission 1 ms behind entering OPERATIONAL). */

#define REFRESH 2
#define SRVT_US 1000
#define CYCLE_US 1000

#define IDLE 0
#define NORMAL 1  /* The normal frame is awaited. */
#define INVERSE 2 /* The inverse frame is awaited. */

#define CYCLED 0
#define PREPARES 1
#define CONFIRMS 2
#define FAILS 3

/* What is confirmed. */
#define RIGHT_NORMAL 0
#define WRONG_NORMAL 1
#define RIGHT_INVERSE 2
#define WRONG_INVERSE 3
#define ANOTHER 4

/* Causes, by their numbers. */
#define NOT_INVERSE 4
#define OF_A_CONSUMER 6
#define QUEUE 13
#define BUS_OFF 14
#define NO_CONFIRMATION 15
#define MISSED 16
#define WRONG_ECHO 17

/* State. */
bool is_on;
bool open;    /* the initial delay is over */
byte phase;   /* cycles to the next refresh */
bool refresh; /* a refresh waits */
bool request; /* a request waits */
byte flight;
byte passed;  /* cycles since the pair's base: the call before Prepare, or that before the confirmation of the normal frame */
byte offset;  /* us of that confirmation behind its call */

/* Observer: cycles since the pair left without being over. */
byte unanswered;

byte in_a, in_b;
hidden byte k_is_on, k_open, k_phase, k_refresh, k_request, k_flight, k_passed, k_offset, due, waits, faults, cause, ready, step;
hidden short elapsed;

inline Keep()
{
    k_is_on = is_on; k_open = open; k_phase = phase; k_refresh = refresh; k_request = request; k_flight = flight; k_passed = passed;
    k_offset = offset; due = 0; waits = 0; faults = 0; cause = 0; ready = 0; step = 0
}

inline Tell(act)
{
    printf("T %d %d %d %d %d %d %d %d | %d %d %d | ", k_is_on, k_open, k_phase, k_refresh, k_request, k_flight, k_passed, k_offset, act, in_a, in_b);
    printf("%d %d %d %d %d %d %d %d | ", is_on, open, phase, refresh, request, flight, passed, offset);
    printf("%d %d %d %d %d %d %d\n", is_on, due, faults, ready, step, (is_on && (flight == INVERSE)), waits)
}

inline GiveUp()
{
    flight = IDLE; passed = 0; offset = 0; faults = faults + 1
}

inline Clear()
{
    open = false; phase = 0; refresh = false; request = false; flight = IDLE; passed = 0; offset = 0; unanswered = 0
}

inline Cycle()
{
    if
    :: !in_a -> is_on = false; Clear()
    :: in_a && !is_on -> is_on = true; Clear(); phase = 1; request = in_b
    :: else ->
        open = true;
        phase = phase - 1;
        if :: flight != IDLE -> passed = passed + 1; unanswered = unanswered + 1 :: else -> skip fi;
#ifdef PLANTED_NO_LIMIT
        if :: passed > 5 -> passed = 5 :: else -> skip fi;
#else
        if :: flight != IDLE && passed * CYCLE_US - offset > SRVT_US -> GiveUp() :: else -> skip fi;
#endif
        if
        :: phase == 0 ->
            phase = REFRESH;
#ifdef PLANTED_SKIPPED_IN_FLIGHT
            if :: flight != IDLE || refresh -> faults = faults + 1 :: else -> refresh = true fi
#else
            if :: refresh -> faults = faults + 1 :: else -> refresh = true fi
#endif
        :: else -> skip
        fi;
        request = (request || in_b)
    fi;
#ifdef PLANTED_DUE_IN_FLIGHT
    due = (is_on && open && (refresh || request));
#else
    due = (is_on && open && flight == IDLE && (refresh || request));
#endif
    waits = (is_on && refresh);
    if :: flight == IDLE -> unanswered = 0 :: else -> skip fi
}

inline Prepare()
{
    if
    :: is_on && flight == IDLE -> flight = NORMAL; passed = 0; offset = 0; unanswered = 0; refresh = false; request = false; ready = 1
    :: else -> skip
    fi
}

inline Confirm()
{
    elapsed = passed * CYCLE_US + in_b - offset;
    if
    :: (flight == NORMAL && in_a == WRONG_NORMAL) || (flight == INVERSE && in_a == WRONG_INVERSE) -> GiveUp()
    :: (flight == NORMAL && in_a == RIGHT_NORMAL) || (flight == INVERSE && in_a == RIGHT_INVERSE) ->
        if
        :: elapsed > SRVT_US -> GiveUp()
        :: elapsed <= SRVT_US && flight == NORMAL -> flight = INVERSE; passed = 0; offset = in_b; step = 1; unanswered = 0
        :: else -> flight = IDLE; passed = 0; offset = 0; step = 2
        fi
    :: else -> skip
    fi
}

inline Fail()
{
    if :: flight != IDLE && in_a != OF_A_CONSUMER -> GiveUp() :: else -> skip fi
}

inline Observe()
{
    /* Nothing is due, in flight or remembered outside OPERATIONAL, nothing due before the first instant or beside a pair in flight. */
    assert(is_on || (!due && flight == IDLE && !refresh && !request));
    assert(!due || (open && flight == IDLE));
    /* A pair is over within SRVT and a cycle of its begin, and of its normal frame. */
    assert(unanswered <= 1);
    /* The inverse frame is never awaited without the normal one before it, and a pair is complete by both alone. */
    assert(flight != INVERSE || k_flight == INVERSE || (k_flight == NORMAL && step == 1));
    assert(step != 2 || k_flight == INVERSE);
    /* Each refresh that falls due waits, with a pair in flight as well; behind one that waits already it is a fault. */
    assert(!(is_on && k_is_on && k_phase == 1 && phase == REFRESH) || (refresh && (!k_refresh || faults > 0)));
    /* It waits until Prepare uses it up, or OPERATIONAL is left. */
    assert(!k_refresh || refresh || ready == 1 || !is_on)
}

active proctype Producer()
{
    do
    :: atomic {
        if :: in_a = 0 :: in_a = 1 fi;
        if :: in_b = 0 :: in_b = 1 fi;
        d_step { Keep(); Cycle(); Observe(); Tell(CYCLED); in_a = 0; in_b = 0 }
    }
    :: d_step { Keep(); Prepare(); Observe(); Tell(PREPARES) }
    :: atomic {
        select(in_a : RIGHT_NORMAL .. ANOTHER);
        if :: in_b = 0 :: in_b = 1 fi;
        d_step {
            if
            :: passed == 0 && in_b < offset -> skip /* Stamps come in order. */
            :: else -> Keep(); Confirm(); Observe(); Tell(CONFIRMS)
            fi;
            in_a = 0; in_b = 0
        }
    }
    :: atomic {
        if :: in_a = NOT_INVERSE :: in_a = OF_A_CONSUMER :: in_a = QUEUE :: in_a = BUS_OFF :: in_a = NO_CONFIRMATION fi;
        d_step { Keep(); Fail(); Observe(); Tell(FAILS); in_a = 0 }
    }
    od
}
