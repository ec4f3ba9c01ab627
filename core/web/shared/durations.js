// Durations and times of a clip in words.

import {digits} from './text.js';

/**
 * A duration as pictures write it: 45 s, 7 min, 3:20 h.
 * @param {number} seconds
 */
export function durationOf(seconds) {
    const whole = Math.round(Math.round(seconds * 10) / 10);
    const minutes = Math.round(whole / 60);
    return whole < 100 ? whole + ' s' : minutes < 100 ? minutes + ' min' : Math.floor(minutes / 60) + ':' + digits(minutes % 60) + ' h';
}

/**
 * From a minute on: 3:05 min, 1:02 h.
 * @param {number} all whole seconds
 */
function longSpan(all) {
    const minutes = Math.floor(all / 60);
    return minutes < 60 ? minutes + ':' + digits(all % 60) + ' min' : Math.floor(minutes / 60) + ':' + digits(minutes % 60) + ' h';
}

/**
 * A duration with tenths below a minute: 8.4 s, 3:05 min, 1:02 h.
 * @param {number} seconds
 */
export const spanOf = seconds => seconds < 60 ? seconds.toFixed(1) + ' s' : longSpan(Math.round(seconds));

/**
 * A duration with tenths below 10 seconds: 8.4 s, 42 s, 3:05 min, 1:02 h.
 * @param {number} seconds
 */
export function shortSpanOf(seconds) {
    const all = Math.round(seconds);
    if (all >= 60) return longSpan(all);
    return seconds < 10 ? seconds.toFixed(1) + ' s' : all + ' s';
}

/**
 * 75.25 as 1:15.2. Tenths are truncated, as clocks do; without them, the time is rounded, as in the picture.
 * @param {number} seconds
 * @param {boolean} [tenths]
 */
export function clipTime(seconds, tenths = true) {
    const all = tenths ? Math.floor(seconds * 10 + 1e-4) : 10 * Math.round(seconds);
    const whole = Math.floor(all / 10);
    const hours = Math.floor(whole / 3600);
    const minutes = Math.floor(whole / 60) % 60;
    return (hours ? hours + ':' + digits(minutes) : minutes) + ':' + digits(whole % 60) + (tenths ? '.' + all % 10 : '');
}
