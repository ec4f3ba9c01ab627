// Which clips of an archive have been seen. The browser keeps it, so index and pages share it.

const most = 20_000;

/**
 * @param {string} index address of the index
 */
export function seenOf(index) {
    const key = 'vvr seen ' + new URL(index, location.href).pathname;

    /** @returns {Set<string>} */
    function read() {
        try {
            return new Set(JSON.parse(localStorage.getItem(key) ?? '[]'));
        } catch {
            return new Set();  // this browser keeps nothing
        }
    }
    const seen = read();

    return {
        /** @param {{url: string}} clip */
        isSeen: clip => seen.has(clip.url),
        /** @param {{url: string}} clip its URL as in the index */
        see(clip) {
            seen.add(clip.url);
            try {
                // Other pages may have added some.
                localStorage.setItem(key, JSON.stringify([...new Set([...read(), ...seen])].slice(-most)));
            } catch {
                // the browser's storage is full, or it keeps nothing
            }
        },
        /**
         * Reads what other pages have added.
         * @returns {boolean} whether there is something new
         */
        refresh() {
            const before = seen.size;
            for (const url of read()) seen.add(url);
            return seen.size > before;
        },
    };
}
