// Times that a reader types.

/**
 * The second of the clip that a text means; null = none. 75, 1:15, 1:02:03 and 1:15.5 are times of the clip; where the
 * clip has times of the day, 14:20 and 14:20:05 are those.
 * @param {string} text
 * @param {import('./timeline.js').Timeline} time
 */
export function momentOf(text, time) {
    const match = /^\s*(?:(\d+):)?(?:(\d+):)?(\d+(?:[.,]\d+)?)\s*s?\s*$/.exec(text);
    if (!match) return null;
    const last = Number(match[3].replace(',', '.'));
    const parts = [match[1], match[2]].filter(part => part !== undefined).map(Number);
    if (parts.some((part, k) => k > 0 && part >= 60) || (parts.length && last >= 60)) return null;
    const [begin, end] = [time.begins, time.ends];
    const inClip = (/** @type {number} */ seconds) => seconds >= begin && seconds <= end ? seconds : null;
    if (time.clock !== null && parts.length) {
        const ofDay = parts.length === 2 ? parts[0] * 3600 + parts[1] * 60 + last : parts[0] * 3600 + last * 60;
        const found = secondAt(ofDay, time);
        if (found !== null) return found;
    }
    return inClip(parts.reduce((sum, part) => sum * 60 + part, 0) * (parts.length ? 60 : 1) + last);
}

/**
 * The first second of the clip at which the clock of the day shows so many seconds after midnight. A time that the clock
 * leaps over, where summer time begins, is the moment of the leap.
 * @param {number} ofDay
 * @param {import('./timeline.js').Timeline} time
 */
function secondAt(ofDay, time) {
    const day = 86400;
    const aheadOf = (/** @type {number} */ from) => ((ofDay - time.wallSeconds(from)) % day + day) % day;
    const leaps = (time.clock?.leaps ?? []).filter(([at]) => at > time.begins && at <= time.ends);
    const parts = [time.begins, ...leaps.map(([at]) => at)];
    for (const [k, from] of parts.entries()) {
        const seconds = from + aheadOf(from);
        const [to, by] = leaps[k] ?? [Infinity, 0];
        if (seconds < to && seconds <= time.ends) return seconds;
        if (seconds >= to && seconds < to + by) return to;
    }
    // A minute in which the clip begins means the clip's beginning.
    return day - aheadOf(time.begins) < 60 ? time.begins : null;
}
