// How the program frames a volume in its picture (LookPlan::framing), for any angle; and which frames are where in it.

import {fitCamera, pixelOf, within} from './camera.js';
import {layouts, outerEdge, outlinePoints, rulerReach} from './layouts.js';
import {clamp} from '../shared/text.js';

/** @typedef {import('./data.js').TurningVolume} TurningVolume */

/**
 * @param {Pick<TurningVolume, 'shape' | 'view' | 'part' | 'shows'>} volume
 * @param {import('./layouts.js').LayoutName} layout
 * @param {number[]} angle azimuth and elevation
 * @param {number[]} size of the picture
 */
export function framingOf({shape, view, part, shows}, layout, [azimuth, elevation], size) {
    const pOf = (/** @type {import('./layouts.js').Point} */ c) => layouts[layout].pOf(shape, c);
    const partSize = [part[2] - part[0], part[3] - part[1]];
    const points = outlinePoints(pOf);
    const fit = () => fitCamera([azimuth, elevation, view[2], view[3]], points, partSize);
    let camera = fit();
    const edge = outerEdge(pOf, p => pixelOf(camera, p, partSize), partSize);
    if (shows.ruler) {
        points.push(...rulerReach(pOf, edge));
        camera = fit();
    }
    return {camera: within(camera, part, size), edge, pOf};
}

/**
 * The place of a frame along the volume.
 * @param {Pick<TurningVolume, 'frames' | 'size' | 'scale' | 'end'>} volume
 */
export function timesOf({frames, size, scale, end}) {
    const layers = frames.length - 1;
    const deep = size[2] * scale[2];  // layers of the reduced volume per t
    /**
     * Where a layer begins, in layers; the last one may be shorter.
     * @param {number} k
     */
    const beginOf = k => k < layers ? k : end * deep;
    return {
        /** @param {number} frame */
        tOf(frame) {
            let low = 0;
            for (let high = layers; high - low > 1;) {
                const middle = (low + high) >> 1;
                if (frames[middle] <= frame) low = middle;
                else high = middle;
            }
            const share = clamp((frame - frames[low]) / Math.max(1, frames[low + 1] - frames[low]), 0, 1);
            return (low + share * (beginOf(low + 1) - low)) / deep;
        },
        /** @param {number} t */
        frameAt(t) {
            const at = clamp(t, 0, end) * deep;
            const low = Math.min(Math.floor(at), layers - 1);
            const share = clamp((at - low) / Math.max(1e-9, beginOf(low + 1) - low), 0, 1);
            return Math.round(frames[low] + share * (frames[low + 1] - frames[low]));
        },
    };
}

/**
 * The angle between two others; azimuths go the shorter way.
 * @param {number[]} from
 * @param {number[]} to
 * @param {number} share
 */
export function angleBetween(from, to, share) {
    const turn = ((to[0] - from[0]) % 360 + 540) % 360 - 180;
    return [from[0] + share * turn, from[1] + share * (to[1] - from[1])];
}

/**
 * An azimuth from -180 to 180, and an elevation above the ground; tenths of a degree.
 * @param {number[]} angle
 */
export const angleWithin = ([azimuth, elevation]) =>
    [Math.round((((azimuth % 360) + 540) % 360 - 180) * 10) / 10, Math.round(clamp(elevation, 3, 90) * 10) / 10];
