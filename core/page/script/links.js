
// ---- Links and exports

/// What the address asks for: #event=4 or #t=12.9, a second of the clip.
function followAddress() {
    const parts = new URLSearchParams(location.hash.slice(1));
    const number = parts.has('event') ? placeOfNumber(Number(parts.get('event'))) : -1;
    if (number >= 0) {
        choose(number);
        show(events[number].first, false);
        until = events[number].last;
        return;
    }
    const seconds = Number(parts.get('t') ?? NaN);
    if (Number.isFinite(seconds)) show(frameAt(clamp(seconds, begins, secondsOf(lastFrame))), false);
}
addEventListener('hashchange', followAddress);

/// So that going back, and a reload, find the event again.
function keepInAddress() {
    const wantedHash = chosen === null ? '' : '#event=' + numberOf(chosen);
    if (location.hash !== wantedHash) history.replaceState(null, '', wantedHash || location.pathname + location.search);
}

/// A place in the page without a clipboard of its own has only the old way to copy.
async function copy(text, what) {
    try {
        await navigator.clipboard.writeText(text);
    } catch {
        const area = element('textarea', 'unseen');
        area.value = text;
        document.body.append(area);
        area.select();
        document.execCommand('copy');
        area.remove();
    }
    tell(`Copied ${what}: ${text}`);
}

function tell(text) {
    at('told').textContent = text;
    at('told').hidden = false;
    clearTimeout(tell.timer);
    tell.timer = setTimeout(() => { at('told').hidden = true; }, 6000);
}

const linkHere = () => location.href.split('#')[0] + (chosen === null ? '#t=' + secondsOf(now).toFixed(3) : '#event=' + numberOf(chosen));
at('copylink').addEventListener('click', () => copy(linkHere(), 'a link'));

/// When the last frame of an event has been shown. What follows may be a gap, which no file shows.
function endOf(event) {
    const step = stretchAt(0, event.last)[3];
    return secondsOf(event.last) + (step > 0 ? step : lengthOf(event.last));
}

/// The files that an event is in, in order: [the way to it as a shell reads it, seconds at which it begins and ends];
/// null where there is none, or where a name has marks that no shell shows.
function filesOf(event) {
    const [first, end] = [secondsOf(event.first), endOf(event)];
    const files = segments.length ? segments.filter(([, begin, length]) => begin < end - 1e-6 && begin + length > first + 1e-6)
                                  : [[data.clip ?? '', 0, Infinity]];
    try {
        const paths = files.map(([address, begin, length]) => [decodeURIComponent(address), begin, begin + length]);
        return paths.length && paths.every(([path]) => path !== '' && !/[\u0000-\u001f\u007f]/.test(path)) ? paths : null;
    } catch {
        return null;
    }
}
const quoted = text => /^[\w./-]+$/.test(text) ? text : `'${text.replaceAll("'", "'\\''")}'`;

/// The command that cuts an event out of the clip, or out of those files of a recording in which it is.
function cutCommand(number) {
    const files = filesOf(events[number]);
    const [[path, begin]] = files;
    const stem = path.slice(path.lastIndexOf('/') + 1).replace(/\.[^.]*$/, '').replace(/^-/, '_');
    const time = seconds => (Math.max(seconds, begin) - begin).toFixed(3) + 's';
    const overlap = files.some(([, from], i) => i > 0 && from < files[i - 1][2] - 0.001);
    return ['vvr cut', ...files.map(([file]) => quoted(file)), ...data.cut.names.map(names => `--names ${quoted(names)}`),
            `--start ${time(secondsOf(events[number].first))} --end ${time(Math.min(endOf(events[number]), files.at(-1)[2]))}`,
            overlap ? '--exact' : [], `-o ${quoted(`${stem}-event-${numberOf(number)}${overlap ? '.mp4' : data.cut.ending}`)}`].flat().join(' ');
}
at('copycut').addEventListener('click', () => { if (chosen !== null) copy(cutCommand(chosen), 'the command'); });

/// A picture of the frame on show: {image, frame, from}, where `from` says what it is taken from; '' = the clip.
/// Browsers give no pixels of a clip that was opened as a file: then it is the preview's, else a still's.
const stillSources = [
    async () => film && {image: video, frame: film.isPreview ? frameOfPreview(now) : now, from: film.isPreview ? 'the preview in this page' : ''},
    previewNow,
    stillNow,
];

async function saveStill() {
    for (const open of stillSources) {
        const still = await open();
        if (!still) continue;
        try {
            return save(await pngOf(still.image), still);
        } catch (error) {
            if (error.name !== 'SecurityError') throw error;
        }
    }
}

function pngOf(image) {
    const canvas = document.createElement('canvas');
    canvas.width = image.videoWidth ?? image.naturalWidth;
    canvas.height = image.videoHeight ?? image.naturalHeight;
    canvas.getContext('2d').drawImage(image, 0, 0, canvas.width, canvas.height);
    return new Promise(done => canvas.toBlob(done, 'image/png'));
}

/// The preview at the moment on show.
async function previewNow() {
    if (!data.preview) return null;
    const small = document.createElement('video');
    small.muted = true;
    small.src = previewUrl();
    const happens = name => new Promise((done, fail) => {
        small.addEventListener(name, done, {once: true});
        small.addEventListener('error', () => fail(new Error('the preview does not open')), {once: true});
    });
    await happens('loadeddata');
    small.currentTime = Math.max(0, timeWithin(now) - data.preview.begin);
    await happens('seeked');
    setTimeout(() => URL.revokeObjectURL(small.src), 10_000);
    return {image: small, frame: frameOfPreview(now), from: 'the preview in this page'};
}

/// The frame that the preview shows: it has every second, third, ... alone.
const frameOfPreview = frame => frame - (frame - firstFrame) % data.preview.step;

async function stillNow() {
    const nearest = stillNear(now);
    const image = new Image();
    image.src = nearest.src;
    await image.decode();
    return {image, frame: nearest.frame, from: 'a still in this page'};
}

/// Names a still after its camera, else its clip, and its time.
const stillName = (frame, ending) => `${upright(data.camera ?? data.name).replace(/[^\p{L}\p{N}._-]+/gu, '_')} ${dayOf(secondsOf(frame))} ${clockOf(secondsOf(frame)).replaceAll(':', '-')}${ending}`.replace(/ +/g, ' ');

/// What is not the clip's own frame says so, in the file's name too: it may be taken for evidence.
function save(blob, {image, frame, from}) {
    const size = [image.videoWidth ?? image.naturalWidth, image.videoHeight ?? image.naturalHeight];
    const whole = from === '' && size.every((side, k) => Math.abs(side - data.size[k]) <= 1);
    const link = element('a');
    link.download = stillName(frame, whole ? '.png' : '.preview.png');
    link.href = URL.createObjectURL(blob);
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
    const fullSize = at('copystill').disabled ? '' : ' “Copy still command” gives the clip’s own frame.';
    const other = frame === now ? '' : ` It is the frame at ${clockOf(secondsOf(frame))}.`;
    tell(whole ? `Saved ${link.download}, ${size.join('×')}, as in the clip`
        : `Saved ${link.download}: ${size.join('×')} of the clip’s ${data.size.join('×')}, from ${from || 'the player'}.${other}${fullSize}`);
}
at('savestill').addEventListener('click', () => saveStill().catch(error => tell(`The still can’t be saved: ${error.message}`)));

/// The file that a frame is in, as filesOf has it.
const fileOf = frame => filesOf({first: frame, last: frame})?.[0] ?? null;

/// The command that takes a frame out of the clip in its full size: FFmpeg shows the first frame that is not before a time.
function stillCommand(frame) {
    const [path, begin] = fileOf(frame);
    const seconds = Math.max(0, secondsOf(frame) - begin - Math.min(lengthOf(frame) / 2, 0.01));
    return `ffmpeg -ss ${seconds.toFixed(3)} -i ${quoted(path.startsWith('-') ? './' + path : path)} -frames:v 1 ${quoted(stillName(frame, '.png'))}`;
}
at('copystill').disabled = fileOf(firstFrame) === null;
at('copystill').addEventListener('click', () => copy(stillCommand(now), 'the command for this frame in full size'));

/// The index knows which clip comes next: this page was made before that clip was there.
if (data.index) {
    for (const [id, hash] of [['toindex', ''], ['earlier', '#before='], ['later', '#after=']]) {
        at(id).href = data.index.url + (hash && hash + encodeURIComponent(data.index.clip));
    }
    at('around').hidden = false;
}
