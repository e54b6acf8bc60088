// What a key means to a reader. Arrows point where the leaf goes by.

/**
 * @typedef {{ turn: boolean, all?: boolean } | { bookmark: boolean } | "back" | "open" | "settings" | "cost" | "full"} Wish
 */

/**
 * @param {KeyboardEvent} event
 * @param {"ltr" | "rtl"} direction
 * @returns {Wish | undefined}
 */
export function wish(event, direction) {
    if (event.ctrlKey || event.metaKey || event.altKey) return undefined;
    const ltr = direction === "ltr";
    const arrow = (/** @type {boolean} */ onward) => (event.shiftKey ? { bookmark: onward } : { turn: onward });
    switch (event.key) {
        case "ArrowRight": return arrow(ltr);
        case "ArrowLeft": return arrow(!ltr);
        case "ArrowDown": return arrow(true);
        case "ArrowUp": return arrow(false);
        case " ": return { turn: !event.shiftKey };
        case "PageDown": return { turn: true };
        case "PageUp": return { turn: false };
        case "End": return { turn: true, all: true };
        case "Home": return { turn: false, all: true };
        case "Escape": return "back";
        case "o": return "open";
        case "s": return "settings";
        case "a": return "cost";
        case "f": return "full";
        default: return undefined;
    }
}
