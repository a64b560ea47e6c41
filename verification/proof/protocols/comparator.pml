/* Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0

   The comparator with decision and latch of the kernel, over one slot and two channels that may say anything in any cycle.
   Written from SRS_CMP_002 to SRS_CMP_008, SRS_CMP_011, SRS_CMP_250 and semantics 3, 4. Limits: discrepancy time 2 cycles, acknowledge
   window 3 cycles. Tell prints each transition for the replay in the code; PLANTED_... are defects that have to be found.
   Each state lets in 1731 inputs. */

#define DISCREPANCY 2
#define WINDOW 3

#define WAITING 0
#define RELEASED 1
#define FAULTED 2

/* State. Behind a fault of the device all but `running` is 0: nothing else counts any more. */
bool running;
bool agreed;    /* by the comparison before */
bool fresh;     /* a new pair was not matched yet */
bool committed; /* the outputs are open */
byte differ;    /* cycles since the pairs, or due marks, were last seen alike; 0: alike */
byte alone;     /* comparisons in a row in which one channel alone is released or faulted; 0: none */

/* Observers of the properties. */
bool quiet;         /* since the start the channels said the same, and nothing else happened */
bool unlike_news;  /* a pair came that the channels do not hold alike; a pair that changes without news is a fault of its channel */
byte held_unlike;  /* comparisons in a row with unequal ordinals and nobody demoted */
byte one_alone;    /* comparisons in a row with one channel alone in release or fault, and nobody demoted */

/* What the channels say in this cycle; 0 between cycles. Not hidden: the verifier would not restore them between two choices. */
byte state_a, state_b, due, pairs, overall;
bool fault_a, fault_b, news, demand;
/* What follows; set anew within one d_step each time. */
hidden byte fault, demote, received, apart, one_faulted, pending, look, unlike, late, was_running, was_agreed, matched;
/* The state before, for the replay. */
hidden byte b_running, b_agreed, b_fresh, b_committed, b_differ, b_alone;

inline Choose()
{
    if :: state_a = WAITING :: state_a = RELEASED :: state_a = FAULTED fi;
    if :: state_b = WAITING :: state_b = RELEASED :: state_b = FAULTED fi;
    if :: fault_a = false :: fault_a = true fi;
    if :: fault_b = false :: fault_b = true fi;
    if :: news = false :: news = true fi;
    if :: due = 0 :: due = 1 :: due = 2 fi;                /* of no channel, of one, of both */
    if :: pairs = 0 :: pairs = 1 :: pairs = 2 :: pairs = 3 fi; /* alike; other ordinal; one holds none; other data */
}

/* SRS_CMP_003, SRS_CMP_004, SRS_CMP_005, SRS_CMP_006, SRS_CMP_007, SRS_CMP_008, SRS_CMP_250 */
inline Judge()
{
    was_agreed = agreed;
    one_faulted = ((state_a == FAULTED) != (state_b == FAULTED));
#ifdef PLANTED_ONE_IS_ENOUGH
    apart = one_faulted; /* What B says of its release is not asked for. */
#else
    apart = (one_faulted || ((state_a == RELEASED) != (state_b == RELEASED)));
#endif
    demote = ((fault_a != fault_b) || (apart && was_agreed));
#ifdef PLANTED_ONE_IS_ENOUGH
    agreed = ((state_a == RELEASED) && (state_b != FAULTED) && !fault_a && !fault_b);
#else
    agreed = ((state_a == RELEASED) && (state_b == RELEASED) && !fault_a && !fault_b);
#endif
    pending = (!demote && (apart || ((alone > 0) && agreed)));
    look = ((!demote && ((differ > 0) || pending || news || (pairs == 1))) || (due == 1));
    unlike = (look && ((pairs != 0) || (due == 1)));
    fresh = (look && (fresh || news));
    late = false;
    if
    :: look && pending ->
        if
        :: apart && (alone <= WINDOW) -> alone = alone + 1
        :: else -> late = (alone > WINDOW); alone = 0
        fi
    :: else -> alone = 0
    fi;
    if
    :: !unlike -> differ = 0
    :: unlike && (differ <= DISCREPANCY) -> differ = differ + 1
    :: else -> skip
    fi;
    fault = ((unlike && (pairs == 3)) || (differ > DISCREPANCY));
    demote = (demote || late);
    agreed = (agreed && !late);
    matched = ((differ == 0) && (alone == 0));
    received = ((fresh && matched && look && !late) || !committed);
    if :: late || (differ == 0 && alone == 0) -> fresh = false :: else -> skip fi
}

/* Decision::Commit: what was agreed before stays as it was written, nothing new without a match. */
inline Commit()
{
    received = (received && agreed && !demote && matched);
    committed = (agreed && !demote && (matched || committed))
}

inline Safe()
{
    running = false; agreed = false; fresh = false; committed = false; differ = 0; alone = 0; received = false
}

inline Observe()
{
    /* No permit without the agreement of both in this very cycle, beside a fault or outside of running. */
    assert(!committed || (running && !fault && !demand && (overall == 0)));
    assert(!committed || ((state_a == RELEASED) && (state_b == RELEASED) && !fault_a && !fault_b));
    /* Nothing new is written unless both hold the same pair, as far as a channel tells of news. */
    unlike_news = (running && !demote && (pairs != 0) && (unlike_news || news || (pairs == 1)));
    assert(!received || (committed && !unlike_news));
    /* One way in: a fault or a demand. No way out: only the other branch of the loop starts again. */
    assert(!was_running || running || fault || demand || (overall != 0));
    assert(was_running || !running);
    /* Data that differ under one ordinal, or unequal voices, are never outlived by a cycle. */
    assert((overall == 0) || !running);
    assert(!(news && (pairs == 3) && !demote) || !running);
    /* In time: unequal ordinals end in the safe state, a release of one alone in a demotion. */
    if
    :: !running || demote || (overall != 0) -> held_unlike = 0; one_alone = 0
    :: else ->
        held_unlike = ((pairs == 1) -> held_unlike + 1 : 0);
        one_alone = (apart -> one_alone + 1 : 0)
    fi;
    assert(held_unlike <= DISCREPANCY);
    assert(one_alone <= WINDOW + 1);
    /* Channels that say the same are never demoted, and never end in the safe state. */
    quiet = (quiet && (state_a == state_b) && (fault_a == fault_b) && (pairs == 0) && (due != 1) && (overall == 0) && !demand);
    assert(!quiet || (running && !demote))
}

inline Keep()
{
    b_running = running; b_agreed = agreed; b_fresh = fresh; b_committed = committed; b_differ = differ; b_alone = alone;
    was_running = running
}

inline Tell(act)
{
    printf("T %d %d %d %d %d %d | %d %d %d %d %d %d %d %d %d %d | %d %d %d %d %d %d | %d %d %d %d\n",
        b_running, b_agreed, b_fresh, b_committed, b_differ, b_alone,
        act, state_a, state_b, fault_a, fault_b, news, due, pairs, overall, demand,
        running, agreed, fresh, committed, differ, alone, running, committed, demote && was_running, received)
}

inline Forget()
{
    state_a = 0; state_b = 0; fault_a = false; fault_b = false; news = false; due = 0; pairs = 0; overall = 0; demand = false
}

inline Begin()
{
    Keep();
    fault = false; demote = false; received = false; apart = false; one_faulted = false
}

active proctype Device()
{
    do
    :: atomic {
        Choose();
        if :: demand = false :: demand = true fi;
        d_step {
            Begin();
            if
            :: running -> Judge(); Commit()
            :: else -> skip
            fi;
            if :: fault || demand -> Safe() :: else -> skip fi;
#ifdef PLANTED_WAY_OUT
            if :: !was_running && !fault && (state_a == state_b) -> running = true :: else -> skip fi;
#endif
            Observe(); Tell(0); Forget()
        }
    }
    :: atomic { /* Counts, guard or cycle differ (1), or a guard's view is stale (2). */
        if :: overall = 1 :: overall = 2 fi;
        d_step { Begin(); Safe(); Observe(); Tell(0); Forget() }
    }
    :: d_step { Begin(); Safe(); running = true; quiet = true; unlike_news = false; held_unlike = 0; one_alone = 0; Tell(1) }
    od
}
