// Elements of a page.

/**
 * The element with an id. Every page's HTML has those that its script asks for.
 * @template {Element} [T=HTMLElement]
 * @param {string} id
 * @param {{new (): T, prototype: T}} [type] a more special class of elements
 * @returns {T}
 */
export function at(id, type) {
    const found = document.getElementById(id);
    if (!found || (type && !(found instanceof type))) throw new Error(`the page has no ${type?.name ?? 'element'} '${id}'`);
    return /** @type {any} */ (found);
}

/** The data that the program wrote into the page. */
export const dataOfPage = () => JSON.parse(at('data').textContent ?? '');

/**
 * @template {keyof HTMLElementTagNameMap} K
 * @param {K} tag
 * @param {string} [className]
 * @param {string} [text]
 * @returns {HTMLElementTagNameMap[K]}
 */
export function element(tag, className, text) {
    const made = document.createElement(tag);
    if (className) made.className = className;
    if (text !== undefined) made.textContent = text;
    return made;
}

/**
 * @param {string} className
 * @param {string} text
 * @param {() => void} [action] of a click
 */
export function button(className, text, action) {
    const made = element('button', className, text);
    made.type = 'button';
    if (action) made.addEventListener('click', action);
    return made;
}

/**
 * An element of SVG, appended to its parent.
 * @param {string} name
 * @param {Record<string, string | number | boolean>} attributes
 * @param {Element} parent
 */
export function appendShape(name, attributes, parent) {
    const shape = document.createElementNS('http://www.w3.org/2000/svg', name);
    for (const [key, value] of Object.entries(attributes)) shape.setAttribute(key, String(value));
    parent.append(shape);
    return shape;
}

/**
 * Sets an attribute of a button that can be on or off.
 * @param {Element} element
 * @param {boolean} on
 */
export const press = (element, on) => element.setAttribute('aria-pressed', String(on));

/**
 * Where a pointer is within an element, in shares of its width and height.
 * @param {Element} element
 * @param {{clientX: number, clientY: number}} event
 */
export function sharesWithin(element, event) {
    const box = element.getBoundingClientRect();
    return [(event.clientX - box.left) / box.width, (event.clientY - box.top) / box.height];
}
