// Drawing a rectangle or a line over a picture with the pointer.

import {appendShape, sharesWithin} from './dom.js';
import {clamp} from './text.js';

/** @typedef {import('./shapes.js').Shape} Shape */

/**
 * Draws a shape into an SVG over a picture; null = nothing.
 * @param {SVGElement} surface
 * @param {Shape | null} shape
 * @param {number[]} size of the picture, in the unit of the SVG
 * @param {number} whole the picture's width and height in the unit of shapes
 */
export function drawShape(surface, shape, [width, height], whole) {
    surface.setAttribute('viewBox', `0 0 ${width} ${height}`);
    surface.replaceChildren();
    if (!shape) return;
    const [[x, y], [toX, toY]] = [shape.from, shape.to].map(([across, down]) => [across / whole * width, down / whole * height]);
    if (shape.kind === 'box') {
        appendShape('rect', {x: Math.min(x, toX), y: Math.min(y, toY), width: Math.abs(toX - x), height: Math.abs(toY - y)}, surface);
    } else {
        appendShape('line', {x1: x, y1: y, x2: toX, y2: toY}, surface);
    }
}

/**
 * Lets drags on a surface draw. A click draws nothing.
 * @param {SVGElement} surface
 * @param {number} whole the picture's width and height in the unit of shapes
 * @param {{kind: () => Shape['kind'] | null, shows: (shape: Shape | null) => void, asks: (shape: Shape | null) => void}} how
 *     kind: what a drag draws, null = nothing; shows: the shape so far, null = none; asks: the shape when it is drawn
 */
export function drawByPointer(surface, whole, {kind, shows, asks}) {
    /** @type {Shape | null} */
    let drawn = null;
    const pointAt = (/** @type {PointerEvent} */ event) => sharesWithin(surface, event).map(share => clamp(share, 0, 1) * whole);
    surface.addEventListener('pointerdown', event => {
        const wanted = kind();
        if (!wanted || event.button !== 0) return;
        event.preventDefault();
        drawn = {kind: wanted, from: pointAt(event), to: pointAt(event)};
        surface.setPointerCapture(event.pointerId);
    });
    surface.addEventListener('pointermove', event => {
        if (!drawn) return;
        drawn = {...drawn, to: pointAt(event)};
        shows(drawn);
    });
    surface.addEventListener('pointerup', event => {
        if (!drawn) return;
        const done = {...drawn, to: pointAt(event)};
        drawn = null;
        const far = Math.hypot(done.to[0] - done.from[0], done.to[1] - done.from[1]);
        asks(far < 0.01 * whole ? null : done);
    });
    surface.addEventListener('pointercancel', () => {
        drawn = null;
        shows(null);
    });
}
