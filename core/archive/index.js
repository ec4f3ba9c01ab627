'use strict';

const data = JSON.parse(document.getElementById('data').textContent);
const at = id => document.getElementById(id);
const digits = number => String(number).padStart(2, '0');
const many = (count, word) => count.toLocaleString('en') + ' ' + word + (count === 1 ? '' : 's');

/// The name in an address as people read it; bytes that are no UTF-8 stay as they stand there.
function readable(url) {
    try {
        return decodeURIComponent(url);
    } catch {
        return url;
    }
}

function dayOf(date) {
    return date.getFullYear() + '-' + digits(date.getMonth() + 1) + '-' + digits(date.getDate());
}

function lengthOf(seconds) {
    const all = Math.round(seconds);
    if (all < 60) return seconds < 10 ? seconds.toFixed(1) + ' s' : all + ' s';
    const minutes = Math.floor(all / 60);
    return minutes < 60 ? minutes + ':' + digits(all % 60) + ' min'
                        : Math.floor(minutes / 60) + ':' + digits(minutes % 60) + ' h';
}

// Each row: camera, address, begins (seconds since 1970), length, events or null, the kinds of files that there are, and
// of a failure its status, its reason and the number of tries.
const [hasPicture, hasPage, hasThumbnail] = [1, 2, 4];
const clips = data.clips.map(([camera, url, begins, seconds, events, files, status, reason, tries]) => {
    const date = new Date(begins * 1000);
    const name = readable(url.slice(url.lastIndexOf('/') + 1));
    const time = digits(date.getHours()) + ':' + digits(date.getMinutes()) + ':' + digits(date.getSeconds());
    const clip = {camera, url, begins, seconds, events, files, status, reason, tries, name, time, day: dayOf(date)};
    clip.failed = status !== undefined;
    clip.text = [data.cameras[camera], name, clip.day, time, reason ?? ''].join(' ').toLowerCase();
    return clip;
}).sort((a, b) => b.begins - a.begins || (a.url < b.url ? -1 : 1));

const cameraName = camera => data.cameras[camera] === '' ? '(top folder)' : data.cameras[camera];

// ---- What is asked for: kept in the address, so that going back from a clip's page finds it again

const asked = {text: '', kind: 'all', camera: null};

function readAsked() {
    const parts = new URLSearchParams(location.hash.slice(1));
    asked.text = parts.get('text') ?? '';
    asked.kind = ['all', 'events', 'failed'].includes(parts.get('kind')) ? parts.get('kind') : 'all';
    const camera = data.cameras.indexOf(parts.get('camera') ?? undefined);
    asked.camera = camera < 0 ? null : camera;
    at('text').value = asked.text;
    for (const radio of document.getElementsByName('kind')) radio.checked = radio.value === asked.kind;
}

function keepAsked() {
    const parts = new URLSearchParams();
    if (asked.text) parts.set('text', asked.text);
    if (asked.kind !== 'all') parts.set('kind', asked.kind);
    if (asked.camera !== null) parts.set('camera', data.cameras[asked.camera]);
    history.replaceState(null, '', '#' + parts);
}

const wanted = {all: () => true, events: clip => clip.events > 0, failed: clip => clip.failed};

function chosen() {
    const words = asked.text.toLowerCase().split(/\s+/).filter(Boolean);
    return clips.filter(clip => (asked.camera === null || clip.camera === asked.camera) && wanted[asked.kind](clip) &&
                                words.every(word => clip.text.includes(word)));
}

// ---- What is shown: a section a day, in it one a camera, filled when it comes near the window

function element(tag, className, text) {
    const made = document.createElement(tag);
    if (className) made.className = className;
    if (text !== undefined) made.textContent = text;
    return made;
}

function factsOf(clip) {
    const facts = element('span', 'facts');
    const first = element('span', 'first');
    first.append(element('b', '', clip.time));
    if (!clip.failed) {
        first.append(clip.events === null ? '' : clip.events ? element('span', 'badge', many(clip.events, 'event'))
                                                             : element('span', 'badge none', 'no events'));
    }
    const second = element('span', 'second');
    const name = element('bdi', 'name', clip.name);
    name.title = clip.name;
    second.append(name);
    if (!clip.failed) second.append(element('small', '', lengthOf(clip.seconds)));
    facts.append(first, second);
    return facts;
}

function cardOf(clip) {
    if (clip.failed) {
        const card = element('article', 'card failed');
        const reason = element('p', 'reason');
        reason.title = clip.reason;
        reason.append(element('b', '', `Failed ${clip.tries === 1 ? 'once' : clip.tries + ' times'}, status ${clip.status}`), clip.reason);
        card.append(reason, factsOf(clip));
        return card;
    }
    const card = element('a', 'card');
    card.href = clip.url + (clip.files & hasPage ? '.html' : '.png');
    const image = element('img');
    image.loading = 'lazy';
    image.decoding = 'async';
    image.alt = '';
    image.src = clip.url + (clip.files & hasThumbnail ? '.jpg' : '.png');
    card.append(image, factsOf(clip));
    return card;
}

const nearby = new IntersectionObserver(entries => {
    for (const {target, isIntersecting} of entries) {
        if (!isIntersecting) continue;
        nearby.unobserve(target);
        target.style.minHeight = '';
        target.replaceChildren(...target.clips.map(cardOf));
    }
}, {rootMargin: '1200px'});

function grouped(list, key) {
    const groups = new Map();
    for (const clip of list) {
        const group = groups.get(clip[key]);
        if (group) group.push(clip);
        else groups.set(clip[key], [clip]);
    }
    return groups;
}

function show() {
    const list = chosen();
    const days = at('days');
    nearby.disconnect();
    const columns = Math.max(1, Math.floor((days.clientWidth + 12) / 224));
    const sections = [];
    for (const [day, ofDay] of grouped(list, 'day')) {
        const section = element('section', 'day');
        const date = new Date(ofDay[0].begins * 1000);
        section.append(element('h2', '', date.toLocaleDateString('en', {weekday: 'long'}) + ', ' + day));
        const cameras = [...grouped(ofDay, 'camera')].sort((a, b) => a[0] - b[0]);
        for (const [camera, ofCamera] of cameras) {
            const block = element('section', 'camera');
            const cards = element('div', 'cards');
            cards.clips = ofCamera;
            cards.style.minHeight = Math.ceil(ofCamera.length / columns) * 182 + 'px';
            block.append(element('h3', '', `${cameraName(camera)} · ${ofCamera.length}`), cards);
            section.append(block);
            nearby.observe(cards);
        }
        sections.push(section);
    }
    if (!list.length) sections.push(element('p', 'empty', clips.length ? 'Nothing here is like that.' : 'No clips yet.'));
    days.replaceChildren(...sections);
    at('count').textContent = list.length === clips.length ? '' : `${list.length.toLocaleString('en')} of ${many(clips.length, 'clip')}`;
    for (const button of at('cameras').querySelectorAll('button')) button.setAttribute('aria-pressed', button.camera === asked.camera);
}

function ask(change) {
    Object.assign(asked, change);
    keepAsked();
    show();
    scrollTo(0, 0);
}

function cameraButton(camera, name, of) {
    const button = element('button');
    button.type = 'button';
    button.camera = camera;
    button.append(element('bdi', '', name));
    const failed = of.filter(clip => clip.failed).length;
    const counts = element('i', '', of.length.toLocaleString('en'));
    if (failed) {
        const bad = element('span', 'bad', ` ✕${failed}`);
        bad.title = `${failed} failed`;
        counts.append(bad);
    }
    button.append(counts);
    button.addEventListener('click', () => ask({camera}));
    const item = element('li');
    item.append(button);
    return item;
}

const ofCamera = grouped(clips, 'camera');
at('cameras').append(cameraButton(null, 'All cameras', clips),
                     ...data.cameras.map((_, camera) => cameraButton(camera, cameraName(camera), ofCamera.get(camera) ?? [])));

const failures = clips.filter(clip => clip.failed).length;
const events = clips.reduce((sum, clip) => sum + (clip.events ?? 0), 0);
const zone = Intl.DateTimeFormat().resolvedOptions().timeZone;
at('summary').textContent = [many(clips.length, 'clip'), many(data.cameras.length, 'camera'), many(events, 'event'),
                             failures ? many(failures, 'failure') : '', 'times are those of ' + zone].filter(Boolean).join(' · ');

let typing = 0;
at('text').addEventListener('input', () => {
    clearTimeout(typing);
    typing = setTimeout(() => ask({text: at('text').value.trim()}), 120);
});
for (const radio of document.getElementsByName('kind')) radio.addEventListener('change', () => ask({kind: radio.value}));
at('tools').addEventListener('submit', event => event.preventDefault());
addEventListener('hashchange', () => { readAsked(); show(); });
readAsked();
show();
