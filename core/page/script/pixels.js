
// ---- What the pixels of the picture show

const picture = at('picture');
const width = Number(picture.getAttribute('width'));
const height = Number(picture.getAttribute('height'));
let frames = null;   // of each pixel; -1 = none
let objects = null;  // the place in data.events that each pixel shows; -1 = none
let contents = [0, 0, width, height];  // the part of the picture that is not empty: left, top, right, bottom

function bytesOf(base64) {
    return Uint8Array.from(atob(base64), letter => letter.charCodeAt(0));
}

function canvasOf(image) {
    const canvas = document.createElement('canvas');
    canvas.width = width;
    canvas.height = height;
    const context = canvas.getContext('2d', {willReadFrequently: true});
    context.drawImage(image, 0, 0);
    return context.getImageData(0, 0, width, height).data;
}

/// The number of each pixel, less by one: -1 = none.
async function readPixels(source) {
    const png = new Blob([bytesOf(source.src.split(',')[1])], {type: 'image/png'});
    const bytes = canvasOf(await createImageBitmap(png, {premultiplyAlpha: 'none', colorSpaceConversion: 'none'}));
    const read = new Int32Array(width * height);
    let sum = 0;
    for (let k = 0; k < read.length; ++k) {
        const value = bytes[4 * k] << 16 | bytes[4 * k + 1] << 8 | bytes[4 * k + 2];
        sum += value;
        read[k] = value - 1;
    }
    // Some browsers answer with noise, so that pages can't tell machines apart.
    if (sum !== source.sum) throw new Error('this browser changes what pages read from pictures');
    return read;
}

async function readPicture() {
    await picture.decode();
    const ground = groundOf(picture);
    pale = colour(...ground, 205);
    view.style.backgroundColor = `rgb(${ground})`;
    findContents();
    const read = await readPixels(data.pixels);
    objects = data.objects ? await readPixels(data.objects) : null;
    frames = read.map(value => value < 0 ? -1 : value + data.pixels.first);
}

/// The picture's border in one colour is left out of the view.
function findContents() {
    const words = new Uint32Array(canvasOf(picture).buffer);
    const isGround = k => words[k] === words[0];
    let [left, top, right, bottom] = [width, height, 0, 0];
    for (let y = 0; y < height; ++y) {
        for (let x = 0; x < width; ++x) {
            if (isGround(y * width + x)) continue;
            left = Math.min(left, x);
            right = Math.max(right, x + 1);
            top = Math.min(top, y);
            bottom = Math.max(bottom, y + 1);
        }
    }
    if (right <= left) return;
    const edge = Math.round(width / 100);
    contents = [Math.max(0, left - edge), Math.max(0, top - edge), Math.min(width, right + edge), Math.min(height, bottom + edge)];
    place();
}

/// The place of the pixel nearest to a point of the picture that shows a frame, a few pixels away at most; null = none.
function pixelNear(x, y) {
    if (!frames) return null;
    const reach = 4;
    let nearest = null;
    let least = reach * reach + 1;
    for (let j = Math.max(0, Math.floor(y) - reach); j <= Math.min(height - 1, Math.floor(y) + reach); ++j) {
        for (let i = Math.max(0, Math.floor(x) - reach); i <= Math.min(width - 1, Math.floor(x) + reach); ++i) {
            const frame = frames[j * width + i];
            const distance = (i - Math.floor(x)) ** 2 + (j - Math.floor(y)) ** 2;
            if (frame < 0 || distance >= least) continue;
            nearest = j * width + i;
            least = distance;
        }
    }
    return nearest;
}

/// What a point of the picture shows: the frame, and the place of the event in the list; null where there is none.
function shownAt(x, y) {
    // Of the parts that stand for an event, the last drawn is on top.
    const region = data.regions.findLast(([left, top, right, bottom]) => x >= left && x < right && y >= top && y < bottom);
    if (region) return {frame: data.events[region[4]].first, event: region[4]};
    const pixel = pixelNear(x, y);
    if (pixel === null) return {frame: null, event: null};
    return {frame: frames[pixel], event: objects && objects[pixel] >= 0 ? objects[pixel] : null};
}

/// The colour behind everything in the picture, which is that of its corner.
function groundOf(image) {
    const canvas = document.createElement('canvas');
    canvas.width = canvas.height = 1;
    const context = canvas.getContext('2d');
    context.drawImage(image, 0, 0, 1, 1, 0, 0, 1, 1);
    const [red, green, blue, alpha] = context.getImageData(0, 0, 1, 1).data;
    return alpha > 0 ? [red, green, blue] : [255, 255, 255];
}

/// Pales what is not of the chosen event or the place that is asked for, and marks the moment that the player shows.
const veil = at('veil').getContext('2d');
const veilPixels = veil.createImageData(width, height);
const veilWords = new Uint32Array(veilPixels.data.buffer);
const colour = (red, green, blue, alpha) => new Uint32Array(new Uint8Array([red, green, blue, alpha]).buffer)[0];
let pale = 0;
const glow = colour(217, 72, 15, 215);

function drawVeil() {
    if (!frames) return;
    const reach = Math.max(1, Math.round((lastFrame - firstFrame) * 0.003));
    const from = now - reach;
    const to = now + reach;
    const isOther = othersThan(litEvents());
    for (let k = 0; k < frames.length; ++k) {
        const frame = frames[k];
        if (frame < 0) veilWords[k] = 0;  // lines and writing
        else if (moved && frame >= from && frame <= to && frame !== firstFrame && frame !== lastFrame) veilWords[k] = glow;
        else veilWords[k] = isOther(k) ? pale : 0;
    }
    veil.putImageData(veilPixels, 0, 0);
}

/// The events that are lit; null = all, and what is of no event.
function litEvents() {
    const one = lightened ?? chosen;
    if (one !== null) return [one];
    return asksForSome() ? wantedEvents() : null;
}

/// Whether a pixel shows something else than these events.
function othersThan(events) {
    if (events === null) return () => false;
    if (objects) {
        const lit = new Uint8Array(data.events.length);
        for (const event of events) lit[event] = 1;
        return k => objects[k] < 0 || !lit[objects[k]];
    }
    const spans = events.map(event => [data.events[event].first, data.events[event].last]);
    return k => !spans.some(([first, last]) => frames[k] >= first && frames[k] <= last);
}

/// Says at the horseshoe's ends which is which, where there are pixels enough of the first and the last frame; a picture
/// that tells of its objects says it itself.
function labelEnds() {
    if (data.regions.length) return;
    for (const [label, frame, words] of [[at('begins'), firstFrame, 'begins ' + clockOf(begins, false)],
                                         [at('ends'), lastFrame, 'ends ' + clockOf(ends, false)]]) {
        let count = 0;
        let left = width, right = 0, bottom = 0;
        frames.forEach((seen, k) => {
            if (seen !== frame) return;
            ++count;
            left = Math.min(left, k % width);
            right = Math.max(right, k % width);
            bottom = Math.max(bottom, Math.floor(k / width));
        });
        label.hidden = count < width * height / 1000;
        label.textContent = words;
        label.style.left = (left + right) / 2 / width * 100 + '%';
        label.style.top = bottom / height * 100 + '%';
    }
}
