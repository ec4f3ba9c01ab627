// The player: the clip, else the pieces of its events, else the preview in this page, else stills.

import {at} from '../shared/dom.js';
import {clipTime} from '../shared/durations.js';
import {clamp} from '../shared/text.js';
import {bytesOf} from './base64.js';
import {busyStretches, newestAt, stretchFrom} from './busy.js';
import {stillNear} from './events.js';
import {wantedEvents} from './filters.js';
import {wasDrag} from './layout.js';
import {momentOf} from './moments.js';
import {tell} from './messages.js';
import {fileAt, footageOf, hasMoment, nameOf} from './pieces.js';
import {render, set, state} from './state.js';
import {isForeign, isGone, notPlayed, whyNot} from './unplayable.js';

/**
 * What the player can open.
 * @typedef {object} Film
 * @property {string} says what it is
 * @property {import('./data.js').Segment[]} files one, those of a recording, or the pieces of its events; the player opens the one that it needs
 * @property {import('./data.js').Segment} segment the file of these that is open
 * @property {boolean} [isPieces] there is nothing between the files
 * @property {boolean} [isPreview]
 * @property {number} stretch seconds of the picture per second of its own clock
 * @property {number} [offset] where its own clock is at its first frame
 * @property {string} [src] the address that is open
 */

export const video = at('video', HTMLVideoElement);
const still = at('still', HTMLImageElement);
const speed = at('speed', HTMLSelectElement);
const loop = at('loop', HTMLInputElement);

let previewAddress = '';  // it has up to 8 MB: one copy is enough

export function previewUrl() {
    const {preview} = state.parts;
    if (preview && !previewAddress) previewAddress = URL.createObjectURL(new Blob([bytesOf(preview.base64)], {type: preview.type}));
    return previewAddress;
}

/**
 * The films in the order in which they are tried, each at the moment that is shown.
 * @returns {(() => Film)[]}
 */
function filmsOf() {
    const {data, time, now} = state;
    const {preview} = state.parts;
    const ofFiles = (/** @type {import('./data.js').Segment[]} */ files, /** @type {string} */ says) =>
        ({says, files, segment: fileAt(files, time.secondsOf(now)), stretch: data.stretch ?? 1});
    const films = [];
    const {films: ofStream} = data;
    if (ofStream?.length) films.push(() => ofFiles(ofStream, 'a film of the last bricks'));
    const footage = footageOf(data);
    if (footage.length) films.push(() => ofFiles(footage, data.clip ? 'the original clip' : 'the original recording'));
    const pieces = footageOf(data, true);
    if (pieces.length) films.push(() => ({...ofFiles(pieces, 'a clip per event'), isPieces: true}));
    if (preview) {
        const every = preview.step > 1 ? ', one frame in ' + preview.step : '';
        films.push(() => ({...ofFiles([[previewUrl(), preview.begin, Infinity]], `a small preview${every}`), isPreview: true, stretch: 1}));
    }
    return films;
}

/**
 * Whether the film that is open has a frame: between the pieces of events there is none.
 * @param {number} frame
 */
export const hasFrame = frame => !state.film?.isPieces || hasMoment(state.film.files, state.time.secondsOf(frame));

/** Whether a still is shown instead of a film. */
export const showsStill = () => state.stills || !hasFrame(state.now);

/** What the player does, or will do once a film is open. */
export const isPlaying = () => state.film ? !video.paused : state.wantsPlay;

/**
 * Whether the file that was opened can be what the picture was made of.
 * @param {Film} candidate
 */
function isTheClip(candidate) {
    if (video.videoWidth === 0) return false;
    if (!Number.isFinite(video.duration)) return true;
    const [, begin, length] = candidate.segment;
    const wanted = Number.isFinite(length) ? length : state.time.secondsOf(state.time.lastFrame) - begin;
    return video.duration * candidate.stretch + 1 > wanted;
}

/** Whether the player can go to any moment. With a server that sends files only from their beginning it would play that. */
const canSeek = () => video.seekable.length > 0 && video.seekable.end(0) > 0;

/**
 * The film that was asked for before the page had come as a whole.
 * @type {{place: number, why: string} | null}
 */
let waiting = null;

export function openWaiting() {
    if (waiting) openFilm(waiting.place, waiting.why);
}

/**
 * Looks whether a clip that cannot be played is there at all.
 * @param {string} address
 * @param {number} place among the films
 */
function lookFor(address, place) {
    const probe = document.createElement('video');
    probe.onerror = () => {
        const why = whyNot(probe.error?.message ?? '', address);
        if (why !== notPlayed) openFilm(place + 1, why);
    };
    probe.src = address;
}

/**
 * @param {number} place among the films
 * @param {string} [why] the one before can't be played
 * @returns {void}
 */
export function openFilm(place, why = '') {
    const {data} = state;
    const gone = place > 0 && (state.gone || isGone(why, footageOf(data, true).length > 0));
    set({film: null, gone, wantsPlay: isPlaying()});
    const because = why ? `${why}, so this is ` : '';
    const films = filmsOf();
    // What cannot be played must not take the way from what is still to come.
    const isInVain = !why && place < films.length && isForeign(films[place]().segment[0], video);
    if ((isInVain || place >= films.length) && !state.allArrived) {
        waiting = {place, why};
        return set({source: (why && why + ', ') + 'loading the preview…'});
    }
    waiting = null;
    if (place >= films.length) {
        video.onerror = null;
        video.removeAttribute('src');
        set({stills: true, source: because ? `${because}a still` : data.live ? 'stills' : 'a still, as there is no film to be played'});
        return;
    }
    const film = films[place]();
    if (isInVain) {
        lookFor(film.segment[0], place);
        return openFilm(place + 1, notPlayed);
    }
    const next = (/** @type {string} */ reason) => openFilm(place + 1, reason);
    film.offset = 0;
    const ready = () => {
        if (state.film === film || video.src !== film.src) return;
        if (!canSeek()) return next('the server can’t send a part of the clip');
        if (film.files.length > 1) video.onerror = () => { video.dataset.failed = video.src; };  // of others only one part is missing
        const plays = isPlaying();
        set({film, stills: false, source: because + film.says});
        if (state.moved) show(state.now, plays, {follows: state.follows});
        else if (state.time.secondsOf(state.now) > film.segment[1] + 0.002) goToFrame(video, state.now);
    };
    video.onerror = () => next(whyNot(video.error?.message ?? '', film.segment[0]));
    video.onloadedmetadata = () => {
        if (!isTheClip(film)) next('the file of that name is another clip');
    };
    video.onloadeddata = () => {
        if (!video.requestVideoFrameCallback) return ready();
        setTimeout(ready, 700);  // a page that is not to be seen gets no frames
        video.requestVideoFrameCallback((_, shown) => {
            if (video.currentTime === 0 && shown.mediaTime < 5) film.offset = shown.mediaTime;
            ready();
        });
    };
    video.src = film.segment[0];
    film.src = video.src;
}

/** A stream's newer page has newer films. What plays goes on. */
export function takeFilms() {
    const {data: {films}, film} = state;
    if (!films?.length) return;
    if (!film) return openFilm(0);
    film.files = films;
    if (!isPlaying()) goToFrame(video, state.now);
}

/**
 * Shows a frame in one of the two players; of a recording or of pieces it opens the file that has it.
 * @param {HTMLVideoElement} player
 * @param {number} frame
 */
export function goToFrame(player, frame) {
    const {film, time} = state;
    if (!film) return;
    const segment = fileAt(film.files, time.secondsOf(frame));
    const inside = Math.max(0, (time.timeWithin(frame) - segment[1]) / film.stretch + (film.offset ?? 0));
    if (player === video) film.segment = segment;
    const address = new URL(segment[0], location.href).href;
    if (player.src === address) {
        player.currentTime = inside;
        return;
    }
    const rate = player.playbackRate;
    // What is seen until the file is there.
    player.poster = stillNear(state.parts.stills, frame)?.src ?? '';
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
 * @param {Partial<typeof state>} [change] of the state besides
 */
export function show(frame, play, change = {}) {
    let now = state.time.clamped(frame);
    let plays = play;
    if (state.film) {
        if (play && !hasFrame(now)) {
            const piece = state.film.files.find(([, begin]) => begin > state.time.secondsOf(now));
            if (piece) now = state.time.clamped(state.time.frameAt(piece[1]));
            plays = piece !== undefined;
        }
        goToFrame(video, now);
        playFilm(plays);
    }
    set({now, moved: true, wantsPlay: plays, stillClock: state.time.secondsOf(now), follows: false, ...change});
}

/** @param {boolean} play */
function playFilm(play) {
    if (play) video.play().catch(() => {});
    else video.pause();
}

/** @param {boolean} play */
export function setPlaying(play) {
    if (play && !hasFrame(state.now)) return show(state.now, true);
    if (state.film) playFilm(play);
    set({moved: true, wantsPlay: play});
}

/** After the last moment of what was to play, playing begins it again. */
export function togglePlaying() {
    if (isPlaying() || state.now !== state.time.lastFrame) return setPlaying(!isPlaying());
    show(state.time.firstFrame, true);
}

const speeds = [0.25, 0.5, 1, 2, 4, 8];

/** @param {number} by 1 = the next faster one */
export const changeSpeed = by => set({speed: speeds[clamp(speeds.indexOf(state.speed) + by, 0, speeds.length - 1)]});

export function drawSpeed() {
    speed.value = String(state.speed);
    video.playbackRate = video.defaultPlaybackRate = state.speed;
}

// ---- The events one after another

const stretches = () => busyStretches(wantedEvents().map(place => state.events[place]), 1 + Math.round(state.time.frames / Math.max(1, state.time.lasts)));

/** Plays the wanted events from here on, without what is between them; again it ends that. */
export function toggleTour() {
    if (state.touring) {
        set({touring: false});
        return setPlaying(false);
    }
    const next = stretchFrom(stretches(), state.moved ? state.now : -1) ?? stretchFrom(stretches(), -1);
    if (!next) return tell('There are no events to play.');
    show(next.from, true, {until: next.last, touring: true});
}

/** Chooses the event that came last, and leaps over what is between events. */
function followTour() {
    const {events, now, until} = state;
    const newest = newestAt(events, wantedEvents(), until === null ? now : Math.min(now, until));  // the film may have gone past it
    if (newest >= 0 && newest !== state.chosen) set({chosen: newest});
    if (until === null || now < until) return;
    const next = stretchFrom(stretches(), now);
    if (next) return show(next.from, true, {until: next.last});
    show(until, false, {until: null, touring: false});
    tell('All events have been played.');
}

export function drawTour() {
    at('playall').textContent = state.touring ? '■ Stop' : '▶ Play events';
    at('playall').setAttribute('aria-pressed', String(state.touring));
}

// ---- A time that is typed

export function askTime() {
    set({jumping: true});
    jump.value = '';
    jump.focus();
}

const jump = at('jump', HTMLInputElement);

export function drawJump() {
    jump.hidden = !state.jumping;
    at('clock').hidden = state.jumping;
}

function jumpToTyped() {
    const seconds = momentOf(jump.value, state.time);
    if (seconds === null) return tell(`“${jump.value}” is no time of this clip. It has ${state.time.span()}.`);
    set({jumping: false});
    goTo(state.time.frameAt(Math.min(seconds, state.time.secondsOf(state.time.lastFrame))));
}

/**
 * To another frame, from which it plays on if it plays.
 * @param {number} frame
 */
export const goTo = frame => show(frame, isPlaying(), {until: null, touring: false});

/** @param {number} seconds */
export function goBy(seconds) {
    const {time, now} = state;
    goTo(time.frameAt(clamp(time.secondsOf(now) + seconds, time.begins, time.secondsOf(time.lastFrame))));
}

/** The preview of a long clip has only every second, third, ... frame: a step goes to the next picture. */
const frameStep = () => state.film?.isPreview ? state.parts.preview?.step ?? 1 : 1;

/**
 * To a frame beside the one that is shown, and stays there.
 * @param {number} by
 */
export const stepFrame = by => show(state.time.frameBeside(state.now, by * frameStep()), false, {until: null, touring: false});

/** On a small window the player is below the picture: what plays is to be seen. */
export function bringIntoSight() {
    const box = at('screen').getBoundingClientRect();
    if (box.bottom > innerHeight || box.top < 0) at('screen').scrollIntoView({block: 'nearest'});
}

let lastLook = performance.now();

/** Follows the film, over what the picture does not show; where there is no film, goes on from still to still. */
export function followPlayer() {
    let isOver = false;  // whether the film shows what comes after the frame
    const {film, time, until} = state;
    const passed = (performance.now() - lastLook) / 1000;
    lastLook = performance.now();
    if (film && state.moved && !video.seeking && video.readyState > 1 && (!video.paused || hasFrame(state.now))) {
        const [, begin, length] = film.segment;
        const seconds = (video.currentTime - (film.offset ?? 0)) * film.stretch + begin;
        const now = time.frameAt(seconds);
        isOver = seconds > Math.min(time.secondsOf(now) + time.lengthOf(now), begin + length) + 0.05;
        set({now});
    } else if (state.stills && state.wantsPlay) {
        // A stream's page may have lost the moment that was shown.
        const stillClock = Math.max(state.stillClock, time.begins) + passed * state.speed;
        const now = time.clamped(time.frameAt(stillClock));
        set({now, stillClock});
        if (now === time.lastFrame) setPlaying(false);
    }
    if (isPlaying() && state.touring) followTour();
    else if (isPlaying() && until !== null && state.now >= until) endOfEvent(until);
    else if (isPlaying() && isOver) playOnAfter(state.now);
    setTimeout(() => requestAnimationFrame(followPlayer), 60);
}

/**
 * Plays on with the next frame that the picture shows, or stops after its last.
 * @param {number} frame
 */
function playOnAfter(frame) {
    const {time, until, touring} = state;
    if (frame < time.lastFrame) show(time.frameBeside(frame, 1), true, {until, touring});
    else show(time.lastFrame, false, {until: null, touring: false});
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
    const {film} = state;
    at('source').textContent = state.source + (film && film.files.length > 1 && !state.data.live ? ': ' + nameOf(film.segment) : '');
    video.hidden = showsStill();
    still.hidden = !showsStill();
}

export function drawClocks() {
    const {time, now} = state;
    // Tenths where one steps; they are of no use while it runs.
    at('clock').textContent = time.clockOf(time.secondsOf(now), !isPlaying());
    at('cliptime').textContent = time.clock === null || state.data.live ? '' : clipTime(time.secondsOf(now)) + ' of the clip';
}

export function drawStill() {
    if (!showsStill()) return;
    const nearest = stillNear(state.parts.stills, state.now);
    if (!nearest) return;
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
        const {film, time} = state;
        if (!film) return;
        const [, begin, length] = film.segment;
        const last = time.frameAt(begin + length - 0.002);  // of the file
        // A piece ends with its event.
        const isOver = film.isPieces && (state.until !== null && !state.touring || !film.files.some(([, from]) => from > begin));
        if (last < time.lastFrame && !isOver) playOnAfter(last);
        else if (state.touring) set({touring: false});
        else if (state.until !== null) endOfEvent(state.until);
    });
    video.addEventListener('click', event => {
        if (state.asking || wasDrag()) return;
        event.preventDefault();
        togglePlaying();
    });
    at('play').addEventListener('click', togglePlaying);
    at('back').addEventListener('click', () => stepFrame(-1));
    at('forward').addEventListener('click', () => stepFrame(1));
    speed.addEventListener('change', () => set({speed: Number(speed.value)}));
    at('playall').addEventListener('click', toggleTour);
    at('clock').addEventListener('click', askTime);
    jump.addEventListener('keydown', event => {
        if (event.key === 'Enter') jumpToTyped();
        if (event.key === 'Escape') set({jumping: false});
        event.stopPropagation();
    });
    jump.addEventListener('blur', () => set({jumping: false}));
}
