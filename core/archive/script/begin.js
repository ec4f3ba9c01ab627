
// ---- Everything together

function show() {
    const list = chosenClips();
    for (const [view, id] of [['clips', 'days'], ['days', 'overview'], ['scene', 'scene']]) at(id).hidden = asked.view !== view;
    for (const button of at('views').querySelectorAll('button')) button.setAttribute('aria-pressed', button.value === asked.view);
    if (asked.view === 'clips') showClips(list);
    else if (asked.view === 'days') showDays(list);
    else showScene(list);
    const day = asked.day ? ` on ${asked.day}` : '';
    at('count').textContent = list.length === clips.length ? '' : `${list.length.toLocaleString('en')} of ${many(clips.length, 'clip')}${day}`;
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
    const failed = counted(of).filter(clip => clip.failed).length;
    const counts = element('i', '', counted(of).length.toLocaleString('en'));
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

const failures = counted(clips).filter(clip => clip.failed).length;
const gone = clips.filter(clip => clip.gone).length;
const events = counted(clips).reduce((sum, clip) => sum + (clip.events ?? 0), 0);
const zones = [...new Set(zone.map(([, , name]) => name))].join(', then ');
at('summary').textContent = [many(counted(clips).length, 'clip'), many(data.cameras.length, 'camera'), many(events, 'event'),
                             failures ? many(failures, 'failure') : '', gone ? `${gone} gone` : '',
                             'times are those of ' + zones].filter(Boolean).join(' · ');

let typing = 0;
at('text').addEventListener('input', () => {
    clearTimeout(typing);
    typing = setTimeout(() => ask({text: at('text').value.trim()}), 120);
});
for (const radio of document.getElementsByName('kind')) radio.addEventListener('change', () => ask({kind: radio.value}));
at('class').append(...['', ...classesOf.keys()].map(name => {
    const words = name === '' ? 'everything' : (Object.hasOwn(data.classes, name) ? '' : '\u2013 ') + name;
    return Object.assign(element('option', '', words), {value: name});
}));
at('class').hidden = classesOf.size === 0;
at('class').addEventListener('change', () => ask({class: at('class').value}));
at('order').addEventListener('change', () => ask({order: at('order').value}));
for (const button of at('views').querySelectorAll('button')) button.addEventListener('click', () => ask({view: button.value, day: null}));
at('tools').addEventListener('submit', event => event.preventDefault());
addEventListener('hashchange', () => { if (!followNeighbour()) { readAsked(); show(); } });
if (!followNeighbour()) {
    readAsked();
    show();
}
