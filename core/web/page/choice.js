// The chosen event.

import {at} from '../shared/dom.js';
import {addressWith, readAddress} from './address.js';
import {endOfHit} from './around.js';
import {deedOf, factsOf, nameOf, numberOf, placeBeside, placeOfNumber} from './events.js';
import {answerOf, listedEvents, wantedEvents} from './filters.js';
import {ofEvent} from './looks.js';
import {say, tell} from './messages.js';
import {bringIntoSight, isPlaying, show} from './player.js';
import {kindOf, set, state} from './state.js';
import {clamp} from '../shared/text.js';

/** @param {number | null} place */
export const rowOf = place => place === null ? null : /** @type {HTMLButtonElement | null} */ (at('events').querySelector(`.row[data-event="${place}"]`));

/**
 * Lights up one event, or all of them for null.
 * @param {number | null} place
 */
export function choose(place) {
    set({chosen: place, until: null, touring: false});
    rowOf(place)?.scrollIntoView({block: 'nearest'});
    keepInAddress();
}

/** What is chosen is among what is found: else nothing would be lit. */
export function leaveUnfound() {
    if (state.chosen !== null && !wantedEvents().includes(state.chosen)) choose(null);
}

/** So that going back, and a reload, find the event again. */
function keepInAddress() {
    const hash = addressWith(location.hash, state.chosen === null ? null : numberOf(state.events, state.chosen));
    if (location.hash !== hash) history.replaceState(null, '', hash || location.pathname + location.search);
}

/** Goes to where the address leads. */
export function followAddress() {
    const {number, seconds, plays} = readAddress(location.hash);
    const {time, events} = state;
    const place = number === null ? null : placeOfNumber(events, number);
    const frame = seconds === null ? null : time.frameAt(clamp(seconds, time.begins, time.secondsOf(time.lastFrame)));
    if (place !== null) choose(place);
    else if (number !== null) tell(`This page has no event ${number}.`);
    const until = place === null ? null : endOfHit(place);
    const first = frame ?? (place === null ? null : events[place].first);
    if (first !== null) show(first, plays, {until});
}

/**
 * Plays an event, and stops at its end or begins again.
 * @param {number} place
 */
export function playEvent(place) {
    choose(place);
    show(state.events[place].first, true, {until: state.events[place].last});
    bringIntoSight();
}

/**
 * The next event that is wanted, or the one before; null = there is none.
 * @param {number} by 1 or -1
 */
export function besideNow(by) {
    const isListed = state.chosen !== null && wantedEvents().includes(state.chosen);
    return placeBeside(state.events, isListed ? listedEvents() : wantedEvents(), state.chosen, state.now, by);
}

/** The buttons say where they lead; at an end, to its event again. */
export function drawBeside() {
    for (const [id, by, words, end, key] of /** @type {[string, number, string, string, string][]} */ ([
        ['previous', -1, 'Previous event', 'First event again', '←'], ['next', 1, 'Next event', 'Last event again', '→']])) {
        const place = besideNow(by);
        const number = place === null ? '' : String(numberOf(state.events, place));
        const name = (place !== null && place === state.chosen ? end : words) + (number && `: ${number}`);
        Object.assign(at(id), {ariaLabel: name, title: `${name} (${key})`});
        const badge = /** @type {HTMLElement} */ (at(id).querySelector('.number'));
        badge.hidden = place === null;
        badge.textContent = number;
        if (place !== null) ofEvent(badge, place);
    }
}

/**
 * Goes there, and shows its first moment.
 * @param {number} by 1 or -1
 */
export function step(by) {
    const {events, time} = state;
    const place = besideNow(by);
    if (place === null) return;
    const plays = isPlaying();
    const {touring} = state;
    choose(place);
    const event = events[place];
    show(event.first, plays, {until: event.last, touring: touring && plays});
    if (document.activeElement?.closest('#events')) rowOf(place)?.focus();
    const facts = [deedOf(event), ...factsOf(event, kindOf(event.kind), answerOf(event))].join(' · ');
    say(`${nameOf(events, place, listedEvents())}, from ${time.clockOf(event.begin)} to ${time.clockOf(event.end)}, ${facts}`);
}
