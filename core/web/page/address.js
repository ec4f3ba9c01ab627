// The part of the address after '#', which links to an event or to a moment: #event=4, #t=12.9.

/**
 * @param {string} hash
 * @returns {{number: number | null, seconds: number | null}} the event's number, and a second of the clip
 */
export function readAddress(hash) {
    const parts = new URLSearchParams(hash.replace(/^#/, ''));
    const numberIn = (/** @type {string} */ name) => {
        const number = Number(parts.get(name) ?? NaN);
        return Number.isFinite(number) ? number : null;
    };
    return {number: numberIn('event'), seconds: numberIn('t')};
}

/** @type {(number: number) => string} */
export const addressOfEvent = number => '#event=' + number;

/** @type {(seconds: number) => string} */
export const addressOfMoment = seconds => '#t=' + seconds.toFixed(3);
