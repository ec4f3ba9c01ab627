
const drawing = at('drawing');
const width = Number(at('frame').getAttribute('width'));
const height = Number(at('frame').getAttribute('height'));

// ---- Regions: corners in pixels of the clip; a box keeps its right angles

let regions = [];
let chosen = -1;   // place in `regions`; -1 = none
let draft = null;  // corners of a polygon that is being drawn
let drag = null;   // what the pointer holds
const past = [];   // what `regions` was, for undo

const copyOf = list => list.map(region => ({box: region.box, corners: region.corners.map(corner => [...corner])}));

/// To be called before a change.
function remember() {
    past.push(copyOf(regions));
    if (past.length > 200) past.shift();
}

const boxOf = ([ax, ay], [bx, by]) => {
    const [left, right] = [Math.min(ax, bx), Math.max(ax, bx)];
    const [top, bottom] = [Math.min(ay, by), Math.max(ay, by)];
    return [[left, top], [right, top], [right, bottom], [left, bottom]];
};

function isBox(corners) {
    if (corners.length !== 4) return false;
    const [a, b, c, d] = corners;
    return (a[1] === b[1] && b[0] === c[0] && c[1] === d[1] && d[0] === a[0]) || (a[0] === b[0] && b[1] === c[1] && c[0] === d[0] && d[1] === a[1]);
}

/// What vvr's option holds; texts that are no polygons give none.
function parse(text) {
    return text.split(';').map(part => part.trim().split(/ +/).map(point => point.split(',').map(Number)))
        .filter(corners => corners.length > 2 && corners.every(point => point.length === 2 && point.every(Number.isFinite)))
        .map(corners => ({box: isBox(corners), corners}));
}

const textOf = region => region.corners.map(corner => corner.join(',')).join(' ');
const kind = () => document.querySelector('[name=option]:checked').value;
const tool = () => document.querySelector('[name=tool]:checked').value;
const optionText = () => regions.length ? `--${kind()} "${regions.map(textOf).join('; ')}"` : '';

function boundsOf(corners) {
    const xs = corners.map(corner => corner[0]);
    const ys = corners.map(corner => corner[1]);
    return [Math.min(...xs), Math.min(...ys), Math.max(...xs), Math.max(...ys)];
}

function nameOf(region) {
    const [left, top, right, bottom] = boundsOf(region.corners);
    const where = `${right - left}×${bottom - top} at ${left},${top}`;
    return region.box ? where : `${region.corners.length} corners, ${where}`;
}

/// Moves a region as far as the picture goes.
function moved(corners, dx, dy) {
    const [left, top, right, bottom] = boundsOf(corners);
    const x = clamp(dx, Math.min(0, -left), Math.max(0, width - right));
    const y = clamp(dy, Math.min(0, -top), Math.max(0, height - bottom));
    return corners.map(corner => [corner[0] + x, corner[1] + y]);
}

function moveCorner(region, number, [x, y]) {
    if (!region.box) {
        region.corners[number] = [x, y];
        return;
    }
    const old = region.corners[number];
    region.corners = region.corners.map((corner, k) => k === number ? [x, y]
        : [corner[0] === old[0] && k !== (number + 2) % 4 ? x : corner[0], corner[1] === old[1] && k !== (number + 2) % 4 ? y : corner[1]]);
}

function add(corners, box) {
    remember();
    regions.push({box, corners});
    chosen = regions.length - 1;
    say(`Region ${regions.length} added.`);
}

function remove(place) {
    if (!regions[place]) return;
    remember();
    regions.splice(place, 1);
    chosen = regions.length ? Math.min(place, regions.length - 1) : -1;
    say(`Region ${place + 1} deleted.`);
    show();
}

function undo() {
    if (draft) {
        draft.pop();
        if (!draft.length) draft = null;
    } else if (past.length) {
        regions = past.pop();
        chosen = Math.min(chosen, regions.length - 1);
        say('Undone.');
    }
    show();
}

function closeDraft() {
    if (!draft || draft.length < 3) return;
    const corners = draft;
    draft = null;
    add(corners, false);
    show();
}

// ---- What is shown

const say = text => { at('said').textContent = text; };

function shape(name, attributes, parent = drawing) {
    const element = document.createElementNS('http://www.w3.org/2000/svg', name);
    for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
    parent.append(element);
    return element;
}

/// Pixels of the clip for one of the screen.
const unit = () => width / Math.max(1, drawing.clientWidth);
const reach = () => (matchMedia('(pointer: coarse)').matches ? 13 : 7) * unit();
const pointsOf = corners => corners.map(corner => corner.join(',')).join(' ');

/// Darkens what vvr will not look at.
function showVeil() {
    if (!regions.length) return;
    if (kind() === 'mask') {
        for (const region of regions) shape('polygon', {class: 'veil', points: pointsOf(region.corners)});
        return;
    }
    const mask = shape('mask', {id: 'outside', maskUnits: 'userSpaceOnUse', x: 0, y: 0, width, height});
    shape('rect', {width, height, fill: '#fff'}, mask);
    for (const region of regions) shape('polygon', {points: pointsOf(region.corners), fill: '#000'}, mask);
    shape('rect', {class: 'veil', width, height, mask: 'url(#outside)'});
}

function showRegions() {
    regions.forEach((region, k) => {
        shape('polygon', {class: k === chosen ? 'region chosen' : 'region', points: pointsOf(region.corners), tabindex: 0, role: 'button',
                          'aria-pressed': k === chosen, 'aria-label': `Region ${k + 1}: ${nameOf(region)}`, 'data-key': `region ${k}`});
        const [left, top] = boundsOf(region.corners);
        const size = 15 * unit();
        shape('text', {class: 'number', x: left + size / 2, y: top + 1.2 * size, 'font-size': size, 'stroke-width': size / 5, 'aria-hidden': true}).textContent = k + 1;
    });
    const region = regions[chosen];
    if (!region || draft) return;
    region.corners.forEach(([x, y], k) => {
        shape('circle', {class: 'corner', cx: x, cy: y, r: reach(), tabindex: 0, role: 'button',
                         'aria-label': `Corner ${k + 1} of region ${chosen + 1}: ${x}, ${y}`, 'data-key': `corner ${k}`});
    });
}

function showDraft() {
    if (drag && drag.box) shape('polygon', {class: 'draft', points: pointsOf(drag.box)});
    if (!draft) return;
    const end = drag || !draft.pointer ? [] : [draft.pointer];
    shape('polyline', {class: 'draft', points: pointsOf([...draft, ...end])});
    draft.forEach(([x, y]) => shape('circle', {class: 'corner', cx: x, cy: y, r: reach() * 0.7}));
}

function button(text, label, key, action) {
    const element = document.createElement('button');
    element.type = 'button';
    element.textContent = text;
    element.dataset.key = key;
    if (label) element.setAttribute('aria-label', label);
    element.addEventListener('click', action);
    return element;
}

function showList() {
    at('list').replaceChildren(...regions.map((region, k) => {
        const row = document.createElement('li');
        const name = button(`${k + 1}. ${nameOf(region)}`, '', `row ${k}`, () => { chosen = k; show(); });
        name.setAttribute('aria-pressed', k === chosen);
        row.append(name, button('✕', `Delete region ${k + 1}`, `delete ${k}`, () => remove(k)));
        return row;
    }));
    at('none').hidden = regions.length > 0;
}

function show() {
    const focused = document.activeElement && document.activeElement.dataset ? document.activeElement.dataset.key : undefined;
    drawing.replaceChildren();
    showVeil();
    showRegions();
    showDraft();
    showList();
    at('option').value = optionText();
    at('copy').disabled = at('clear').disabled = !regions.length;
    at('undo').disabled = !past.length && !draft;
    at('corner').disabled = !regions[chosen];
    at('hint').textContent = draft ? 'Click for each corner; the first one again, or Enter, closes it.' : '';
    if (focused) {
        const again = document.querySelector(`[data-key="${focused}"]`);
        if (again) again.focus({preventScroll: true});
    }
}

// ---- Mouse, pen and finger

/// A point of the screen in whole pixels of the clip, within the picture.
function placeOf(event) {
    const box = drawing.getBoundingClientRect();
    return [clamp(Math.round((event.clientX - box.left) * width / box.width), 0, width),
            clamp(Math.round((event.clientY - box.top) * height / box.height), 0, height)];
}

const isNear = (a, b) => Math.hypot(a[0] - b[0], a[1] - b[1]) <= 1.6 * reach();

function beginDrag(event) {
    const place = placeOf(event);
    if (draft) {
        if (draft.length > 2 && isNear(place, draft[0])) closeDraft();
        else if (!isNear(place, draft.at(-1))) draft.push(place);
        return;
    }
    const [part, number] = (event.target.dataset.key || '').split(' ');
    if (part === 'corner') {
        drag = {corner: Number(number), before: copyOf(regions)};
    } else if (part === 'region') {
        chosen = Number(number);
        drag = {from: place, corners: regions[chosen].corners, before: copyOf(regions)};
    } else if (tool() === 'polygon') {
        chosen = -1;
        draft = [place];
    } else {
        chosen = -1;
        drag = {from: place, box: boxOf(place, place)};
    }
}

drawing.addEventListener('pointerdown', event => {
    if (!event.isPrimary || event.button !== 0) return;
    event.preventDefault();
    drawing.setPointerCapture(event.pointerId);
    beginDrag(event);
    if (document.activeElement) document.activeElement.blur();
    show();
});

drawing.addEventListener('pointermove', event => {
    if (!event.isPrimary) return;
    const place = placeOf(event);
    at('place').textContent = `x ${place[0]}, y ${place[1]}`;
    if (draft) {
        draft.pointer = place;
    } else if (!drag) {
        return;
    } else if (drag.box) {
        drag.box = boxOf(drag.from, place);
        at('place').textContent += `, ${drag.box[1][0] - drag.box[0][0]}×${drag.box[2][1] - drag.box[0][1]}`;
    } else if (drag.corners) {
        regions[chosen].corners = moved(drag.corners, place[0] - drag.from[0], place[1] - drag.from[1]);
    } else {
        moveCorner(regions[chosen], drag.corner, place);
    }
    show();
});

function endDrag() {
    if (!drag) return;
    const {box, before} = drag;
    drag = null;
    // A click is no rectangle.
    if (box && box[2][0] - box[0][0] > 2 && box[2][1] - box[0][1] > 2) add(box, true);
    if (before && JSON.stringify(before) !== JSON.stringify(copyOf(regions))) past.push(before);
    show();
}

drawing.addEventListener('pointerup', endDrag);
drawing.addEventListener('pointercancel', () => {
    if (drag && drag.before) regions = drag.before;
    drag = null;
    show();
});
drawing.addEventListener('pointerleave', () => { at('place').textContent = '\u00a0'; });
drawing.addEventListener('dblclick', closeDraft);

// ---- Keys

const steps = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1]};

/// Moves the corner or the region that has the focus. \returns whether there is one
function moveByKey([dx, dy]) {
    const [part, number] = ((document.activeElement && document.activeElement.dataset && document.activeElement.dataset.key) || '').split(' ');
    if (!['corner', 'region', 'row'].includes(part)) return false;
    if (part !== 'corner') chosen = Number(number);
    const region = regions[chosen];
    remember();
    if (part === 'corner') {
        const [x, y] = region.corners[Number(number)];
        moveCorner(region, Number(number), [clamp(x + dx, 0, width), clamp(y + dy, 0, height)]);
    } else {
        region.corners = moved(region.corners, dx, dy);
    }
    show();
    return true;
}

/// \returns whether the key means something here
function onKey(event) {
    const writes = event.target.id === 'option';
    if (event.key === 'z' && (event.ctrlKey || event.metaKey)) undo();
    else if (event.ctrlKey || event.metaKey || event.altKey) return false;
    else if (steps[event.key]) return moveByKey(steps[event.key].map(step => step * (event.shiftKey ? 10 : 1)));
    else if ((event.key === 'Delete' || event.key === 'Backspace') && chosen >= 0 && !writes) remove(chosen);
    else if (event.key === 'Enter' && draft) closeDraft();
    else if (event.key === 'Escape') {
        draft = null;
        if (drag && drag.before) regions = drag.before;
        drag = null;
        chosen = -1;
        show();
    } else if ((event.key === 'Enter' || event.key === ' ') && (event.target.dataset.key || '').startsWith('region ')) {
        chosen = Number(event.target.dataset.key.split(' ')[1]);
        show();
    } else return false;
    return true;
}

document.addEventListener('keydown', event => { if (onKey(event)) event.preventDefault(); });

// ---- Buttons

at('add').addEventListener('click', () => {
    // Not on top of one that was added so before.
    const offset = (regions.length % 6) * 0.04;
    const corner = share => [Math.round(width * (share + offset)), Math.round(height * (share + offset))];
    add(boxOf(corner(0.3), corner(0.6)), true);
    show();
});
at('corner').addEventListener('click', () => {
    const {corners} = regions[chosen];
    const length = k => Math.hypot(...corners[k].map((value, axis) => corners[(k + 1) % corners.length][axis] - value));
    const longest = corners.reduce((best, _, k) => length(k) > length(best) ? k : best, 0);
    const next = corners[(longest + 1) % corners.length];
    remember();
    corners.splice(longest + 1, 0, corners[longest].map((value, axis) => Math.round((value + next[axis]) / 2)));
    regions[chosen].box = false;
    say(`Region ${chosen + 1} has ${corners.length} corners.`);
    show();
});
at('undo').addEventListener('click', undo);
at('clear').addEventListener('click', () => {
    remember();
    regions = [];
    chosen = -1;
    say('All regions deleted.');
    show();
});
at('copy').addEventListener('click', async () => {
    const box = at('option');
    try {
        await navigator.clipboard.writeText(box.value);
    } catch {
        // Some browsers have no clipboard for files.
        box.select();
        if (!document.execCommand('copy')) return say('Press Ctrl+C to copy.');
    }
    say('Copied.');
});
for (const choice of document.querySelectorAll('[name=option], [name=tool]')) {
    choice.addEventListener('change', () => {
        draft = null;
        show();
    });
}
/// As large as the window allows: a small clip is hard to draw on.
function fit() {
    const room = innerWidth > 900 ? innerHeight - 130 : 0.52 * innerHeight;
    const stage = at('stage');
    stage.style.width = `${Math.floor(Math.max(160, Math.min(stage.parentElement.clientWidth, room * width / height)))}px`;
}
addEventListener('resize', fit);
fit();
new ResizeObserver(show).observe(drawing);

document.querySelector(`[name=option][value=${data.option}]`).checked = true;
regions = parse(data.regions);
at('panel').hidden = false;
show();
document.documentElement.dataset.ready = '';
