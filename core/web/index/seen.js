// Which clips have been seen; the browser keeps it.

const key = 'vvr seen ' + location.pathname;
const most = 20_000;

function read() {
    try {
        return new Set(JSON.parse(localStorage.getItem(key) ?? '[]'));
    } catch {
        return new Set();  // this browser keeps nothing
    }
}
const seen = read();

/** @param {{url: string}} clip */
export const isSeen = clip => seen.has(clip.url);

/** @param {{url: string}} clip */
export function see(clip) {
    seen.add(clip.url);
    try {
        localStorage.setItem(key, JSON.stringify([...seen].slice(-most)));
    } catch {
        // the browser's storage is full, or it keeps nothing
    }
}
