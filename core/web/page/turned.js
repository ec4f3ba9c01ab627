// Where things are in the picture as it is turned.

import {derived} from '../shared/state.js';
import {ticksOf} from '../shared/time_axis.js';
import {clamp} from '../shared/text.js';
import {boundsOf} from './arc.js';
import {pixelOf} from './camera.js';
import {framingOf, timesOf} from './framing.js';
import {corners, markAt} from './layouts.js';
import {pictureSize, state} from './state.js';

/**
 * @typedef {import('./data.js').PageEvent} PageEvent
 * @typedef {import('./layouts.js').Point} Point
 */

/** The volume of the page, once it has come. */
const volumeNow = () => /** @type {import('./data.js').TurningVolume} */ (state.parts.volume);

/** @returns {import('./layouts.js').LayoutName} */
export const layoutNow = () => state.unbent ? 'box' : volumeNow().layout;

const times = derived(() => [state.parts.volume], () => timesOf(volumeNow()));

export const framingNow = derived(() => [state.parts.volume, layoutNow(), ...state.angle], () => framingOf(volumeNow(), layoutNow(), state.angle, pictureSize));

/**
 * The piece of time that is shown, as t of the whole.
 * @returns {[number, number]}
 */
export function pieceNow() {
    if (!state.piece) return [0, 1];
    const [from, to] = state.piece.map(seconds => times().tOf(state.time.frameAt(seconds)));
    return [from, Math.max(to, from + 1e-3)];
}

/**
 * What the ends of the layout show.
 * @returns {[number, number]}
 */
export const bentNow = () => state.bends ? pieceNow() : [0, 1];

/**
 * t of the layout.
 * @param {number} frame
 */
export function tOf(frame) {
    const [from, to] = bentNow();
    return (times().tOf(frame) - from) / (to - from);
}

/** @param {number} t of the layout */
export function frameAt(t) {
    const [from, to] = bentNow();
    return state.time.clamped(times().frameAt(from + t * (to - from)));
}

/**
 * The first and the last t of the layout that is shown.
 * @returns {[number, number]}
 */
export function shownNow() {
    const [[from, to], [first, last]] = [pieceNow(), bentNow()];
    return [(from - first) / (last - first), (to - first) / (last - first)];
}

/**
 * Whether a moment is in the piece of time that is shown.
 * @param {number} frame
 */
export const showsFrame = frame => isShown(tOf(frame));

/** @param {number} t of the layout */
const isShown = t => t >= shownNow()[0] - 1e-6 && t <= shownNow()[1] + 1e-6;

/**
 * Where a place of a frame is in C-space.
 * @param {number} frame
 * @param {number} x share of its width
 * @param {number} y
 * @returns {Point}
 */
export const placeOf = (frame, x, y) => [1 - x, 1 - y, tOf(frame)];

/**
 * In pixels of the picture.
 * @param {Point} place in C-space
 */
export const pixelAt = place => pixelOf(framingNow().camera, framingNow().pOf(place), pictureSize);

/**
 * An event's path in C-space, in steps so short that it is straight.
 * @param {Pick<PageEvent, 'path'>} event
 * @returns {Point[]}
 */
export function pathOf({path}) {
    /** @type {Point[]} */
    const places = [];
    for (const [frame, x, y] of path) {
        const to = placeOf(frame, x, y);
        if (!isShown(to[2])) continue;
        const from = places[places.length - 1];
        const steps = from ? Math.ceil((to[2] - from[2]) * 96) : 1;
        for (let k = 1; k < steps; ++k) places.push(from.map((value, axis) => value + k / steps * (to[axis] - value)));
        places.push(to);
    }
    return places;
}

/**
 * The times along the arc, in the layout: those of the picture; of a piece that has all of it, its own.
 * @returns {{t: number, text: string}[]}
 */
function notesNow() {
    const {data: {overlay}, time, piece, bends} = state;
    if (!piece || !bends) return overlay.notes;
    const [from, to] = piece;
    return ticksOf(from, to - from, 8, time.clock?.begin ?? 0).map(seconds => ({t: tOf(time.frameAt(seconds)), text: time.clockOf(seconds, false)}));
}

/** Where the volume is cut, in the layout. */
export const ticksNow = () => state.bends ? notesNow().map(({t}) => t) : volumeNow().ticks;

/**
 * The point of a path to which the picture's portrait has its line.
 * @param {{event: number, to: number[]}} portrait
 */
function anchorOf({event, to}) {
    const volume = volumeNow();
    const {camera, pOf} = framingOf(volume, volume.layout, volume.view, pictureSize);
    const {path, first, last} = state.events[event];
    let best = path[0];
    let nearest = Infinity;
    for (let k = 0; k <= 100; ++k) {
        const frame = first + (last - first) * k / 100;
        const after = path.find(point => point[0] >= frame) ?? path[path.length - 1];
        const [x, y] = pixelOf(camera, pOf([1 - after[1], 1 - after[2], times().tOf(frame)]), pictureSize);
        if (Math.hypot(x - to[0], y - to[1]) >= nearest) continue;
        [nearest, best] = [Math.hypot(x - to[0], y - to[1]), [frame, after[1], after[2]]];
    }
    return best;
}

const anchors = derived(() => [state.data.overlay, state.parts.volume], () => state.data.overlay.portraits.map(anchorOf));

/** How far it is turned away from the picture's own view: 0 = hardly, 1 = it is another one. */
function awayNow() {
    if (!state.turns) return 0;
    if (state.unbent || state.bends) return 1;
    return clamp((Math.max(...state.angle.map((value, k) => Math.abs(value - volumeNow().view[k]))) - 3) / 12, 0, 1);
}

/**
 * What lies over the picture.
 * @returns {import('./data.js').Overlay}
 */
const turnedOverlay = derived(() => [state.data.overlay, framingNow(), state.piece, state.bends], () => {
    const {overlay} = state.data;
    const {edge} = framingNow();
    const sections = Array.from({length: 193}, (_, k) => k / 192).filter(isShown)
        .map(t => [state.time.secondsOf(frameAt(t)), ...corners.flatMap(([x, y]) => pixelAt([x, y, t]))]);
    const notes = notesNow().filter(({t}) => isShown(t)).map(note => {
        const [begin, end] = markAt(edge, note.t).map(pixelAt);
        const out = end.map((value, k) => value - begin[k]);
        return {...note, at: end, out: out.map(value => value / Math.max(1e-6, Math.hypot(...out))), place: [...edge, note.t]};
    });
    const portraits = overlay.portraits.flatMap((portrait, k) => {
        const [frame, x, y] = anchors()[k];
        const place = placeOf(frame, x, y);
        return isShown(place[2]) ? [{...portrait, to: pixelAt(place), place}] : [];
    });
    // Portraits and map have their places around the picture's own view.
    return {...overlay, sections, notes, ...awayNow() ? {portraits: [], map: null} : {portraits}};
});

/** What lies over the picture or the volume, whichever is shown. */
export const overlayNow = () => state.turns ? turnedOverlay() : state.data.overlay;

const roomOfTimes = [56, 32];  // pixels of the screen beside the volume

/** What has to be in sight: the picture's contents; the further it is turned away, the more the volume alone. */
export const contentsNow = derived(() => [state.contents, ...state.room, overlayNow(), awayNow()], () => {
    if (!awayNow()) return state.contents;
    const [left, top, right, bottom] = boundsOf(overlayNow().sections);
    const scale = Math.min(...[right - left, bottom - top].map((side, k) => Math.max(40, state.room[k] - 2 * roomOfTimes[k]) / Math.max(1, side)));
    const [x, y] = roomOfTimes.map(side => side / scale);
    return [left - x, top - y, right + x, bottom + y].map((value, k) => state.contents[k] + awayNow() * (value - state.contents[k]));
});
