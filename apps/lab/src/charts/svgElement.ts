/** An SVG element with attributes and, where given, text. */
export function svgElement(
  document: Document,
  name: string,
  attributes: Readonly<Record<string, string | number>>,
  text?: string,
): SVGElement {
  const element = document.createElementNS('http://www.w3.org/2000/svg', name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, String(value));
  if (text !== undefined) element.textContent = text;
  return element;
}

/** About how wide a text is in the system's font (pixels): without a layout, for files as for pages. */
export function textWidth(text: string, size = 12): number {
  let units = 0;
  for (const letter of text)
    units += /[ .,:;'’|ijl!()]/.test(letter) ? 0.32 : /[A-Zmw%+×–≈→↓]/.test(letter) ? 0.72 : 0.55;
  return Math.ceil(units * size);
}

/** A text cut to a width (pixels); nothing where not even its first letters fit. */
export function fittedText(text: string, room: number, size = 12): string {
  if (textWidth(text, size) <= room) return text;
  for (let length = text.length - 1; length >= 3; length--) {
    const cut = `${text.slice(0, length).trimEnd()}…`;
    if (textWidth(cut, size) <= room) return cut;
  }
  return '';
}
