
// ---- The player: the clip, else the preview in this page, else stills

const video = at('video');
const still = at('still');
let now = firstFrame;  // the frame on show
let moved = false;     // whether anybody asked for a moment yet
let film = null;       // what the player has open
let playing = false;
let until = null;      // the frame at which playing ends; null = none

const previewUrl = () => URL.createObjectURL(new Blob([bytesOf(data.preview.base64)], {type: data.preview.type}));
const films = [];
if (data.clip) films.push({url: () => data.clip, begin: 0, says: 'the clip itself'});
// Files of a recording, [address, seconds at which it begins, length] each: the player opens the one that it needs.
const segments = data.segments ?? [];
if (segments.length) films.push({url: () => segments[0][0], begin: segments[0][1], says: 'the recording itself', segment: segments[0]});
if (data.preview) {
    const every = data.preview.step > 1 ? ', one frame in ' + data.preview.step : '';
    films.push({url: previewUrl, begin: data.preview.begin, isPreview: true, says: `a small preview${every}`});
}

/// Whether the file that was opened can be what the picture was made of.
function isTheClip(candidate) {
    if (video.videoWidth === 0) return false;
    if (candidate.segment) return !Number.isFinite(video.duration) || video.duration + 1 > candidate.segment[2];
    return !Number.isFinite(video.duration) || video.duration + 1 > secondsOf(lastFrame) - candidate.begin;
}

/// Whether the player can go to any moment. Of a server that sends files only from their beginning it can't, and would
/// play that beginning instead.
const canSeek = () => video.seekable.length > 0 && video.seekable.end(0) > 0;

/// \param why the one before can't be played
function openFilm(number, why = '') {
    film = null;
    const because = why ? `${why}, so this is ` : '';
    if (number === films.length) {
        video.onerror = null;
        video.removeAttribute('src');
        video.hidden = true;
        still.hidden = false;
        at('source').textContent = because ? `${because}a still` : 'a still, as there is no film to be played';
        drawNow();
        return;
    }
    const candidate = films[number];
    const next = reason => openFilm(number + 1, reason);
    // Where the film's own clock stands at its first frame, which is our zero.
    candidate.offset = 0;
    const ready = () => {
        if (film === candidate || video.src !== candidate.src) return;
        if (!canSeek()) return next('the server can’t send a part of the clip');
        film = candidate;
        if (film.segment) video.onerror = () => { video.dataset.failed = video.src; };  // of others only one part is missing
        at('source').textContent = because + film.says;
        at('peeker').src = film.src;
        if (moved) show(now, playing);
    };
    video.onerror = () => next('the clip can’t be played here');
    video.onloadedmetadata = () => {
        if (!isTheClip(candidate)) next('the clip can’t be played here');
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

/// The file of a recording that shows a moment: the last that begins by then.
const segmentAt = seconds => segments.findLast(([, begin]) => begin <= seconds + 1e-6) ?? segments[0];

/// Shows a frame in one of the two players; of a recording it opens the file that has it.
function goToFrame(player, frame) {
    const seconds = timeWithin(frame);
    if (!film.segment) {
        player.currentTime = Math.max(0, seconds - film.begin + film.offset);
        return;
    }
    const segment = segmentAt(seconds);
    const inside = Math.max(0, seconds - segment[1] + film.offset);
    if (player === video) {
        film.segment = segment;
        film.begin = segment[1];
    }
    const address = new URL(segment[0], location.href).href;
    if (player.src === address) {
        player.currentTime = inside;
        return;
    }
    const speed = player.playbackRate;
    player.onloadedmetadata = () => {
        player.onloadedmetadata = null;
        player.playbackRate = speed;
        player.currentTime = inside;
    };
    player.src = address;
}
video.addEventListener('ended', () => {
    const next = film?.segment ? segments[segments.indexOf(film.segment) + 1] : undefined;
    if (next) show(frameAt(next[1]), true);
});

/// Goes to the middle of a frame, and plays on from there.
function show(frame, play) {
    now = clamp(frame, firstFrame, lastFrame);
    moved = true;
    playing = play;
    stillClock = secondsOf(now);
    if (film) {
        goToFrame(video, now);
        if (play) video.play().catch(() => {});
        else video.pause();
    }
    drawNow();
    drawButtons();
}

/// Plays an event, and stops at its end or begins again.
function playEvent(number) {
    choose(number);
    show(data.events[number].first, true);
    until = data.events[number].last;
    bringIntoSight();
}

/// On a small window the player is below the picture: what plays is to be seen.
function bringIntoSight() {
    const box = at('screen').getBoundingClientRect();
    if (box.bottom > innerHeight || box.top < 0) at('screen').scrollIntoView({block: 'nearest'});
}

function drawNow() {
    at('clock').textContent = clockOf(secondsOf(now));
    at('cliptime').textContent = data.clock === null || data.live ? '' : clipTime(secondsOf(now)) + ' of the clip';
    drawCursor();
    if (!still.hidden) {
        const nearest = stillNear(now);
        still.src = nearest.src;
        still.alt = 'The clip at ' + clockOf(secondsOf(nearest.frame));
    }
    drawVeil();
    drawRing();
}

function drawButtons() {
    at('play').textContent = playing ? '❚❚' : '▶';
    at('play').ariaLabel = playing ? 'Pause' : 'Play';
}

let lastLook = performance.now();

/// Follows the film; where there is none, goes on from still to still.
function followPlayer() {
    const passed = (performance.now() - lastLook) / 1000;
    lastLook = performance.now();
    let frame = now;
    if (film && moved && !video.seeking && video.readyState > 1) {
        frame = clamp(frameAt(video.currentTime - film.offset + film.begin), firstFrame, lastFrame);
    } else if (!film && playing && !still.hidden) {
        stillClock += passed * Number(at('speed').value);
        frame = clamp(frameAt(stillClock), firstFrame, lastFrame);
        if (frame === lastFrame) setPlaying(false);
    }
    if (!playing || film || still.hidden) stillClock = secondsOf(now);
    if (frame !== now) {
        now = frame;
        drawNow();
    }
    if (playing && until !== null && now >= until) endOfEvent();
    setTimeout(() => requestAnimationFrame(followPlayer), 60);
}
let stillClock = begins;

function endOfEvent() {
    const again = at('loop').checked && chosen !== null;
    const stop = until;
    if (again) {
        show(data.events[chosen].first, true);
    } else {
        until = null;
        show(stop, false);
    }
}

function setPlaying(play) {
    moved = true;
    playing = play;
    if (film && play) video.play().catch(() => {});
    else if (film) video.pause();
    drawButtons();
}

function togglePlaying() {
    setPlaying(!playing);
}
video.addEventListener('play', () => { moved = playing = true; drawButtons(); });
video.addEventListener('pause', () => {
    if (!video.seeking && !video.ended) playing = false;
    drawButtons();
});
video.addEventListener('click', event => {
    if (asking) return;
    event.preventDefault();
    togglePlaying();
});

/// To another frame, or by seconds, and stays there.
function goTo(frame) {
    until = null;
    show(frame, playing);
}
const goBy = seconds => goTo(frameAt(clamp(secondsOf(now) + seconds, begins, secondsOf(lastFrame))));
function stepFrame(by) {
    until = null;
    show(frameBeside(now, by), false);
}

at('play').addEventListener('click', togglePlaying);
at('back').addEventListener('click', () => stepFrame(-1));
at('forward').addEventListener('click', () => stepFrame(1));
at('speed').addEventListener('change', () => {
    video.playbackRate = video.defaultPlaybackRate = Number(at('speed').value);
});

function stillNear(frame) {
    return data.stills.reduce((a, b) => Math.abs(b.frame - frame) < Math.abs(a.frame - frame) ? b : a);
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

/// Puts a ring about where an event is in a frame.
function putRing(ring, number, frame) {
    const place = number === null ? null : placeOf(data.events[number], frame);
    ring.hidden = !place;
    if (!place) return;
    ring.style.left = place[0] * 100 + '%';
    ring.style.top = place[1] * 100 + '%';
}

/// A ring in the player about what the chosen event is.
function drawRing() {
    putRing(at('ring'), chosen, !film && !still.hidden ? stillNear(now).frame : now);
}
