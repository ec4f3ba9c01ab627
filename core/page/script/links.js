
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

/// The file that an event is in: [the way to it as a shell reads it, seconds at which it begins]; null where there is
/// none, or where its name has marks that no shell shows.
function fileOf(event) {
    const [address, begin] = segments.length ? segmentAt(secondsOf(event.first)) : [data.clip, 0];
    try {
        const path = decodeURIComponent(address ?? '');
        return path === '' || /[\u0000-\u001f\u007f]/.test(path) ? null : [path, begin];
    } catch {
        return null;
    }
}
const quoted = text => /^[\w./-]+$/.test(text) ? text : `'${text.replaceAll("'", "'\\''")}'`;

/// The command that cuts an event out of the clip.
function cutCommand(number) {
    const event = events[number];
    const [path, begin] = fileOf(event);
    const stem = path.slice(path.lastIndexOf('/') + 1).replace(/\.[^.]*$/, '').replace(/^-/, '_');
    const time = seconds => (seconds - begin).toFixed(3) + 's';
    return `vvr cut ${quoted(path)} --from ${time(secondsOf(event.first))} --to ${time(secondsOf(event.last) + lengthOf(event.last))} -o ${quoted(`${stem}-event-${numberOf(number)}.mp4`)}`;
}
at('copycut').addEventListener('click', () => { if (chosen !== null) copy(cutCommand(chosen), 'the command'); });

/// The frame on show as a picture. Browsers give no pixels of a clip that was opened as a file: then it is the
/// preview's, else a still's.
async function saveStill() {
    const sources = [[async () => film && video, ''], [previewNow, ', which is the preview’s'], [stillNow, ', which is small']];
    for (const [open, remark] of sources) {
        const image = await open();
        if (!image) continue;
        try {
            return save(await pngOf(image), remark);
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
    return small;
}

async function stillNow() {
    const image = new Image();
    image.src = stillNear(now).src;
    await image.decode();
    return image;
}

function save(blob, remark) {
    const link = element('a');
    link.download = `${data.name.replace(/[^\p{L}\p{N}._-]+/gu, '_')} ${dayOf(secondsOf(now))} ${clockOf(secondsOf(now)).replaceAll(':', '-')}.png`.replace(/ +/g, ' ');
    link.href = URL.createObjectURL(blob);
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
    tell(`Saved ${link.download}${remark}`);
}
at('savestill').addEventListener('click', () => saveStill().catch(error => tell(`The still can’t be saved: ${error.message}`)));

/// The index knows which clip comes next: this page was made before that clip was there.
if (data.index) {
    for (const [id, hash] of [['toindex', ''], ['earlier', '#before='], ['later', '#after=']]) {
        at(id).href = data.index.url + (hash && hash + encodeURIComponent(data.index.clip));
    }
    at('around').hidden = false;
}
