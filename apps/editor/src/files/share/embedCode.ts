const escaped = (text: string): string =>
  text.replaceAll('&', '&amp;').replaceAll('"', '&quot;').replaceAll('<', '&lt;');

/** HTML that shows an address within another page. @param name - of the scene, for people who do not see it */
export function embedCode(address: string, name: string): string {
  const attributes = 'width="640" height="360" style="border:0" loading="lazy" allowfullscreen';
  return `<iframe src="${escaped(address)}" title="${escaped(name)}" ${attributes}></iframe>`;
}
