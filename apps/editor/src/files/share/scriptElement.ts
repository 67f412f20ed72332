/**
 * An inline script element. What would end it, or hide its end, stands escaped in the literals of its code.
 * @see HTML, "Restrictions for contents of script elements"
 */
export const scriptElement = (nonce: string, code: string): string =>
  `<script nonce="${nonce}">${code.replaceAll(/<(?=\/script|!--)/gi, '\\x3C')}</script>`;
