// Which moments are asked for: days, and a time of day, which may go across midnight.

import {dayText, daysBefore} from './wall_clock.js';

/** @typedef {{from: string, to: string, since: string, until: string}} Span days as 2026-11-21, times as 20:00; '' = no limit */

/** @param {string} time as 20:00 */
const minutesOf = time => Number(time.slice(0, 2)) * 60 + Number(time.slice(3, 5));

/** Whether the time of day goes across midnight: the early hours then belong to the evening before. */
export const isNight = (/** @type {Span} */ {since, until}) => since !== '' && until !== '' && minutesOf(since) > minutesOf(until);

/**
 * @param {Span} span
 * @param {Date} wall a date whose UTC fields are what the clock shows
 */
export function isWithin(span, wall) {
    const minutes = wall.getUTCHours() * 60 + wall.getUTCMinutes();
    const [since, until] = [minutesOf(span.since || '00:00'), minutesOf(span.until || '24:00')];
    const night = isNight(span);
    if (night ? minutes < since && minutes >= until : minutes < since || minutes >= until) return false;
    if (!span.from && !span.to) return true;
    const today = dayText(wall);
    const day = night && minutes < until ? daysBefore(today, 1) : today;
    return (!span.from || day >= span.from) && (!span.to || day <= span.to);
}

/**
 * Whether any minute of a stretch is asked for.
 * @param {Span} span
 * @param {number} begins seconds since 1970
 * @param {number} lasts seconds
 * @param {(seconds: number) => Date} wallOf
 */
export function overlaps(span, begins, lasts, wallOf) {
    if (!span.from && !span.to && !span.since && !span.until) return true;
    for (let seconds = 0; seconds < lasts; seconds += 60) if (isWithin(span, wallOf(begins + seconds))) return true;
    return isWithin(span, wallOf(begins + lasts));
}

const time = '(\\d{1,2})(?::(\\d\\d))?';
const forms = [
    {form: new RegExp(`\\b${time}\\s*(?:-|–|\\bto\\b)\\s*${time}(?![\\d:.-])`, 'i'), ends: ['since', 'until'], least: /:/},
    {form: new RegExp(`\\b(?:after|since)\\s+${time}(?![\\d:])`, 'i'), ends: ['since'], least: /./},
    {form: new RegExp(`\\b(?:before|until)\\s+${time}(?![\\d:])`, 'i'), ends: ['until'], least: /./},
];

/**
 * Takes "after 20:00", "before 6" and "20:00 to 06:00" out of a text.
 * @param {string} text
 * @returns {{words: string, since: string, until: string}}
 */
export function timesIn(text) {
    /** @type {{words: string, since: string, until: string}} */
    const found = {words: text, since: '', until: ''};
    for (const {form, ends, least} of forms) {
        const match = form.exec(found.words);
        if (!match || !least.test(match[0])) continue;
        const times = ends.map((_, k) => [Number(match[1 + 2 * k]), Number(match[2 + 2 * k] ?? 0)]);
        if (times.some(([hours, minutes]) => minutes > 59 || hours * 60 + minutes > 1440)) continue;
        ends.forEach((end, k) => {
            found[/** @type {'since' | 'until'} */ (end)] = times[k].map(number => String(number).padStart(2, '0')).join(':');
        });
        found.words = found.words.replace(match[0], ' ');
    }
    return found;
}

/**
 * "20:00 to 06:00"; '' = at any time
 * @param {{since: string, until: string}} span
 */
export const timeWords = ({since, until}) => !since && !until ? '' : until ? `${since || '00:00'} to ${until}` : `after ${since}`;
