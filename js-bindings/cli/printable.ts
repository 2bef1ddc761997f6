/**
 * A text with parts from outside, such as names in a model, as a terminal can safely show it: on one line, without what
 * would move its cursor, colour it or turn the direction of writing around.
 */
export const printable = (text: string) => text.replace(/[\p{Cc}\p{Cf}\p{Zl}\p{Zp}]/gu, '?')
