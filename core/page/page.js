'use strict';

const data = JSON.parse(document.getElementById('data').textContent);
const at = id => document.getElementById(id);
const clamp = (value, low, high) => Math.min(Math.max(value, low), high);

// ---- Times: stretches of [first frame, count, seconds of the first, seconds a frame]

const firstFrame = data.times[0][0];
const lastFrame = data.times.at(-1)[0] + data.times.at(-1)[1] - 1;

/// The last of the stretches whose number `column` is not above `value`.
function stretchAt(column, value) {
    let low = 0;
    for (let high = data.times.length; high - low > 1;) {
        const middle = (low + high) >> 1;
        if (data.times[middle][column] <= value)
            low = middle;
        else
            high = middle;
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

/// How long a frame is on show. Several may have one time; the last of all is on show as long as the one before it.
function lengthOf(frame) {
    const begin = secondsOf(frame);
    for (let next = frame + 1; next <= Math.min(frame + 100, lastFrame); ++next) {
        if (secondsOf(next) > begin) return secondsOf(next) - begin;
    }
    return frame > firstFrame ? Math.max(0, begin - secondsOf(frame - 1)) : 0.04;
}

/// A time at which a player shows this frame, however it rounds: the middle of the frame's time, but not far from its
/// beginning. Where frames refer to later ones and their times vary, MP4 has the lengths of others in their places, and
/// Chromium passes over a frame that should have ended by such a length.
const timeWithin = frame => secondsOf(frame) + Math.min(lengthOf(frame) / 2, 0.01);

const begins = secondsOf(firstFrame);
const lasts = Math.max(secondsOf(lastFrame) - begins, 0.001);

/// 75.25 as 1:15.2; tenths are cut off, as clocks do.
function clockOf(seconds, tenths = true) {
    const all = Math.floor(seconds * 10 + 1e-4);
    const digits = number => String(number).padStart(2, '0');
    const whole = Math.floor(all / 10);
    const hours = Math.floor(whole / 3600);
    const minutes = Math.floor(whole / 60) % 60;
    return (hours ? hours + ':' + digits(minutes) : minutes) + ':' + digits(whole % 60) +
        (tenths ? '.' + all % 10 : '');
}

// ---- What the pixels show

const picture = at('picture');
const width = Number(picture.getAttribute('width'));
const height = Number(picture.getAttribute('height'));
let frames = null;   // of each pixel; -1 = none
let objects = null;  // the place in data.events that each pixel shows; -1 = none

function bytesOf(base64) { return Uint8Array.from(atob(base64), letter => letter.charCodeAt(0)); }

/// The number of each pixel, less by one: -1 = none.
async function readPixels(source) {
    const png = new Blob([bytesOf(source.src.split(',')[1])], {type: 'image/png'});
    const bitmap = await createImageBitmap(png, {premultiplyAlpha: 'none', colorSpaceConversion: 'none'});
    const canvas = document.createElement('canvas');
    canvas.width = width;
    canvas.height = height;
    const context = canvas.getContext('2d', {willReadFrequently: true});
    context.drawImage(bitmap, 0, 0);
    const bytes = context.getImageData(0, 0, width, height).data;
    const read = new Int32Array(width * height);
    let sum = 0;
    for (let k = 0; k < read.length; ++k) {
        const value = bytes[4 * k] << 16 | bytes[4 * k + 1] << 8 | bytes[4 * k + 2];
        sum += value;
        read[k] = value - 1;
    }
    // Some browsers answer with noise, so that pages can't tell machines apart.
    if (sum !== source.sum) throw new Error('this browser changes what pages read from pictures');
    return read;
}

async function readPicture() {
    await picture.decode();
    const ground = groundOf(picture);
    pale = colour(...ground, 205);
    view.style.backgroundColor = `rgb(${ground})`;
    const read = await readPixels(data.pixels);
    if (data.objects) objects = await readPixels(data.objects);
    frames = read.map(value => value < 0 ? -1 : value + data.pixels.first);
}

/// The place of the pixel nearest to a point of the picture that shows a frame, a few pixels away at most; null = none.
function pixelNear(x, y) {
    if (!frames) return null;
    const reach = 4;
    let nearest = null;
    let least = reach * reach + 1;
    for (let j = Math.max(0, Math.floor(y) - reach); j <= Math.min(height - 1, Math.floor(y) + reach); ++j) {
        for (let i = Math.max(0, Math.floor(x) - reach); i <= Math.min(width - 1, Math.floor(x) + reach); ++i) {
            const frame = frames[j * width + i];
            const distance = (i - Math.floor(x)) ** 2 + (j - Math.floor(y)) ** 2;
            if (frame < 0 || distance >= least) continue;
            nearest = j * width + i;
            least = distance;
        }
    }
    return nearest;
}

/// What a point of the picture shows: the frame, and the place of the event in the list; null where there is none.
function shownAt(x, y) {
    // Of the parts that stand for an event, the last drawn is on top.
    const region =
        data.regions.findLast(([left, top, right, bottom]) => x >= left && x < right && y >= top && y < bottom);
    if (region) return {frame: data.events[region[4]].first, event: region[4]};
    const pixel = pixelNear(x, y);
    if (pixel === null) return {frame: null, event: null};
    return {frame: frames[pixel], event: objects && objects[pixel] >= 0 ? objects[pixel] : null};
}

/// The colour behind everything in the picture, which is that of its corner.
function groundOf(image) {
    const canvas = document.createElement('canvas');
    canvas.width = canvas.height = 1;
    const context = canvas.getContext('2d');
    context.drawImage(image, 0, 0, 1, 1, 0, 0, 1, 1);
    const [red, green, blue, alpha] = context.getImageData(0, 0, 1, 1).data;
    return alpha > 0 ? [red, green, blue] : [255, 255, 255];
}

/// Pales what is not of the chosen event, and marks the moment that the player shows.
const veil = at('veil').getContext('2d');
const veilPixels = veil.createImageData(width, height);
const veilWords = new Uint32Array(veilPixels.data.buffer);
const colour = (red, green, blue, alpha) => new Uint32Array(new Uint8Array([red, green, blue, alpha]).buffer)[0];
let pale = 0;
const glow = colour(217, 72, 15, 215);

function drawVeil() {
    if (!frames) return;
    const reach = Math.max(1, Math.round((lastFrame - firstFrame) * 0.003));
    const from = now - reach;
    const to = now + reach;
    const lit = lightened ?? chosen;
    const event = lit === null ? null : data.events[lit];
    const isOther = objects ? k => objects[k] !== lit : k => frames[k] < event.first || frames[k] > event.last;
    for (let k = 0; k < frames.length; ++k) {
        const frame = frames[k];
        if (frame < 0)
            veilWords[k] = 0;  // lines and writing
        else if (moved && frame >= from && frame <= to && frame !== firstFrame && frame !== lastFrame)
            veilWords[k] = glow;
        else
            veilWords[k] = event && isOther(k) ? pale : 0;
    }
    veil.putImageData(veilPixels, 0, 0);
}

/// Says at the horseshoe's ends which is which, where there are pixels enough of the first and the last frame.
function labelEnds() {
    const ends = [
        [at('begins'), firstFrame, 'begins ' + clockOf(begins, false)],
        [at('ends'), lastFrame, 'ends ' + clockOf(secondsOf(lastFrame) + lengthOf(lastFrame), false)]
    ];
    for (const [label, frame, words] of ends) {
        let count = 0;
        let left = width, right = 0, bottom = 0;
        frames.forEach((seen, k) => {
            if (seen !== frame) return;
            ++count;
            left = Math.min(left, k % width);
            right = Math.max(right, k % width);
            bottom = Math.max(bottom, Math.floor(k / width));
        });
        if (count < width * height / 1000) continue;
        label.textContent = words;
        label.style.left = (left + right) / 2 / width * 100 + '%';
        label.style.top = bottom / height * 100 + '%';
        label.hidden = false;
    }
}

// ---- The player: the clip, else the preview in this page, else stills

const video = at('video');
const still = at('still');
let now = firstFrame;  // the frame on show
let moved = false;     // whether anybody asked for a moment yet
let film = null;       // what the player has open

const films = [];
if (data.clip) films.push({url: () => data.clip, begin: 0, says: 'the clip itself'});
if (data.preview) {
    const every = data.preview.step > 1 ? ', one frame in ' + data.preview.step : '';
    films.push({
        url: () => URL.createObjectURL(new Blob([bytesOf(data.preview.base64)], {type: data.preview.type})),
        begin: data.preview.begin,
        says: (data.clip ? 'the clip can’t be played here, so this is ' : '') + 'a small preview' + every,
    });
}

/// Whether the file that was opened can be what the picture was made of.
function isTheClip(candidate) {
    if (video.videoWidth === 0) return false;
    return !Number.isFinite(video.duration) || video.duration + 1 > secondsOf(lastFrame) - candidate.begin;
}

function openFilm(number) {
    film = null;
    if (number === films.length) {
        video.onerror = null;
        video.removeAttribute('src');
        video.hidden = true;
        still.hidden = false;
        at('source').textContent =
            data.clip ? 'a still, as the clip can’t be played here' : 'a still, as there is no film to be played';
        drawNow();
        return;
    }
    const candidate = films[number];
    const next = () => openFilm(number + 1);
    // Where the film's own clock stands at its first frame, which is our zero.
    candidate.offset = 0;
    const ready = () => {
        if (film === candidate || video.src !== candidate.src) return;
        film = candidate;
        at('source').textContent = film.says;
        at('peeker').src = film.src;
        if (moved) show(now, playing);
    };
    video.onerror = next;
    video.onloadedmetadata = () => {
        if (!isTheClip(candidate)) next();
    };
    video.onloadeddata = () => {
        if (!video.requestVideoFrameCallback) return ready();
        setTimeout(ready, 700);  // a page that is not to be seen gets no frames
        video.requestVideoFrameCallback((_, shown) => {
            if (video.currentTime === 0 && shown.mediaTime < 5) candidate.offset = shown.mediaTime;
            ready();
        });
    };
    video.src = candidate.url();
    candidate.src = video.src;
}

let playing = false;

/// Goes to the middle of a frame, and plays on from there.
function show(frame, play) {
    now = clamp(frame, firstFrame, lastFrame);
    moved = true;
    playing = play;
    if (film) {
        video.currentTime = Math.max(0, timeWithin(now) - film.begin + film.offset);
        if (play)
            video.play().catch(() => {});
        else
            video.pause();
    }
    drawNow();
}

function drawNow() {
    at('clock').textContent = clockOf(secondsOf(now));
    at('cursor').style.left = (secondsOf(now) - begins) / lasts * 100 + '%';
    if (!still.hidden) {
        const nearest = stillNear(now);
        still.src = nearest.src;
        still.alt = 'The clip at ' + clockOf(secondsOf(nearest.frame));
    }
    drawVeil();
    drawRing();
}

function followPlayer() {
    if (film && moved) {
        const frame = clamp(frameAt(video.currentTime - film.offset + film.begin), firstFrame, lastFrame);
        if (frame !== now && !video.seeking) {
            now = frame;
            drawNow();
        }
    }
    setTimeout(() => requestAnimationFrame(followPlayer), 60);
}
video.addEventListener('play', () => {
    moved = playing = true;
});
video.addEventListener('pause', () => {
    playing = false;
});

function togglePlaying() {
    if (!film) return;
    if (video.paused)
        video.play().catch(() => {});
    else
        video.pause();
}

function stillNear(frame) {
    return data.stills.reduce((a, b) => Math.abs(b.frame - frame) < Math.abs(a.frame - frame) ? b : a);
}

// ---- Pointing: the time and a thumbnail

const tip = at('tip');
const peeker = at('peeker');
let pointed = null;  // the frame
peeker.hidden = true;

function pointAt(frame, x, y, event = null) {
    tip.hidden = frame === null;
    light(event);
    if (frame === null) {
        pointed = null;
        return;
    }
    if (frame !== pointed) {
        pointed = frame;
        const nearest = stillNear(frame);
        const apart = Math.abs(secondsOf(nearest.frame) - secondsOf(frame));
        at('about').textContent = film || apart < 0.5 ? '' : 'picture of ' + clockOf(secondsOf(nearest.frame));
        at('peek').src = nearest.src;
        peeker.hidden = true;
        peekAt(frame);
    }
    at('when').textContent =
        clockOf(secondsOf(frame)) + (event === null ? '' : ` · ${event + 1} ${data.events[event].kind}`);
    const box = tip.getBoundingClientRect();
    const beside = x + 18 + box.width > innerWidth ? x - 18 - box.width : x + 18;
    tip.style.transform =
        `translate(${Math.max(4, beside)}px, ${clamp(y - box.height / 2, 4, innerHeight - box.height - 4)}px)`;
}

/// A still is there at once; the frame itself comes from the film, one after the other.
function peekAt(frame) {
    if (!film || peeker.readyState < 1 || peeker.seeking) return;
    peeker.dataset.frame = frame;
    peeker.currentTime = Math.max(0, timeWithin(frame) - film.begin + film.offset);
}
peeker.addEventListener('seeked', () => {
    if (Number(peeker.dataset.frame) === pointed)
        peeker.hidden = false;
    else if (pointed !== null)
        peekAt(pointed);
});
peeker.addEventListener('loadeddata', () => {
    if (pointed !== null) peekAt(pointed);
});

// ---- Zoom and pan

const view = at('view');
const stage = at('stage');
let scale = 1;            // 1 = the whole picture fits
let middle = [0.5, 0.5];  // of the picture, stands in the middle of the view

function place() {
    const fit = Math.min(view.clientWidth / width, view.clientHeight / height);
    const size = [width * fit * scale, height * fit * scale];
    const room = [view.clientWidth, view.clientHeight];
    const corner = [0, 1].map(k => {
        const half = Math.min(0.5, room[k] / 2 / size[k]);
        middle[k] = clamp(middle[k], half, 1 - half);
        return room[k] / 2 - middle[k] * size[k];
    });
    view.style.touchAction = scale > 1 ? 'none' : 'pan-y';
    stage.style.width = size[0] + 'px';
    stage.style.height = size[1] + 'px';
    stage.style.transform = `translate(${corner[0]}px, ${corner[1]}px)`;
}

/// Zooms so that what is under a point of the window stays there.
function zoom(factor, x, y) {
    const before = picture.getBoundingClientRect();
    const point = x === undefined ? middle : [(x - before.left) / before.width, (y - before.top) / before.height];
    const wanted = clamp(scale * factor, 1, 16);
    const ratio = scale / wanted;
    middle = middle.map((value, k) => point[k] + (value - point[k]) * ratio);
    scale = wanted;
    place();
}

function pan(x, y) {
    const box = picture.getBoundingClientRect();
    middle = [middle[0] - x / box.width, middle[1] - y / box.height];
    place();
}

function showWhole() {
    scale = 1;
    place();
}

function shownUnder(event) {
    const box = picture.getBoundingClientRect();
    return shownAt((event.clientX - box.left) / box.width * width, (event.clientY - box.top) / box.height * height);
}

let press = null;  // where the pointer went down
view.addEventListener('pointerdown', event => {
    if (event.button !== 0 || event.target.closest('button')) return;
    press = {x: event.clientX, y: event.clientY, drag: false};
    view.setPointerCapture(event.pointerId);
});
view.addEventListener('pointermove', event => {
    if (press) {
        press.drag ||= Math.hypot(event.clientX - press.x, event.clientY - press.y) > 4;
        if (press.drag) {
            view.classList.add('dragging');
            pan(event.movementX, event.movementY);
            pointAt(null);
            return;
        }
    }
    const shown = event.target.closest('button') ? {frame: null, event: null} : shownUnder(event);
    pointAt(shown.frame, event.clientX, event.clientY, shown.event);
});
view.addEventListener('pointerup', event => {
    const clicked = press && !press.drag;
    press = null;
    view.classList.remove('dragging');
    if (!clicked) return;
    const shown = shownUnder(event);
    if (shown.frame === null) return;
    choose(shown.event);
    show(shown.frame, true);
    say('Plays from ' + clockOf(secondsOf(shown.frame)) + (shown.event === null ? '' : `, event ${shown.event + 1}`));
});
view.addEventListener('pointercancel', () => {
    press = null;
});
view.addEventListener('pointerleave', () => pointAt(null));
view.addEventListener('wheel', event => {
    event.preventDefault();
    zoom(Math.exp(-event.deltaY * (event.deltaMode === 1 ? 0.04 : 0.0016)), event.clientX, event.clientY);
}, {passive: false});
at('closer').addEventListener('click', () => zoom(1.5));
at('farther').addEventListener('click', () => zoom(1 / 1.5));
at('whole').addEventListener('click', showWhole);
new ResizeObserver(place).observe(view);

// ---- The strip of time

const strip = at('strip');

function frameOnStrip(event) {
    const box = strip.getBoundingClientRect();
    return frameAt(begins + clamp((event.clientX - box.left) / box.width, 0, 1) * lasts);
}
strip.addEventListener(
    'pointermove', event => pointAt(frameOnStrip(event), event.clientX, strip.getBoundingClientRect().top - 100));
strip.addEventListener('pointerleave', () => pointAt(null));
strip.addEventListener('click', event => show(frameOnStrip(event), true));

function drawStrip() {
    const steps = [1, 2, 5, 10, 15, 30, 60, 120, 300, 600, 900, 1800, 3600, 7200, 14400, 43200, 86400];
    const step = steps.find(seconds => lasts / seconds <= 10) ?? 86400 * Math.ceil(lasts / 864000);
    for (let seconds = Math.ceil(begins / step) * step; seconds <= begins + lasts * 0.98; seconds += step) {
        const label = document.createElement('span');
        label.textContent = clockOf(seconds, false);
        label.style.left = (seconds - begins) / lasts * 100 + '%';
        at('ticks').append(label);
    }
    // Each event in the first row that is free for it.
    const rows = [];
    for (const event of data.events ?? []) {
        let row = rows.findIndex(end => end < event.first);
        if (row < 0) row = rows.length;
        rows[row] = event.last;
        const bar = document.createElement('i');
        if (event.colour) bar.style.background = event.colour;
        bar.style.left = (secondsOf(event.first) - begins) / lasts * 100 + '%';
        bar.style.width = (secondsOf(event.last) - secondsOf(event.first)) / lasts * 100 + '%';
        bar.dataset.row = row;
        at('bars').append(bar);
    }
    for (const bar of at('bars').children) {
        const share = 100 / Math.max(rows.length, 4);
        bar.style.top = bar.dataset.row * share + '%';
        bar.style.height = `max(2px, ${share * 0.75}%)`;
    }
}

// ---- Events

let chosen = null;     // place in data.events
let lightened = null;  // the one that the pointer is on

/// Shows which event the pointer is on, without choosing it.
function light(number) {
    if (number === lightened) return;
    lightened = number;
    drawVeil();
}

function say(text) { at('said').textContent = text; }

function textOf(event) {
    const parts = [];
    const seconds = secondsOf(event.last) - secondsOf(event.first);
    parts.push(event.kind);
    parts.push(seconds.toFixed(1) + ' s');
    if (event.still > 0) parts.push('still for ' + event.still.toFixed(1) + ' s');
    if (event.from !== null) parts.push('came out of ' + (event.from + 1));
    if (event.into !== null) parts.push('went into ' + (event.into + 1));
    return parts.join(' · ');
}

/// Where an event's object was, in shares of the picture's width and height; null = not at that time.
function placeOf(event, frame) {
    const after = event.path.findIndex(point => point[0] >= frame);
    if (after < 0 || frame < event.first) return null;
    const [end, x, y] = event.path[after];
    const [begin, fromX, fromY] = event.path[Math.max(0, after - 1)];
    const share = end > begin ? (frame - begin) / (end - begin) : 1;
    return [fromX + share * (x - fromX), fromY + share * (y - fromY)];
}

/// A part of a still in which the event's object is to be seen; grey where no still is of its time.
function portraitOf(event) {
    const frame = document.createElement('div');
    const seen = stillNear((event.first + event.last) / 2);
    const place = placeOf(event, seen.frame);
    if (!place) return frame;
    const image = document.createElement('img');
    const shown = 0.3;  // of the still's longer side
    const side = 62 / shown / Math.max(...data.size);
    ['width', 'height'].forEach((name, k) => {
        const length = data.size[k] * side;
        image.style[name] = length + 'px';
        image.style[k ? 'top' : 'left'] = clamp(31 - place[k] * length, Math.min(0, 62 - length), 0) + 'px';
    });
    image.alt = '';
    image.src = seen.src;
    frame.append(image);
    return frame;
}

/// A ring in the player about what the chosen event is.
function drawRing() {
    const event = chosen === null ? null : data.events[chosen];
    const shown = !film && !still.hidden ? stillNear(now).frame : now;
    const place = event && placeOf(event, shown);
    at('ring').hidden = !place;
    if (!place) return;
    at('ring').style.left = place[0] * 100 + '%';
    at('ring').style.top = place[1] * 100 + '%';
}

function listEvents() {
    const list = at('events');
    const count = data.events?.length ?? 0;
    at('heading').textContent = count ? count + (count === 1 ? ' event' : ' events') : 'Events';
    at('previous').disabled = at('next').disabled = count === 0;
    if (!count) {
        const item = document.createElement('li');
        item.textContent = data.events ? 'Nothing moved long enough to be an event.' :
                                         'The filter of this picture marks no objects, so nobody looked for events.';
        list.append(item);
    }
    (data.events ?? []).forEach((event, number) => {
        const button = document.createElement('button');
        button.type = 'button';
        const times = document.createElement('b');
        times.textContent = `${number + 1}.  ${clockOf(secondsOf(event.first))} – ${clockOf(secondsOf(event.last))}`;
        const text = document.createElement('span');
        text.textContent = textOf(event);
        if (event.colour) button.style.borderLeft = '5px solid ' + event.colour;
        button.append(portraitOf(event), times, text);
        button.addEventListener('click', () => {
            choose(number);
            show(event.first, true);
        });
        const item = document.createElement('li');
        item.append(button);
        list.append(item);
    });
}

/// Lights up one event, or all of them for null.
function choose(number) {
    chosen = number;
    at('events').querySelectorAll('button').forEach((button, k) => {
        button.setAttribute('aria-current', k === number);
        if (k === number) button.scrollIntoView({block: 'nearest'});
    });
    at('bars').querySelectorAll('i').forEach((bar, k) => bar.classList.toggle('chosen', k === number));
    drawVeil();
    drawRing();
}

/// Goes to the next event, or the one before, and shows its first moment.
function step(by) {
    if (!data.events?.length) return;
    const number = chosen !== null ? clamp(chosen + by, 0, data.events.length - 1) :
        by > 0                     ? Math.max(0, data.events.findIndex(event => event.first >= now)) :
                                     Math.max(0, data.events.findLastIndex(event => event.first < now));
    choose(number);
    const event = data.events[number];
    show(event.first, false);
    if (document.activeElement?.closest('#events')) at('events').querySelectorAll('button')[number].focus();
    say(`Event ${number + 1} of ${data.events.length}, from ${clockOf(secondsOf(event.first))} to ${
        clockOf(secondsOf(event.last))}, ${textOf(event)}`);
}
at('previous').addEventListener('click', () => step(-1));
at('next').addEventListener('click', () => step(1));

// ---- Keys

const arrows = {
    ArrowLeft: [1, 0],
    ArrowRight: [-1, 0],
    ArrowUp: [0, 1],
    ArrowDown: [0, -1]
};
document.addEventListener('keydown', event => {
    if (event.ctrlKey || event.altKey || event.metaKey || event.target.closest('video')) return;
    const arrow = arrows[event.key];
    if (arrow && event.shiftKey)
        pan(80 * arrow[0], 80 * arrow[1]);
    else if (arrow)
        step(event.key === 'ArrowRight' || event.key === 'ArrowDown' ? 1 : -1);
    else if (event.key === '+' || event.key === '=')
        zoom(1.5);
    else if (event.key === '-')
        zoom(1 / 1.5);
    else if (event.key === '0')
        showWhole();
    else if (event.key === 'Escape')
        choose(null);
    else if (event.key === ' ' && !event.target.closest('button'))
        togglePlaying();
    else
        return;
    event.preventDefault();
});

// ---- Beginning

const count = lastFrame - firstFrame + 1;
at('summary').textContent = `${clockOf(begins, false)} to ${
    clockOf(secondsOf(lastFrame) + lengthOf(lastFrame), false)}, ${count} frame${count === 1 ? '' : 's'}`;
at('screen').style.aspectRatio = at('peeked').style.aspectRatio = data.size[0] + ' / ' + data.size[1];
at('screen').style.maxWidth = `max(160px, 46vh * ${data.size[0] / data.size[1]})`;
at('peeked').style.width = 220 * data.size[0] / Math.max(...data.size) + 'px';
listEvents();
drawStrip();
place();
drawNow();
openFilm(0);
followPlayer();
readPicture()
    .then(() => {
        labelEnds();
        drawVeil();
        document.documentElement.dataset.ready = '';
    })
    .catch(error => {
        at('notice').textContent =
            `The picture can’t tell times here: ${error.message}. The strip of time and the events can.`;
        at('notice').hidden = false;
    });
