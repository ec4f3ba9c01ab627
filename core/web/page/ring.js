// Rings about where an event is in a frame.

import {at} from '../shared/dom.js';
import {pointAt, stillNear} from './events.js';
import {ofEvent} from './looks.js';
import {showsStill} from './player.js';
import {state} from './state.js';

/**
 * @param {HTMLElement} ring
 * @param {number | null} event
 * @param {number} frame
 */
export function putRing(ring, event, frame) {
    const point = event === null ? null : pointAt(state.events[event], frame);
    ring.hidden = !point;
    if (!point || event === null) return;
    ofEvent(ring, event);
    ring.style.left = point[0] * 100 + '%';
    ring.style.top = point[1] * 100 + '%';
}

/** A ring in the player about the chosen event. */
export function drawRing() {
    const {now, chosen, parts} = state;
    putRing(at('ring'), chosen, showsStill() ? stillNear(parts.stills, now)?.frame ?? now : now);
}
