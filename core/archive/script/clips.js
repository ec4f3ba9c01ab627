
const many = (count, word) => count.toLocaleString('en') + ' ' + word + (count === 1 ? '' : 's');

/// The name in an address as people read it; bytes that are no UTF-8 stay as they stand there.
function readable(url) {
    try {
        return upright(decodeURIComponent(url));
    } catch {
        return url;
    }
}

// ---- The clock of the machine that drew the pictures, so that every reader sees the times of the place

const zone = data.zone.length ? data.zone : [[0, 0, 'UTC']];  // [from, seconds ahead of UTC, name] each

/// The clock on the wall at a moment, as a date whose UTC fields are what it shows.
function wallOf(seconds) {
    const change = zone.findLast(([from]) => from <= seconds) ?? zone[0];
    return new Date((seconds + change[1]) * 1000);
}
const dayOf = date => date.toISOString().slice(0, 10);
const timeOf = date => date.toISOString().slice(11, 19);
const weekday = day => new Date(day + 'T00:00:00Z').toLocaleDateString('en', {weekday: 'long', timeZone: 'UTC'});

function lengthOf(seconds) {
    const all = Math.round(seconds);
    if (all < 60) return seconds < 10 ? seconds.toFixed(1) + ' s' : all + ' s';
    const minutes = Math.floor(all / 60);
    return minutes < 60 ? minutes + ':' + digits(all % 60) + ' min'
                        : Math.floor(minutes / 60) + ':' + digits(minutes % 60) + ' h';
}

/// Text for comparisons: small letters without marks, with ü as u and, as others write it, as ue.
function folded(text) {
    const small = text.toLowerCase().normalize('NFC');
    const plain = small.normalize('NFD').replace(/\p{M}/gu, '').replaceAll('ß', 'ss');
    const german = small.replace(/[äöüß]/g, letter => ({ä: 'ae', ö: 'oe', ü: 'ue', ß: 'ss'})[letter]);
    return plain === german ? plain : plain + '\n' + german.normalize('NFD').replace(/\p{M}/gu, '');
}

// Each row: camera, address, begins (seconds since 1970), length, events or null, the kinds of files that there are,
// what is told of the events of each of `data.kinds` (seconds, or how many; 0 = nothing), the classes of their objects or
// null, and of a failure its status, its
// reason and the number of tries, and of one whose picture is there all the same the moment until which that shows the clip.
const [hasPicture, hasPage, hasThumbnail, hasStill, hasGone, hasDamage] = [1, 2, 4, 16, 256, 512];
// Where nothing tells when a clip was recorded, it stands where it was written.
const [byContainer, byFile] = [1024, 2048];
// A recording is all that a camera recorded on a day, in one picture.
const rows = [...data.clips.map(row => ({row})), ...data.recordings];
const clips = rows.map(({row: [camera, url, begins, seconds, events, files, tallies, classes, status, reason, tries, until], date: wholeDay, clips: of}) => {
    const date = wallOf(begins);
    const path = readable(url).replace(/^\.\//, '');
    const tallyOf = Object.fromEntries(data.kinds.map(({name}, rank) => [name, tallies?.[rank] ?? 0]));
    const clip = {camera, url, path, begins, seconds, events, files, tallyOf, classes: classes ?? [], status, reason: reason && upright(reason), tries,
                  wholeDay, of, name: wholeDay ? many(of, 'clip') : path.slice(path.lastIndexOf('/') + 1), time: timeOf(date), day: wholeDay ?? dayOf(date), hour: date.getUTCHours()};
    clip.failed = status !== undefined;
    clip.until = until === undefined ? '' : dayOf(wallOf(until)) + ' ' + timeOf(wallOf(until));
    clip.drawn = !clip.failed || clip.until !== '';
    clip.gone = (files & hasGone) !== 0;
    clip.damaged = (files & hasDamage) !== 0;
    clip.placedBy = files & byContainer ? 'when its container says it was written' : files & byFile ? 'when it was last written' : '';
    clip.text = folded([data.cameras[camera], path, clip.day, weekday(clip.day), clip.time, reason ?? '', ...clip.classes].join(' '));
    return clip;
}).sort((a, b) => b.begins - a.begins || (a.url < b.url ? -1 : 1));

/// Clips are counted one by one where they are there; a picture of a whole day tells of them again.
const counted = list => {
    const single = list.filter(clip => !clip.wholeDay);
    return single.length ? single : list;
};

const clipOfUrl = new Map(clips.map(clip => [clip.url, clip]));
const cameraName = camera => data.cameras[camera] === '' ? '(top folder)' : upright(data.cameras[camera]);
const pageOf = clip => clip.url + (clip.files & hasPage ? '.html' : '.png');

// ---- What has been seen, kept in the browser

const seenKey = 'vvr seen ' + location.pathname;
let seen = new Set();
try {
    seen = new Set(JSON.parse(localStorage.getItem(seenKey) ?? '[]'));
} catch {
    // a browser that keeps nothing
}

function see(clip) {
    seen.add(clip.url);
    try {
        localStorage.setItem(seenKey, JSON.stringify([...seen].slice(-20_000)));
    } catch {
        // it is full, or keeps nothing
    }
}

function grouped(list, key) {
    const groups = new Map();
    for (const clip of list) {
        const group = groups.get(clip[key]);
        if (group) group.push(clip);
        else groups.set(clip[key], [clip]);
    }
    return groups;
}

// ---- What is asked for: kept in the address, so that going back from a clip's page finds it again

const asked = {view: 'clips', text: '', kind: 'all', class: '', order: 'newest', camera: null, day: null};
// The kinds of events that are chosen together, by what the choice is called.
const kindsOfChoice = grouped(data.kinds.filter(({choice}) => choice !== null), 'choice');
// What objects can be asked for: groups of classes, and the classes in them.
const classesOf = new Map(Object.entries(data.classes).flatMap(([group, names]) => [[group, names], ...names.map(name => [name, [name]])]));
const isOf = (what, names) => what === '' || classesOf.get(what).some(name => names.includes(name));
const choices = {view: ['clips', 'days', 'scene'], kind: ['all', 'events', ...kindsOfChoice.keys(), 'unseen', 'failed'],
                 class: ['', ...classesOf.keys()], order: ['newest', ...kindsOfChoice.keys(), 'events']};

function readAsked() {
    const parts = new URLSearchParams(location.hash.slice(1));
    asked.text = parts.get('text') ?? '';
    asked.day = parts.get('day');
    for (const [name, known] of Object.entries(choices)) asked[name] = known.includes(parts.get(name)) ? parts.get(name) : known[0];
    const camera = data.cameras.indexOf(parts.get('camera') ?? undefined);
    asked.camera = camera < 0 ? null : camera;
    at('text').value = asked.text;
    at('order').value = asked.order;
    at('class').value = asked.class;
    for (const radio of document.getElementsByName('kind')) radio.checked = radio.value === asked.kind;
}

function keepAsked() {
    const parts = new URLSearchParams();
    if (asked.text) parts.set('text', asked.text);
    if (asked.day) parts.set('day', asked.day);
    for (const [name, known] of Object.entries(choices)) if (asked[name] !== known[0]) parts.set(name, asked[name]);
    if (asked.camera !== null) parts.set('camera', data.cameras[asked.camera]);
    history.replaceState(null, '', '#' + parts);
}

const isWanted = {
    all: () => true,
    events: clip => clip.events > 0,
    ...Object.fromEntries([...kindsOfChoice].map(([choice, ofChoice]) => [choice, clip => ofChoice.some(({name}) => clip.tallyOf[name] > 0)])),
    unseen: clip => clip.drawn && !seen.has(clip.url),
    failed: clip => clip.failed,
};

function chosenClips() {
    const words = asked.text.split(/\s+/).filter(Boolean).map(word => folded(word).split('\n'));
    return clips.filter(clip => (asked.camera === null || clip.camera === asked.camera) && isWanted[asked.kind](clip) && isOf(asked.class, clip.classes) &&
                                (!asked.day || clip.day === asked.day) &&
                                words.every(ways => ways.some(word => clip.text.includes(word))));
}

/// A clip's page leads here to find the clip before or after it, which it can't know.
function followNeighbour() {
    const parts = new URLSearchParams(location.hash.slice(1));
    const by = parts.has('after') ? -1 : 1;
    const clip = clipOfUrl.get(parts.get('after') ?? parts.get('before') ?? '');
    if (!clip) return false;
    const ofCamera = clips.filter(other => other.camera === clip.camera && other.drawn);
    const next = ofCamera[ofCamera.indexOf(clip) + by];
    if (next) location.replace(pageOf(next));
    else Object.assign(asked, {camera: clip.camera});
    if (!next) history.replaceState(null, '', '#' + new URLSearchParams({camera: data.cameras[clip.camera]}));
    return Boolean(next);
}
