/**
 * An inline script element. Sequences in the code that would end it, or hide its end, are escaped.
 * @see HTML, "Restrictions for contents of script elements"
 */
export const scriptElement = (nonce: string, code: string): string =>
  `<script nonce="${nonce}">${code.replaceAll(/<(?=\/script|!--)/gi, '\\x3C')}</script>`;
