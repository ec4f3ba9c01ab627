// The player: the clip, else the preview in this page, else stills.

import {at} from '../shared/dom.js';
import {clipTime} from '../shared/durations.js';
import {clamp} from '../shared/text.js';
import {stillNear} from './events.js';
import {render, set, state} from './state.js';

/**
 * What the player can open.
 * @typedef {object} Film
 * @property {() => string} url
 * @property {number} begin seconds of the clip
 * @property {string} says what it is
 * @property {import('./data.js').Segment} [segment] the file of a recording that is open
 * @property {boolean} [isPreview]
 * @property {number} [offset] where its own clock is at its first frame
 * @property {string} [src] the address that is open
 */

export const video = at('video', HTMLVideoElement);
const still = at('still', HTMLImageElement);
const speed = at('speed', HTMLSelectElement);
const loop = at('loop', HTMLInputElement);

/** @param {string} base64 */
export const bytesOf = base64 => Uint8Array.from(atob(base64), letter => letter.charCodeAt(0));

export function previewUrl() {
    const {preview} = state.data;
    return preview ? URL.createObjectURL(new Blob([bytesOf(preview.base64)], {type: preview.type})) : '';
}

/** @returns {Film[]} */
function filmsOf() {
    const {clip, segments, preview} = state.data;
    const films = [];
    if (clip) films.push({url: () => clip, begin: 0, says: 'the clip itself'});
    // The player opens the file of a recording that it needs.
    if (segments?.length) films.push({url: () => segments[0][0], begin: segments[0][1], says: 'the recording itself', segment: segments[0]});
    if (preview) {
        const every = preview.step > 1 ? ', one frame in ' + preview.step : '';
        films.push({url: previewUrl, begin: preview.begin, isPreview: true, says: `a small preview${every}`});
    }
    return films;
}
const films = filmsOf();
const segments = state.data.segments ?? [];

/** What the player does, or will do once a film is open. */
export const isPlaying = () => state.film ? !video.paused : state.wantsPlay;

/**
 * Whether the file that was opened can be what the picture was made of.
 * @param {Film} candidate
 */
function isTheClip(candidate) {
    if (video.videoWidth === 0) return false;
    if (!Number.isFinite(video.duration)) return true;
    const wanted = candidate.segment ? candidate.segment[2] : state.time.secondsOf(state.time.lastFrame) - candidate.begin;
    return video.duration + 1 > wanted;
}

/** Whether the player can go to any moment. With a server that sends files only from their beginning it would play that. */
const canSeek = () => video.seekable.length > 0 && video.seekable.end(0) > 0;

/**
 * @param {number} place among the films
 * @param {string} [why] the one before can't be played
 */
export function openFilm(place, why = '') {
    set({film: null, wantsPlay: isPlaying()});
    const because = why ? `${why}, so this is ` : '';
    if (place === films.length) {
        video.onerror = null;
        video.removeAttribute('src');
        set({stills: true, source: because ? `${because}a still` : 'a still, as there is no film to be played'});
        return;
    }
    const film = films[place];
    const next = (/** @type {string} */ reason) => openFilm(place + 1, reason);
    film.offset = 0;
    const ready = () => {
        if (state.film === film || video.src !== film.src) return;
        if (!canSeek()) return next('the server can’t send a part of the clip');
        if (film.segment) video.onerror = () => { video.dataset.failed = video.src; };  // of others only one part is missing
        const plays = isPlaying();
        set({film, source: because + film.says});
        if (state.moved) show(state.now, plays);
    };
    video.onerror = () => next('the clip can’t be played here');
    video.onloadedmetadata = () => {
        if (!isTheClip(film)) next('the clip can’t be played here');
    };
    video.onloadeddata = () => {
        if (!video.requestVideoFrameCallback) return ready();
        setTimeout(ready, 700);  // a page that is not to be seen gets no frames
        video.requestVideoFrameCallback((_, shown) => {
            if (video.currentTime === 0 && shown.mediaTime < 5) film.offset = shown.mediaTime;
            ready();
        });
    };
    video.src = film.url();
    film.src = video.src;
}

/**
 * The file of a recording that shows a moment: the last that begins by then.
 * @param {number} seconds
 */
const segmentAt = seconds => segments.findLast(([, begin]) => begin <= seconds + 1e-6) ?? segments[0];

/**
 * Shows a frame in one of the two players; of a recording it opens the file that has it.
 * @param {HTMLVideoElement} player
 * @param {number} frame
 */
export function goToFrame(player, frame) {
    const {film, time} = state;
    if (!film) return;
    const seconds = time.timeWithin(frame);
    const offset = film.offset ?? 0;
    if (!film.segment) {
        player.currentTime = Math.max(0, seconds - film.begin + offset);
        return;
    }
    const segment = segmentAt(seconds);
    const inside = Math.max(0, seconds - segment[1] + offset);
    if (player === video) {
        film.segment = segment;
        film.begin = segment[1];
    }
    const address = new URL(segment[0], location.href).href;
    if (player.src === address) {
        player.currentTime = inside;
        return;
    }
    const rate = player.playbackRate;
    player.onloadedmetadata = () => {
        player.onloadedmetadata = null;
        player.playbackRate = rate;
        player.currentTime = inside;
    };
    player.src = address;
}

/**
 * Goes to the middle of a frame, and plays on from there.
 * @param {number} frame
 * @param {boolean} play
 * @param {{until?: number | null}} [change] of the state besides
 */
export function show(frame, play, change = {}) {
    const now = state.time.clamped(frame);
    if (state.film) {
        goToFrame(video, now);
        playFilm(play);
    }
    set({now, moved: true, wantsPlay: play, stillClock: state.time.secondsOf(now), ...change});
}

/** @param {boolean} play */
function playFilm(play) {
    if (play) video.play().catch(() => {});
    else video.pause();
}

/** @param {boolean} play */
export function setPlaying(play) {
    if (state.film) playFilm(play);
    set({moved: true, wantsPlay: play});
}
export const togglePlaying = () => setPlaying(!isPlaying());

/**
 * To another frame, from which it plays on if it plays.
 * @param {number} frame
 */
export const goTo = frame => show(frame, isPlaying(), {until: null});

/** @param {number} seconds */
export function goBy(seconds) {
    const {time, now} = state;
    goTo(time.frameAt(clamp(time.secondsOf(now) + seconds, time.begins, time.secondsOf(time.lastFrame))));
}

/**
 * To a frame beside the one that is shown, and stays there.
 * @param {number} by
 */
export const stepFrame = by => show(state.time.frameBeside(state.now, by), false, {until: null});

/** On a small window the player is below the picture: what plays is to be seen. */
export function bringIntoSight() {
    const box = at('screen').getBoundingClientRect();
    if (box.bottom > innerHeight || box.top < 0) at('screen').scrollIntoView({block: 'nearest'});
}

let lastLook = performance.now();

/** Follows the film; where there is none, goes on from still to still. */
export function followPlayer() {
    const {film, time, until} = state;
    const passed = (performance.now() - lastLook) / 1000;
    lastLook = performance.now();
    if (film && state.moved && !video.seeking && video.readyState > 1) {
        set({now: time.clamped(time.frameAt(video.currentTime - (film.offset ?? 0) + film.begin))});
    } else if (state.stills && state.wantsPlay) {
        // A stream's page may have lost the moment that was shown.
        const stillClock = Math.max(state.stillClock, time.begins) + passed * Number(speed.value);
        const now = time.clamped(time.frameAt(stillClock));
        set({now, stillClock});
        if (now === time.lastFrame) setPlaying(false);
    }
    if (isPlaying() && until !== null && state.now >= until) endOfEvent(until);
    setTimeout(() => requestAnimationFrame(followPlayer), 60);
}

/**
 * Begins the event again, or stops at its last frame.
 * @param {number} last
 */
function endOfEvent(last) {
    if (loop.checked && state.chosen !== null) show(state.events[state.chosen].first, true);
    else show(last, false, {until: null});
}

export function drawPlayer() {
    at('source').textContent = state.source;
    video.hidden = state.stills;
    still.hidden = !state.stills;
}

export function drawClocks() {
    const {time, now} = state;
    at('clock').textContent = time.clockOf(time.secondsOf(now));
    at('cliptime').textContent = time.clock === null || state.data.live ? '' : clipTime(time.secondsOf(now)) + ' of the clip';
}

export function drawStill() {
    if (!state.stills) return;
    const nearest = stillNear(state.data.stills, state.now);
    still.src = nearest.src;
    still.alt = 'The clip at ' + state.time.clockOf(state.time.secondsOf(nearest.frame));
}

export function drawPlayButton() {
    at('play').textContent = isPlaying() ? '❚❚' : '▶';
    at('play').ariaLabel = isPlaying() ? 'Pause' : 'Play';
}

export function listenToPlayer() {
    video.addEventListener('play', () => set({moved: true}));
    video.addEventListener('pause', render);
    video.addEventListener('ended', () => {
        const next = state.film?.segment ? segments[segments.indexOf(state.film.segment) + 1] : undefined;
        if (next) show(state.time.frameAt(next[1]), true);
        else if (state.until !== null) endOfEvent(state.until);
    });
    video.addEventListener('click', event => {
        if (state.asking) return;
        event.preventDefault();
        togglePlaying();
    });
    at('play').addEventListener('click', togglePlaying);
    at('back').addEventListener('click', () => stepFrame(-1));
    at('forward').addEventListener('click', () => stepFrame(1));
    speed.addEventListener('change', () => { video.playbackRate = video.defaultPlaybackRate = Number(speed.value); });
}
