// Times of a clip's frames, and how its clock shows them.

import {clipTime} from '../shared/durations.js';
import {clamp} from '../shared/text.js';
import {dateOf, dayText, timeText} from '../shared/wall_clock.js';

/**
 * @typedef {import('./data.js').Stretch} Stretch
 * @typedef {import('./data.js').WallClock} WallClock
 */

/**
 * Stretches without frames, [the last frame before, the first one after] each: numbers skip the frames that were lost.
 * @param {Stretch[]} times
 * @returns {[number, number][]}
 */
function gapsIn(times) {
    /** @type {[number, number][]} */
    const gaps = [];
    times.slice(1).forEach(([first], k) => {
        const last = times[k][0] + times[k][1] - 1;
        if (first > last + 1) gaps.push([last, first]);
    });
    return gaps;
}

/**
 * Why there are no frames, within a sentence.
 * @param {string} reason
 */
export const inSentence = reason => reason.replace(', ', ' and ');

/** Seconds are those of the clip. */
export class Timeline {
    /**
     * @param {Stretch[]} times in order
     * @param {WallClock | null} clock
     * @param {string[]} [reasons] of the gaps
     */
    constructor(times, clock, reasons = []) {
        const last = times[times.length - 1];
        this.times = times;
        this.clock = clock;
        this.firstFrame = times[0][0];
        this.lastFrame = last[0] + last[1] - 1;
        this.gaps = gapsIn(times);
        this.reasons = this.gaps.map((_, k) => reasons[k] ?? 'no signal');
        this.frames = times.reduce((sum, [, count]) => sum + count, 0);
        this.begins = this.secondsOf(this.firstFrame);
        this.ends = this.secondsOf(this.lastFrame) + this.lengthOf(this.lastFrame);
        this.lasts = Math.max(this.secondsOf(this.lastFrame) - this.begins, 0.001);
    }

    /**
     * The last of the stretches whose number `column` is not above `value`.
     * @param {0 | 2} column
     * @param {number} value
     */
    stretchAt(column, value) {
        let low = 0;
        for (let high = this.times.length; high - low > 1;) {
            const middle = (low + high) >> 1;
            if (this.times[middle][column] <= value) low = middle;
            else high = middle;
        }
        return this.times[low];
    }

    /** @param {number} frame */
    secondsOf(frame) {
        const [first, count, begin, step] = this.stretchAt(0, frame);
        return begin + clamp(frame - first, 0, count - 1) * step;
    }

    /**
     * The frame that is shown at a time.
     * @param {number} seconds
     */
    frameAt(seconds) {
        const [first, count, begin, step] = this.stretchAt(2, seconds);
        const steps = step > 0 ? Math.floor((seconds - begin) / step + 1e-6) : 0;
        return first + clamp(steps, 0, count - 1);
    }

    /** @param {number} frame */
    clamped(frame) {
        return clamp(frame, this.firstFrame, this.lastFrame);
    }

    /**
     * The frame so many frames further on; in a gap the first one beyond it.
     * @param {number} frame
     * @param {number} by
     */
    frameBeside(frame, by) {
        const gap = this.gaps.find(([last, first]) => frame + by > last && frame + by < first);
        return gap ? gap[by > 0 ? 1 : 0] : frame + by;
    }

    /**
     * How long a frame is shown, seconds. Several may have one time; the last of all, and of those before a gap, is shown
     * as long as the one before it. Nothing tells how long one alone is.
     * @param {number} frame
     */
    lengthOf(frame) {
        const begin = this.secondsOf(frame);
        const last = Math.min(frame + 100, this.gaps.find(([before]) => before >= frame)?.[0] ?? this.lastFrame);
        for (let next = frame + 1; next <= last; ++next) {
            if (this.secondsOf(next) > begin) return this.secondsOf(next) - begin;
        }
        const isFirst = frame === this.firstFrame || this.gaps.some(([, first]) => first === frame);
        return isFirst ? 0.04 : Math.max(0, begin - this.secondsOf(frame - 1));
    }

    /**
     * A time at which a player shows this frame, however it rounds: the middle of the frame's time, but not far from its
     * beginning. Where frames refer to later ones and their times vary, MP4 has the lengths of others in their places, and
     * Chromium passes over a frame that should have ended by such a length.
     * @param {number} frame
     */
    timeWithin(frame) {
        return this.secondsOf(frame) + Math.min(this.lengthOf(frame) / 2, 0.01);
    }

    /**
     * The end of the last frame of an event. A gap may follow, which no file shows.
     * @param {{last: number}} event
     */
    endOf(event) {
        const step = this.stretchAt(0, event.last)[3];
        return this.secondsOf(event.last) + (step > 0 ? step : this.lengthOf(event.last));
    }

    /** Seconds of video, without those that have no frames. */
    secondsSeen() {
        return this.gapSpans().reduce((sum, [from, to]) => sum - (to - from), this.ends - this.begins);
    }

    /**
     * The gaps in seconds, beginning and end each.
     * @returns {[number, number][]}
     */
    gapSpans() {
        return this.gaps.map(([last, first]) => [this.secondsOf(last) + this.lengthOf(last), this.secondsOf(first)]);
    }

    /**
     * Why there are no frames at a time; undefined = there are.
     * @param {number} seconds
     * @returns {string | undefined}
     */
    reasonAt(seconds) {
        return this.reasons[this.gapSpans().findIndex(([from, to]) => seconds >= from && seconds < to)];
    }

    /**
     * Why there are no frames, and for how many seconds in all: the reasons in the order in which they occur.
     * @returns {[string, number][]}
     */
    secondsWithout() {
        /** @type {Map<string, number>} */
        const sums = new Map();
        this.gapSpans().forEach(([from, to], k) => sums.set(this.reasons[k], (sums.get(this.reasons[k]) ?? 0) + to - from));
        return [...sums];
    }

    /**
     * Seconds since 1970 on the wall clock, which leaps where summer time begins or ends.
     * @param {number} seconds
     */
    wallSeconds(seconds) {
        if (this.clock === null) return seconds;
        const leaps = this.clock.leaps.filter(([at]) => at <= seconds);
        return this.clock.begin + seconds + leaps.reduce((sum, [, by]) => sum + by, 0);
    }

    /**
     * The time of day if it is known, else that of the clip.
     * @param {number} seconds
     * @param {boolean} [tenths]
     */
    clockOf(seconds, tenths = true) {
        if (this.clock === null) return clipTime(seconds, tenths);
        const all = Math.floor(this.wallSeconds(seconds) * 10 + 1e-4);
        return timeText(dateOf(all / 10)) + (tenths ? '.' + (all % 10 + 10) % 10 : '');
    }

    /** From when to when it is, as in the picture's title: the times of the first and the last frame. */
    span() {
        return `${this.clockOf(this.begins, false)} to ${this.clockOf(this.secondsOf(this.lastFrame), false)}`;
    }

    /**
     * From when to when, as short as it can be said.
     * @param {number} begin
     * @param {number} end
     */
    fromTo(begin, end) {
        const [from, to] = [begin, end].map(seconds => this.clockOf(seconds, false));
        return from === to ? from : `${from}–${to}`;
    }

    /**
     * Both times, that of the day first.
     * @param {number} seconds
     */
    bothClocks(seconds) {
        return this.clockOf(seconds) + (this.clock === null ? '' : ` (${clipTime(seconds)} of the clip)`);
    }

    /**
     * The date; empty = unknown.
     * @param {number} seconds
     */
    dayOf(seconds) {
        return this.clock === null ? '' : dayText(dateOf(this.wallSeconds(seconds)));
    }
}
