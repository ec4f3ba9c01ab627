// Shapes that are searched for: a rectangle or a line.

import {clamp} from './text.js';

/**
 * @typedef {number[]} Point x and y
 * @typedef {number[]} Sides left, top, right, bottom
 * @typedef {{kind: 'box' | 'line', from: Point, to: Point}} Shape
 */

/** @type {(shape: {from: Point, to: Point}) => Sides} */
export const sidesOf = ({from, to}) => [Math.min(from[0], to[0]), Math.min(from[1], to[1]), Math.max(from[0], to[0]), Math.max(from[1], to[1])];

/** @type {(a: Sides, b: Sides) => boolean} */
export const meets = (a, b) => a[0] <= b[2] && b[0] <= a[2] && a[1] <= b[3] && b[1] <= a[3];

/**
 * The part of the stretch from (x, y) to (toX, toY) that lies in a rectangle, as shares of the stretch; null = none.
 * @param {number} x
 * @param {number} y
 * @param {number} toX
 * @param {number} toY
 * @param {Sides} sides
 * @returns {[number, number] | null}
 */
export function partInBox(x, y, toX, toY, [left, top, right, bottom]) {
    let [begin, end] = [0, 1];
    for (const [from, by, low, high] of [[x, toX - x, left, right], [y, toY - y, top, bottom]]) {
        if (by === 0) {
            if (from < low || from > high) return null;
            continue;
        }
        const [a, b] = by > 0 ? [(low - from) / by, (high - from) / by] : [(high - from) / by, (low - from) / by];
        begin = Math.max(begin, a);
        end = Math.min(end, b);
    }
    return begin <= end ? [begin, end] : null;
}

/**
 * The shape in whole thousandths of the picture, as addresses have it and ways are compared with it.
 * @param {Shape} shape
 * @param {number} whole the picture's width and height in the unit of the shape
 * @returns {Shape}
 */
export function inThousandths({kind, from, to}, whole) {
    const rounded = (/** @type {Point} */ point) => point.map(value => Math.round(value / whole * 1000));
    return {kind, from: rounded(from), to: rounded(to)};
}

/**
 * For addresses: "line.500.0.500.1000".
 * @param {Shape} shape in whole thousandths of the picture
 */
export const shapeText = ({kind, from, to}) => [kind, ...from, ...to].join('.');

/**
 * @param {string | null} text
 * @returns {Shape | null} null = it is none
 */
export function shapeOfText(text) {
    const [kind, ...numbers] = (text ?? '').split('.');
    const [x, y, toX, toY] = numbers.map(Number);
    const inside = numbers.length === 4 && numbers.every(number => /^\d+$/.test(number) && Number(number) <= 1000);
    return inside && (kind === 'box' || kind === 'line') ? {kind, from: [x, y], to: [toX, toY]} : null;
}

/**
 * A shape of which one end has moved, or the whole of it, within the picture.
 * @param {Shape} shape
 * @param {'from' | 'to' | null} end null = the whole
 * @param {number[]} by
 * @param {number} whole the picture's width and height in the unit of shapes
 * @returns {Shape}
 */
export function movedShape(shape, end, by, whole) {
    if (end) return {...shape, [end]: shape[end].map((value, k) => clamp(value + by[k], 0, whole))};
    const [left, top, right, bottom] = sidesOf(shape);
    const step = [clamp(by[0], -left, whole - right), clamp(by[1], -top, whole - bottom)];
    const moved = (/** @type {Point} */ point) => point.map((value, k) => value + step[k]);
    return {...shape, from: moved(shape.from), to: moved(shape.to)};
}

/**
 * The shape with which drawing by keys begins.
 * @param {Shape['kind']} kind
 * @param {number} whole the picture's width and height in the unit of shapes
 * @returns {Shape}
 */
export const firstShape = (kind, whole) => kind === 'box' ? {kind, from: [0.35 * whole, 0.35 * whole], to: [0.65 * whole, 0.65 * whole]}
    : {kind, from: [0.5 * whole, 0.2 * whole], to: [0.5 * whole, 0.8 * whole]};

/**
 * The shape in another unit.
 * @param {Shape} shape
 * @param {number} by
 * @returns {Shape}
 */
export const scaled = ({kind, from, to}, by) => ({kind, from: from.map(value => value * by), to: to.map(value => value * by)});
