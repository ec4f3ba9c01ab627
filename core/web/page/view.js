// Zoom and pan of the picture; a click plays what it shows.

import {at, sharesWithin} from '../shared/dom.js';
import {choose} from './choice.js';
import {numberOf} from './events.js';
import {picture} from './picture.js';
import {shownAt} from './pixels.js';
import {bringIntoSight, show} from './player.js';
import {point} from './pointing.js';
import {say} from './messages.js';
import {pictureSize, set, state} from './state.js';
import {placed, wheelZooms, zoomedAbout} from './zoom.js';

export const view = at('view');
const stage = at('stage');

const placement = () => placed({size: pictureSize, room: state.room, contents: state.contents, scale: state.scale, middle: state.middle});

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
 * The event whose portrait or number is there; the last drawn is on top.
 * @param {MouseEvent} event
 */
function overlaidAt({clientX, clientY}) {
    for (const element of [...at('letters').querySelectorAll(':scope > [data-event]')].reverse()) {
        for (const part of [element, element.querySelector('.caption')]) {
            const box = part?.getBoundingClientRect();
            if (box && clientX >= box.left && clientX < box.right && clientY >= box.top && clientY < box.bottom) return Number(element.getAttribute('data-event'));
        }
    }
    return null;
}

/** @param {MouseEvent} event */
function shownUnder(event) {
    const place = overlaidAt(event);
    if (place !== null) return {frame: state.events[place].first, event: place};
    const [x, y] = sharesWithin(picture, event).map((share, k) => share * pictureSize[k]);
    return shownAt(state.pixels, x, y);
}

/**
 * Pointers that are down, and where they are.
 * @type {Map<number, {x: number, y: number}>}
 */
const fingers = new Map();
/**
 * Where the first went down.
 * @type {{x: number, y: number, drag: boolean} | null}
 */
let press = null;

/** The middle of two fingers, and how far they are apart. */
function spreadOf() {
    const [a, b] = [...fingers.values()];
    return {x: (a.x + b.x) / 2, y: (a.y + b.y) / 2, apart: Math.max(1, Math.hypot(a.x - b.x, a.y - b.y))};
}

/** @param {Event} event */
const isOnButton = event => event.target instanceof Element && event.target.closest('button') !== null;

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
            pan(byX, byY);
            return point(null);
        }
    }
    const shown = isOnButton(event) ? {frame: null, event: null} : shownUnder(event);
    point(shown.frame, event.clientX, event.clientY, shown.event);
}

/** @param {PointerEvent} event */
function lift(event) {
    fingers.delete(event.pointerId);
    view.classList.remove('dragging');
    if (fingers.size === 0 && event.type === 'pointercancel') press = null;
}

/**
 * A click comes last, after all that a finger sends for a mouse: the page may scroll now.
 * @param {MouseEvent} event
 */
function playUnder(event) {
    const {frame, event: place} = shownUnder(event);
    if (frame === null) {
        choose(null);  // a tap on nothing shows all again
        return;
    }
    set({touring: false});
    choose(place);
    show(frame, true, {until: place === null ? null : state.events[place].last});
    bringIntoSight();
    point(null);  // what follows in the picture is to be seen
    say('Plays from ' + state.time.clockOf(state.time.secondsOf(frame)) + (place === null ? '' : `, event ${numberOf(state.events, place)}`));
}

/** The buttons of a narrow window have a row of their own. */
export const roomOf = () => [view.clientWidth, view.clientHeight - parseFloat(getComputedStyle(view).getPropertyValue('--buttons') || '0')];

export function listenToView() {
    view.addEventListener('pointerdown', event => {
        if (event.button !== 0 || isOnButton(event)) return;
        fingers.set(event.pointerId, {x: event.clientX, y: event.clientY});
        press = {x: event.clientX, y: event.clientY, drag: fingers.size > 1};
        view.setPointerCapture(event.pointerId);
    });
    view.addEventListener('pointermove', move);
    view.addEventListener('pointerup', lift);
    view.addEventListener('pointercancel', lift);
    view.addEventListener('click', event => {
        if (press && !press.drag && !isOnButton(event)) playUnder(event);
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
    at('whole').addEventListener('click', showWhole);
    new ResizeObserver(() => set({room: roomOf()})).observe(view);
}
