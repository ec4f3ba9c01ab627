// Dates whose UTC fields are what a clock on the wall shows.

/** @type {(seconds: number) => Date} */
export const dateOf = seconds => new Date(Math.floor(seconds) * 1000);

/**
 * 2026-11-21
 * @type {(date: Date) => string}
 */
export const dayText = date => date.toISOString().slice(0, 10);

/**
 * 07:15:02
 * @type {(date: Date) => string}
 */
export const timeText = date => date.toISOString().slice(11, 19);

/**
 * The time zone of the machine that drew the pictures, so that every reader sees the times of the place.
 * @typedef {[from: number, ahead: number, name: string]} ZoneChange seconds since 1970, seconds ahead of UTC
 */

/**
 * Returns a function that gives the date on the wall at seconds since 1970.
 * @param {ZoneChange[]} changes in order
 */
export function wallIn(changes) {
    return (/** @type {number} */ seconds) => {
        const change = changes.findLast(([from]) => from <= seconds) ?? changes[0];
        return new Date((seconds + change[1]) * 1000);
    };
}

const weekdays = new Intl.DateTimeFormat('en', {weekday: 'long', timeZone: 'UTC'});
const months = new Intl.DateTimeFormat('en', {month: 'long', year: 'numeric', timeZone: 'UTC'});

/** @param {string} day as 2026-11-21 */
export const weekday = day => weekdays.format(new Date(day + 'T00:00:00Z'));
/** @param {string} day as 2026-11-21 */
export const monthOf = day => months.format(new Date(day + 'T00:00:00Z'));

/**
 * The day so many days earlier.
 * @param {string} day as 2026-11-21
 * @param {number} count
 */
export function daysBefore(day, count) {
    const date = new Date(day + 'T00:00:00Z');
    date.setUTCDate(date.getUTCDate() - count);
    return dayText(date);
}
