// What is around the clip: the index, the clips before and after, and the other hits of a search there.

import {at} from '../shared/dom.js';
import {scaled} from '../shared/shapes.js';
import {seenOf} from '../shared/seen.js';
import {readAddress} from './address.js';
import {numberOf} from './events.js';
import {tell} from './messages.js';
import {isPlaying} from './player.js';
import {set, state} from './state.js';

/** What led here; it stays when the address leads elsewhere in the page. */
const arrived = readAddress(location.hash);
const hasHits = arrived.nth !== null;

/**
 * The address of the index that leads somewhere else from here.
 * @param {Record<string, string>} parts
 */
const indexAddress = parts => {
    const {index} = state.data;
    const all = new URLSearchParams(arrived.search);
    for (const [name, value] of Object.entries(parts)) all.set(name, value);
    return index ? `${index.url}#${all}` : '';
};

/** The event from which the next hit is counted. */
const hitNumber = () => String(arrived.number ?? (state.chosen === null ? '' : numberOf(state.events, state.chosen)));

/**
 * The hit beside this one, or else the clip: the index knows which that is, as this page was made before it was there.
 * @param {number} by 1 = the next, -1 = the one before
 * @param {boolean} [all] whether the hits follow by themselves
 */
function addressBeside(by, all = arrived.all) {
    const {clip} = state.data.index ?? {clip: ''};
    if (!hasHits) return indexAddress({[by > 0 ? 'after' : 'before']: clip});
    return indexAddress({hit: clip, event: hitNumber(), go: String(by), ...all && {all: ''}});
}

/** @param {number} by 1 = the next, -1 = the one before */
function goBeside(by) {
    if (state.data.index) location.replace(addressBeside(by));
}

/** Marks the end of the hits, or of the clips: the index has led back. */
function tellEnd() {
    const {ended} = arrived;
    if (ended === null) return;
    const link = at(ended > 0 ? 'later' : 'earlier');
    link.removeAttribute('href');
    link.setAttribute('aria-disabled', 'true');
    const what = hasHits ? 'hit' : arrived.search ? 'clip that was asked for' : 'clip of this camera with a picture';
    tell(ended > 0 ? `This is the last ${what}.` : `This is the first ${what}.`);
}

/** Links to the index, and what the index needs to know: that somebody has seen the clip. */
export function linkIndex() {
    const {index} = state.data;
    if (!index) return;
    at('toindex', HTMLAnchorElement).href = indexAddress({clip: index.clip, ...hasHits && {event: hitNumber()}});
    for (const [id, by] of /** @type {[string, number][]} */ ([['earlier', -1], ['later', 1]])) {
        const link = at(id, HTMLAnchorElement);
        link.href = addressBeside(by);
        if (hasHits) link.textContent = by < 0 ? '◀ Hit' : 'Hit ▶';
        link.title = `${hasHits ? by < 0 ? 'Previous hit' : 'Next hit' : by < 0 ? 'Earlier clip' : 'Later clip'} (${by < 0 ? 'B' : 'N'})`;
        link.addEventListener('click', event => {
            if (event.ctrlKey || event.metaKey || event.shiftKey || !link.href) return;
            event.preventDefault();
            goBeside(by);
        });
    }
    at('nth').textContent = hasHits ? `${arrived.nth} of ${arrived.of}` : '';
    at('around').hidden = false;
    seenOf(index.url).see({url: index.clip});
    tellEnd();
}

/** The place that the index searched for. */
export function takeArrival() {
    if (arrived.place) set({asked: scaled(arrived.place, 1 / 1000)});
}

const mostPlayed = 8;  // seconds of a hit, if all are played

/**
 * The last frame that is played of a hit; of an event that nobody searched for, its last.
 * @param {number} place of the event
 */
export function endOfHit(place) {
    const {events, time} = state;
    const {last} = events[place];
    return arrived.all && arrived.seconds !== null ? Math.min(last, time.frameAt(arrived.seconds + mostPlayed)) : last;
}

let plays = false;

/** After the end of a hit, the next one follows if all are to be played. */
export function playOn() {
    const {chosen, events, now} = state;
    const wasPlaying = plays;
    plays = isPlaying();
    if (!arrived.all || !wasPlaying || plays || chosen === null || numberOf(events, chosen) !== arrived.number) return;
    if (now >= endOfHit(chosen)) goBeside(1);
}

export function listenToNeighbours() {
    document.addEventListener('keydown', event => {
        if (event.ctrlKey || event.altKey || event.metaKey || !(event.target instanceof Element) || event.target.closest('input, select, textarea')) return;
        const by = {n: 1, b: -1}[event.key.toLowerCase()];
        if (by === undefined) return;
        event.preventDefault();
        if (arrived.ended === by) tellEnd();
        else goBeside(by);
    });
}
