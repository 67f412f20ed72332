type Attributes = Readonly<Record<string, string | number | undefined>>;

/** An SVG element as text; attributes that are undefined are left out, children are SVG text already. */
export function tag(name: string, attributes: Attributes, ...children: readonly string[]): string {
  const written = Object.entries(attributes).flatMap(([key, value]) =>
    value === undefined ? [] : [` ${key}="${escaped(rounded(value)).replaceAll('"', '&quot;')}"`],
  );
  return `<${name}${written.join('')}>${children.join('')}</${name}>`;
}

/** An SVG element with text content. */
export function textTag(words: string, attributes: Attributes, name = 'text'): string {
  return tag(name, attributes, escaped(words));
}

function escaped(text: string): string {
  return text.replaceAll('&', '&amp;').replaceAll('<', '&lt;').replaceAll('>', '&gt;');
}

/** Rounds a number to hundredths of a pixel: smaller differences are invisible. Text is returned unchanged. */
function rounded(value: string | number): string {
  return typeof value === 'number' ? String(Math.round(value * 100) / 100) : value;
}

/** Approximate width (pixels) of a text in the system's font: computed without layout, so that files equal the page. */
export function textWidth(text: string, size = 12): number {
  let units = 0;
  for (const letter of text)
    units += /[ .,:;'’|ijl!()]/.test(letter) ? 0.32 : /[A-Zmw%+×–≈→↓]/.test(letter) ? 0.72 : 0.55;
  return Math.ceil(units * size);
}

/** A text shortened to a width (pixels); empty if not even three letters fit. */
export function fittedText(text: string, room: number, size = 12): string {
  if (textWidth(text, size) <= room) return text;
  for (let length = text.length - 1; length >= 3; length--) {
    const cut = `${text.slice(0, length).trimEnd()}…`;
    if (textWidth(cut, size) <= room) return cut;
  }
  return '';
}

/** A text broken between words into lines of at most `width` pixels. */
export function wrapText(text: string, width: number, size: number): string[] {
  const lines: string[] = [];
  for (const word of text.split(' ')) {
    const longer = lines.length === 0 ? word : `${lines.at(-1)} ${word}`;
    if (lines.length > 0 && textWidth(longer, size) <= width) lines[lines.length - 1] = longer;
    else lines.push(word);
  }
  return lines;
}
