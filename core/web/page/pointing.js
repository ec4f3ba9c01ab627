// Pointing at a moment: its time, and a thumbnail.

import {at} from '../shared/dom.js';
import {clamp} from '../shared/text.js';
import {deedOf, numberOf, stillNear} from './events.js';
import {goToFrame, hasFrame, isPlaying} from './player.js';
import {putRing} from './ring.js';
import {set, state} from './state.js';

export const tip = at('tip');
export const peeker = at('peeker', HTMLVideoElement);

/**
 * @param {number | null} frame null = at nothing
 * @param {number} [x] in the window
 * @param {number} [y]
 * @param {number | null} [event]
 * @param {string} [note] before the time
 */
export function point(frame, x = 0, y = 0, event = null, note = '') {
    set({pointed: frame === null ? null : {frame, x, y, note}, lightened: event});
}

/** The player shows what is pointed at: a still at once, the frame itself when the film has it. */
export function drawPeek() {
    const {pointed, time, film, parts} = state;
    if (!pointed) return;
    const nearest = stillNear(parts.stills, pointed.frame);
    if (!nearest) return peekAt(pointed.frame);
    const apart = Math.abs(time.secondsOf(nearest.frame) - time.secondsOf(pointed.frame));
    at('about').textContent = film || apart < 0.5 ? '' : 'picture of ' + time.clockOf(time.secondsOf(nearest.frame));
    at('peek', HTMLImageElement).src = nearest.src;
    if (!hasFrame(pointed.frame)) peeker.hidden = true;
    peekAt(pointed.frame);
}

export function drawTip() {
    const {pointed, lightened, time, film, parts, events} = state;
    tip.hidden = !pointed;
    at('peeked').hidden = !pointed || isPlaying();
    if (!pointed) return;
    putRing(at('peekring'), lightened, film ? pointed.frame : stillNear(parts.stills, pointed.frame)?.frame ?? pointed.frame);
    const named = lightened === null ? '' : ` · ${numberOf(events, lightened)} ${deedOf(events[lightened])}`;
    at('when').textContent = pointed.note + time.clockOf(time.secondsOf(pointed.frame)) + named;
    placeTip(pointed.x, pointed.y);
}

/**
 * One line beside the pointer, on the side where the picture has less to show.
 * @param {number} x
 * @param {number} y
 */
function placeTip(x, y) {
    const box = tip.getBoundingClientRect();
    const whole = at('view').getBoundingClientRect();
    const wantsLeft = x < whole.left + whole.width / 2;
    const isLeft = wantsLeft && x - 18 - box.width > 4 || x + 18 + box.width > innerWidth;
    const left = clamp(isLeft ? x - 18 - box.width : x + 18, 4, Math.max(4, innerWidth - box.width - 4));
    tip.style.transform = `translate(${left}px, ${clamp(y - box.height / 2, 4, innerHeight - box.height - 4)}px)`;
}

/**
 * One frame after the other: the next one when the player is there.
 * @param {number} frame
 */
function peekAt(frame) {
    if (!state.film || !hasFrame(frame) || peeker.readyState < 1 || peeker.seeking) return;
    peeker.dataset.frame = String(frame);
    goToFrame(peeker, frame);
}

export function openPeeker() {
    if (state.film?.src) peeker.src = state.film.src;
}

export function listenToPeeker() {
    peeker.hidden = true;
    peeker.addEventListener('seeked', () => {
        if (Number(peeker.dataset.frame) === state.pointed?.frame) peeker.hidden = false;
        else if (state.pointed) peekAt(state.pointed.frame);
    });
    peeker.addEventListener('loadeddata', () => { if (state.pointed) peekAt(state.pointed.frame); });
}
