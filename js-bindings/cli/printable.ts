/**
 * Makes text with untrusted parts, such as names in a model, safe for a terminal: puts it on one line, and removes characters
 * that would move the cursor, change colours or reverse the direction of writing.
 */
export const printable = (text: string) => text.replace(/[\p{Cc}\p{Cf}\p{Zl}\p{Zp}]/gu, '?')
