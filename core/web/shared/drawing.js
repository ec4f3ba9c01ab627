// Drawing a rectangle or a line over a picture, with the pointer or with keys.

import {appendShape, element, sharesWithin} from './dom.js';
import {firstShape, inThousandths, movedShape, scaled} from './shapes.js';
import {clamp} from './text.js';

/** @typedef {import('./shapes.js').Shape} Shape */

const ends = /** @type {const} */ (['from', 'to']);

/**
 * The end of a shape that an element moves; null = none.
 * @param {EventTarget | null} target
 */
function endOf(target) {
    const name = target instanceof SVGElement ? target.dataset.end : undefined;
    return ends.find(end => end === name) ?? null;
}

/**
 * Draws a shape into an SVG over a picture; null = nothing. Unless it is fixed, its ends can be dragged, and moved by keys.
 * @param {SVGElement} surface
 * @param {Shape | null} shape
 * @param {number[]} size of the picture, in the unit of the SVG
 * @param {number} whole the picture's width and height in the unit of shapes
 * @param {boolean} [isFixed] whether nobody can move it
 */
export function drawShape(surface, shape, [width, height], whole, isFixed = false) {
    const focused = surface.contains(document.activeElement) ? endOf(document.activeElement) : null;
    surface.setAttribute('viewBox', `0 0 ${width} ${height}`);
    surface.replaceChildren();
    if (!shape) return;
    const [[x, y], [toX, toY]] = [shape.from, shape.to].map(([across, down]) => [across / whole * width, down / whole * height]);
    if (shape.kind === 'box') {
        appendShape('rect', {x: Math.min(x, toX), y: Math.min(y, toY), width: Math.abs(toX - x), height: Math.abs(toY - y)}, surface);
    } else {
        appendShape('line', {x1: x, y1: y, x2: toX, y2: toY}, surface);
    }
    if (isFixed) return;
    [[x, y], [toX, toY]].forEach(([across, down], k) => {
        const words = shape.kind === 'box' ? 'Corner' : 'End';
        const [percentX, percentY] = [across / width, down / height].map(share => Math.round(100 * share));
        const handle = appendShape('path', {
            class: 'handle', d: `M${across} ${down}h0.001`, tabindex: 0, role: 'button', 'data-end': ends[k],
            'aria-label': `${words} ${k + 1}: ${percentX} % from the left, ${percentY} % from the top. Arrow keys move it, Enter searches.`,
        }, surface);
        if (focused === ends[k] && handle instanceof SVGElement) handle.focus({preventScroll: true});
    });
}

/**
 * A button that shows what is searched in a small picture, and ends the search.
 * @param {HTMLElement} button
 * @param {Shape | null} shape null = nothing is searched
 * @param {string} src the picture
 * @param {number} whole the picture's width and height in the unit of shapes
 */
export function drawChip(button, shape, src, whole) {
    button.hidden = shape === null;
    if (!shape) return;
    const picture = element('span', 'place');
    const marks = document.createElementNS('http://www.w3.org/2000/svg', 'svg');
    marks.setAttribute('preserveAspectRatio', 'none');
    drawShape(marks, shape, [1000, 1000], whole, true);
    picture.append(Object.assign(element('img'), {src, alt: ''}), marks);
    button.replaceChildren(picture, shape.kind === 'box' ? 'In this area' : 'Across this line', element('span', 'end', '✕'));
    button.title = 'Search everywhere again';
}

/**
 * @typedef {object} Drawing
 * @property {() => Shape['kind'] | null} kind what a drag draws; null = nothing
 * @property {() => Shape | null} shape that is drawn, which keys move
 * @property {(shape: Shape | null) => void} shows the shape so far; null = none
 * @property {(shape: Shape | null) => void} asks the shape when it is drawn
 */

/**
 * Lets drags on a surface draw. A click draws nothing.
 * @param {SVGElement} surface
 * @param {number} whole the picture's width and height in the unit of shapes
 * @param {Drawing} how
 */
function drawByPointer(surface, whole, {kind, shape, shows, asks}) {
    /** @type {((to: number[]) => Shape) | null} */
    let drawn = null;
    const pointAt = (/** @type {PointerEvent} */ event) => sharesWithin(surface, event).map(share => clamp(share, 0, 1) * whole);
    surface.addEventListener('pointerdown', event => {
        const [wanted, end, from, before] = [kind(), endOf(event.target), pointAt(event), shape()];
        if (event.button !== 0 || (!wanted && !end)) return;
        event.preventDefault();
        if (end && before) drawn = to => ({...before, [end]: to});
        else if (wanted) drawn = to => ({kind: wanted, from, to});
        surface.setPointerCapture(event.pointerId);
    });
    surface.addEventListener('pointermove', event => { if (drawn) shows(drawn(pointAt(event))); });
    surface.addEventListener('pointerup', event => {
        if (!drawn) return;
        const done = drawn(pointAt(event));
        drawn = null;
        const far = Math.hypot(done.to[0] - done.from[0], done.to[1] - done.from[1]);
        asks(far < 0.01 * whole ? null : done);
    });
    surface.addEventListener('pointercancel', () => {
        drawn = null;
        shows(null);
    });
}

/** @type {Record<string, number[]>} */
const steps = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1]};

/**
 * Arrow keys move an end that has the focus, or the shape; Enter asks, Escape takes back what was moved.
 * @param {SVGElement} surface
 * @param {number} whole the picture's width and height in the unit of shapes
 * @param {Drawing} how
 */
function drawByKeys(surface, whole, {shape, shows, asks}) {
    surface.addEventListener('keydown', event => {
        const drawn = shape();
        if (!drawn || event.ctrlKey || event.altKey || event.metaKey) return;
        const step = steps[event.key];
        if (step) shows(movedShape(drawn, endOf(event.target), step.map(by => by * whole * (event.shiftKey ? 0.05 : 0.01)), whole));
        else if (event.key === 'Enter' || event.key === ' ') asks(drawn);
        else if (event.key === 'Escape') shows(null);
        else return;
        event.preventDefault();
        event.stopPropagation();
    });
}

/**
 * Lets people draw on a surface. What is asked is what addresses can say, so that a link and a reload answer the same.
 * @param {SVGElement} surface
 * @param {number} whole the picture's width and height in the unit of shapes
 * @param {Drawing} how
 */
export function letDraw(surface, whole, how) {
    const asks = (/** @type {Shape | null} */ shape) => how.asks(shape && scaled(inThousandths(shape, whole), whole / 1000));
    drawByPointer(surface, whole, {...how, asks});
    drawByKeys(surface, whole, {...how, asks});
}

/**
 * Begins a shape in the middle for those who draw by keys: its first end gets the focus.
 * @param {SVGElement} surface
 * @param {number} whole the picture's width and height in the unit of shapes
 * @param {Shape['kind']} kind
 * @param {(shape: Shape) => void} shows
 */
export function beginByKeys(surface, whole, kind, shows) {
    shows(firstShape(kind, whole));
    /** @type {SVGElement | null} */ (surface.querySelector('[data-end]'))?.focus();
}

/** Whether a click comes from the keyboard. */
export const isByKeyboard = (/** @type {MouseEvent} */ event) => event.detail === 0;
