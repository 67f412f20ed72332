const escaped = (text: string): string =>
  text.replaceAll('&', '&amp;').replaceAll('"', '&quot;').replaceAll('<', '&lt;');

/** HTML that embeds a URL in another page. @param name - scene's name, for screen readers */
export function embedCode(address: string, name: string): string {
  const attributes = 'width="640" height="360" style="border:0" loading="lazy" allowfullscreen';
  return `<iframe src="${escaped(address)}" title="${escaped(name)}" ${attributes}></iframe>`;
}
