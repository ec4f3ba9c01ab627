// The part of a page's address after '#', which links to an event or to a moment: #event=4, #t=12.9. The index adds what
// was searched for there, so that the page can show it and lead on.

import {shapeOfText, shapeText} from '../shared/shapes.js';

/**
 * @typedef {import('../shared/shapes.js').Shape} Shape
 *
 * @typedef {object} Hit of a search in the index
 * @property {number} number of the event
 * @property {number} seconds of the clip at which it is shown
 * @property {Shape | null} place that is searched for, in thousandths of the picture
 * @property {string} search what the index was asked, as the part of its address after '#'
 * @property {number} nth its place among the hits, from 1
 * @property {number} of how many there are
 */

/** @typedef {{angle: number[], unbent: boolean}} Turned azimuth and elevation, and whether the volume is straight */

/**
 * @param {string | null} text "-30,12", or "-30,12,unbent"
 * @returns {Turned | null}
 */
function viewOfText(text) {
    const [azimuth, elevation, layout] = (text ?? '').split(',');
    const angle = [azimuth, elevation].map(word => word?.trim() ? Number(word) : NaN);
    return angle.every(Number.isFinite) ? {angle, unbent: layout === 'unbent'} : null;
}

/**
 * The address with another angle; null = that of the picture.
 * @param {string} hash
 * @param {Turned | null} view
 */
export function addressWithView(hash, view) {
    const parts = new URLSearchParams(hash.replace(/^#/, ''));
    parts.delete('view');
    if (view) parts.set('view', view.angle.join(',') + (view.unbent ? ',unbent' : ''));
    const text = String(parts).replaceAll('%2C', ',');
    return text && '#' + text;
}

/** @param {string} hash */
export function readAddress(hash) {
    const parts = new URLSearchParams(hash.replace(/^#/, ''));
    const numberIn = (/** @type {string} */ name) => {
        const number = Number(parts.get(name) || NaN);
        return Number.isFinite(number) ? number : null;
    };
    return {
        number: numberIn('event'),
        seconds: numberIn('t'),
        plays: parts.has('play'),
        place: shapeOfText(parts.get('place')),
        search: parts.get('search') ?? '',
        nth: numberIn('nth'),
        of: numberIn('of'),
        /** The way in which the index found nothing more: 1 = after this, -1 = before; null = it was not asked. */
        ended: numberIn('ended'),
        all: parts.has('all'),
        view: viewOfText(parts.get('view')),
    };
}

/** @type {(number: number) => string} */
export const addressOfEvent = number => '#event=' + number;

/** @type {(seconds: number) => string} */
export const addressOfMoment = seconds => '#t=' + seconds.toFixed(3);

/**
 * A hit, which plays from its moment with the place drawn.
 * @param {Hit} hit
 * @param {{all?: boolean, ended?: number}} [how] all: the next hits follow by themselves; ended: there is none in this
 *     way, and it only shows
 */
export function addressOfHit({number, seconds, place, search, nth, of}, how = {}) {
    const {all, ended} = how;
    const parts = new URLSearchParams({event: String(number), t: seconds.toFixed(1)});
    if (ended) parts.set('ended', String(ended));
    else parts.set('play', '');
    if (place) parts.set('place', shapeText(place));
    if (all) parts.set('all', '');
    for (const [name, value] of Object.entries({search, nth, of})) parts.set(name, String(value));
    return '#' + parts;
}

/**
 * The address with another event, or none. What was searched for in the index stays, the hit only with its event.
 * @param {string} hash
 * @param {number | null} number
 */
export function addressWith(hash, number) {
    const before = new URLSearchParams(hash.replace(/^#/, ''));
    const parts = new URLSearchParams(number === null ? {} : {event: String(number)});
    const isHit = before.has('nth') && before.get('event') === String(number);
    for (const name of isHit ? ['t', 'place', 'all', 'search', 'nth', 'of', 'view'] : ['search', 'view']) {
        const value = before.get(name);
        if (value !== null) parts.set(name, value);
    }
    const text = String(parts);
    return text && '#' + text;
}

/**
 * A clip that is reached from the index, or from the clip beside it.
 * @param {string} search
 * @param {number} [ended] the way in which there is none
 */
export const addressOfClip = (search, ended) => search || ended
    ? '#' + new URLSearchParams({...search && {search}, ...ended && {ended: String(ended)}}) : '';
