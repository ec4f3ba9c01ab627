// Copying text.

import {element} from './dom.js';

/**
 * Copies text. Some browsers have no clipboard for files: there it is selected and copied as a person would.
 * @param {string} text
 * @param {HTMLTextAreaElement} [shown] a field that has the text already; it stays selected
 * @returns {Promise<boolean>} whether it is copied
 */
export async function copyText(text, shown) {
    try {
        await navigator.clipboard.writeText(text);
        return true;
    } catch {
        const area = shown ?? element('textarea', 'unseen');
        if (!shown) {
            area.value = text;
            document.body.append(area);
        }
        area.select();
        const done = document.execCommand('copy');
        if (!shown) area.remove();
        return done;
    }
}
