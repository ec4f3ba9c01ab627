
// ---- Clips: a section for each day, in it one for each camera, filled when it comes near the window

function badgesOf(clip) {
    const badges = [];
    for (const {name, emphasis, tally} of data.kinds) {
        const told = clip.tallyOf[name];
        if (told > 0) badges.push(element('span', 'badge ' + emphasis, name + (tally !== 'count' ? ' ' + durationOf(told) : told > 1 ? ' ' + told : '')));
    }
    if (clip.events !== null) {
        badges.push(clip.events ? element('span', 'badge', many(clip.events, 'event')) : element('span', 'badge none', 'no events'));
    }
    if (clip.damaged) badges.push(element('span', 'badge strong', 'damaged'));
    return badges;
}

/// From when to when a picture of a day shows it: most days are not whole.
const stretchOf = clip => clip.drawn ? clip.time.slice(0, 5) + ' to ' + timeOf(wallOf(clip.begins + clip.seconds)).slice(0, 5) : 'the day';

function factsOf(clip) {
    const facts = element('span', 'facts');
    const first = element('span', 'first');
    first.append(element('b', '', clip.wholeDay ? stretchOf(clip) : clip.time));
    if (clip.drawn) first.append(element('small', '', lengthOf(clip.seconds)));
    if (clip.drawn && !seen.has(clip.url)) {
        const dot = element('i', 'new', '●');
        dot.title = 'not seen yet';
        first.append(dot);
    }
    const badges = element('span', 'badges');
    if (clip.drawn) badges.append(...badgesOf(clip));
    if (clip.failed && clip.drawn) {
        const old = element('span', 'badge strong', 'failed; shows what was until ' + clip.until);
        old.title = `Failed ${clip.tries === 1 ? 'once' : clip.tries + ' times'}, status ${clip.status}: ${clip.reason}`;
        badges.append(old);
    }
    const second = element('span', 'second');
    const name = element('bdi', 'name', clip.name);
    name.title = clip.path;
    second.append(name);
    if (clip.placedBy) {
        const written = element('small', 'written', clip.wholeDay ? 'day of writing' : 'time of writing');
        written.title = `Nothing tells when it was recorded, so it stands at ${clip.placedBy}.`;
        second.append(written);
    }
    if (clip.gone) second.append(element('small', 'gone', 'the clip is gone'));
    facts.append(first, badges, second);
    return facts;
}

function imageOf(clip, ending) {
    const image = element('img');
    image.loading = 'lazy';
    image.decoding = 'async';
    image.alt = '';
    image.src = clip.url + ending;
    return image;
}

function cardOf(clip) {
    if (!clip.drawn) {
        const card = element('article', 'card failed');
        const reason = element('p', 'reason');
        reason.title = clip.reason;
        reason.append(element('b', '', `Failed ${clip.tries === 1 ? 'once' : clip.tries + ' times'}, status ${clip.status}`), clip.reason);
        card.append(reason, factsOf(clip));
        return card;
    }
    const card = element('a', 'card');
    card.href = pageOf(clip);
    const images = element('span', 'images');
    if (clip.files & hasStill) images.append(imageOf(clip, '.still.jpg'));
    images.append(imageOf(clip, clip.files & hasThumbnail ? '.jpg' : '.png'));
    card.append(images, factsOf(clip));
    card.addEventListener('click', () => see(clip));
    return card;
}

const nearby = new IntersectionObserver(entries => {
    for (const {target, isIntersecting} of entries) if (isIntersecting) fill(target);
}, {rootMargin: '1200px'});

function fill(cards) {
    nearby.unobserve(cards);
    cards.style.minHeight = '';
    cards.replaceChildren(...cards.clips.map(cardOf));
}
addEventListener('beforeprint', () => {
    for (const cards of at('days').querySelectorAll('.cards')) if (!cards.firstChild) fill(cards);
});

const orders = {
    newest: null,
    ...Object.fromEntries([...kindsOfChoice].map(([choice, ofChoice]) => [choice, (a, b) => {
        const differs = ofChoice.find(({name}) => a.tallyOf[name] !== b.tallyOf[name]);
        return differs ? b.tallyOf[differs.name] - a.tallyOf[differs.name] : 0;
    }])),
    events: (a, b) => (b.events ?? 0) - (a.events ?? 0),
};
/// Pictures of whole days come first, what failed last.
const placeInList = clip => !clip.drawn ? 2 : clip.wholeDay ? 0 : 1;
const lastFailed = list => [...list].sort((a, b) => placeInList(a) - placeInList(b));

function sectionOf(title, clipsOf, columns) {
    const block = element('section', 'camera');
    const cards = element('div', 'cards');
    cards.clips = clipsOf;
    cards.style.minHeight = Math.ceil(clipsOf.length / columns) * 232 + 'px';
    block.append(element('h3', '', title), cards);
    nearby.observe(cards);
    return block;
}

function showClips(list) {
    const days = at('days');
    nearby.disconnect();
    const columns = Math.max(1, Math.floor((days.clientWidth + 12) / 284));
    const sections = [];
    if (asked.order !== 'newest') {
        const sorted = lastFailed([...list].sort(orders[asked.order]));
        if (sorted.length) sections.push(sectionOf(at('order').selectedOptions[0].textContent, sorted, columns));
    } else {
        for (const [day, ofDay] of grouped(list, 'day')) {
            const section = element('section', 'day');
            section.append(element('h2', '', weekday(day) + ', ' + day));
            const cameras = [...grouped(ofDay, 'camera')].sort((a, b) => a[0] - b[0]);
            for (const [camera, ofCamera] of cameras) section.append(sectionOf(`${cameraName(camera)} · ${counted(ofCamera).length}`, lastFailed(ofCamera), columns));
            sections.push(section);
        }
    }
    if (!list.length) {
        const empty = element('p', 'empty', clips.length ? 'Nothing here is like that. ' : 'No clips yet.');
        if (clips.length) {
            const all = element('button', '', 'Show all clips');
            all.type = 'button';
            all.addEventListener('click', () => { readNothing(); ask({}); });
            empty.append(all);
        }
        sections.push(empty);
    }
    days.replaceChildren(...sections);
}

function readNothing() {
    Object.assign(asked, {text: '', kind: 'all', class: '', camera: null, day: null});
    at('text').value = '';
    at('class').value = '';
    for (const radio of document.getElementsByName('kind')) radio.checked = radio.value === 'all';
}
