// The state of a page: one object, one function that changes it, and one that draws what depends on the change.

/**
 * A part of a page: what it depends on, and the function that draws it.
 * @typedef {{from: () => unknown[], draw: () => void}} Part
 */

/**
 * @template {object} S
 * @param {S} state
 */
export function store(state) {
    /** @type {(Part & {drawn: unknown[] | null})[]} */
    let parts = [];
    let isDrawing = false;
    let isStale = false;

    /** Draws each part whose inputs differ from those that it was last drawn from, in the order of the parts. */
    function render() {
        isStale = true;
        if (isDrawing) return;  // a part has changed the state: another round follows
        isDrawing = true;
        try {
            while (isStale) {
                isStale = false;
                for (const part of parts) {
                    const inputs = part.from();
                    if (part.drawn?.every((value, k) => Object.is(value, inputs[k]))) continue;
                    part.drawn = inputs;
                    part.draw();
                }
            }
        } finally {
            isDrawing = false;
        }
    }

    return {
        state,
        /** @param {Partial<S>} change */
        set(change) {
            Object.assign(state, change);
            render();
        },
        render,
        /**
         * Draws everything, and from then on what changes.
         * @param {Part[]} all in the order in which they are drawn
         */
        drawAll(all) {
            parts = all.map(part => ({...part, drawn: null}));
            render();
        },
    };
}

/**
 * A function that computes its value again only when its inputs have changed.
 * @template T
 * @param {() => unknown[]} inputs
 * @param {() => T} compute
 */
export function derived(inputs, compute) {
    /** @type {unknown[] | null} */
    let last = null;
    /** @type {T} */
    let value;
    return () => {
        const now = inputs();
        if (!last?.every((input, k) => Object.is(input, now[k]))) {
            last = now;
            value = compute();
        }
        return value;
    };
}
