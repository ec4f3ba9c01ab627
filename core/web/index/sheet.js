// Places on a contact sheet: a clip's small pictures in one, from left to right and from the top down.

/**
 * The place of the picture nearest to a time, if possible of those in a stretch.
 * @param {number[]} stills seconds of the pictures, in order
 * @param {number} at seconds
 * @param {number} [from]
 * @param {number} [to]
 */
export function nearestStill(stills, at, from = -Infinity, to = Infinity) {
    const inside = stills.filter(seconds => seconds >= from && seconds <= to);
    const nearest = (inside.length ? inside : stills).reduce((a, b) => Math.abs(b - at) < Math.abs(a - at) ? b : a, Infinity);
    return stills.indexOf(nearest);
}

/**
 * The places of the pictures in a stretch; at least one.
 * @param {number[]} stills seconds of the pictures, in order
 * @param {number} from
 * @param {number} to
 */
export function stillsBetween(stills, from, to) {
    const places = [...stills.keys()].filter(place => stills[place] >= from && stills[place] <= to);
    return places.length ? places : [nearestStill(stills, (from + to) / 2)];
}

/**
 * How the sheet lies behind a window that shows one picture, in hundredths of the window's width and height.
 * @param {number} place of the picture
 * @param {number} count of pictures
 * @param {number} most columns
 */
export function sheetPlace(place, count, most) {
    const columns = Math.min(count, most);
    return {left: -100 * (place % columns), top: -100 * Math.floor(place / columns), width: 100 * columns, height: 100 * Math.ceil(count / columns)};
}
