
// ---- Places that are asked for: a rectangle or a line, {kind: 'box' or 'line', from: [x, y], to: [x, y]}

/// The sides of a rectangle: left, top, right, bottom.
const sidesOf = ({from, to}) => [Math.min(from[0], to[0]), Math.min(from[1], to[1]), Math.max(from[0], to[0]), Math.max(from[1], to[1])];

/// The part of a stretch from (x, y) to (toX, toY) that lies in a rectangle, as shares of the stretch; null = none.
function partInBox(x, y, toX, toY, [left, top, right, bottom]) {
    let [begin, end] = [0, 1];
    for (const [from, by, low, high] of [[x, toX - x, left, right], [y, toY - y, top, bottom]]) {
        if (by === 0) {
            if (from < low || from > high) return null;
            continue;
        }
        const [a, b] = by > 0 ? [(low - from) / by, (high - from) / by] : [(high - from) / by, (low - from) / by];
        begin = Math.max(begin, a);
        end = Math.min(end, b);
    }
    return begin <= end ? [begin, end] : null;
}

/// Draws a place into an SVG over a picture; null = nothing.
/// \param size of the picture, in the unit of the SVG
/// \param whole what the places have for the whole of it
function drawShape(drawing, place, [width, height], whole) {
    drawing.setAttribute('viewBox', `0 0 ${width} ${height}`);
    drawing.replaceChildren();
    if (!place) return;
    const [[x, y], [toX, toY]] = [place.from, place.to].map(([across, down]) => [across / whole * width, down / whole * height]);
    const shape = document.createElementNS('http://www.w3.org/2000/svg', place.kind === 'box' ? 'rect' : 'line');
    const values = place.kind === 'box'
        ? {x: Math.min(x, toX), y: Math.min(y, toY), width: Math.abs(toX - x), height: Math.abs(toY - y)}
        : {x1: x, y1: y, x2: toX, y2: toY};
    for (const [name, value] of Object.entries(values)) shape.setAttribute(name, value);
    drawing.append(shape);
}
