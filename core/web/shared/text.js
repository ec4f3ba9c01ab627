// Text and numbers as all pages write them.

/** @type {(value: number, low: number, high: number) => number} */
export const clamp = (value, low, high) => Math.min(Math.max(value, low), high);

/** @type {(number: number) => string} */
export const digits = number => String(number).padStart(2, '0');

const inGroups = new Intl.NumberFormat('en');  // toLocaleString makes one each time

/** @type {(count: number, word: string) => string} */
export const many = (count, word) => inGroups.format(count) + ' ' + word + (count === 1 ? '' : 's');

/**
 * Replaces characters that change the direction of writing by their code points. With them, a name could show a wrong
 * extension.
 * @param {string} text
 */
export const upright = text => text.replace(/[\u061c\u200e\u200f\u202a-\u202e\u2066-\u2069]/g,
    mark => `[U+${mark.charCodeAt(0).toString(16).toUpperCase().padStart(4, '0')}]`);

/**
 * Decodes the name in a URL. Returns the URL as it is if its bytes are not UTF-8.
 * @param {string} url
 */
export function readable(url) {
    try {
        return upright(decodeURIComponent(url));
    } catch {
        return url;
    }
}

/**
 * Text for comparisons: lower case without diacritics. If the text has ü, a second line has it as ue.
 * @param {string} text
 */
export function folded(text) {
    const small = text.toLowerCase().normalize('NFC');
    const plain = small.normalize('NFD').replace(/\p{M}/gu, '').replaceAll('ß', 'ss');
    /** @type {Record<string, string>} */
    const written = {ä: 'ae', ö: 'oe', ü: 'ue', ß: 'ss'};
    const german = small.replace(/[äöüß]/g, letter => written[letter]);
    return plain === german ? plain : plain + '\n' + german.normalize('NFD').replace(/\p{M}/gu, '');
}

/**
 * Groups by the value of a key, in order of first appearance.
 * @template T
 * @template {keyof T} K
 * @param {T[]} list
 * @param {K} key
 * @returns {Map<T[K], T[]>}
 */
export function grouped(list, key) {
    const groups = new Map();
    for (const item of list) {
        const group = groups.get(item[key]);
        if (group) group.push(item);
        else groups.set(item[key], [item]);
    }
    return groups;
}
