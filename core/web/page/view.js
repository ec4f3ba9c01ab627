// Zoom and pan of the picture; a click plays what it shows.

import {at, sharesWithin} from '../shared/dom.js';
import {boundsOf} from './arc.js';
import {choose} from './choice.js';
import {numberOf} from './events.js';
import {wantedEvents} from './filters.js';
import {picture} from './picture.js';
import {meantByFinger, shownNear} from './pixels.js';
import {bringIntoSight, show} from './player.js';
import {point} from './pointing.js';
import {say} from './messages.js';
import {pictureSize, set, state} from './state.js';
import {dragNow, heldAt, startTurning, turnBack, turnBy} from './turning.js';
import {contentsNow, overlayNow} from './turned.js';
import {pickedAround} from './volume_view.js';
import {askWhich} from './which.js';
import {placed, wheelZooms, zoomedAbout} from './zoom.js';

export const view = at('view');
const stage = at('stage');

const placement = () => placed({size: pictureSize, room: state.room, contents: contentsNow(), scale: state.scale, middle: state.middle});

export function drawStage() {
    const {size, middle, corner} = placement();
    state.middle = middle;  // so that the next move begins at the border, not beyond it
    view.style.touchAction = state.scale > 1 ? 'none' : 'pan-y';
    stage.style.width = size[0] + 'px';
    stage.style.height = size[1] + 'px';
    stage.style.transform = `translate(${corner[0]}px, ${corner[1]}px)`;
    const {contents: [left, top, right, bottom]} = state;
    view.style.setProperty('--contents', String((right - left) / (bottom - top)));
    set({stageWidth: size[0]});
}

/**
 * Zooms so that what is under a point of the window stays there; without a point, the middle.
 * @param {number} factor
 * @param {number} [x]
 * @param {number} [y]
 */
export function zoom(factor, x, y) {
    const about = x === undefined || y === undefined ? state.middle : sharesWithin(picture, {clientX: x, clientY: y});
    set(zoomedAbout(state, factor, about));
}

/**
 * @param {number} x pixels of the window
 * @param {number} y
 */
export function pan(x, y) {
    const box = picture.getBoundingClientRect();
    set({middle: [state.middle[0] - x / box.width, state.middle[1] - y / box.height]});
}

export const showWhole = () => set({scale: 1});

/**
 * The portrait or the number that is there; the last drawn is on top.
 * @param {MouseEvent} event
 * @returns {{event: number, isPortrait: boolean} | null}
 */
function overlaidAt({clientX, clientY}) {
    for (const element of [...at('letters').querySelectorAll(':scope > [data-event]')].reverse()) {
        for (const part of [element, element.querySelector('.caption')]) {
            const box = part?.getBoundingClientRect();
            if (box && clientX >= box.left && clientX < box.right && clientY >= box.top && clientY < box.bottom) {
                return {event: Number(element.getAttribute('data-event')), isPortrait: element.classList.contains('portrait')};
            }
        }
    }
    return null;
}

/** How far it may be from what is meant, in pixels of the screen. */
const reaches = {mouse: 4, finger: 12};

/** @typedef {{frame: number | null, event: number | null}} Shown null = none */

/**
 * In pixels of the picture.
 * @param {MouseEvent} event
 */
const pixelUnder = event => sharesWithin(picture, event).map((share, k) => share * pictureSize[k]);

/**
 * In pixels of the view.
 * @param {MouseEvent} event
 */
const placeInView = event => sharesWithin(at('volume'), event).map((share, k) => share * [view.clientWidth, view.clientHeight][k]);

/**
 * @param {MouseEvent} event
 * @param {number} reach pixels of the screen
 */
function nearOf(event, reach) {
    if (!state.turns) {
        const [x, y] = pixelUnder(event);
        return shownNear(state.pixels, x, y, reach * pictureSize[0] / state.stageWidth);
    }
    const [x, y] = placeInView(event);
    return shownNear(pickedAround(x, y, reach), reach, reach, reach);
}

/**
 * What may be meant at a point, the first most of all; never nothing. A mouse means what is nearest.
 * @param {MouseEvent} event
 * @param {boolean} byFinger
 * @returns {Shown[]}
 */
export function meantAt(event, byFinger) {
    const over = overlaidAt(event);
    const numbered = over ? [{frame: state.events[over.event].first, event: over.event}] : [];
    if (over && (over.isPortrait || !byFinger)) return numbered;
    const near = nearOf(event, byFinger ? reaches.finger : reaches.mouse);
    const meant = byFinger ? meantByFinger([...numbered, ...near.filter(one => one.event !== over?.event)], wantedEvents()) : near.slice(0, 1);
    return meant.length ? meant : [{frame: null, event: null}];
}

/**
 * Pointers that are down, and where they are.
 * @type {Map<number, {x: number, y: number}>}
 */
const fingers = new Map();
/**
 * Where the first went down.
 * @type {{x: number, y: number, drag: boolean, byFinger: boolean, held: number[] | null} | null}
 */
let press = null;

/** The middle of two fingers, and how far they are apart. */
function spreadOf() {
    const [a, b] = [...fingers.values()];
    return {x: (a.x + b.x) / 2, y: (a.y + b.y) / 2, apart: Math.max(1, Math.hypot(a.x - b.x, a.y - b.y))};
}

/** @param {Event} event */
const isOnButton = event => event.target instanceof Element && event.target.closest('button, select, input') !== null;

/** @param {PointerEvent} event */
function move(event) {
    const finger = fingers.get(event.pointerId);
    if (finger && fingers.size === 2) {
        const before = spreadOf();
        Object.assign(finger, {x: event.clientX, y: event.clientY});
        const after = spreadOf();
        zoom(after.apart / before.apart, before.x, before.y);
        pan(after.x - before.x, after.y - before.y);
        return point(null);
    }
    if (finger && press) {
        const [byX, byY] = [event.clientX - finger.x, event.clientY - finger.y];
        press.drag ||= Math.hypot(event.clientX - press.x, event.clientY - press.y) > 4;
        if (press.drag) {
            Object.assign(finger, {x: event.clientX, y: event.clientY});
            view.classList.add('dragging');
            endFirst();
            if (press.held) dragNow(press.held, pixelUnder(event));
            else if (event.shiftKey || !startTurning()) pan(byX, byY);
            else turnBy(byX, byY);
            return point(null);
        }
    }
    const [shown] = isOnButton(event) ? [{frame: null, event: null}] : meantAt(event, event.pointerType === 'touch');
    point(shown.frame, event.clientX, event.clientY, shown.event);
}

/** @param {PointerEvent} event */
function lift(event) {
    fingers.delete(event.pointerId);
    view.classList.remove('dragging');
    if (fingers.size === 0 && event.type === 'pointercancel') press = null;
}

/**
 * Plays from a moment of an event, to its end.
 * @param {{frame: number, event: number | null}} shown
 */
export function playCandidate({frame, event: place}) {
    set({touring: false});
    choose(place);
    show(frame, true, {until: place === null ? null : state.events[place].last});
    bringIntoSight();
    point(null);  // what follows in the picture is to be seen
    say('Plays from ' + state.time.clockOf(state.time.secondsOf(frame)) + (place === null ? '' : `, event ${numberOf(state.events, place)}`));
}

/**
 * A click comes last, after all that a finger sends for a mouse: the page may scroll now.
 * @param {MouseEvent} event
 * @param {boolean} byFinger
 */
function playUnder(event, byFinger) {
    const meant = meantAt(event, byFinger);
    const [{frame, event: place}] = meant;
    if (frame === null) return choose(null);  // a tap on nothing shows all again
    if (meant.length === 1) return playCandidate({frame, event: place});
    point(null);
    askWhich(/** @type {import('./which.js').Candidate[]} */ (meant), event);
}

/** Legend and buttons have a row of their own, and what it all means another. */
export function roomOf() {
    const style = getComputedStyle(view);
    const rows = ['--buttons', '--meaning'].reduce((sum, name) => sum + (parseFloat(style.getPropertyValue(name)) || 0), 0);
    return [view.clientWidth, view.clientHeight - rows].map(side => Math.max(1, side));
}

/**
 * Where the frame of now is held; null = the pointer is on something else.
 * @param {MouseEvent} event
 */
function heldUnder(event) {
    if (!state.turns || event.shiftKey) return null;
    const [x, y] = placeInView(event);
    return pickedAround(x, y, 0).isNow ? heldAt(pixelUnder(event)) : null;
}

/** All of the picture, from its own angle. */
function showDefault() {
    showWhole();
    turnBack();
}

const kept = 'vvr-dragged';  // the name under which the browser keeps that nothing needs to be said any more

/** What the volume is, and which of its ends is which as it is seen now. */
export function drawMeaning() {
    const {data: {settings}, piece, stageWidth, turns, unbent} = state;
    const {sections} = overlayNow();
    const isArc = settings.layout === 'horseshoe';
    at('bent').textContent = isArc ? 'Film, bent' : 'Volume';
    if (!sections.length) return;
    const [begin, end] = [sections[0], sections[sections.length - 1]].map(([, ...xy]) => (xy[0] + xy[2] + xy[4] + xy[6]) / 4 / pictureSize[0] * stageWidth);
    const ends = begin < end ? ['left', 'right'] : ['right', 'left'];
    const told = Math.abs(end - begin) < 60 ? '' : `: it starts at the ${ends[0]} and ends at the ${ends[1]}`;
    at('what').textContent = (isArc && !unbent ? 'The arc' : 'The box') + ` is ${turns && piece ? 'a piece of ' : ''}the film${isArc && !unbent ? ', bent' : ''}${told}.`;
}

/** A phone's tab of the volume shows what is there. */
export function drawGlance() {
    const {sections} = state.data.overlay;
    const glance = at('glance', HTMLCanvasElement);
    glance.hidden = !sections.length;
    if (glance.hidden || !picture.complete) return;
    const [left, top, right, bottom] = boundsOf(sections);
    [glance.width, glance.height] = [Math.round((right - left) / (bottom - top) * 84), 84];
    glance.getContext('2d')?.drawImage(picture, left, top, right - left, bottom - top, 0, 0, glance.width, glance.height);
}

/** What to do here is said until it has been done. */
export function drawFirst() {
    at('first').hidden = !state.isFirst;
    at('firstturn').hidden = !state.turnable;
}

function endFirst() {
    if (!state.isFirst) return;
    set({isFirst: false});
    try {
        localStorage.setItem(kept, '1');
    } catch {
        // It is said again then.
    }
}

export function listenToView() {
    try {
        set({isFirst: !localStorage.getItem(kept)});
    } catch {
        set({isFirst: true});
    }
    set({room: roomOf()});
    view.addEventListener('pointerdown', event => {
        if (event.button !== 0 || isOnButton(event)) return;
        fingers.set(event.pointerId, {x: event.clientX, y: event.clientY});
        press = {x: event.clientX, y: event.clientY, drag: fingers.size > 1, byFinger: event.pointerType === 'touch', held: heldUnder(event)};
        view.setPointerCapture(event.pointerId);
    });
    view.addEventListener('pointermove', move);
    view.addEventListener('pointerup', lift);
    view.addEventListener('pointercancel', lift);
    view.addEventListener('click', event => {
        if (press && !press.drag && !isOnButton(event)) playUnder(event, press.byFinger);
        press = null;
    });
    view.addEventListener('pointerleave', () => point(null));
    view.addEventListener('wheel', event => {
        if (!wheelZooms(event)) return;
        event.preventDefault();
        zoom(Math.exp(-event.deltaY * (event.deltaMode === 1 ? 0.04 : 0.0016)), event.clientX, event.clientY);
    }, {passive: false});
    at('closer').addEventListener('click', () => zoom(1.5));
    at('farther').addEventListener('click', () => zoom(1 / 1.5));
    at('whole').addEventListener('click', showDefault);
    view.addEventListener('dblclick', event => { if (!isOnButton(event)) showDefault(); });
    new ResizeObserver(() => { if (view.clientWidth > 0) set({room: roomOf()}); }).observe(view);  // a full screen hides it
}
