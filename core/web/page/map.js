// The map of a phone: the empty scene with the path of each object. A tap on a path plays its object from there.

import {appendShape, at} from '../shared/dom.js';
import {choose} from './choice.js';
import {ofEvent} from './looks.js';
import {wantedEvents} from './filters.js';
import {litEvents} from './picture.js';
import {state} from './state.js';
import {playCandidate} from './view.js';
import {askWhich} from './which.js';

const reach = 12;  // pixels of the screen

export function drawSheet() {
    const {data: {overlay: {map}, size}, events, tab} = state;
    at('tabmap').hidden = !map;
    if (!map || tab !== 'map') return;
    const scene = at('scene', HTMLImageElement);
    if (scene.src !== map.src) scene.src = map.src;
    at('sheet').style.aspectRatio = size[0] + ' / ' + size[1];
    const lit = litEvents();
    at('paths', SVGSVGElement).replaceChildren();
    events.forEach(({path}, place) => {
        const isPale = lit !== null && !lit.includes(place);
        const points = path.map(([, x, y]) => `${x},${y}`).join(' ');
        ofEvent(appendShape('polyline', {points, class: isPale ? 'pale' : ''}, at('paths', SVGSVGElement)), place);
    });
}

/**
 * Where a path is nearest to a point.
 * @param {number[][]} path frame, x, y each
 * @param {number[]} point in pixels
 * @param {number[]} size of the map in pixels
 */
export function nearestOn(path, [x, y], [width, height]) {
    let nearest = {frame: path[0][0], far: Infinity};
    path.forEach(([frame, u, v], k) => {
        const [before, fromU, fromV] = path[Math.max(0, k - 1)];
        const [outX, outY] = [(u - fromU) * width, (v - fromV) * height];
        const along = ((x - fromU * width) * outX + (y - fromV * height) * outY) / Math.max(1e-9, outX * outX + outY * outY);
        const share = Math.min(1, Math.max(0, along));
        const far = Math.hypot(fromU * width + share * outX - x, fromV * height + share * outY - y);
        if (far < nearest.far) nearest = {frame: Math.round(before + share * (frame - before)), far};
    });
    return nearest;
}

export function listenToSheet() {
    at('sheet').addEventListener('click', event => {
        const box = at('sheet').getBoundingClientRect();
        const near = wantedEvents().map(place => ({event: place, ...nearestOn(state.events[place].path, [event.clientX - box.left, event.clientY - box.top], [box.width, box.height])}))
            .filter(({far}) => far <= reach).sort((a, b) => a.far - b.far);
        if (near.length > 1) askWhich(near, event);
        else if (near.length) playCandidate(near[0]);
        else choose(null);
    });
}
