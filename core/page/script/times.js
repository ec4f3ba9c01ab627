
document.documentElement.dataset.script = '';  // shows what needs a script

// ---- Times: stretches of [first frame, count, seconds of the first, seconds per frame]

let firstFrame = data.times[0][0];
let lastFrame = data.times.at(-1)[0] + data.times.at(-1)[1] - 1;

/// The last of the stretches whose number `column` is not above `value`.
function stretchAt(column, value) {
    let low = 0;
    for (let high = data.times.length; high - low > 1;) {
        const middle = (low + high) >> 1;
        if (data.times[middle][column] <= value) low = middle;
        else high = middle;
    }
    return data.times[low];
}

function secondsOf(frame) {
    const [first, count, begin, step] = stretchAt(0, frame);
    return begin + clamp(frame - first, 0, count - 1) * step;
}

/// The frame that is on show at a time.
function frameAt(seconds) {
    const [first, count, begin, step] = stretchAt(2, seconds);
    const steps = step > 0 ? Math.floor((seconds - begin) / step + 1e-6) : 0;
    return first + clamp(steps, 0, count - 1);
}

/// Stretches of time without signal, [the last frame before, the first one after] each: numbers skip the frames that were
/// lost.
const gapsIn = times => times.slice(1).flatMap(([first], k) => {
    const last = times[k][0] + times[k][1] - 1;
    return first > last + 1 ? [[last, first]] : [];
});
let gaps = gapsIn(data.times);
const framesIn = times => times.reduce((sum, [, count]) => sum + count, 0);

/// The frame by so many frames further on that there is.
function frameBeside(frame, by) {
    const gap = gaps.find(([last, first]) => frame + by > last && frame + by < first);
    return gap ? gap[by > 0 ? 1 : 0] : frame + by;
}

/// How long a frame is on show. Several may have one time; the last of all, and of those before a gap, is on show as long
/// as the one before it. Nothing tells how long one alone is.
function lengthOf(frame) {
    const begin = secondsOf(frame);
    const last = Math.min(frame + 100, gaps.find(([before]) => before >= frame)?.[0] ?? lastFrame);
    for (let next = frame + 1; next <= last; ++next) {
        if (secondsOf(next) > begin) return secondsOf(next) - begin;
    }
    const isFirst = frame === firstFrame || gaps.some(([, first]) => first === frame);
    return isFirst ? 0.04 : Math.max(0, begin - secondsOf(frame - 1));
}

/// A time at which a player shows this frame, however it rounds: the middle of the frame's time, but not far from its
/// beginning. Where frames refer to later ones and their times vary, MP4 has the lengths of others in their places, and
/// Chromium passes over a frame that should have ended by such a length.
const timeWithin = frame => secondsOf(frame) + Math.min(lengthOf(frame) / 2, 0.01);

let begins = secondsOf(firstFrame);
let ends = secondsOf(lastFrame) + lengthOf(lastFrame);
let lasts = Math.max(secondsOf(lastFrame) - begins, 0.001);

/// Seconds of video, without those that have no signal.
const secondsSeen = () => gaps.reduce((sum, [last, first]) => sum - (secondsOf(first) - secondsOf(last) - lengthOf(last)), ends - begins);

/// 75.25 as 1:15.2; tenths are cut off, as clocks do.
function clipTime(seconds, tenths = true) {
    const all = Math.floor(seconds * 10 + 1e-4);
    const whole = Math.floor(all / 10);
    const hours = Math.floor(whole / 3600);
    const minutes = Math.floor(whole / 60) % 60;
    return (hours ? hours + ':' + digits(minutes) : minutes) + ':' + digits(whole % 60) + (tenths ? '.' + all % 10 : '');
}

/// What the clock on the wall shows at a second of the clip, in seconds since 1970; it leaps where summer time begins or
/// ends.
function wallSeconds(seconds) {
    const leaps = data.clock.leaps.filter(([at]) => at <= seconds);
    return data.clock.begin + seconds + leaps.reduce((sum, [, by]) => sum + by, 0);
}

/// The time of the day where it is known, else the clip's.
function clockOf(seconds, tenths = true) {
    if (data.clock === null) return clipTime(seconds, tenths);
    const all = Math.floor(wallSeconds(seconds) * 10 + 1e-4);
    const ofDay = new Date(Math.floor(all / 10) * 1000).toISOString().slice(11, 19);
    return ofDay + (tenths ? '.' + (all % 10 + 10) % 10 : '');
}

/// Both clocks, the one of the day first.
const bothClocks = seconds => clockOf(seconds) + (data.clock === null ? '' : ` (${clipTime(seconds)} of the clip)`);

const dayOf = seconds => data.clock === null ? '' : new Date(Math.floor(wallSeconds(seconds)) * 1000).toISOString().slice(0, 10);

/// A length of time: 8.4 s, 3:05 min, 1:02 h.
function spanOf(seconds) {
    if (seconds < 60) return seconds.toFixed(1) + ' s';
    const all = Math.round(seconds);
    return all < 3600 ? Math.floor(all / 60) + ':' + digits(all % 60) + ' min'
                      : Math.floor(all / 3600) + ':' + digits(Math.floor(all / 60) % 60) + ' h';
}

/// Tells screen readers.
function say(text) {
    at('said').textContent = text;
}
