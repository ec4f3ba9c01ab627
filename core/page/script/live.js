
// ---- A stream's page: asks whether there is a newer one, and takes over what is new in it

let stamp = '';          // what the server says of the page that is shown
let serverAhead = null;  // seconds between the server's clock and this machine's; null = it says no time

async function lookForNews() {
    try {
        const head = await fetch(location.href, {method: 'HEAD', cache: 'no-store'});
        const date = Date.parse(head.headers.get('Date') ?? '');
        serverAhead = Number.isFinite(date) ? (date - Date.now()) / 1000 : null;
        const found = ['ETag', 'Last-Modified', 'Content-Length'].map(name => head.headers.get(name)).join(' ');
        if (!head.ok || found === stamp) return;
        const isFirst = stamp === '';
        stamp = found;
        if (isFirst) return;  // it is what the browser has just opened
        takeOver(await (await fetch(location.href, {cache: 'no-store'})).text());
    } catch {
        // A page that was opened as a file may fetch nothing: it opens itself again.
        if (location.protocol === 'file:' && document.visibilityState === 'visible') location.reload();
    }
}

function takeOver(text) {
    const fresh = new DOMParser().parseFromString(text, 'text/html');
    const node = fresh.getElementById('data');
    if (!node) return;
    const before = chosen === null ? null : numberOf(chosen);
    Object.assign(data, JSON.parse(node.textContent));
    events = data.events ?? [];
    gaps = gapsIn(data.times);
    firstFrame = data.times[0][0];
    lastFrame = data.times.at(-1)[0] + data.times.at(-1)[1] - 1;
    begins = secondsOf(firstFrame);
    ends = secondsOf(lastFrame) + lengthOf(lastFrame);
    lasts = Math.max(secondsOf(lastFrame) - begins, 0.001);
    frames = objects = null;
    lightened = wanted = null;
    chosen = before !== null && placeOfNumber(before) >= 0 ? placeOfNumber(before) : null;
    now = clamp(now, firstFrame, lastFrame);
    picture.src = fresh.getElementById('picture').src;
    document.title = fresh.title;
    document.querySelector('h1').textContent = fresh.querySelector('h1').textContent;
    nameIt();
    summarise();
    drawChips();
    listEvents();
    showOnStrip(begins, lasts);
    drawNow();
    tellAge();
    readPicture().then(() => { labelEnds(); drawVeil(); });
}

/// Says what the stream does, and how old the picture is by the clock of the machine that serves it.
function tellAge() {
    const seconds = Math.max(0, Math.round(Date.now() / 1000 + (serverAhead ?? 0) - data.live.written));
    const old = seconds > 2 * data.live.brick + 5;
    at('state').className = old ? 'old' : '';
    at('state').textContent = [data.live.state, old ? `no new picture for ${seconds} s` : `updated ${seconds} s ago`].join(' · ');
}

if (data.live) {
    at('state').hidden = false;
    tellAge();
    setInterval(tellAge, 1000);
    const every = clamp(data.live.brick / 2, 1, 30) * 1000;
    if (location.protocol !== 'file:') lookForNews();
    setInterval(lookForNews, location.protocol === 'file:' ? 2 * every : every);
}
